// Builds the harness's shader programs for a technique.
#pragma once

#include "realtime/gl/gl_program.h"
#include "realtime/technique/technique.h"

#include <memory>

namespace plumbline {

/// Vertex and fragment stage of a program.
struct StageSources {
    ShaderSource vertex, fragment;
};

/// Draws objects without relief: proxies and micro-triangles.
StageSources plainSources(size_t lightCount, bool shadowMaps);
/// Draws proxies with a relief using the technique. The technique's file comes last, so that it can't change
/// the meaning of the code before it and a redefinition is reported at the author's line.
StageSources reliefSources(const Technique& technique, size_t lightCount);
/// The same for the light pass of shadow maps, which writes only depth.
StageSources plainLightSources();
StageSources reliefLightSources(const Technique& technique);

/// Compiles, links and checks that the technique declares no uniform the harness doesn't set. Throws
/// InputError. Programs for the camera's view have the unit of the shadow maps set, unitBehindBaked() of
/// baked_family.h, and are left in use.
std::unique_ptr<GlProgram> buildReliefProgram(const Technique& technique, size_t lightCount);
std::unique_ptr<GlProgram> buildPlainProgram(size_t lightCount, bool shadowMaps);
std::unique_ptr<GlProgram> buildReliefLightProgram(const Technique& technique);
std::unique_ptr<GlProgram> buildPlainLightProgram();

} // namespace plumbline
