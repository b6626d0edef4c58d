#include "engine/core/units.h"
#include "engine/receptance/receptance_fields.h"
#include "engine/receptance/shaft/shaft_receptance.h"

namespace lathelier::receptance {

const std::vector<Field<ReceptanceParameters>>& fieldsOf(const ReceptanceParameters*)
{
    using P = ReceptanceParameters;
    static const std::vector<Field<P>> all{
        field("respond_z_mm", &P::respond_z_mm, Range{0, 1e6},
              Label{LT_TEXT("Engine", "Response at z"),
                    LT_TEXT("Engine", "Where the deflection is, from the free end toward the chuck."), unit::mm}),
        field("excite_z_mm", &P::excite_z_mm, Range{0, 1e6},
              Label{LT_TEXT("Engine", "Force at z"),
                    LT_TEXT("Engine", "Where the force acts, from the free end toward the chuck."), unit::mm}),
        field("from_hz", &P::from_hz, Range{0, 1e6},
              Label{LT_TEXT("Engine", "From"),
                    LT_TEXT("Engine", "The first frequency; not stated: that of the spindle's table, else 50."),
                    unit::hz}),
        field("to_hz", &P::to_hz, Range{0, 1e6},
              Label{LT_TEXT("Engine", "To"),
                    LT_TEXT("Engine", "The last frequency; not stated: that of the spindle's table, else 5000."),
                    unit::hz}),
        field("step_hz", &P::step_hz, Range{1e-6, 1e6},
              Label{LT_TEXT("Engine", "Step"), LT_TEXT("Engine", "From one frequency to the next."), unit::hz}),
        shearField(&P::shear),
        methodField(&P::method),
        field("step_correction", &P::step_correction,
              Label{LT_TEXT("Engine", "Step correction"),
                    LT_TEXT("Engine",
                            "Beside a shoulder only material within 45° of the smaller diameter gives stiffness."),
                    {},
                    true}),
    };
    return all;
}

}  // namespace lathelier::receptance
