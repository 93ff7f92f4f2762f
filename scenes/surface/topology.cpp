#include "scenes/surface/topology.h"

#include "scenes/core/error.h"

#include <opensubdiv/far/error.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <string>
#include <vector>

namespace plumbline {

using namespace OpenSubdiv;

namespace {

/// OpenSubdiv reports errors through a global callback; the last message is kept for the InputError.
std::string& lastOpenSubdivMessage() {
    thread_local std::string message;
    return message;
}
void keepOpenSubdivError(Far::ErrorType, const char* message) {
    lastOpenSubdivMessage() = message;
}
void keepOpenSubdivWarning(const char* message) {
    lastOpenSubdivMessage() = message;
}

/// The arrays a TopologyDescriptor points at.
struct TagArrays {
    std::vector<int> creaseVertices, cornerVertices, holes;
    std::vector<float> creaseSharpness, cornerSharpness;

    explicit TagArrays(const SubdivisionTags& tags) {
        for (const SubdivisionTags::Crease& crease : tags.creases) {
            creaseVertices.insert(creaseVertices.end(), {crease.from, crease.to});
            creaseSharpness.push_back(static_cast<float>(crease.sharpness));
        }
        for (const SubdivisionTags::Corner& corner : tags.corners) {
            cornerVertices.push_back(corner.vertex);
            cornerSharpness.push_back(static_cast<float>(corner.sharpness));
        }
        for (const SubdivisionTags::Hole& hole : tags.holes)
            holes.push_back(hole.face);
    }

    void describe(Far::TopologyDescriptor& descriptor) const {
        descriptor.numCreases = countOf(creaseSharpness);
        descriptor.creaseVertexIndexPairs = creaseVertices.data();
        descriptor.creaseWeights = creaseSharpness.data();
        descriptor.numCorners = countOf(cornerSharpness);
        descriptor.cornerVertexIndices = cornerVertices.data();
        descriptor.cornerWeights = cornerSharpness.data();
        descriptor.numHoles = countOf(holes);
        descriptor.holeIndices = holes.data();
    }
};

Sdc::Options subdivisionOptions(const ControlMesh& mesh) {
    Sdc::Options options;
    options.SetVtxBoundaryInterpolation(mesh.boundaryFacesSupportOnly ? Sdc::Options::VTX_BOUNDARY_NONE
                                        : mesh.tags.boundaryCornersRound
                                            ? Sdc::Options::VTX_BOUNDARY_EDGE_ONLY
                                            : Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    return options;
}

} // namespace

std::unique_ptr<Far::TopologyRefiner> makeTopology(const ControlMesh& mesh, Scheme scheme) {
    Far::SetErrorCallback(keepOpenSubdivError);
    Far::SetWarningCallback(keepOpenSubdivWarning);
    lastOpenSubdivMessage().clear();

    Far::TopologyDescriptor descriptor;
    descriptor.numVertices = countOf(mesh.points);
    descriptor.numFaces = mesh.faceCount();
    descriptor.numVertsPerFace = mesh.faceSizes.data();
    descriptor.vertIndicesPerFace = mesh.faceVertices.data();

    const TagArrays tags(mesh.tags);
    if (scheme != Scheme::None) tags.describe(descriptor); // polygons have no smooth edges

    const Sdc::SchemeType type = scheme == Scheme::CatmullClark ? Sdc::SCHEME_CATMARK
                                 : scheme == Scheme::Loop       ? Sdc::SCHEME_LOOP
                                                                : Sdc::SCHEME_BILINEAR;
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    std::unique_ptr<Far::TopologyRefiner> refiner(
        Factory::Create(descriptor, Factory::Options(type, subdivisionOptions(mesh))));
    if (!refiner)
        throw InputError(mesh.name, "OpenSubdiv refuses the mesh: " + lastOpenSubdivMessage(),
                         "a mesh whose faces share edges and vertices consistently");
    return refiner;
}

} // namespace plumbline
