#include "scenes/mesh/obj_file.h"

#include "scenes/core/error.h"
#include "scenes/core/read_file.h"
#include "scenes/mesh/obj_scan.h"

#include <fmt/format.h>

#include <tiny_obj_loader.h>

namespace plumbline {
namespace {

/// `width` coordinates of each of tinyobjloader's flat numbers.
template <class Vector>
std::vector<Vector> unflatten(const std::vector<tinyobj::real_t>& numbers) {
    constexpr auto kWidth = static_cast<size_t>(Vector::length());
    std::vector<Vector> vectors(numbers.size() / kWidth);
    for (size_t i = 0; i < vectors.size(); ++i)
        for (size_t axis = 0; axis < kWidth; ++axis)
            vectors[i][static_cast<int>(axis)] = numbers[i * kWidth + axis];
    return vectors;
}

void normalizeWherePossible(std::vector<Vec3>& normals) {
    for (Vec3& normal : normals)
        if (const double length = glm::length(normal); length > 0) normal /= length;
}

std::string missingOnFace(const ObjScan& scan, int face, const char* what) {
    return fmt::format("the face in line {} has no {} indices, though others have",
                       scan.faceLines[static_cast<size_t>(face)], what);
}

/// Faces of all the shapes of the file, in its order.
void appendFaces(ControlMesh& mesh, const std::vector<tinyobj::shape_t>& shapes, bool uvs, bool normals) {
    for (const tinyobj::shape_t& shape : shapes)
        for (const tinyobj::index_t& index : shape.mesh.indices) {
            mesh.faceVertices.push_back(index.vertex_index);
            if (uvs) mesh.faceUvs.push_back(index.texcoord_index);
            if (normals) mesh.faceNormals.push_back(index.normal_index);
        }
}

} // namespace

ControlMesh readObj(const std::filesystem::path& file) {
    std::string text = readWholeFile(file);
    const ObjScan scan = scanObj(file.string(), text);
    tinyobj::ObjReaderConfig config;
    config.triangulate = false;
    config.vertex_color = false;
    tinyobj::ObjReader reader;
    if (!reader.ParseFromString(text, "", config))
        throw InputError(file.string(), "can't be read as OBJ: " + reader.Error());
    ControlMesh mesh;
    mesh.name = file.string();
    mesh.points = unflatten<Vec3>(reader.GetAttrib().vertices);
    mesh.uvs = unflatten<Vec2>(reader.GetAttrib().texcoords);
    mesh.normals = unflatten<Vec3>(reader.GetAttrib().normals);
    normalizeWherePossible(mesh.normals);
    mesh.faceSizes = scan.faceSizes; // tinyobjloader keeps them in a byte
    mesh.faceLines = scan.faceLines;
    const bool allUvs = scan.firstFaceWithoutUvs < 0, allNormals = scan.firstFaceWithoutNormals < 0;
    if (scan.anyUvs && !allUvs) mesh.uvsMissing = missingOnFace(scan, scan.firstFaceWithoutUvs, "uv");
    if (scan.anyNormals && !allNormals)
        mesh.normalsMissing = missingOnFace(scan, scan.firstFaceWithoutNormals, "normal");
    mesh.tags = scan.tags.tags;
    mesh.boundaryFacesSupportOnly = scan.tags.boundaryFacesSupportOnly;
    mesh.warnings = scan.tags.warnings;
    appendFaces(mesh, reader.GetShapes(), allUvs, allNormals);
    checkControlMesh(mesh, Scheme::CatmullClark); // what every scheme asks for
    return mesh;
}

} // namespace plumbline
