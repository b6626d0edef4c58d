#include "widgets/lobes/lobes_question.h"

#include "engine/core/field_within.h"
#include "engine/core/units.h"

namespace lathelier::lobes_panel {

const std::vector<Field<LobesQuestion>>& fieldsOf(const LobesQuestion*)
{
    using Q = LobesQuestion;
    static const std::vector<Field<Q>> all{
        rows("modes", &Q::modes, Range{0, 50},
             Label{LT_TEXT("Engine", "Modes"),
                   LT_TEXT("Engine", "Of the point that is cut, where there is no measured frequency response.")}),
        within(&Q::lobes, "cutting_coefficient_N_mm2"),
        within(&Q::lobes, "relation"),
        within(&Q::lobes, "speed_rpm"),
        field("operating_speed_rpm", &Q::operating_speed_rpm, Range{1, 1e6},
              Label{LT_TEXT("Engine", "Spindle speed"),
                    LT_TEXT("Engine", "Of the operating point; drag it in the chart."), unit::rpm}),
        field("operating_depth", &Q::operating_depth, Range{1e-6, 1e6},
              Label{LT_TEXT("Engine", "Depth of cut"),
                    LT_TEXT("Engine",
                            "Of the operating point, in mm; without a cutting coefficient in multiples of the least "
                            "limit.")}),
        within(&Q::speed, "diameter_mm"),
        within(&Q::speed, "range_m_min"),
        within(&Q::speed, "rule"),
        within(&Q::lobes, "direction_factor"),
        within(&Q::lobes, "process_damping_N_mm"),
        within(&Q::lobes, "points"),
        within(&Q::lobes, "uncertainty_frequency_percent"),
        within(&Q::lobes, "uncertainty_compliance_percent"),
        within(&Q::lobes, "uncertainty_coefficient_percent")};
    return all;
}

}  // namespace lathelier::lobes_panel
