// An end of the hits in the rows of a rotary scanner: is it the part's, and where?
#pragma once

#include <optional>

#include "engine/features/model/model.h"
#include "engine/registration/revolution/scanner_axis.h"

namespace lathelier::features {

/// What the rows say of an end of the hits.
struct EndOfRows {
    /// ln of the ratio of two marginal likelihoods: the part ends here, to: the data do. The part's end is a plane
    /// across the part's axis, blurred by the spot, anywhere between the rows; that of the data lies between two rows,
    /// the first of them whole, the second empty. About 0 where all rays end in one row, and a row's distance does not
    /// exclude either.
    double log_ratio = 0;
    double z_mm = 0, sigma_mm = 0;    ///< of the part's end, if it is one: mean and standard deviation of its posterior
    double from_mm = 0, to_mm = 0;    ///< and the interval that holds 95 % of it
};

/// The first end of an outline, or the last. Hits are the points between the smallest and the largest radius that the
/// model has within the spot, for a thread from its root to its crests. nullopt: too few rows before the end, or
/// sectors of the circle in which they are whole.
std::optional<EndOfRows> endOfRows(const MeridianCloud& cloud, const Model& model, bool start,
                                   const registration::ScannerAxis& scanner);

}  // namespace lathelier::features
