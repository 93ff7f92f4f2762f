// Compiles and links the harness's shader programs for a technique (technique/stage_sources.h).
#pragma once

#include "realtime/gl/gl_program.h"
#include "realtime/technique/stage_sources.h"

#include <memory>

namespace plumbline {

/// Compiles, links and checks that the technique declares no uniform the harness doesn't set. Throws
/// InputError. Programs for the camera's view have the unit of the shadow maps set, unitBehindBaked() of
/// baked_family.h, and are left in use.
std::unique_ptr<GlProgram> buildReliefProgram(const Technique& technique, size_t lightCount,
                                              Side side = Side::Front);
std::unique_ptr<GlProgram> buildPlainProgram(size_t lightCount, bool shadowMaps);
std::unique_ptr<GlProgram> buildReliefLightProgram(const Technique& technique, Side side);
std::unique_ptr<GlProgram> buildPlainLightProgram();
std::unique_ptr<GlProgram> buildNearestPolygonProgram();

} // namespace plumbline
