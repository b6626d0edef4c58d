// Stock of each clamping for the deflection: from its free end to the chuck face.
#pragma once

#include <optional>

#include "engine/cam/clampings.h"
#include "engine/deflection/setup.h"

namespace lathelier::chain {

/// Stock of one clamping and its z origin.
struct HeldBar {
    Shaft bar;                 ///< from the free end to the chuck face
    double z_zero_mm = 0;      ///< z of the program zero from the free end
    bool is_mirrored = false;  ///< program z counts from the other end of the part
};

/// First clamping: the raw bar.
HeldBar firstBar(const cam::Job& job);

/// Second clamping: raw up to the stretch finished in the first clamping, finished beyond. None: the part cannot be
/// split or gripped. Shoulders are assumed as drawn.
std::optional<HeldBar> secondBar(const Shaft& part, const cam::Job& job);

/// The set-up for a clamping: its bar as a file of that name, without tailstock in the second clamping.
deflection::TurningSetup setupFor(deflection::TurningSetup setup, const HeldBar& held, const std::string& bar_file);

}  // namespace lathelier::chain
