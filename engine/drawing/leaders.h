// Placement of leader texts: boundary labelling with vertical leaders above a view.
#pragma once

#include <vector>

namespace lathelier::drawing {

struct LeaderText {
    double x_mm = 0;      ///< of the place that it points at
    double width_mm = 0;  ///< of the text
};

struct LeaderPlace {
    double x_mm = 0;       ///< of the vertical part
    int lane = 0;          ///< 0: nearest to the view
    bool to_left = false;  ///< the text stands left of the leader, else right
};

/// The positions nearest to `sorted` (least squares) that are at least `spacing_mm` apart.
std::vector<double> spread(const std::vector<double>& sorted, double spacing_mm);

/// Leaders keep the order of their places and at least `spacing_mm` between them (least squares of the moves). Texts of
/// the first ones stand to the left and of the others to the right, each in the lowest lane where it crosses no leader
/// that ends higher; where the sides part is chosen so that lanes are fewest. Results in the order of `texts`.
/// Cost n³ for n texts.
std::vector<LeaderPlace> placeLeaders(const std::vector<LeaderText>& texts, double spacing_mm);

}  // namespace lathelier::drawing
