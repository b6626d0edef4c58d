// The shaft that a recognition describes: as measured, and with the suggested nominal sizes in place.
//
// Nominal: diameters of cylinders and the z of shoulders and ends (baseline dimensions) are put in place first; widths
// of grooves give their second wall. Then the rows between follow, so that the contour stays closed:
//   taper     between two cylinders its length from their diameters and its ratio, from its start on; at one cylinder
//             its other end; else through its middle
//   chamfer   from its shoulder or end: leg and angle; the cylinder keeps its diameter
//   arc       tangent to both neighbours: solved from them and its radius, so that length = R between a
//             cylinder and a face; tangent to one: scaled about that end; else its chord stays, the radius changes
//   undercut  DIN 509 rows from the shoulder's z and the cylinder's diameter; form F with its relieved face, which must
//             end below the shoulder's edge. Form F after its face stays as measured: a shaft cannot represent it.
// Sizes without suggestion stay as measured; corners between them keep their z. The result passes checkShaft():
// suggestions of rows that would break a rule are left out, in the extreme all of them.
//
// A gap in the data is bridged by a straight row with role "gap", for a shaft has no gaps (Recognition::complete is
// false there). An arc that runs behind the edge of an undercut face is cut at the face.
#pragma once

#include <vector>

#include "engine/features/recognition.h"
#include "engine/shaft/shaft.h"

namespace lathelier::features {

/// Rows, bores and marks as measured, each row with `measured` and its uncertainty; no name, no material. Precondition:
/// `segments` is not empty.
Shaft measuredShaft(const Recognition& recognition);

/// The same with the first suggestion of each quantity of each row in place (`describeRows()` first), whether it agrees
/// or not (agreeing_sizes.h); nominal diameters with their tolerance. Precondition: `segments` is not empty.
Shaft appliedNominal(const Recognition& recognition);

struct PlacedShaft {
    Shaft shaft;
    std::vector<std::ptrdiff_t> source;  ///< of each outer row, in Recognition::segments; PlacedRow::none: none
};
PlacedShaft placedNominal(const Recognition& recognition);

}  // namespace lathelier::features
