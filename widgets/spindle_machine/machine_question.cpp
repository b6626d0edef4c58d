#include "widgets/spindle_machine/machine_question.h"

#include "engine/core/units.h"

namespace lathelier::machine_panel {
namespace {

std::vector<FieldChoice> sources()
{
    std::vector<FieldChoice> choices = receptance::machineChoices(LT_TEXT("Engine", "springs"));
    choices.front().key = springsSource;
    choices.insert(choices.begin(), {measuredSource, LT_TEXT("Engine", "tap tests")});
    return choices;
}

}  // namespace

const std::vector<Field<MachineQuestion>>& fieldsOf(const MachineQuestion*)
{
    using Q = MachineQuestion;
    static const auto all = [] {
        auto list = described<Q>(
            choice(sourceKey, &Q::source, sources(),
                   Label{LT_TEXT("Engine", "Known from"),
                         LT_TEXT("Engine", "Machines of the library are assumed values to begin with.")}),
            group("springs", &Q::springs,
                  Label{LT_TEXT("Engine", "Springs at the chuck"), LT_TEXT("Engine", "Where they are typed.")}));
        for (const auto& inner : fields<receptance::IdentificationParameters>())
            list.push_back({inner.info, [inner](const Q& q) { return inner.get(q.identification); },
                            [inner](Q& q, const Value& value) { inner.set(q.identification, value); }});
        list.push_back(
            field("limit_percent", &Q::limit_percent, Range{0, 1000},
                  Label{LT_TEXT("Engine", "Largest residual"),
                        LT_TEXT("Engine", "Of the rod held out, else of all responses used."), unit::percent}));
        return list;
    }();
    return all;
}

}  // namespace lathelier::machine_panel
