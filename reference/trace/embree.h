// Embree 3 (Debian 12) and Embree 4 (Debian 13) behind one face: the few lines that differ.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <pmmintrin.h>
#include <xmmintrin.h>

namespace plumbline {

/// Nearest hit of one ray.
inline void embreeIntersect(RTCScene scene, RTCRayHit& rayHit) {
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene, &rayHit);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &rayHit);
#endif
}

/// Afterwards ray.tfar is -inf if anything lies between tnear and tfar.
inline void embreeOccluded(RTCScene scene, RTCRay& ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
}

/// Embree wants denormals flushed in every thread that traces; restored on leaving the scope, so that results
/// don't depend on which thread did the work before.
class FlushDenormals {
  public:
    FlushDenormals() : saved_(_mm_getcsr()) {
        _mm_setcsr(saved_ | _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON);
    }
    ~FlushDenormals() { _mm_setcsr(saved_); }
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

  private:
    unsigned saved_;
};

} // namespace plumbline
