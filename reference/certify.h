// The certificate of a traced frame, and its uncertain channels.
#pragma once

#include "../scenes/frame.h"
#include "../scenes/scene.h"
#include "embree_scene.h"
#include "reference.h"
#include "render.h"

namespace plumbline {

/// Adds `uncertain` and `uncertain.shadow.<light>` to the frame. The certificate's aim and limit are left as they are.
void certifyFrame(const Scene& scene, const std::vector<TracedObject>& objects, const EmbreeScene& embree,
                  const FrameEvidence& evidence, Frame& frame, Certificate& certificate);

} // namespace plumbline
