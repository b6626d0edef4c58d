// One contour with suggested sizes in place: the geometry behind snap.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/features/nominal/row_chain.h"

namespace lathelier::features {

/// A row of the resulting contour in u.
struct PlacedRow {
    static constexpr std::ptrdiff_t none = -1;
    double start_u_mm = 0, end_u_mm = 0;
    double start_mm = 0, end_mm = 0;      ///< diameters at its start and its end
    std::optional<double> arc_radius_mm;  ///< none: straight
    std::string role;                     ///< as ShaftSegment::role
    std::ptrdiff_t source = none;  ///< row of the chain; `none`: a gap's bridge or a relieved face that was not seen
    std::optional<SizeTolerance> tolerance = {};  ///< of a cylinder whose nominal diameter is in place
};

/// Rows of the chain, with the suggestions of those rows in place for which `in_place` holds (one flag for each row).
/// `end_mm`: where the contour has to end; none: at the end of its rows.
std::vector<PlacedRow> placedRows(const RowChain& chain, const std::vector<bool>& in_place,
                                  std::optional<double> end_mm = {});

}  // namespace lathelier::features
