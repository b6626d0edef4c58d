// User parameters of a plan, and the error of a refused plan.
#include "engine/cam/plan.h"
#include "engine/core/units.h"

namespace lathelier::cam {

const std::vector<Field<SkippedOperation>>& fieldsOf(const SkippedOperation*)
{
    using S = SkippedOperation;
    static const auto all = [] {
        std::vector<FieldChoice> kinds;
        for (int i = 0; i <= static_cast<int>(OperationKind::Thread); ++i) {
            const auto kind = static_cast<OperationKind>(i);
            kinds.push_back({key(kind), nameOf(kind)});
        }
        return described<S>(
            field("setup", &S::setup, {1, 2},
                  Label{LT_TEXT("Engine", "Clamping"), LT_TEXT("Engine", "First or second.")}),
            field("kind", &S::kind, kinds, Label{LT_TEXT("Engine", "Operation"), LT_TEXT("Engine", "What for.")}),
            field("tool", &S::tool, {0, 99999},
                  Label{LT_TEXT("Engine", "Tool number"), LT_TEXT("Engine", "As the program calls it.")}));
    }();
    return all;
}

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
        field("optional_stops", &P::optional_stops,
              Label{LT_TEXT("Engine", "Optional stops"),
                    LT_TEXT("Engine", "A stop (M1) before each further tool, where the control's post knows one.")}),
        field("work_offset", &P::work_offset,
              Label{LT_TEXT("Engine", "State the work offset"),
                    LT_TEXT("Engine", "G54 at the start, where the control's post knows it.")}),
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

}  // namespace lathelier::cam
