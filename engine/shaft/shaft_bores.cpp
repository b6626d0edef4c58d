#include "engine/shaft/shaft_bores.h"

#include <algorithm>

namespace lathelier {

std::vector<ShaftBore> boresOf(const Shaft& shaft)
{
    if (!shaft.bores.empty()) return shaft.bores;
    const auto isBored = [](const ShaftSegment& row) { return row.bore_diameter_mm > 0; };
    if (std::none_of(shaft.segments.begin(), shaft.segments.end(), isBored)) return {};
    const auto rowOf = [](const ShaftSegment& row) {
        return BoreSegment{row.length_mm, row.bore_diameter_mm, row.bore_diameter_mm, {}, {}};
    };
    std::vector<ShaftBore> bores;
    const auto& rows = shaft.segments;
    const auto solid = [&](const ShaftSegment& row) { return !isBored(row) && row.length_mm > 0; };
    const auto first_solid = std::find_if(rows.begin(), rows.end(), solid);
    ShaftBore free{ShaftEnd::Free, {}};
    for (auto row = rows.begin(); row != first_solid; ++row)
        if (row->length_mm > 0) free.segments.push_back(rowOf(*row));
    if (!free.segments.empty()) bores.push_back(free);
    if (first_solid == rows.end()) return bores;
    ShaftBore chuck{ShaftEnd::Chuck, {}};
    for (auto row = rows.rbegin(); row != rows.rend() && !solid(*row); ++row)
        if (row->length_mm > 0) chuck.segments.push_back(rowOf(*row));
    if (!chuck.segments.empty()) bores.push_back(chuck);
    return bores;
}

}  // namespace lathelier
