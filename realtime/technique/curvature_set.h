// Which quadrics of the proxy's vertices (scenes/surface/quadric_fit.h) a technique is given as the curvature
// of its base.
#pragma once

namespace plumbline {

/// TwoTerms: C = 0.
enum class CurvatureSet { RingTwoTerms, RingThreeTerms, LimitTwoTerms, LimitThreeTerms };

} // namespace plumbline
