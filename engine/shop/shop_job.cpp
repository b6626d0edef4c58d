#include "engine/shop/shop_job.h"

#include <algorithm>

#include "engine/cam/job_library.h"
#include "engine/receptance/library.h"
#include "engine/shaft/shaft_codes.h"
#include "engine/shop/bar_sizes.h"
#include "engine/shop/shop_codes.h"

namespace lathelier::shop {
namespace {

double largestDiameter_mm(const Shaft& part)
{
    double largest = 0;
    for (const ShaftSegment& row : part.segments)
        largest = std::max({largest, row.start_diameter_mm, row.end_diameter_mm});
    return largest;
}

double meanDiameter_mm(const Shaft& part)
{
    double area = 0, length = 0;
    for (const ShaftSegment& row : part.segments) {
        area += row.length_mm * (row.start_diameter_mm + row.end_diameter_mm) / 2;
        length += row.length_mm;
    }
    return length > 0 ? area / length : 0;
}

/// The bore where the centre would be.
bool isBoredAtFreeEnd(const Shaft& part)
{
    return std::any_of(part.bores.begin(), part.bores.end(),
                       [](const ShaftBore& bore) { return bore.from == ShaftEnd::Free; }) ||
           (!part.segments.empty() && part.segments.front().bore_diameter_mm > 0);
}

void checkSize(const Lathe& lathe, Text what, double found_mm, const std::optional<double>& most_mm)
{
    if (!most_mm || found_mm <= *most_mm) return;
    throw Error(errors::partLargerThanLathe,
                {{"what", what}, {"found_mm", found_mm}, {"most_mm", *most_mm}, {"lathe", lathe.name}});
}

template <class T>
void assume(Text what, const Chosen<T>& chosen, Notes& notes)
{
    if (!chosen.is_assumed) return;
    notes.push_back({notes::ofShop, {{"what", what}, {"value", chosen.value.name}, {"source", chosen.source}}});
}

}  // namespace

cam::Job jobOf(const Shop& shop, const Shaft& part)
{
    if (part.segments.empty()) throw Error(errors::shaftEmpty, {});
    const Lathe& lathe = shop.lathe.value;
    const Chuck& chuck = shop.chuck.value;
    const BarMaterial& material = shop.material.value;
    const double diameter_mm = largestDiameter_mm(part), length_mm = part.length_mm();
    const auto bar_mm = barFor_mm(diameter_mm + material.diameter_allowance_mm);
    if (!bar_mm)
        throw Error(errors::partLargerThanBars,
                    {{"diameter_mm", diameter_mm}, {"largest_mm", barDiameters_mm().back()}});
    checkSize(lathe, LT_TEXT("Engine", "in diameter"), *bar_mm, lathe.swing_mm);
    checkSize(lathe, LT_TEXT("Engine", "long"), length_mm, lathe.distance_mm);

    cam::Job job;
    job.title = part.name;
    job.stock.diameter_mm = *bar_mm;
    job.stock.face_allowance_mm = material.face_allowance_mm;
    job.tools = shop.tools.value.tools;
    for (cam::JobTool& tool : job.tools) tool.settle();
    const cam::JobTool* const blade = job.toolFor(cam::ToolUse::PartOff);
    job.part_off = blade && cam::withLibrary(job).partingBlade()->reach_mm.value_or(0) > *bar_mm / 2;
    job.setup.chuck_face_z_mm =
        length_mm + chuck.clearance_mm + (job.part_off ? blade->width_mm.value_or(assumed::width_mm) : 0);
    job.setup.jaw_diameter_mm = chuck.jaw_diameter_mm;
    job.setup.grip_length_mm = chuck.grip_length_mm;
    job.setup.power_kW = lathe.power_kW;
    job.setup.efficiency = lathe.efficiency;
    if (shop.tailstock && !isBoredAtFreeEnd(part) &&
        length_mm >= shop.tailstock->value.from_slenderness * meanDiameter_mm(part)) {
        job.setup.tailstock.emplace().centre_hole_mm = shop.tailstock->value.centre_hole_mm;
    }
    job.cutting = {material.name, material.rough, material.finish};
    job.max_rpm = lathe.max_rpm;
    return job;
}

deflection::TurningSetup setupOf(const Shop& shop, const cam::Job& job)
{
    const BarMaterial& material = shop.material.value;
    const Chuck& chuck = shop.chuck.value;
    deflection::TurningSetup setup;
    setup.z_zero_mm = job.stock.face_allowance_mm;
    if (const auto* const elastic = entryOf(receptance::materials(), material.elastic))
        setup.material.elastic = elastic->value;
    setup.material.cutting = material.cutting;
    const cam::Job whole = cam::withLibrary(job);
    if (const cam::JobTool* const finisher = whole.toolFor(cam::ToolUse::Finish)) setup.tool = Tool(*finisher);
    setup.chuck.radial_N_mm = chuck.springs.radial_N_mm;
    setup.chuck.tilt_N_mm_rad = chuck.springs.tilt_N_mm_rad;
    if (job.setup.tailstock && shop.tailstock) {
        setup.tailstock.emplace().radial_N_mm = shop.tailstock->value.radial_N_mm;
        setup.tailstock->tilt_N_mm_rad = shop.tailstock->value.tilt_N_mm_rad;
    }
    return setup;
}

receptance::SpindleReceptance chuckFaceOf(const Shop& shop)
{
    return {shop.chuck.value.springs};
}

Notes assumptionsOf(const Shop& shop)
{
    Notes notes;
    assume(LT_TEXT("Engine", "Lathe"), shop.lathe, notes);
    assume(LT_TEXT("Engine", "Chuck"), shop.chuck, notes);
    if (shop.tailstock) assume(LT_TEXT("Engine", "Tailstock"), *shop.tailstock, notes);
    assume(LT_TEXT("Engine", "Set of tools"), shop.tools, notes);
    assume(LT_TEXT("Engine", "Material"), shop.material, notes);
    return notes;
}

}  // namespace lathelier::shop
