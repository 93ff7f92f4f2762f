#include "scenes/mesh/vertex_normals.h"

#include <cmath>

namespace plumbline {

namespace {

/// Angle inside a face between its edges that meet at the corner b; `normal` is the face's.
double cornerAngle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
    const Vec3 e = a - b, f = c - b, across = glm::cross(f, e);
    const double angle = std::atan2(glm::length(across), glm::dot(e, f));
    return glm::dot(across, normal) < 0 ? 2 * kPi - angle : angle;
}

/// Normal of a polygon, its length twice the area (Newell).
Vec3 polygonNormal(const ControlMesh& mesh, const MeshFace& face) {
    Vec3 sum(0);
    const Vec3& origin = mesh.pointAt(face.firstCorner);
    for (size_t k = 1; k + 1 < face.size; ++k)
        sum += glm::cross(mesh.pointAt(face.corner(k)) - origin, mesh.pointAt(face.corner(k + 1)) - origin);
    return sum;
}

/// A sum of unit vectors shorter than this has canceled; only rounding errors of about 1e-15 remain.
constexpr double kCanceled = 1e-9;

/// Gives face normals to the corners of vertices without a normal.
void fallBackOnFaceNormals(ControlMesh& mesh) {
    for (const MeshFace& face : mesh.faces()) {
        int ofFace = -1; // index into normals, created on first use
        for (size_t k = 0; k < face.size; ++k) {
            int& index = mesh.faceNormals[face.corner(k)];
            if (item(mesh.normals, index) != Vec3(0)) continue;
            if (ofFace < 0) {
                ofFace = countOf(mesh.normals);
                mesh.normals.push_back(unitOrZero(polygonNormal(mesh, face)));
            }
            index = ofFace;
        }
    }
}

} // namespace

void addAngleWeightedNormals(ControlMesh& mesh) {
    mesh.normals.assign(mesh.points.size(), Vec3(0));
    for (const MeshFace& face : mesh.faces()) {
        const Vec3 normal = unitOrZero(polygonNormal(mesh, face));
        for (size_t k = 0; k < face.size; ++k) {
            const double angle =
                cornerAngle(mesh.pointAt(face.corner(k + face.size - 1)), mesh.pointAt(face.corner(k)),
                            mesh.pointAt(face.corner(k + 1)), normal);
            item(mesh.normals, mesh.faceVertices[face.corner(k)]) += normal * angle;
        }
    }
    for (Vec3& normal : mesh.normals)
        normal = glm::length(normal) > kCanceled ? glm::normalize(normal) : Vec3(0);
    mesh.faceNormals = mesh.faceVertices;
    fallBackOnFaceNormals(mesh);
}

} // namespace plumbline
