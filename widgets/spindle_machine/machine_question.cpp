#include "widgets/spindle_machine/machine_question.h"

#include <array>

#include "engine/core/units.h"

namespace lathelier::machine_panel {
namespace {

std::vector<FieldChoice> sources()
{
    std::vector<FieldChoice> choices = chatter_common::machineChoices(LT_TEXT("Engine", "springs"));
    choices.front().key = "springs";
    choices.insert(choices.begin(), {"measured", LT_TEXT("Engine", "tap tests")});
    return choices;
}

}  // namespace

chatter_common::MachineChoice ofLibrary(MachineSource source)
{
    constexpr std::array choices{chatter_common::MachineChoice::Stated, chatter_common::MachineChoice::Stated,
                                 chatter_common::MachineChoice::Papers, chatter_common::MachineChoice::Stiff,
                                 chatter_common::MachineChoice::Soft};
    return choices.at(static_cast<std::size_t>(source));
}

const std::vector<Field<MachineQuestion>>& fieldsOf(const MachineQuestion*)
{
    using Q = MachineQuestion;
    static const auto all = [] {
        auto list = described<Q>(
            field(sourceKey, &Q::source, sources(),
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
