// The shader programs of the harness with a technique put in.
#pragma once

#include "realtime/gl/gl_program.h"
#include "realtime/technique/technique.h"

#include <memory>

namespace plumbline {

/// Vertex and fragment stage of a program.
struct StageSources {
    ShaderSource vertex, fragment;
};

/// Draws objects as they are: proxies without relief, micro-triangles.
StageSources plainSources(size_t lightCount, bool shadowMaps);
/// Draws proxies with a relief by the technique. The technique's own file comes last, so that nothing in it
/// can change the meaning of what stands before, and a redefinition is reported where the author wrote it.
StageSources reliefSources(const Technique& technique, size_t lightCount);
/// The same two in the light pass of shadow maps: they write a depth and no color.
StageSources plainLightSources();
StageSources reliefLightSources(const Technique& technique);

/// Compiles, links and checks that the technique declares no uniform the harness doesn't set. Throws
/// InputError. What the camera sees has the unit of its shadow maps set, unitBehindBaked() of baked_input.h,
/// and is left in use.
std::unique_ptr<GlProgram> buildReliefProgram(const Technique& technique, size_t lightCount);
std::unique_ptr<GlProgram> buildPlainProgram(size_t lightCount, bool shadowMaps);
std::unique_ptr<GlProgram> buildReliefLightProgram(const Technique& technique);
std::unique_ptr<GlProgram> buildPlainLightProgram();

} // namespace plumbline
