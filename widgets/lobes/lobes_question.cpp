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
    using S = stability::SpeedParameters;
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
        within<S>(&Q::speed, "diameter_mm"),
        within<S>(&Q::speed, "range_m_min"),
        within<S>(&Q::speed, "rule"),
        within<P>(&Q::lobes, "direction_factor"),
        within<P>(&Q::lobes, "process_damping_N_mm"),
        within<P>(&Q::lobes, "points"),
        within<P>(&Q::lobes, "uncertainty_frequency_percent"),
        within<P>(&Q::lobes, "uncertainty_compliance_percent"),
        within<P>(&Q::lobes, "uncertainty_coefficient_percent")};
    return all;
}

}  // namespace lathelier::lobes_panel
