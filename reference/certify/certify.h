// The certificate of a traced frame, and its uncertain channels.
#pragma once

#include "reference/rates/rate.h"
#include "reference/trace/embree_scene.h"
#include "reference/trace/render.h"
#include "scenes/frame/certificate.h"
#include "scenes/frame/frame.h"
#include "scenes/scene/scene.h"

namespace plumbline {

/// The error of each pixel in pixels, as seen by the camera; 0 where the frame shows nothing.
std::vector<float> errorsPx(const Camera& camera, const FrameEvidence& evidence, const Frame& frame);

/// The certificate's figures; its aim and limit are left as they are.
void measureCertificate(const Frame& frame, const FrameEvidence& evidence, const std::vector<float>& errorsPx,
                        Certificate& certificate);

/// The error seen of each face, px: what 99 % of its pixels don't exceed; 0 for a face that isn't seen. Per
/// object, per face.
FaceErrorsPx measureFaces(const std::vector<TracedObject>& objects, const Frame& frame,
                          const FrameEvidence& evidence, const std::vector<float>& errorsPx);

/// Adds `uncertain` and `uncertain.shadow.<light>` to the frame.
void markUncertain(const Scene& scene, const std::vector<TracedObject>& objects, const EmbreeScene& embree,
                   const FrameEvidence& evidence, Frame& frame);

} // namespace plumbline
