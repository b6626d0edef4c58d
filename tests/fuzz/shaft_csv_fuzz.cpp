// Shafts as CSV: any bytes are refused with a code of rejected input, or give a table whose numbers are written and
// read to the same.
#include <cstdint>
#include <cstdlib>

#include "engine/cad/shaft_csv.h"
#include "engine/core/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    try {
        Notes notes;
        Shaft shaft = cad::readShaftCsv({reinterpret_cast<const char*>(data), size}, notes);
        for (ShaftSegment& row : shaft.segments) {  // blanks and quotes of words are not kept
            row.role.clear();
            if (row.tolerance) row.tolerance->iso_class.clear();
        }
        for (ShaftBore& bore : shaft.bores)
            for (BoreSegment& row : bore.segments) row.role.clear();
        const std::string text = cad::shaftCsv(shaft);
        if (shaft.segments.empty() && shaft.bores.empty()) return 0;
        if (cad::shaftCsv(cad::readShaftCsv(text, notes)) != text) std::abort();
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::InputRejected) std::abort();
    }
    return 0;
}
