// Axial shift between two bodies of revolution, estimated from matched shoulders and tapers.
#pragma once

#include <optional>

#include "engine/registration/revolution/revolution.h"

namespace lathelier::registration {

struct AxialShift {
    double shift;     ///< reference z = copy z + shift, mm
    double variance;  ///< mm²
};

/// Inverse-variance mean of the axial shifts from all shoulders, tapers and end faces that match when the copy is moved
/// by about `shift`; nullopt when none match. Where the data end without a face is not used.
std::optional<AxialShift> estimateAxialShift(const TurnedPart& reference, const TurnedPart& copy, double shift);

}  // namespace lathelier::registration
