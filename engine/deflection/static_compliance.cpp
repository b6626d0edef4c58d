#include "engine/deflection/static_compliance.h"

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/deflection/turning_work.h"
#include "engine/receptance/shaft/shaft_receptance.h"

namespace lathelier::deflection {
namespace {

constexpr std::size_t comparedPlaces = 9;

/// A run along the whole workpiece without cutting, for the compliance at every node.
ToolRun nonCuttingRun(const Shaft& stock)
{
    double largest_mm = 0;
    for (const ShaftSegment& segment : stock.segments)
        largest_mm = std::max({largest_mm, segment.start_diameter_mm, segment.end_diameter_mm});
    const double length_mm = stock.length_mm();
    return {ToolRun::Kind::TowardChuck, {{0, largest_mm, 0.1, 0}, {length_mm, largest_mm, 0.1, 0}}};
}

receptance::ShaftHolding holdingOf(const TurningSetup& setup)
{
    receptance::ShaftHolding holding;
    holding.spindle = receptance::SpindleReceptance{
        receptance::SpindleSprings{setup.chuck.radial_N_mm, setup.chuck.tilt_N_mm_rad, 0}};
    if (setup.tailstock)
        holding.supports.push_back({0, setup.tailstock->radial_N_mm, setup.tailstock->tilt_N_mm_rad, 0});
    for (const SteadyRest& rest : setup.steady_rests) holding.supports.push_back({rest.z_mm, rest.radial_N_mm, 0, 0});
    return holding;
}

}  // namespace

StaticCompliance staticCompliance(const Shaft& stock, const TurningSetup& setup)
{
    TurningSetup plain = setup;
    plain.follower_rest.reset();
    plain.tool_post.reset();
    const ToolRun run = nonCuttingRun(stock);
    const WorkPlan plan = workPlan(stock, {&run, 1}, plain);
    TurningWork work(plan, plain);
    std::vector<Station> stations;
    work.take(plan.cuts.front(), CutTask::Predict, stations);
    StaticCompliance found;
    found.z_mm = plan.z_mm;
    for (std::size_t node = 0; node < plan.z_mm.size(); ++node)
        found.compliance_um_N.push_back(um_per_mm * work.complianceAt(node).ww);

    const receptance::ShaftHolding holding = holdingOf(plain);
    Material material = plain.material.elastic;
    material.loss_factor = 0;
    for (std::size_t i = 0; i < comparedPlaces; ++i) {
        const std::size_t node = i * (plan.z_mm.size() - 1) / (comparedPlaces - 1);
        receptance::ReceptanceParameters asked;
        asked.respond_z_mm = asked.excite_z_mm = plan.z_mm[node];
        asked.from_hz = asked.to_hz = 0;
        asked.shear = plain.shear;
        const Frf frf = receptance::receptanceOf(stock, material, asked, holding);
        found.compared_z_mm.push_back(plan.z_mm[node]);
        found.receptance_0_hz_um_N.push_back(um_per_mm * frf.value.front().real());
        const double difference = std::abs(found.compliance_um_N[node] / found.receptance_0_hz_um_N.back() - 1);
        found.largest_difference = std::max(found.largest_difference, difference);
    }
    return found;
}

const std::vector<QuantityOf<StaticCompliance>>& quantitiesOf(const StaticCompliance*)
{
    using R = StaticCompliance;
    static const auto all = describedBy<R>(
        quantity<R>("z_mm", &R::z_mm), quantity<R>("compliance_um_N", &R::compliance_um_N),
        quantity<R>("compared_z_mm", &R::compared_z_mm), quantity<R>("receptance_0_hz_um_N", &R::receptance_0_hz_um_N),
        quantity<R>("largest_difference", &R::largest_difference));
    return all;
}

report::Plot compliancePlot(const StaticCompliance& compliance)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Static compliance of the work before the first cut");
    plot.x = {LT_TEXT("Engine", "z from the free end"), millimetre};
    plot.y = {LT_TEXT("Engine", "Compliance"), LT_TEXT("Engine", "µm/N")};
    plot.curves = {{LT_TEXT("Engine", "by deflection"), compliance.z_mm, compliance.compliance_um_N},
                   {LT_TEXT("Engine", "receptance at 0 Hz"), compliance.compared_z_mm, compliance.receptance_0_hz_um_N,
                    report::Curve::Style::Points}};
    plot.curves.back().colour = report::ColourRole::Mark;
    return plot;
}

}  // namespace lathelier::deflection
