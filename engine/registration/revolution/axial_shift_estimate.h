// What shoulders and slopes say about the shift along the axis between two bodies of revolution.
#pragma once

#include <optional>

#include "engine/registration/revolution/revolution.h"

namespace lathelier::registration {

struct AxialShift {
    double shift;     ///< reference z = copy z + shift, mm
    double variance;  ///< mm²
};

/// The weighted word of all shoulders and slopes that the two parts have in common when the copy is moved by about
/// `shift`; nullopt where there is none. Never from where the data end.
std::optional<AxialShift> estimateAxialShift(const TurnedPart& reference, const TurnedPart& copy, double shift);

}  // namespace lathelier::registration
