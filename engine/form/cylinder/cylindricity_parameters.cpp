#include "engine/core/units.h"
#include "engine/form/cylinder/cylindricity.h"

#include "engine/core/decision_field.h"

namespace lathelier::form {

const std::vector<Field<CylindricityParameters>>& fieldsOf(const CylindricityParameters*)
{
    using P = CylindricityParameters;
    static const std::vector<Field<P>> all{
        field("tolerance_um", &P::tolerance_um, Range{1e-6, 1e6},
              Label{LT_TEXT("Engine", "Tolerance"), LT_TEXT("Engine", "Largest cylindricity deviation CYLt allowed."),
                    unit::um}),
        decisionField(&P::decision,
                      LT_TEXT("Engine",
                              "Guarded rejection: out only where surely out. Simple: the value alone. Guarded: only "
                              "what is sure passes "
                              "or fails."),
                      true),
        field("probe_uncertainty_um", &P::probe_uncertainty_um, Range{0, 1e6},
              Label{LT_TEXT("Engine", "Uncertainty of a point"), LT_TEXT("Engine", "One standard deviation."), unit::um,
                    true}),
    };
    return all;
}

}  // namespace lathelier::form
