// Axial shift between two bodies of revolution, estimated from matched shoulders and tapers.
#pragma once

#include <optional>

#include "engine/registration/revolution/revolution.h"

namespace lathelier::registration {

struct AxialShift {
    double shift;     ///< reference z = copy z + shift, mm
    double variance;  ///< mm²
};

/// Inverse-variance mean of the axial shifts from all shoulders and tapers that match when the copy is moved by about
/// `shift`; nullopt when none match. The ends of the data are not used.
std::optional<AxialShift> estimateAxialShift(const TurnedPart& reference, const TurnedPart& copy, double shift);

}  // namespace lathelier::registration
