#include "engine/cam/plan_quantities.h"

#include "engine/cam/check/check_quantities.h"
#include "engine/core/units.h"

namespace lathelier::cam {
namespace {

/// Findings of all clampings, each with the number of its own.
Rows findingRows(const TurningPlan& plan)
{
    Rows rows;
    for (std::size_t i = 0; i < plan.setups.size(); ++i)
        for (const CheckFinding& finding : plan.setups[i].check.findings) {
            Row row{describedValues(finding)};
            row.cells.emplace_back("setup", static_cast<std::int64_t>(i) + 1);
            rows.rows.push_back(std::move(row));
        }
    return rows;
}

}  // namespace

const std::vector<QuantityOf<PlannedOperation>>& quantitiesOf(const PlannedOperation*)
{
    using R = PlannedOperation;
    static const auto all = describedBy<R>(
        quantity<R>("name", [](const R& r) { return key(r.kind); }),
        quantity<R>("kind_name", [](const R& r) { return nameOf(r.kind); },
                    {LT_TEXT("Engine", "Operation"), {}, 0, false}),
        quantity<R>("tool", &R::tool, {LT_TEXT("Engine", "Tool"), {}, 0}),
        quantity<R>("blocks", &R::blocks, {LT_TEXT("Engine", "Blocks"), {}, 0}),
        quantity<R>("first_line", &R::first_line, {LT_TEXT("Engine", "First line"), {}, 0}),
        quantity<R>("feed_length_mm", &R::feed_length_mm, {LT_TEXT("Engine", "Feed length"), unit::mm, 1}),
        quantity<R>("time_s", &R::time_s, {LT_TEXT("Engine", "Time"), unit::s, 1}),
        quantity<R>("volume_cm3", &R::volume_cm3, {LT_TEXT("Engine", "Volume"), LT_TEXT("Engine", "cm³"), 2}),
        quantity<R>("power_max_kW", &R::power_max_kW,
                    {LT_TEXT("Engine", "Power at the cut, ± 25 %"), LT_TEXT("Engine", "kW"), 2}));
    return all;
}

const std::vector<QuantityOf<SetupPlan>>& quantitiesOf(const SetupPlan*)
{
    using R = SetupPlan;
    static const auto all = describedBy<R>(
        quantity<R>("program", [](const R& r) { return r.program.empty() ? Value() : Value(r.program); }),
        quantity<R>("z_zero",
                    [](const R& r) {
                        return r.clamping.is_mirrored ? LT_TEXT("Engine", "the face of the other end, finished")
                                                      : LT_TEXT("Engine", "the face of the free end, finished");
                    }),
        quantity<R>("z_zero_mm", &R::z_zero_mm),
        quantity<R>("turned_round", [](const R& r) { return r.clamping.is_mirrored; }),
        quantity<R>("chuck_face_z_mm", [](const R& r) { return r.clamping.job.setup.chuck_face_z_mm; },
                    {LT_TEXT("Engine", "Chuck face"), unit::mm, 2}),
        quantity<R>("finished_to_z_mm", [](const R& r) { return r.clamping.finished_to_mm; },
                    {LT_TEXT("Engine", "Finished up to z"), unit::mm, 2}),
        quantity<R>("cut_off_to_mm", [](const R& r) { return r.clamping.cut_off_to_mm; },
                    {LT_TEXT("Engine", "Cut off first to"), unit::mm, 2}),
        quantity<R>("operations", [](const R& r) { return listed(r.operations); }),
        quantity<R>("time_s", &R::time_s, {LT_TEXT("Engine", "Time with tool changes"), unit::s, 1}));
    return all;
}

const std::vector<QuantityOf<SectionSpeed>>& quantitiesOf(const SectionSpeed*)
{
    using R = SectionSpeed;
    static const auto all = describedBy<R>(
        quantity<R>("z_start_mm", &R::z_start_mm, {LT_TEXT("Engine", "From z"), unit::mm, 2}),
        quantity<R>("z_end_mm", &R::z_end_mm, {LT_TEXT("Engine", "To z"), unit::mm, 2}),
        quantity<R>("diameter_mm", &R::diameter_mm, {LT_TEXT("Engine", "Diameter"), unit::mm, 3}),
        quantity<R>("speed_rpm", &R::speed_rpm, {LT_TEXT("Engine", "Speed"), LT_TEXT("Engine", "1/min"), 0}),
        quantity<R>("cutting_speed_m_min", &R::cutting_speed_m_min,
                    {LT_TEXT("Engine", "Cutting speed"), unit::m_min, 1}),
        quantity<R>("frequency_hz", &R::frequency_hz, {LT_TEXT("Engine", "Frequency f_m"), unit::hz, 1}),
        quantity<R>("lobe", [](const R& r) { return r.lobe > 0 ? Value(std::int64_t{r.lobe}) : Value(); },
                    {LT_TEXT("Engine", "Lobe"), {}, 0}),
        quantity<R>("reason", &R::reason, {LT_TEXT("Engine", "Reason"), {}, 0}),
        quantity<R>("Rz_um", &R::Rz_um, {LT_TEXT("Engine", "Ideal Rz"), unit::um, 2}),
        quantity<R>("stable_depth_mm", &R::stable_depth_mm,
                    {LT_TEXT("Engine", "Stable up to a depth of"), unit::mm, 3}),
        quantity<R>("setup", &R::setup, {LT_TEXT("Engine", "Clamping"), {}, 0}));
    return all;
}

const std::vector<QuantityOf<TurningPlan>>& quantitiesOf(const TurningPlan*)
{
    using R = TurningPlan;
    static const auto all = describedBy<R>(
        quantity<R>("post", &R::post), quantity<R>("setups", [](const R& r) { return listed(r.setups); }),
        quantity<R>("rest", [](const R& r) { return listed(r.rest); }),
        quantity<R>("sections", [](const R& r) { return listed(r.sections); }),
        quantity<R>("not_made", [](const R& r) { return listed(r.not_made); }),
        quantity<R>("check.gouge_um", [](const R& r) { return r.worstCheck().gouge_um; },
                    {LT_TEXT("Engine", "Gouge"), unit::um, 2}),
        quantity<R>("check.gouge_z_mm", [](const R& r) { return r.worstCheck().gouge_z_mm; },
                    {LT_TEXT("Engine", "z of the gouge"), unit::mm, 3}),
        quantity<R>("check.gouge_line", [](const R& r) { return r.worstCheck().gouge_line; },
                    {LT_TEXT("Engine", "Line of the gouge"), {}, 0}),
        quantity<R>("check.left_max_mm", &R::left_max_mm, {LT_TEXT("Engine", "Most that is left"), unit::mm, 4}),
        quantity<R>("check.findings", findingRows));
    return all;
}

}  // namespace lathelier::cam
