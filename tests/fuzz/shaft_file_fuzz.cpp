// Files of a shaft, SHAFT.json or stock: any bytes are refused with a code of rejected input, or give a shaft whose
// contour a beam takes or refuses.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "engine/beam/uniform_segments.h"
#include "engine/core/error.h"
#include "engine/io/shaft/shaft_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    try {
        Notes notes;
        const Shaft shaft = io::readShaftFile({reinterpret_cast<const char*>(data), size}, notes);
        if (shaft.segments.empty()) std::abort();
        for (const beam::UniformSegment& piece : beam::uniformSegments(shaft, {true, 50}))
            if (!(piece.length_mm > 0) || !(piece.stiffness_outer_mm <= piece.outer_mm) ||
                !(piece.stiffness_outer_mm > piece.bore_mm))
                std::abort();
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::InputRejected) std::abort();
    }
    return 0;
}
