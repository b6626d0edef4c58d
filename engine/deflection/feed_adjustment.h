// The feed along z that keeps the last pass within a tolerance: an alternative to correcting X.
#pragma once

#include <vector>

#include "engine/core/fields.h"
#include "engine/deflection/deflection.h"

namespace lathelier::deflection {

struct FeedParameters {
    double tolerance_um = 20;         ///< of |e| on diameter
    double least_feed_mm_rev = 0.05;  ///< lower bound, below which the edge rubs
    double largest_feed_mm_rev = 0.4;
    friend bool operator==(const FeedParameters&, const FeedParameters&) = default;
};

const std::vector<Field<FeedParameters>>& fieldsOf(const FeedParameters*);

struct FeedResult {
    FeedParameters parameters;
    std::vector<double> z_mm;               ///< ends of the pieces, ascending
    std::vector<double> feed_mm_rev;        ///< of the piece ending there
    std::vector<double> diameter_error_um;  ///< of the last pass with these feeds
    double max_um = 0;                      ///< largest |e|
    double time_ratio = 1;                  ///< time in cut over that with the programmed feed at the same speed
    Notes notes;                            ///< feedCannotHold
};

/// The largest feed at each piece whose error, with the same feed all along, is within the tolerance; the pass is then
/// cut with these. Error noCut. Cost: 24 passes.
FeedResult feedForTolerance(const WorkPlan& plan, const TurningSetup& setup, const FeedParameters& parameters = {});

}  // namespace lathelier::deflection
