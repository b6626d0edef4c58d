// Sizes of a keyway from its rim in the wall of the shaft.
//
// Rays toward the axis pass the upper edges of a slot and see only the part of its floor between them: a floor seen
// over w at the distance h from the axis belongs to a slot 2R·sin(atan(w/2h)) wide. Rays of other directions see all of
// it. The rim does not depend on the rays; its round ends place its sides between two columns of rays.
#pragma once

#include <optional>

#include "engine/features/marks/wall_rays.h"
#include "engine/shaft/shaft.h"

namespace lathelier::features {

/// Width with U, ends and depth of the slot `mark` (its z and floor are those of the floor seen, `width_mm` that of the
/// floor) and, where it is one of DIN 6885-1, its designation. Returns false and changes nothing where the rim is not
/// that of a slot. Throws Cancelled.
bool measureSlot(const WallScan& scan, ShaftMark& mark, const Progress& progress = {});

/// "DIN 6885 - A 8×7×40": the key whose slot this is, by the width and the range of shaft diameters; empty: none.
std::string keyOf(const ShaftMark& slot, double shaft_mm, bool round_ends);

}  // namespace lathelier::features
