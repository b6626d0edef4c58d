// JOB.json: any bytes are refused with a code of rejected input, or give a job that is written and read again as the
// same; a small program is checked with it wherever its tools and its part can be.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "engine/cam/check/turning_check.h"
#include "engine/cam/job_file.h"
#include "engine/core/error.h"

namespace {

const char* const program =
    "G21 G18 G40 G99\nT0101\nG0 X40. Z3.\nG1 Z-20. F.2\nG2 X50. Z-25. R5.\nG0 X60.\nT0202\nG0 Z2.\nX-1.\nG1 Z0. F.1\n"
    "X18.\nG3 X20. Z-1. R1.\nG1 Z-30.\nX40. Z-90.\nG0 X80. Z3.\nT0808\nZ-10.\nG1 X10.\nG0 X80.\nM30\n";

void check(const lathelier::cam::Job& job)
{
    constexpr double longest_mm = 300;
    constexpr std::size_t most_tools = 20;
    if (!job.shaft || job.tools.size() > most_tools || !(job.shaft->length_mm() < longest_mm)) return;
    const auto result = lathelier::cam::checkTurning(program, *job.shaft, job);
    if (result.path.has_errors || !std::isfinite(result.gouge_um) || !std::isfinite(result.left_max_mm)) std::abort();
    for (const auto& rest : result.rest)
        if (!(rest.z_start_mm <= rest.z_end_mm) || !std::isfinite(rest.left_mm)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    try {
        Notes notes;
        const cam::Job job = cam::readJob(std::string(reinterpret_cast<const char*>(data), size), notes);
        Notes again;
        if (!(cam::readJob(cam::jobText(job), again) == job)) std::abort();
        check(job);
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::InputRejected) std::abort();
    }
    return 0;
}
