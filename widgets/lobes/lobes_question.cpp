#include "widgets/lobes/lobes_question.h"

#include <algorithm>
#include <stdexcept>

namespace lathelier::lobes_panel {
namespace {

/// The field `key` of a struct within the question.
template <class Part>
Field<LobesQuestion> within(Part LobesQuestion::*member, const std::string& key)
{
    for (const Field<Part>& inner : fields<Part>())
        if (inner.info.key == key)
            return {inner.info, [member, inner](const LobesQuestion& q) { return inner.get(q.*member); },
                    [member, inner](LobesQuestion& q, const Value& value) { inner.set(q.*member, value); }};
    throw std::logic_error("no such parameter: " + key);
}

}  // namespace

const std::vector<Field<LobesQuestion>>& fieldsOf(const LobesQuestion*)
{
    using Q = LobesQuestion;
    using P = stability::LobeParameters;
    static const std::vector<Field<Q>> all{
        rows("modes", &Q::modes, Range{0, 50},
             Label{LT_TEXT("Engine", "Modes"),
                   LT_TEXT("Engine", "Of the point that is cut, where there is no measured frequency response.")}),
        within<P>(&Q::lobes, "cutting_coefficient_N_mm2"),
        within<P>(&Q::lobes, "relation"),
        within<P>(&Q::lobes, "speed_rpm"),
        field("operating_speed_rpm", &Q::operating_speed_rpm, Range{1, 1e6},
              Label{LT_TEXT("Engine", "Spindle speed"),
                    LT_TEXT("Engine", "Of the operating point; drag it in the chart."), LT_TEXT("Engine", "1/min")}),
        field("operating_depth", &Q::operating_depth, Range{1e-6, 1e6},
              Label{LT_TEXT("Engine", "Depth of cut"),
                    LT_TEXT("Engine",
                            "Of the operating point, in mm; without a cutting coefficient in multiples of the least "
                            "limit.")}),
        field("diameter_mm", &Q::diameter_mm, Range{1e-3, 1e5},
              Label{LT_TEXT("Engine", "Diameter"), LT_TEXT("Engine", "Of the turned surface, for cutting speeds."),
                    LT_TEXT("Engine", "mm")}),
        field("range_m_min", &Q::range_m_min, Range{1e-3, 1e5},
              Label{LT_TEXT("Engine", "Cutting speeds of the tool"), LT_TEXT("Engine", "Range, 200:350."),
                    LT_TEXT("Engine", "m/min")}),
        field("rule", &Q::rule,
              {{"lobe", LT_TEXT("Engine", "Lobe of the selected speed")},
               {"nearest", LT_TEXT("Engine", "Nearest in range")}},
              Label{LT_TEXT("Engine", "Rule"), LT_TEXT("Engine", "Which candidate is recommended."), {}, true}),
        within<P>(&Q::lobes, "direction_factor"),
        within<P>(&Q::lobes, "points"),
        within<P>(&Q::lobes, "uncertainty_frequency_percent"),
        within<P>(&Q::lobes, "uncertainty_compliance_percent"),
        within<P>(&Q::lobes, "uncertainty_coefficient_percent")};
    return all;
}

}  // namespace lathelier::lobes_panel
