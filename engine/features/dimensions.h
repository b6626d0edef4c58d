// Rows of a table and their uncertainties from a settled model.
#pragma once

#include <vector>

#include "engine/features/outline.h"

namespace lathelier::features {

/// What the statistics of the fit do not know and is added to every U.
struct AddedUncertainty {
    double scanner_um = 0;  ///< systematic, in quadrature
    double ovality_um = 0;  ///< of the diameter, where only a part of the circle is seen, in quadrature
};

/// How much the diameter is off for each µm of a two-lobed form (radius) when only this arc of the circle is seen.
double ovalityFactor(double coverage_deg);

/// Rows in order of z (from `zero_mm`, the free end). Uncertainties: k = 2, by numeric derivatives of the resolved
/// model.
std::vector<RecognizedRow> rowsOf(const Outline& outline, double zero_mm, double coverage_deg,
                                  const AddedUncertainty& added);

/// The walls that were fitted, with what is left of them; `first_row` is added to their rows.
void addMeridian(const Outline& outline, double zero_mm, bool bore, std::int32_t first_row,
                 std::vector<MeridianPoint>& points);

}  // namespace lathelier::features
