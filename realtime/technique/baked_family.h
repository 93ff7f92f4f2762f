// Baked maps as a shader sees them: the GLSL that reads a kind, its sampler and texture unit.
#pragma once

#include <string>
#include <vector>

namespace plumbline {

/// What the kinds that are read in one way have in common. A technique takes one kind of a family at most.
struct BakedFamily {
    const char* shader;       // in shaders/
    const char* sampler;      // sampler2DArray; slices are the array's layers
    const char* scaleUniform; // vec3, the BakeScale it was baked at; null: it has none
    int unit;                 // texture unit
    bool packsLevels;         // all levels in one picture (draw/baked_input.h); else level 0 alone is sent
    std::vector<const char*> kinds;
};
const std::vector<BakedFamily>& bakedFamilies();
/// The first texture unit behind the height map's, the color map's and those of the families.
int unitBehindBaked();
/// Throws InputError for a name that is no kind of baked map.
const BakedFamily& bakedFamily(const std::string& kind);

} // namespace plumbline
