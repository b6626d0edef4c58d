// User parameters of a plan, and the error of a refused plan.
#include "engine/cam/check/check_quantities.h"
#include "engine/cam/plan.h"
#include "engine/cam/plan_codes.h"
#include "engine/core/units.h"

namespace lathelier::cam {

const std::vector<Field<TurningParameters>>& fieldsOf(const TurningParameters*)
{
    using P = TurningParameters;
    const std::vector<FieldChoice> setups{{"auto", LT_TEXT("Engine", "two where one leaves more")},
                                          {"1", LT_TEXT("Engine", "one")},
                                          {"2", LT_TEXT("Engine", "two")}};
    const std::vector<FieldChoice> relations{{"exact", LT_TEXT("Engine", "exact")},
                                             {"published", LT_TEXT("Engine", "as published")}};
    const std::vector<FieldChoice> models{{"finished", LT_TEXT("Engine", "the finished part")},
                                          {"moment", LT_TEXT("Engine", "the work at that moment")}};
    const std::vector<FieldChoice> cycles{{"as_post", LT_TEXT("Engine", "as the control's post states it")},
                                          {"none", LT_TEXT("Engine", "every pass as moves")},
                                          {"g71_g70", LT_TEXT("Engine", "cycles G71 and G70")}};
    static const auto all = described<P>(
        field("setups", &P::setups, setups,
              Label{LT_TEXT("Engine", "Clampings"),
                    LT_TEXT("Engine", "Auto turns the part round where that leaves less on the drawing.")}),
        field("relation", &P::relation, relations,
              Label{LT_TEXT("Engine", "Relation"), LT_TEXT("Engine", "Between lobes and speeds.")}),
        field("part_model", &P::part_model, models,
              Label{LT_TEXT("Engine", "Part for the speeds"),
                    LT_TEXT("Engine", "Body whose dynamics decide the speeds of the finish.")}),
        field("cycles", &P::cycles, cycles,
              Label{LT_TEXT("Engine", "Roughing and finish"),
                    LT_TEXT("Engine",
                            "In cycles the control lays the passes itself; the check reads them as this program "
                            "expands them.")}),
        field("tool_change_s", &P::tool_change_s, {0, 600},
              Label{LT_TEXT("Engine", "Tool change"), LT_TEXT("Engine", "Time of a tool change."), unit::s}),
        rows("skipped", &P::skipped, Range{0, 100},
             Label{LT_TEXT("Engine", "Left out"),
                   LT_TEXT("Engine", "Operations that are switched off: clamping, kind, tool."),
                   {},
                   true}),
        rows("order", &P::order, Range{0, 100},
             Label{LT_TEXT("Engine", "Order"),
                   LT_TEXT("Engine",
                           "Operations in the order in which they run: clamping, kind, tool. Those that are not named "
                           "keep their places."),
                   {},
                   true}));
    return all;
}

void throwIfRefused(const TurningPlan& plan)
{
    if (!plan.is_refused) return;
    Rows findings;
    std::int64_t count = 0;
    double gouge = 0;
    for (std::size_t i = 0; i < plan.setups.size(); ++i) {
        const CheckResult& check = plan.setups[i].check;
        for (const gcode::Diagnostic& diagnostic : check.path.diagnostics)
            if (diagnostic.error) throw Error(*diagnostic.error);
        gouge = std::max(gouge, check.gouge_um);
        for (const CheckFinding& finding : check.findings) {
            Row row{describedValues(finding)};
            row.cells.emplace_back("setup", static_cast<std::int64_t>(i) + 1);
            findings.rows.push_back(std::move(row));
            ++count;
        }
    }
    throw Error(errors::programRefused, {{"count", count}, {"gouge_um", gouge}, {"findings", findings}});
}

}  // namespace lathelier::cam
