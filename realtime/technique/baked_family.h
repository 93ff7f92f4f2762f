// How shaders access baked maps: the GLSL file, sampler and texture unit of each kind.
#pragma once

#include <string>
#include <vector>

namespace plumbline {

/// Kinds that are read by the same GLSL code. A technique can use at most one kind of a family.
struct BakedFamily {
    const char* shader;       // in shaders/
    const char* sampler;      // sampler2DArray; slices are the array's layers
    const char* scaleUniform; // vec3, the BakeScale of the map; null: none
    int unit;                 // texture unit
    bool packsLevels; // all levels in one image (draw/baked_input.h); otherwise only level 0 is uploaded
    std::vector<const char*> kinds;
};
const std::vector<BakedFamily>& bakedFamilies();
/// The first texture unit after those of the height map, the color map and the families.
int unitBehindBaked();
/// Throws InputError for an unknown kind.
const BakedFamily& bakedFamily(const std::string& kind);

} // namespace plumbline
