#include "engine/features/nominal/snap.h"

#include <algorithm>
#include <cmath>

#include "engine/features/nominal/nominal_chain.h"
#include "engine/features/nominal/nominal_limits.h"
#include "engine/shaft/shaft_rules.h"

namespace lathelier::features {
namespace {

using Flags = std::vector<bool>;

/// `sense`: of the rows along z.
MeasuredSize measuredOf(const RecognizedRow& row, double sense)
{
    return {sense * (row.z_end_mm - row.z_start_mm), row.start_diameter_mm, row.end_diameter_mm, row.arc_radius_mm,
            row.uncertainty};
}

PlacedShaft outsideOf(const Recognition& recognition, const Flags& in_place)
{
    PlacedShaft made;
    for (const PlacedRow& row : placedRows(RowChain(recognition), in_place)) {
        ShaftSegment segment;
        segment.length_mm = row.end_u_mm - row.start_u_mm;
        segment.start_diameter_mm = row.start_mm;
        segment.end_diameter_mm = row.end_mm;
        segment.arc_radius_mm = row.arc_radius_mm;
        segment.role = row.role;
        segment.tolerance = row.tolerance;
        if (row.source != PlacedRow::none)
            segment.measured = measuredOf(recognition.segments[static_cast<std::size_t>(row.source)], 1);
        made.shaft.segments.push_back(std::move(segment));
        made.source.push_back(row.source);
    }
    made.shaft.marks = recognition.marks;
    if (recognition.parameters.unexplained == Unexplained::Damage) return made;
    for (const UnexplainedStructure& one : recognition.unexplained) {
        ShaftMark mark{MarkKind::Unexplained};
        mark.z_start_mm = one.z_start_mm;
        mark.z_end_mm = one.z_end_mm;
        mark.angle_deg = one.angle_deg;
        mark.deviation_mm = one.height_mm;
        made.shaft.marks.push_back(mark);
    }
    return made;
}

void addPlacedBores(Shaft& shaft, const Recognition& recognition, bool in_place)
{
    for (std::size_t i = 0; i < recognition.bores.size(); ++i) {
        if (recognition.bores[i].empty()) continue;
        const RowChain chain(recognition, i);
        // A through bore ends where the part does.
        std::optional<double> end_mm;
        if (chain.endsAtEnd()) end_mm = shaft.length_mm();
        ShaftBore bore{chain.isFromChuck() ? ShaftEnd::Chuck : ShaftEnd::Free, {}};
        for (const PlacedRow& row : placedRows(chain, Flags(chain.size(), in_place), end_mm)) {
            BoreSegment segment{row.end_u_mm - row.start_u_mm, row.start_mm, row.end_mm, row.arc_radius_mm, row.role};
            segment.tolerance = row.tolerance;
            if (row.source != PlacedRow::none)
                segment.measured =
                    measuredOf(chain.row(static_cast<std::size_t>(row.source)), chain.isFromChuck() ? -1 : 1);
            bore.segments.push_back(std::move(segment));
        }
        shaft.bores.push_back(std::move(bore));
    }
}

/// Rows of the recognition that an error of checkShaft() names, and their neighbours; all rows when it names none.
void leaveOut(const Error& error, const PlacedShaft& made, Flags& in_place)
{
    const Flags before = in_place;
    for (const char* name : {"row", "other_row"}) {
        const Value* value = find(error.values(), name);
        const auto* number = value ? std::get_if<std::int64_t>(value) : nullptr;
        if (!number || *number < 1 || *number > static_cast<std::int64_t>(made.source.size())) continue;
        // For a row without a recognised counterpart the one before it.
        auto place = static_cast<std::size_t>(*number - 1);
        while (place > 0 && made.source[place] == PlacedRow::none) --place;
        const auto row = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, made.source[place]));
        for (std::size_t i = row > 0 ? row - 1 : 0; i < std::min(row + 2, in_place.size()); ++i) in_place[i] = false;
    }
    if (in_place == before) in_place.assign(in_place.size(), false);
}

PlacedShaft measuredPlaced(const Recognition& recognition)
{
    PlacedShaft made = outsideOf(recognition, Flags(recognition.segments.size(), false));
    addPlacedBores(made.shaft, recognition, false);
    return made;
}

bool isSound(const Shaft& shaft)
{
    try {
        checkShaft(shaft);
        return true;
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

Shaft measuredShaft(const Recognition& recognition)
{
    return measuredPlaced(recognition).shaft;
}

Shaft appliedNominal(const Recognition& recognition)
{
    return placedNominal(recognition).shaft;
}

PlacedShaft placedNominal(const Recognition& recognition)
{
    Flags in_place(recognition.segments.size(), true);
    PlacedShaft made;
    while (true) {
        made = outsideOf(recognition, in_place);
        try {
            checkShaft(made.shaft);
            break;
        } catch (const Error& error) {
            if (std::none_of(in_place.begin(), in_place.end(), [](bool one) { return one; })) break;
            leaveOut(error, made, in_place);
        }
    }
    for (const bool nominal_bores : {true, false}) {
        PlacedShaft placed = made;
        addPlacedBores(placed.shaft, recognition, nominal_bores);
        if (isSound(placed.shaft)) return placed;
    }
    return measuredPlaced(recognition);
}

}  // namespace lathelier::features
