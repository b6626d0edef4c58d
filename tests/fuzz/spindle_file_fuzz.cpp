// SPINDLE.json: any bytes are refused with a code of rejected input, or give a spindle that is written and read again
// as the same.
#include <cstdint>
#include <cstdlib>

#include "engine/core/error.h"
#include "engine/receptance/spindle/spindle_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    try {
        Notes notes;
        const receptance::SpindleReceptance spindle =
            receptance::readSpindle(std::string(reinterpret_cast<const char*>(data), size), notes);
        Notes none;
        if (!(receptance::readSpindle(receptance::spindleText(spindle), none) == spindle) || !none.empty())
            std::abort();
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::InputRejected) std::abort();
    }
    return 0;
}
