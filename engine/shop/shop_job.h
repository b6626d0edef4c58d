// Job, set-up and chuck face of a part in a shop: what the turning program, deflection and dynamics need, without a
// file of ours.
//
// Bar: the smallest listed diameter (bar_sizes.h) with the allowance of the material. Chuck face: behind the part's end
// by the clearance of the chuck, and by the width of the parting blade where its reach suffices to cut the bar off.
// Tailstock: for slender parts without a bore at the free end.
#pragma once

#include <optional>

#include "engine/cam/job.h"
#include "engine/core/error.h"
#include "engine/deflection/setup.h"
#include "engine/receptance/spindle/spindle_receptance.h"
#include "engine/shop/shop.h"

namespace lathelier::shop {

/// The job without the shaft. Errors: partLargerThanBars, partLargerThanLathe; shaftEmpty.
cam::Job jobOf(const Shop& shop, const Shaft& part);

/// The set-up of deflection for that job: the first finishing tool, springs of chuck and, where the job has one, of the
/// tailstock. Its stock is that of the job and is not stated.
deflection::TurningSetup setupOf(const Shop& shop, const cam::Job& job);

receptance::SpindleReceptance chuckFaceOf(const Shop& shop);

/// One note for each entry of the built-in library that the shop has: assumed, since no person stated it. Notes:
/// ofShop.
Notes assumptionsOf(const Shop& shop);

}  // namespace lathelier::shop
