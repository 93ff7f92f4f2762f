// A first look at an OBJ text: tinyobjloader reads a number it can't make out as 0, drops faces it doesn't
// like and knows no line numbers, so everything that can be wrong is found here, with its line.
#pragma once

#include "scenes/mesh/obj_tags.h"

#include <string>
#include <vector>

namespace plumbline {

struct ObjScan {
    std::vector<int> faceSizes;
    std::vector<int> faceLines;
    int firstFaceWithoutUvs = -1; // index of a face; -1 if there is none
    int firstFaceWithoutNormals = -1;
    bool anyUvs = false, anyNormals = false; // of faces, not just vt and vn lines
    ObjTags tags;
};

/// `text` is changed in place: comments go, one kind of line end remains, lines continued by a backslash are
/// joined and followed by empty ones, so that line numbers stay; lines of tags are blanked. Throws InputError
/// "file:line: …" for: bytes that are no text, an unknown keyword, a number that is malformed or not finite,
/// too few numbers, a face with fewer than 3 corners, an index that is 0, malformed or out of range (negative
/// ones count back from the latest), uv or normal indices on some corners of a face but not on all, free-form
/// surfaces, and tags as obj_tags.h says.
ObjScan scanObj(const std::string& fileName, std::string& text);

} // namespace plumbline
