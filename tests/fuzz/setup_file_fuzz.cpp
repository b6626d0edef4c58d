// SETUP.json: any bytes are refused with a code of rejected input, or give a set-up that is written and read again as
// the same.
#include <cstdint>
#include <cstdlib>

#include "engine/core/error.h"
#include "engine/deflection/setup_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    try {
        Notes notes;
        const deflection::TurningSetup setup =
            deflection::readSetup(std::string(reinterpret_cast<const char*>(data), size), notes);
        Notes again;
        if (!(deflection::readSetup(deflection::setupText(setup), again) == setup)) std::abort();
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::InputRejected) std::abort();
    }
    return 0;
}
