#include "validate/metrics/distance_transform.h"

#include <algorithm>

namespace plumbline {

void PixelBox::include(const Pixel& pixel) {
    x0 = std::min(x0, pixel.x);
    y0 = std::min(y0, pixel.y);
    x1 = std::max(x1, pixel.x + 1);
    y1 = std::max(y1, pixel.y + 1);
}

void PixelBox::include(std::span<const Pixel> pixels) {
    for (const Pixel& pixel : pixels)
        include(pixel);
}

DistanceTransform::DistanceTransform(std::span<const Pixel> set, const PixelBox& box, int reach)
    : box_(box), reach_(reach),
      inColumn_(static_cast<size_t>(box.width()) * static_cast<size_t>(box.height()), kNone) {
    for (const Pixel& pixel : set)
        row(pixel.y)[pixel.x - box_.x0] = 0;
    for (int y = box_.y0 + 1; y < box_.y1; ++y)
        spread(row(y - 1), row(y));
    for (int y = box_.y1 - 1; y > box_.y0; --y)
        spread(row(y), row(y - 1));
}

std::vector<int64_t> DistanceTransform::squaredDistancesOf(std::span<const Pixel> from) {
    std::vector<int64_t> distances;
    distances.reserve(from.size());
    Pixel previous{box_.x0, box_.y0 - 1};
    size_t lowest = 0; // index into the envelope at the previous pixel
    for (const Pixel& pixel : from) {
        if (pixel.y != previous.y) buildEnvelope(row(pixel.y));
        if (pixel.y != previous.y || pixel.x < previous.x) lowest = 0;
        previous = pixel;
        if (envelope_.empty()) {
            distances.push_back(kFar);
            continue;
        }
        const int x = pixel.x - box_.x0;
        while (lowest + 1 < envelope_.size() && envelope_[lowest + 1].begin <= x)
            ++lowest;
        const int64_t dx = x - envelope_[lowest].column;
        distances.push_back(dx * dx + envelope_[lowest].height);
    }
    return distances;
}

int* DistanceTransform::row(int y) {
    return inColumn_.data() + static_cast<size_t>(y - box_.y0) * static_cast<size_t>(box_.width());
}

void DistanceTransform::spread(const int* from, int* to) const {
    for (int x = 0; x < box_.width(); ++x)
        to[x] = std::min(to[x], from[x] == kNone ? kNone : from[x] + 1);
}

// Doubles are exact enough: an intersection is a quotient of integers below 2^53, so it never rounds past an
// integer x that it isn't equal to, and where it is equal both parabolas have the same value.
void DistanceTransform::buildEnvelope(const int* inColumn) {
    envelope_.clear();
    for (int x = 0; x < box_.width(); ++x) {
        if (inColumn[x] == kNone || inColumn[x] > reach_)
            continue; // then it is too far from every pixel of the row
        const int64_t height = int64_t(inColumn[x]) * inColumn[x];
        double begin = -std::numeric_limits<double>::infinity();
        while (!envelope_.empty()) {
            const Parabola& last = envelope_.back();
            const int64_t rise = height + int64_t(x) * x - last.height - int64_t(last.column) * last.column;
            begin = static_cast<double>(rise) / (2.0 * (x - last.column));
            if (begin > last.begin) break;
            envelope_.pop_back();
            begin = -std::numeric_limits<double>::infinity();
        }
        envelope_.push_back({x, height, begin});
    }
}

} // namespace plumbline
