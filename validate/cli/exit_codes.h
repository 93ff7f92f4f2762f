// Exit codes of the program.
#pragma once

namespace plumbline {

inline constexpr int kExitDone = 0;
inline constexpr int kExitThreshold = 1; // a requirement isn't reached, or a regression
inline constexpr int kExitBadInput = 2;  // bad input or usage; also: a technique failed on its own files
inline constexpr int kExitMachine = 3;   // this machine lacks something
inline constexpr int kExitInternal = 70; // a fault of the program itself (EX_SOFTWARE of sysexits.h)

} // namespace plumbline
