// Prediction and measurement of a chain from the results of its steps, on one z: that of the drawing.
#pragma once

#include <optional>
#include <vector>

#include "engine/chain/normalized_error.h"
#include "engine/report/document.h"

namespace lathelier::chain {

/// The copy's diameter at a place, as the mean deviation of its surface there.
struct MeasuredPlace {
    double z_mm = 0;            ///< middle of the stretch, from the free end
    double error_um = 0;        ///< of the diameter against the drawing
    double uncertainty_um = 0;  ///< U
    std::int64_t row = 0;       ///< of the drawing, that it lies in, from 1
};

/// Of the result of deflection. `zero_mm`: z of its stock less z of the part; `mirrored_length_mm`: length of the part
/// where the clamping counts z from its other end; 0: it does not.
PredictedErrors predictedErrors(const Json& deflected, double zero_mm, double mirrored_length_mm = 0);

/// Both clampings on one z: the first one up to `split_mm`, the second one behind.
PredictedErrors joined(const PredictedErrors& first, const PredictedErrors& second, double split_mm);

/// Diameters of rows, from the results of `draw` and `compare`.
std::vector<MeasuredError> measuredErrors(const Json& drawn, const Json& compared);

/// Along z, from the zones of the comparison that lie within one cylinder, clear of its ends.
std::vector<MeasuredPlace> measuredPlaces(const Json& drawn, const Json& compared);

/// The result of the step: places, the largest E_n, what was measured along z, and the prediction itself.
Json proofJson(const PredictedErrors& predicted, const std::vector<ComparedError>& places,
               const std::vector<MeasuredPlace>& along);

/// A proof as proofJson() has it.
struct Proof {
    PredictedErrors predicted;
    std::vector<ComparedError> places;
    std::vector<MeasuredPlace> along;
};

/// None: it is no proof.
std::optional<Proof> proofFrom(const Json& json);

/// The prediction with its band, the rows with U and the places over it.
report::Plot proofPlot(const Proof& proof);

/// Row, predicted, measured, both with U, E_n.
report::Table proofTable(const Proof& proof);

}  // namespace lathelier::chain
