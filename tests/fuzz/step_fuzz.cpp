// STEP files: any bytes are refused with a code that can be shown, or give a shaft that keeps the rules, and whose own
// file has its volume.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "engine/cad/step_reader.h"
#include "engine/core/error.h"
#include "engine/core/texts.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/shaft_rules.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    try {
        Notes notes;
        const cad::StepPart part = cad::readStep({reinterpret_cast<const char*>(data), size}, notes);
        checkShaft(part.shaft);
        const double volume = volume_mm3(part.shaft);
        if (!(part.volume_mm3 >= 0.89 * volume && part.volume_mm3 <= 1.01 * volume)) std::abort();
        if (!part.free_end_mm.allFinite() || std::abs(part.axis.norm() - 1) > 1e-9) std::abort();
        for (const Note& note : notes)
            if (text(note).empty()) std::abort();
    } catch (const Error& error) {
        if (text(error).empty() ||
            (error.code().kind != ErrorKind::InputRejected && error.code().kind != ErrorKind::NoAnswer))
            std::abort();
    }
    return 0;
}
