#include "engine/cam/drawn_features.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/cam/threads.h"
#include "engine/core/units.h"
#include "engine/shaft/shaft_bores.h"

namespace lathelier::cam {
namespace {

DrawnFeature featureOf(const ShaftBore& bore, double part_length_mm)
{
    DrawnFeature feature;
    feature.kind = MarkKind::Bore;
    double length = 0, largest = 0;
    for (const BoreSegment& row : bore.segments) {
        length += row.length_mm;
        largest = std::max({largest, row.start_diameter_mm, row.end_diameter_mm});
    }
    const bool is_from_free = bore.from == ShaftEnd::Free;
    feature.z_start_mm = is_from_free ? 0 : part_length_mm - length;
    feature.z_end_mm = is_from_free ? length : part_length_mm;
    feature.diameter_mm = largest;
    return feature;
}

}  // namespace

std::vector<DrawnFeature> featuresBesideOutside(const Shaft& part)
{
    std::vector<DrawnFeature> all;
    for (const ShaftBore& bore : boresOf(part)) all.push_back(featureOf(bore, part.length_mm()));
    for (const DrawnThread& thread : threadsOf(part))
        all.push_back({MarkKind::Thread, thread.z_start_mm, thread.z_end_mm, thread.major_mm, thread.designation});
    for (const ShaftMark& mark : part.marks) {
        if (mark.kind == MarkKind::Thread || mark.kind == MarkKind::Sphere)
            continue;  // among those above, or in the rows
        all.push_back({mark.kind, mark.z_start_mm, mark.z_end_mm, mark.diameter_mm, mark.designation, mark.other_kind});
    }
    return all;
}

std::string key(const DrawnFeature& feature)
{
    return feature.kind == MarkKind::Other ? feature.other_kind : key(feature.kind);
}

Value nameOf(const DrawnFeature& feature)
{
    return feature.kind == MarkKind::Other ? Value(feature.other_kind) : Value(nameOf(feature.kind));
}

Values valuesOf(const DrawnFeature& feature)
{
    const auto size = [](const std::optional<double>& stated) { return stated ? Value(*stated) : Value(); };
    return {{"feature", nameOf(feature)},
            {"z_start_mm", size(feature.z_start_mm)},
            {"z_end_mm", size(feature.z_end_mm)},
            {"diameter_mm", size(feature.diameter_mm)},
            {"designation", feature.designation}};
}

std::string plainText(const DrawnFeature& feature)
{
    std::string text = key(feature);
    std::replace(text.begin(), text.end(), '_', ' ');
    if (!feature.designation.empty())
        text += " " + feature.designation;
    else if (feature.diameter_mm)
        text += fmt::format(" D{:g}", *feature.diameter_mm);
    if (feature.z_start_mm && feature.z_end_mm)
        text += fmt::format(" z {:g}-{:g}", *feature.z_start_mm, *feature.z_end_mm);
    return text;
}

bool isThreaded(const DrawnFeature& feature, std::span<const gcode::Move> moves, double zero_mm)
{
    if (feature.kind != MarkKind::Thread || !feature.z_start_mm || !feature.z_end_mm) return false;
    for (std::size_t i = 1; i < moves.size(); ++i) {
        if (moves[i].kind != gcode::MoveKind::Thread) continue;
        const double a = zero_mm - moves[i - 1].z_mm, b = zero_mm - moves[i].z_mm;
        if (std::max(a, b) > *feature.z_start_mm && std::min(a, b) < *feature.z_end_mm) return true;
    }
    return false;
}

const std::vector<QuantityOf<DrawnFeature>>& quantitiesOf(const DrawnFeature*)
{
    using R = DrawnFeature;
    static const auto all = describedBy<R>(
        quantity<R>("kind", [](const R& r) { return key(r); }),
        quantity<R>("feature", [](const R& r) { return nameOf(r); }, {LT_TEXT("Engine", "Feature"), {}, 0, false}),
        quantity<R>("z_start_mm", &R::z_start_mm, {LT_TEXT("Engine", "From z"), unit::mm, 2}),
        quantity<R>("z_end_mm", &R::z_end_mm, {LT_TEXT("Engine", "To z"), unit::mm, 2}),
        quantity<R>("diameter_mm", &R::diameter_mm, {LT_TEXT("Engine", "Diameter"), unit::mm, 3}),
        quantity<R>("designation", &R::designation, {LT_TEXT("Engine", "Designation"), {}, 0}));
    return all;
}

}  // namespace lathelier::cam
