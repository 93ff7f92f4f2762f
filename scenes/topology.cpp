#include "topology.h"

#include "error.h"

#include <opensubdiv/far/error.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <string>

namespace plumbline {

using namespace OpenSubdiv;

namespace {

/// OpenSubdiv reports through a global callback; the last message is kept for the error that follows.
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

} // namespace

std::unique_ptr<Far::TopologyRefiner> makeTopology(const ControlMesh& mesh, Scheme scheme) {
    Far::SetErrorCallback(keepOpenSubdivError);
    Far::SetWarningCallback(keepOpenSubdivWarning);
    lastOpenSubdivMessage().clear();

    Far::TopologyDescriptor descriptor;
    descriptor.numVertices = static_cast<int>(mesh.points.size());
    descriptor.numFaces = mesh.faceCount();
    descriptor.numVertsPerFace = mesh.faceSizes.data();
    descriptor.vertIndicesPerFace = mesh.faceVertices.data();

    Sdc::Options options;
    options.SetVtxBoundaryInterpolation(mesh.boundaryFacesSupportOnly
                                            ? Sdc::Options::VTX_BOUNDARY_NONE
                                            : Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    const Sdc::SchemeType type = scheme == Scheme::CatmullClark ? Sdc::SCHEME_CATMARK
                                 : scheme == Scheme::Loop       ? Sdc::SCHEME_LOOP
                                                                : Sdc::SCHEME_BILINEAR;
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    std::unique_ptr<Far::TopologyRefiner> refiner(
        Factory::Create(descriptor, Factory::Options(type, options)));
    if (!refiner)
        throw InputError(mesh.name, "OpenSubdiv refuses the mesh: " + lastOpenSubdivMessage(),
                         "a mesh whose faces share edges and vertices consistently");
    return refiner;
}

} // namespace plumbline
