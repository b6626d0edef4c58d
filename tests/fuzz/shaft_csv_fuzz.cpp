// Shafts as CSV: any bytes are refused with a code of rejected input, or give a table that is written and read to the
// same.
#include <cstdint>
#include <cstdlib>

#include "engine/cad/shaft_csv.h"
#include "engine/core/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    try {
        Notes notes;
        const Shaft shaft = cad::readShaftCsv({reinterpret_cast<const char*>(data), size}, notes);
        const std::string text = cad::shaftCsv(shaft);
        if (shaft.segments.empty() && shaft.bores.empty()) return 0;
        if (cad::shaftCsv(cad::readShaftCsv(text, notes)) != text) std::abort();
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::InputRejected) std::abort();
    }
    return 0;
}
