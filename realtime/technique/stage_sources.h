// The GLSL of the harness with a technique put in, stage by stage, and the names it takes.
#pragma once

#include "realtime/glsl/shader_source.h"
#include "realtime/technique/technique.h"

#include <filesystem>
#include <set>
#include <string>

namespace plumbline {

/// Vertex and fragment stage of a program.
struct StageSources {
    ShaderSource vertex, fragment;
};

/// The side of a surface that a program draws: a relief is searched from there (shaders/relief_side.glsl).
enum class Side { Front, Back };

/// Draws objects as they are: proxies without relief, micro-triangles.
StageSources plainSources(size_t lightCount, bool shadowMaps);
/// Draws proxies with a relief by the technique. The technique's own file comes last, so that nothing in it
/// can change the meaning of what stands before, and a redefinition is reported where the author wrote it.
StageSources reliefSources(const Technique& technique, size_t lightCount, Side side = Side::Front);
/// The same two in the light pass of shadow maps: they write a depth and no color.
StageSources plainLightSources();
StageSources reliefLightSources(const Technique& technique, Side side = Side::Front);
/// Those of the pass that finds the nearest polygons: they write a depth and no color.
StageSources nearestPolygonSources();

/// A file of realtime/shaders/.
std::filesystem::path harnessShader(const std::string& name);

/// What the harness declares at file scope of the fragment stages a technique is put into, with any baked map
/// and any base.
const std::set<std::string>& harnessNames();

} // namespace plumbline
