// Time and size of a report.
#pragma once

namespace plumbline {

/// For sixteen techniques on stone_torus, 800 x 600: seconds and bytes, with the goals.
void printReport();

} // namespace plumbline
