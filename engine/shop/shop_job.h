// Job, set-up and chuck face of a part in a shop: what the turning program, deflection and dynamics need, without a
// file of ours.
//
// Bar: the smallest listed diameter (bar_sizes.h) with the allowance of the material. Chuck face: behind the part's end
// by the clearance of the chuck, and by the width of the parting blade where its reach suffices to cut the bar off.
// Tailstock: for slender parts whose free end has no bore and room for the centre hole.
#pragma once

#include <optional>

#include "engine/cam/job.h"
#include "engine/core/error.h"
#include "engine/deflection/setup_item.h"
#include "engine/receptance/spindle/spindle_receptance.h"
#include "engine/shop/shop.h"

namespace lathelier::shop {

/// The job without the shaft. Errors: partLargerThanBars, partLargerThanLathe; shaftEmpty.
cam::Job jobOf(const Shop& shop, const Shaft& part);

/// The set-up of deflection for a job: its first finishing tool, springs of chuck and, where the job has one, of the
/// tailstock; its stock is the bar of the job up to the chuck face, and the program's zero the finished free end.
deflection::HeldSetup setupOf(const Shop& shop, const cam::Job& job);

/// The same for a stock that is stated elsewhere: without a stock, the program's zero at its free end.
deflection::TurningSetup setupOfStock(const Shop& shop, const Shaft& stock);

receptance::SpindleReceptance chuckFaceOf(const Shop& shop);

/// Entries of a shop that something was made of.
struct UsedEntries {
    bool lathe = false;
    bool chuck = false;
    bool tailstock = false;
    bool tools = false;
    bool material = false;
};

UsedEntries usedBy(const cam::Job& job);                   ///< of jobOf(): all; the tailstock where it has one
UsedEntries usedBy(const deflection::TurningSetup& made);  ///< of setupOf(): all but the lathe, likewise
UsedEntries usedByChuckFace();                             ///< of chuckFaceOf(): the chuck

/// Adds a note for each used entry of the built-in library, unless the notes have it: assumed, since no person stated
/// it. Notes: ofShop.
void noteAssumed(const Shop& shop, const UsedEntries& used, Notes& notes);

}  // namespace lathelier::shop
