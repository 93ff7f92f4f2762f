// Subdivision tags of an OBJ file in the format of OpenSubdiv's example shapes:
//
//     t crease 2/1/0 4 5 2.5        t corner 1/1/0 4 10        t hole 1/0/0 3
//     t interpolateboundary 1/0/0 1
//
// A tag has a name, the counts of integers/numbers/words, and these values. Vertices and faces count from 0
// here, unlike elsewhere in OBJ.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

struct ObjTags {
    SubdivisionTags tags;
    bool boundaryFacesSupportOnly = false; // interpolateboundary 0
    std::vector<std::string> warnings;     // "file:line: …" for tags that are ignored
};

/// Adds the tag of one line. `words`: those after the `t`. Throws InputError "file:line: …" for a tag that is
/// unknown, not supported or malformed; checkControlMesh checks the indices.
void readObjTag(std::span<const std::string_view> words, const std::string& fileName, int line,
                ObjTags& result);

/// A word of the file for use in a message: cut to 40 characters, with '?' for bytes that aren't ASCII.
std::string shortened(std::string_view word);

} // namespace plumbline
