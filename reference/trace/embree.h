// A common interface to Embree 3 (Debian 12) and Embree 4 (Debian 13).
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

/// Makes queries for a nearest hit skip the back sides of a geometry, for rays whose `id` is kSkipsBacks. The
/// back of a micro-triangle is the side that a ray along its normal meets.
inline constexpr unsigned kSkipsBacks = 1;
inline void embreeSkipBacks(RTCGeometry geometry) {
    rtcSetGeometryIntersectFilterFunction(geometry, [](const RTCFilterFunctionNArguments* arguments) {
        const auto* ray = reinterpret_cast<const RTCRay*>(arguments->ray); // N is 1: single rays are traced
        const auto* hit = reinterpret_cast<const RTCHit*>(arguments->hit);
        const float along = hit->Ng_x * ray->dir_x + hit->Ng_y * ray->dir_y + hit->Ng_z * ray->dir_z;
        if (ray->id == kSkipsBacks && !(along < 0)) arguments->valid[0] = 0;
    });
}

/// Sets ray.tfar to -inf if there is any hit between tnear and tfar.
inline void embreeOccluded(RTCScene scene, RTCRay& ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
}

/// Flushes denormals in the current scope, which Embree requires in every tracing thread. The previous mode
/// is restored afterwards, so that results don't depend on a thread's earlier work.
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
