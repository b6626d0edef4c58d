// Limits of changes to the rows by hand.
#pragma once

#include <array>
#include <cstddef>

namespace lathelier::features {

/// Where no origin is stated, a value was chosen by trying changes on the practice scans.
struct RefitLimits {
    std::size_t most_changes = 1000;  ///< read from a text
    double parallel_slope = 0.02;     ///< lines with a smaller difference of slopes have no well-defined intersection
    double chosen_place_sigma_mm = 0.05;  ///< standard uncertainty of a place chosen by hand
    double deleted_row_part = 4;          ///< of a deleted row's length: the same where its neighbours are parallel
    double least_row_mm = 0.02;           ///< length of a row after a cut
    double least_length_mm = 1e-9;        ///< against division by 0
    std::array<double, 2> arc_chords{0.75, 1.5};  ///< starting radii of an arc over its chord
    int arc_iterations = 12, iterations = 25;     ///< of the fit of a changed arc and of the whole
};

inline constexpr RefitLimits refitLimits;

}  // namespace lathelier::features
