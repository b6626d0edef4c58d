#include "widgets/pass/pass_question.h"

#include "engine/core/field_within.h"
#include "engine/core/units.h"

namespace lathelier::pass_panel {

PassQuestion::PassQuestion()
{
    lobes.speed_rpm = {{1000, 6000}};
    lobes.points = 800;  // the limit of each station is drawn about as finely as the screen shows it
}

const std::vector<Field<PassQuestion>>& fieldsOf(const PassQuestion*)
{
    using Q = PassQuestion;
    static const std::vector<Field<Q>> all{
        within(&Q::pass, "pass_z_mm"),
        within(&Q::pass, depthKey),
        within(&Q::lobes, "cutting_coefficient_N_mm2"),
        within(&Q::lobes, "speed_rpm"),
        field(speedKey, &Q::operating_speed_rpm, Range{1, 1e6},
              Label{LT_TEXT("Engine", "Spindle speed"),
                    LT_TEXT("Engine", "That is judged; drag it in the chart. Without it the best over the pass."),
                    unit::rpm}),
        foldedWithin(&Q::lobes, "relation"),
        foldedWithin(&Q::lobes, "process_damping_N_mm"),
        foldedWithin(&Q::lobes, "direction_factor"),
        foldedWithin(&Q::pass, "pass_stations"),
        foldedWithin(&Q::lobes, "points"),
        foldedWithin(&Q::computing, "shear"),
        foldedWithin(&Q::computing, "step_correction")};
    return all;
}

}  // namespace lathelier::pass_panel
