// Predicted and measured errors from the results of the chain, in the z of the drawing.
#pragma once

#include <optional>
#include <vector>

#include "engine/chain/normalized_error.h"
#include "engine/report/document.h"

namespace lathelier::chain {

/// Diameter error of the copy at one z, from the mean deviation of its surface.
struct MeasuredPlace {
    double z_mm = 0;            ///< middle of the stretch, from the free end
    double error_um = 0;        ///< of the diameter against the drawing
    double uncertainty_um = 0;  ///< U
    std::int64_t row = 0;       ///< row of the drawing, from 1
};

/// From the result of deflection. `zero_mm`: z of its stock less z of the part; `mirrored_length_mm`: length of the
/// part if z of the clamping counts from the other end; 0: not mirrored.
PredictedErrors predictedErrors(const Json& deflected, double zero_mm, double mirrored_length_mm = 0);

/// Both clampings combined: the first up to `split_mm`, the second beyond.
PredictedErrors joined(const PredictedErrors& first, const PredictedErrors& second, double split_mm);

/// Diameters of rows, from the results of `draw` and `compare`.
std::vector<MeasuredError> measuredErrors(const Json& drawn, const Json& compared);

/// Along z, from the zones of the comparison that lie within one cylinder, away from its ends.
std::vector<MeasuredPlace> measuredPlaces(const Json& drawn, const Json& compared);

/// The result of the step: places, the largest E_n, measurements along z, and the prediction.
Json proofJson(const PredictedErrors& predicted, const std::vector<ComparedError>& places,
               const std::vector<MeasuredPlace>& along);

/// Content of proofJson().
struct Proof {
    PredictedErrors predicted;
    std::vector<ComparedError> places;
    std::vector<MeasuredPlace> along;
};

/// None: not a proof.
std::optional<Proof> proofFrom(const Json& json);

/// The largest difference against both uncertainties, |E_n| ≤ 1; a copy out of its limit is not a proof, even if it was
/// predicted well. `copy`: copyFinding(); none: no copy is judged. Precondition: there are places.
report::Answer proofAnswer(const Proof& proof, const std::optional<report::Finding>& copy);

/// The prediction with its band, the rows with U and the places over it.
report::Plot proofPlot(const Proof& proof);

/// Row, predicted, measured, both with U, E_n.
report::Table proofTable(const Proof& proof);

}  // namespace lathelier::chain
