#include "scenes/core/write_error.h"

#include "scenes/core/error.h"

#include <cerrno>
#include <cstring>

namespace plumbline {
namespace {

bool isOfMachine(int error) {
    switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG: // a file-size limit
    case EIO:
    case ENOMEM:
    case EMFILE:
    case ENFILE:
    case ESTALE: // a network file system lost it
    case ENOLCK:
    case ENOSYS:
    case EOPNOTSUPP:
        return true;
    default:
        return false;
    }
}

} // namespace

void failWrite(const std::filesystem::path& file, int error) {
    const std::string what = std::string("can't be written: ") + std::strerror(error);
    if (isOfMachine(error)) throw MachineError(file.string(), what);
    throw InputError(file.string(), what, "a place for results that may be written");
}

} // namespace plumbline
