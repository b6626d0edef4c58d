// Rows of a table and their uncertainties from a fitted model.
#pragma once

#include <vector>

#include "engine/features/outline/outline.h"

namespace lathelier::features {

/// Contributions to every U that the covariance of the fit does not contain.
struct AddedUncertainty {
    double scanner_um = 0;      ///< systematic, in quadrature
    double ovality_um = 0;      ///< of the diameter, where only a part of the circle is seen, in quadrature
    double passes_um = 0;       ///< of the radius, where passes of the scanner differ, in quadrature
    double variance_ratio = 1;  ///< of correlated noise to independent noise; multiplies the covariance
};

/// Error of the diameter per µm of a two-lobed form error (radius) when only this arc of the circle is seen.
double ovalityFactor(double coverage_deg);

/// Rows in order of z (from `zero_mm`, the free end). Uncertainties: k = 2, by numeric derivatives of the resolved
/// model.
std::vector<RecognizedRow> rowsOf(const Outline& outline, double zero_mm, double coverage_deg,
                                  const AddedUncertainty& added);

/// Appends the fitted walls with their residuals; `first_row` is added to their row indices.
void addMeridian(const Outline& outline, double zero_mm, bool bore, std::int32_t first_row,
                 std::vector<MeridianPoint>& points);

}  // namespace lathelier::features
