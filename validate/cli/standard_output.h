// Standard output, where results go: what can't be written there must not be lost without a word.
#pragma once

#include "scenes/core/error.h"

namespace plumbline {

/// Opens the standard streams that the caller closed, so that no file of this program gets their numbers and
/// what is printed. Writing to such a stdout still fails.
void openClosedStreams();

/// The error of a stdout that failed; errno may still say why.
MachineError unwrittenOutput();

/// Writes what is buffered. Throws MachineError if any of this program's output couldn't be written.
void finishStandardOutput();

} // namespace plumbline
