// An end of the hits in the rows of a rotary scanner: is it the part's, and where?
#pragma once

#include <optional>

#include "engine/features/outline/edges.h"
#include "engine/registration/revolution/scanner_axis.h"

namespace lathelier::features {

/// The first end of an outline, or the last, and what its rows say of it. The ratio is that of two marginal
/// likelihoods. The part's end is a plane across the part's axis, blurred by the spot, anywhere between the rows; that
/// of the data lies between two rows, the first of them whole, the second empty. ln is about 0 where all rays end in
/// one row, and the distance of the rows excludes neither. Hits are the points between the smallest and the largest
/// radius that the model has within the spot, for a thread from its root to its crests. nullopt: too few rows before
/// the end, or sectors of the circle in which they are whole.
std::optional<EndPlace> endInRows(const MeridianCloud& cloud, const Model& model, bool start,
                                  const registration::ScannerAxis& scanner);

}  // namespace lathelier::features
