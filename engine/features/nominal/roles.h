// Roles of the rows of a recognised part, the features they form, and suggested nominal sizes.
//
// Roles, from geometry alone:
//   chamfer     cone of 10° to 80°, shorter leg at most 6 mm, whose upper edge goes on in a row and whose lower one
//               lies at an end of the part or at a shoulder that falls further
//   edge_round  convex arc in the same place, or between two rows
//   fillet      hollow arc that rises or falls all along
//   saddle      hollow arc with its lowest point inside
//   groove      rows lower than both neighbours, 0.2 to 8 mm and at most half a diameter wide, between planes or flanks
//   undercut    pattern of DIN 509: cone of 15° ± 2°, bottom, hollow arc, face
//   taper       every other cone
//   thread, knurl  cylinder that such a mark covers by half
// "Upper" is away from the material's inside; in bores toward the axis.
//
// Features are of the outside only; every shoulder is one, but for the walls of grooves. A chamfer or round with a leg
// below 0.45 mm is an edge_break with a range of ±0.1 mm as designation, for its form is not certain; a larger
// edge_round is a "fillet". Designations come from suggestions and are empty without.
//
// Suggestions (nominal.h): diameters of cylinders and, where no cylinder has it, the large one of a taper; "z_mm" at
// the row that ends in a shoulder or in the end of the part, from the free end (bores: from their mouth), with the
// uncertainty of that origin; width of a groove as "length_mm", in place of the z of its second wall; legs, radii,
// tapers; an undercut of DIN 509 at its arc, in place of the sizes of its rows; a thread by the mark's crest.
// Rows with coverage below 180° get none.
#pragma once

#include "engine/features/recognition.h"

namespace lathelier::features {

/// Fills `role` and `suggestions` of every row of `segments` and `bores`, `features`, and the designation of threads
/// among `marks` that have none. Existing values are replaced. Parameters with Snap::None: no suggestions, no
/// designations.
void describeRows(Recognition& recognition);

}  // namespace lathelier::features
