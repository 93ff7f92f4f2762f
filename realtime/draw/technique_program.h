// Shader programs of the harness with a technique put in (technique/stage_sources.h), compiled and linked.
#pragma once

#include "realtime/gl/gl_program.h"
#include "realtime/technique/stage_sources.h"

#include <memory>

namespace plumbline {

/// Compiles, links and checks that the technique declares no uniform the harness doesn't set. Throws
/// InputError. What the camera sees has the unit of its shadow maps set, unitBehindBaked() of baked_input.h,
/// and is left in use.
std::unique_ptr<GlProgram> buildReliefProgram(const Technique& technique, size_t lightCount);
std::unique_ptr<GlProgram> buildPlainProgram(size_t lightCount, bool shadowMaps);
std::unique_ptr<GlProgram> buildReliefLightProgram(const Technique& technique);
std::unique_ptr<GlProgram> buildPlainLightProgram();

} // namespace plumbline
