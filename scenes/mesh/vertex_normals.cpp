#include "scenes/mesh/vertex_normals.h"

#include <cmath>

namespace plumbline {

namespace {

/// Angle between the two edges that meet in the corner b of a face.
double cornerAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 e = a - b, f = c - b;
    return std::atan2(glm::length(glm::cross(e, f)), glm::dot(e, f));
}

/// Normal of a polygon, its length twice the area (Newell).
Vec3 polygonNormal(const ControlMesh& mesh, int first, int size) {
    Vec3 sum(0);
    const Vec3 origin = mesh.points[static_cast<size_t>(mesh.faceVertices[static_cast<size_t>(first)])];
    for (int k = 1; k + 1 < size; ++k) {
        const auto corner = [&](int i) {
            return mesh.points[static_cast<size_t>(mesh.faceVertices[static_cast<size_t>(first + i)])];
        };
        sum += glm::cross(corner(k) - origin, corner(k + 1) - origin);
    }
    return sum;
}

Vec3 unitOrZero(const Vec3& vector) {
    const double length = glm::length(vector);
    return length > 0 ? vector / length : Vec3(0);
}

/// Sums of unit vectors shorter than this have cancelled: what is left of them is rounding, some 1e-15.
constexpr double kCancelled = 1e-9;

/// Corners whose vertex got no normal take their face's.
void fallBackOnFaceNormals(ControlMesh& mesh) {
    int first = 0;
    for (const int size : mesh.faceSizes) {
        int ofFace = -1; // index into normals, made when first needed
        for (int corner = first; corner < first + size; ++corner) {
            int& index = mesh.faceNormals[static_cast<size_t>(corner)];
            if (mesh.normals[static_cast<size_t>(index)] != Vec3(0)) continue;
            if (ofFace < 0) {
                ofFace = static_cast<int>(mesh.normals.size());
                mesh.normals.push_back(unitOrZero(polygonNormal(mesh, first, size)));
            }
            index = ofFace;
        }
        first += size;
    }
}

} // namespace

void addAngleWeightedNormals(ControlMesh& mesh) {
    mesh.normals.assign(mesh.points.size(), Vec3(0));
    int first = 0;
    for (const int size : mesh.faceSizes) {
        const Vec3 normal = unitOrZero(polygonNormal(mesh, first, size));
        for (int k = 0; k < size; ++k) {
            const auto vertex = [&](int i) {
                return static_cast<size_t>(mesh.faceVertices[static_cast<size_t>(first + i % size)]);
            };
            const double angle = cornerAngle(mesh.points[vertex(k + size - 1)], mesh.points[vertex(k)],
                                             mesh.points[vertex(k + 1)]);
            mesh.normals[vertex(k)] += normal * angle;
        }
        first += size;
    }
    for (Vec3& normal : mesh.normals)
        normal = glm::length(normal) > kCancelled ? glm::normalize(normal) : Vec3(0);
    mesh.faceNormals = mesh.faceVertices;
    fallBackOnFaceNormals(mesh);
}

} // namespace plumbline
