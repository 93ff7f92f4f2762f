// Whether the frames of a run fit in memory, asked before any work.
#pragma once

#include "scenes/scene/scene.h"

namespace plumbline {

enum class FrameUse {
    Reference, // traced
    Drawn,     // by a technique
    Compared   // both, and one compared with the other
};

/// Throws MachineError, which says what is needed and what is free. The figures are a lower bound: what
/// meshes and maps take isn't known yet.
void requireFrameMemory(const Scene& scene, FrameUse use);

} // namespace plumbline
