// The certificate of a traced frame, and its uncertain channels.
#pragma once

#include "../scenes/frame.h"
#include "../scenes/scene.h"
#include "embree_scene.h"
#include "rate.h"
#include "reference.h"
#include "render.h"

namespace plumbline {

/// The error seen of each face, px: what 99 % of its pixels don't exceed; 0 for a face that isn't seen. Per object, per face.
FaceErrorsPx measureFaces(const Scene& scene, const std::vector<TracedObject>& objects,
                          const FrameEvidence& evidence, const Frame& frame);

/// Adds `uncertain` and `uncertain.shadow.<light>` to the frame. The certificate's aim and limit are left as they are.
void certifyFrame(const Scene& scene, const std::vector<TracedObject>& objects, const EmbreeScene& embree,
                  const FrameEvidence& evidence, Frame& frame, Certificate& certificate);

} // namespace plumbline
