#include "engine/shaft/bore_edit.h"

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/shaft/shaft_codes.h"

namespace lathelier {
namespace {

constexpr double coneLengthPerDiameter = 10;  // 1:10
constexpr double grooveDepth_mm = 1;          // on the radius
constexpr double leastShare = 0.1;            // of a diameter that narrows

}  // namespace

ShaftBores addBoreRow(ShaftBores bores, ShaftEnd from, double diameter_mm, double length_mm)
{
    const auto own = std::find_if(bores.begin(), bores.end(), [from](const ShaftBore& b) { return b.from == from; });
    if (own == bores.end()) {
        bores.push_back({from, {{length_mm, diameter_mm, diameter_mm, {}, {}}}});
        return bores;
    }
    const double bottom_mm = own->segments.empty() ? diameter_mm : own->segments.back().end_diameter_mm;
    const double narrower_mm = bottom_mm > 0 ? bottom_mm : diameter_mm;
    own->segments.push_back({length_mm, narrower_mm, narrower_mm, {}, {}});
    return bores;
}

ShaftBores insertBoreRow(ShaftBores bores, std::size_t bore, std::size_t row)
{
    std::vector<BoreSegment>& rows = bores.at(bore).segments;
    const BoreSegment& before = rows.at(row);
    const double diameter_mm = before.end_diameter_mm > 0 ? before.end_diameter_mm : before.start_diameter_mm;
    const BoreSegment added{before.length_mm, diameter_mm, diameter_mm, {}, {}};
    rows.insert(rows.begin() + static_cast<std::ptrdiff_t>(row) + 1, added);
    return bores;
}

ShaftBores deleteBoreRow(ShaftBores bores, std::size_t bore, std::size_t row)
{
    std::vector<BoreSegment>& rows = bores.at(bore).segments;
    rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(row));
    if (rows.empty()) bores.erase(bores.begin() + static_cast<std::ptrdiff_t>(bore));
    return bores;
}

ShaftBores setBoreDiameter(ShaftBores bores, std::size_t bore, std::size_t row, double diameter_mm)
{
    BoreSegment& edited = bores.at(bore).segments.at(row);
    const double by_mm = diameter_mm - edited.start_diameter_mm;
    edited.start_diameter_mm = diameter_mm;
    if (edited.end_diameter_mm > 0) edited.end_diameter_mm = std::max(0.0, edited.end_diameter_mm + by_mm);
    return bores;
}

ShaftBores setBoreDepth(ShaftBores bores, std::size_t bore, std::size_t row, double depth_mm)
{
    std::vector<BoreSegment>& rows = bores.at(bore).segments;
    double before_mm = 0;
    for (std::size_t i = 0; i < row; ++i) before_mm += rows[i].length_mm;
    if (!(depth_mm > before_mm))
        throw Error(errors::shaftRowWrong, {{"contour", LT_TEXT("Engine", "bore")},
                                            {"row", static_cast<std::int64_t>(row) + 1},
                                            {"quantity", LT_TEXT("Engine", "the depth in mm")},
                                            {"found", depth_mm},
                                            {"expected", LT_TEXT("Engine", "more than the rows before it are long")}});
    rows.at(row).length_mm = depth_mm - before_mm;
    return bores;
}

ShaftBores changeBoreForm(ShaftBores bores, std::size_t bore, std::size_t row, RowForm form)
{
    std::vector<BoreSegment>& rows = bores.at(bore).segments;
    BoreSegment& edited = rows.at(row);
    const double length_mm = edited.length_mm, mouth_mm = edited.start_diameter_mm;
    const auto narrower = [&](double by_mm) { return std::max(mouth_mm - by_mm, leastShare * mouth_mm); };
    edited.arc_radius_mm.reset();
    edited.role.clear();
    edited.end_diameter_mm = mouth_mm;
    switch (form) {
        case RowForm::Cylinder: break;
        case RowForm::Cone: edited.end_diameter_mm = narrower(length_mm / coneLengthPerDiameter); break;
        case RowForm::Chamfer:
            edited.end_diameter_mm = narrower(2 * length_mm);
            edited.role = "chamfer";
            break;
        case RowForm::Round:
        case RowForm::Fillet:
            edited.end_diameter_mm = narrower(2 * length_mm);
            edited.arc_radius_mm = form == RowForm::Round ? length_mm : -length_mm;
            edited.role = form == RowForm::Round ? "edge_round" : "fillet";
            break;
        case RowForm::Groove: {
            const double around_mm = row > 0 ? rows[row - 1].end_diameter_mm : mouth_mm;
            edited.start_diameter_mm = edited.end_diameter_mm = around_mm + 2 * grooveDepth_mm;
            edited.role = "groove";
            break;
        }
    }
    return bores;
}

}  // namespace lathelier
