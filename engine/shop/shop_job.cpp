#include "engine/shop/shop_job.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/job_bodies.h"
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

/// Slender, and its free end has room for the centre.
bool usesTailstock(const Shop& shop, const Shaft& body)
{
    constexpr double land_mm = 1;  // of the end face around the centre hole
    if (!shop.tailstock || body.segments.empty() || isBoredAtFreeEnd(body)) return false;
    const Tailstock& tailstock = shop.tailstock->value;
    return body.segments.front().start_diameter_mm >= tailstock.centre_hole_mm + 2 * land_mm &&
           body.length_mm() >= tailstock.from_slenderness * meanDiameter_mm(body);
}

void checkSize(const Lathe& lathe, Text what, double found_mm, const std::optional<double>& most_mm)
{
    if (!most_mm || found_mm <= *most_mm) return;
    throw Error(errors::partLargerThanLathe,
                {{"what", what}, {"found_mm", found_mm}, {"most_mm", *most_mm}, {"lathe", lathe.name}});
}

template <class T>
void note(Text what, const Chosen<T>& chosen, Notes& notes)
{
    Note made{notes::ofShop, {{"what", what}, {"value", chosen.value.name}, {"source", chosen.source}}};
    const auto isSame = [&](const Note& one) { return one.code == made.code && one.values == made.values; };
    if (chosen.is_assumed && std::none_of(notes.begin(), notes.end(), isSame)) notes.push_back(std::move(made));
}

/// All but zero and stock.
deflection::TurningSetup commonSetup(const Shop& shop, std::vector<cam::JobTool> tools, bool has_tailstock)
{
    const BarMaterial& material = shop.material.value;
    const Chuck& chuck = shop.chuck.value;
    deflection::TurningSetup setup;
    if (const auto* const elastic = entryOf(receptance::materials(), material.elastic))
        setup.material.elastic = elastic->value;
    setup.material.cutting = material.cutting;
    cam::Job whole;
    whole.tools = std::move(tools);
    whole = cam::withLibrary(std::move(whole));
    if (const cam::JobTool* const finisher = whole.toolFor(cam::ToolUse::Finish)) setup.tool = Tool(*finisher);
    setup.chuck.radial_N_mm = chuck.springs.radial_N_mm;
    setup.chuck.tilt_N_mm_rad = chuck.springs.tilt_N_mm_rad;
    if (!has_tailstock || !shop.tailstock) return setup;
    deflection::HoldingSprings& tailstock = setup.tailstock.emplace();
    tailstock.radial_N_mm = shop.tailstock->value.radial_N_mm;
    tailstock.tilt_N_mm_rad = shop.tailstock->value.tilt_N_mm_rad;
    return setup;
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
    checkSize(lathe, LT_TEXT("Engine", "The diameter of the bar"), *bar_mm, lathe.swing_mm);
    checkSize(lathe, LT_TEXT("Engine", "The length of the part"), length_mm, lathe.distance_mm);

    cam::Job job;
    job.title = part.name;
    job.stock.diameter_mm = *bar_mm;
    job.stock.face_allowance_mm = material.face_allowance_mm;
    job.tools = shop.tools.value.tools;
    for (cam::JobTool& tool : job.tools) tool.settle();
    const cam::JobTool* const blade = job.toolFor(cam::ToolUse::PartOff);
    job.part_off = blade && cam::withLibrary(job).partingBlade()->reach_mm.value_or(0) > *bar_mm / 2;
    const double face_mm =
        length_mm + chuck.clearance_mm + (job.part_off ? blade->width_mm.value_or(assumed::width_mm) : 0);
    job.setup.chuck_face_z_mm = std::ceil(2 * face_mm) / 2;  // as a person sets it: a measured length has many digits
    job.setup.jaw_diameter_mm = chuck.jaw_diameter_mm;
    job.setup.grip_length_mm = chuck.grip_length_mm;
    job.setup.power_kW = lathe.power_kW;
    job.setup.efficiency = lathe.efficiency;
    if (usesTailstock(shop, part)) job.setup.tailstock.emplace().centre_hole_mm = shop.tailstock->value.centre_hole_mm;
    job.cutting = {material.name, material.rough, material.finish};
    job.max_rpm = lathe.max_rpm;
    return job;
}

deflection::HeldSetup setupOf(const Shop& shop, const cam::Job& job)
{
    deflection::HeldSetup held{commonSetup(shop, job.tools, job.setup.tailstock.has_value()), cam::heldStock(job)};
    held.setup.z_zero_mm = job.stock.face_allowance_mm;
    return held;
}

deflection::TurningSetup setupOfStock(const Shop& shop, const Shaft& stock)
{
    return commonSetup(shop, shop.tools.value.tools, usesTailstock(shop, stock));
}

receptance::SpindleReceptance chuckFaceOf(const Shop& shop)
{
    return {shop.chuck.value.springs};
}

UsedEntries usedBy(const cam::Job& job)
{
    return {true, true, job.setup.tailstock.has_value(), true, true};
}

UsedEntries usedBy(const deflection::TurningSetup& made)
{
    return {false, true, made.tailstock.has_value(), true, true};
}

UsedEntries usedByChuckFace()
{
    return {false, true, false, false, false};
}

void noteAssumed(const Shop& shop, const UsedEntries& used, Notes& notes)
{
    if (used.lathe) note(LT_TEXT("Engine", "Lathe"), shop.lathe, notes);
    if (used.chuck) note(LT_TEXT("Engine", "Chuck"), shop.chuck, notes);
    if (used.tailstock && shop.tailstock) note(LT_TEXT("Engine", "Tailstock"), *shop.tailstock, notes);
    if (used.tools) note(LT_TEXT("Engine", "Set of tools"), shop.tools, notes);
    if (used.material) note(LT_TEXT("Engine", "Material"), shop.material, notes);
}

}  // namespace lathelier::shop
