// Random small frames for property tests: up to three objects, some pixels empty, some values not finite.
#pragma once

#include "tests/validate/metrics/painted_frames.h"

#include <rapidcheck.h>

#include <limits>

namespace plumbline::test {

inline constexpr int kRandomWidth = 9, kRandomHeight = 7;

inline Frame randomFrame() {
    Frame frame = emptyFrame(kRandomWidth, kRandomHeight);
    for (int y = 0; y < kRandomHeight; ++y)
        for (int x = 0; x < kRandomWidth; ++x) {
            const int id = *rc::gen::inRange(0, 4);
            if (id == 0) continue;
            // Multiples of 1/64, so that sums and differences are exact and may be compared with ==.
            paintPixel(frame, x, y, id, static_cast<float>(*rc::gen::inRange(1, 257)) / 64.0f);
            set(frame, "shadow.sun", x, y, static_cast<float>(*rc::gen::inRange(0, 2)));
            set(frame, "N.X", x, y, static_cast<float>(*rc::gen::inRange(-3, 4)));
            set(frame, "N.Y", x, y, static_cast<float>(*rc::gen::inRange(-3, 4)));
            set(frame, "st.S", x, y, static_cast<float>(*rc::gen::inRange(-128, 129)) / 64.0f);
            set(frame, "st.T", x, y, static_cast<float>(*rc::gen::inRange(-128, 129)) / 64.0f);
            const int spoiled = *rc::gen::inRange(0, 40);
            if (spoiled == 0) set(frame, "Z", x, y, kNanF);
            if (spoiled == 1) set(frame, "Z", x, y, kInfinityF);
            if (spoiled == 2) set(frame, "shadow.sun", x, y, kNanF);
            if (spoiled == 3) set(frame, "st.S", x, y, kInfinityF);
            if (spoiled == 4) set(frame, "N.Z", x, y, kNanF);
        }
    return frame;
}

inline std::vector<ObjectInfo> threeObjects() {
    return {objectWithRelief(1, 0.25), objectWithRelief(2, 0.5), objectWithRelief(3, 1.0)};
}

} // namespace plumbline::test
