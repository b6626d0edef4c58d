#include "engine/cam/check/check_quantities.h"

#include "engine/core/units.h"

namespace lathelier::cam {
namespace {

}  // namespace

const std::vector<QuantityOf<CheckFinding>>& quantitiesOf(const CheckFinding*)
{
    using R = CheckFinding;
    static const auto all =
        describedBy<R>(quantity<R>("line", &R::line, {LT_TEXT("Engine", "Line"), {}, 0}),
                       quantity<R>("kind", [](const R& r) { return key(r.kind); }),
                       quantity<R>("kind_name", [](const R& r) { return nameOf(r.kind); },
                                   {LT_TEXT("Engine", "Finding"), {}, 0, false}),
                       quantity<R>("z_mm", &R::z_mm, {LT_TEXT("Engine", "z"), unit::mm, 3}),
                       quantity<R>("x_mm", &R::x_mm, {LT_TEXT("Engine", "Radius"), unit::mm, 3}),
                       quantity<R>("depth_mm", &R::depth_mm, {LT_TEXT("Engine", "Depth"), unit::mm, 3}));
    return all;
}

const std::vector<QuantityOf<RestInterval>>& quantitiesOf(const RestInterval*)
{
    using R = RestInterval;
    static const auto all = describedBy<R>(
        quantity<R>("z_start_mm", &R::z_start_mm, {LT_TEXT("Engine", "From z"), unit::mm, 2}),
        quantity<R>("z_end_mm", &R::z_end_mm, {LT_TEXT("Engine", "To z"), unit::mm, 2}),
        quantity<R>("left_mm", &R::left_mm, {LT_TEXT("Engine", "Left"), unit::mm, 4}),
        quantity<R>("cause", [](const R& r) { return key(r.cause); }),
        quantity<R>("cause_name", [](const R& r) { return nameOf(r.cause); },
                    {LT_TEXT("Engine", "Cause"), {}, 0, false}),
        quantity<R>("tool", [](const R& r) { return r.tool > 0 ? Value(std::int64_t{r.tool}) : Value(); },
                    {LT_TEXT("Engine", "Tool"), {}, 0}),
        quantity<R>("line", [](const R& r) { return r.line > 0 ? Value(r.line) : Value(); },
                    {LT_TEXT("Engine", "Line"), {}, 0}),
        quantity<R>("corner_radius_mm", &R::corner_radius_mm, {LT_TEXT("Engine", "Drawn radius"), unit::mm, 3}),
        quantity<R>("nose_radius_mm", &R::nose_radius_mm, {LT_TEXT("Engine", "Nose radius"), unit::mm, 3}));
    return all;
}

const std::vector<QuantityOf<CheckResult>>& quantitiesOf(const CheckResult*)
{
    using R = CheckResult;
    static const auto all = describedBy<R>(
        quantity<R>("check.gouge_um", &R::gouge_um, {LT_TEXT("Engine", "Gouge"), unit::um, 2}),
        quantity<R>("check.gouge_z_mm", &R::gouge_z_mm, {LT_TEXT("Engine", "z of the gouge"), unit::mm, 3}),
        quantity<R>("check.gouge_line", &R::gouge_line, {LT_TEXT("Engine", "Line of the gouge"), {}, 0}),
        quantity<R>("check.left_max_mm", &R::left_max_mm, {LT_TEXT("Engine", "Most that is left"), unit::mm, 4}),
        quantity<R>("check.findings", [](const R& r) { return listed(r.findings); }),
        quantity<R>("check.findings_not_listed", &R::findings_not_listed),
        quantity<R>("rest", [](const R& r) { return listed(r.rest); }),
        quantity<R>("not_checked", [](const R& r) { return listed(r.not_checked); }));
    return all;
}

}  // namespace lathelier::cam
