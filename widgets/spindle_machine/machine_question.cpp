#include "widgets/spindle_machine/machine_question.h"

#include <array>

namespace lathelier::machine_panel {

std::string libraryKey(MachineSource source)
{
    constexpr std::array<const char*, 5> keys{"", "", "papers", "stiff", "soft"};
    return keys.at(static_cast<std::size_t>(source));
}

const std::vector<Field<MachineQuestion>>& fieldsOf(const MachineQuestion*)
{
    using Q = MachineQuestion;
    static const auto all = [] {
        auto list = described<Q>(
            field(sourceKey, &Q::source,
                  {{"measured", LT_TEXT("Engine", "tap tests")},
                   {"springs", LT_TEXT("Engine", "springs")},
                   {"papers", LT_TEXT("Engine", "lathe of the papers")},
                   {"stiff", LT_TEXT("Engine", "stiff lathe (example)")},
                   {"soft", LT_TEXT("Engine", "soft lathe (example)")}},
                  Label{LT_TEXT("Engine", "Known from"),
                        LT_TEXT("Engine", "Machines of the library are assumed values to begin with.")}),
            group("springs", &Q::springs,
                  Label{LT_TEXT("Engine", "Springs at the chuck"), LT_TEXT("Engine", "Where they are typed.")}));
        for (const auto& inner : fields<receptance::IdentificationParameters>())
            list.push_back({inner.info, [inner](const Q& q) { return inner.get(q.identification); },
                            [inner](Q& q, const Value& value) { inner.set(q.identification, value); }});
        list.push_back(field(
            "limit_percent", &Q::limit_percent, Range{0, 1000},
            Label{LT_TEXT("Engine", "Largest residual"),
                  LT_TEXT("Engine", "Of the rod held out, else of all responses used."), LT_TEXT("Engine", "%")}));
        return list;
    }();
    return all;
}

}  // namespace lathelier::machine_panel
