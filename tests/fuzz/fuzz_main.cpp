// Entry points of libFuzzer. The environment variable PLUMBLINE_FUZZ_TARGET names the target.
#include "tests/fuzz/fuzz_targets.h"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace {

const plumbline::FuzzTarget* target;

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    const char* name = std::getenv("PLUMBLINE_FUZZ_TARGET");
    target = plumbline::findFuzzTarget(name ? name : "");
    if (target) return 0;
    std::fputs("PLUMBLINE_FUZZ_TARGET must be one of:", stderr);
    for (const plumbline::FuzzTarget& each : plumbline::fuzzTargets())
        std::fprintf(stderr, " %s", std::string(each.name).c_str());
    std::fputs("\n", stderr);
    std::exit(2);
}

/// Any other exception is a finding, as are crashes, hangs and what the sanitizers report.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    try {
        target->read({data, size});
    } catch (const std::runtime_error&) { // InputError and MachineError too
    }
    return 0;
}
