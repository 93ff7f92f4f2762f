// Subdivision tags of an OBJ file as OpenSubdiv's own shapes carry them:
//
//     t crease 2/1/0 4 5 2.5        t corner 1/1/0 4 10        t hole 1/0/0 3
//     t interpolateboundary 1/0/0 1
//
// name, how many whole numbers/numbers/words follow, and these. Vertices and faces count from 0 here, unlike
// anywhere else in OBJ.
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
    std::vector<std::string> warnings;     // "file:line: …" for tags that ask for what isn't done
};

/// Adds what one line says. `words`: all behind the `t`. Throws InputError "file:line: …" for a tag that is
/// unknown, not supported or malformed; indices are left to checkControlMesh.
void readObjTag(std::span<const std::string_view> words, const std::string& fileName, int line,
                ObjTags& result);

/// A word of the file for a message: cut to 40 letters, with '?' for bytes that aren't ASCII.
std::string shortened(std::string_view word);

} // namespace plumbline
