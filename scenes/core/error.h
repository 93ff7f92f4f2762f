// Errors a person can act on. Two kinds, distinguished by the program's exit code:
//   InputError    what the user gave is wrong (exit 2)
//   MachineError  this machine lacks something the command needs (exit 3)
// A broken invariant of the program itself is an assertion, not one of these.
//
// A message is one line: "where: what; expected …; hint". `where` names the file, the line or the field.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace plumbline {

/// Bad input or usage. `expected` and `hint` may be empty; `hint` is a complete clause ("did you mean
/// 'torus'?").
class InputError : public std::runtime_error {
  public:
    InputError(std::string_view where, std::string_view what, std::string_view expected = {},
               std::string_view hint = {});
};

/// The machine lacks something: no OpenGL, no such device, no memory.
class MachineError : public std::runtime_error {
  public:
    MachineError(std::string_view where, std::string_view what, std::string_view expected = {},
                 std::string_view hint = {});
};

/// "did you mean 'x'?" for the choice closest to `name` by edit distance; empty if none is close enough.
std::string didYouMean(std::string_view name, std::span<const std::string> choices);

/// "a, b or c".
std::string listOf(std::span<const std::string> choices);

} // namespace plumbline
