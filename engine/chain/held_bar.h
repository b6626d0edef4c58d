// The bar of each clamping as deflection takes it: from its raw end to the face of the chuck.
#pragma once

#include <optional>

#include "engine/cam/clampings.h"
#include "engine/deflection/setup.h"

namespace lathelier::chain {

/// What the tool meets in one clamping, and where its z begins.
struct HeldBar {
    Shaft bar;                 ///< up to the chuck's face, from the raw end
    double z_zero_mm = 0;      ///< of the program, from the raw end
    bool is_mirrored = false;  ///< z of the program counts from the other end of the part
};

/// Of the first clamping: the raw bar.
HeldBar firstBar(const cam::Job& job);

/// Of the second one: raw up to where the first clamping has finished the part, the finished part behind. None: the
/// part cannot be split or gripped. Drawn shoulders are taken as turned.
std::optional<HeldBar> secondBar(const Shaft& part, const cam::Job& job);

/// The set-up for a clamping: its bar as a file of that name, and no tailstock where the second clamping has none.
deflection::TurningSetup setupFor(deflection::TurningSetup setup, const HeldBar& held, const std::string& bar_file);

}  // namespace lathelier::chain
