#include "engine/core/shaft_step.h"

namespace lathelier {

const std::vector<QuantityOf<ShaftStep>>& quantitiesOf(const ShaftStep*)
{
    using S = ShaftStep;
    const Text mm = LT_TEXT("Engine", "mm");
    static const auto all = describedBy<S>(
        quantity<S>("x_mm", &S::x_mm, {LT_TEXT("Engine", "x"), mm, 3}),
        quantity<S>("y_mm", &S::y_mm, {LT_TEXT("Engine", "y"), mm, 3}),
        quantity<S>("radius_mm", &S::radius_mm, {LT_TEXT("Engine", "Radius"), mm, 4}),
        quantity<S>("z_start_mm", &S::z_start_mm, {LT_TEXT("Engine", "Start z"), mm, 2}),
        quantity<S>("z_end_mm", &S::z_end_mm, {LT_TEXT("Engine", "End z"), mm, 2}),
        quantity<S>("chamfer_start_mm", &S::chamfer_start_mm, {LT_TEXT("Engine", "Chamfer at its start"), mm, 2}),
        quantity<S>("chamfer_end_mm", &S::chamfer_end_mm, {LT_TEXT("Engine", "Chamfer at its end"), mm, 2}),
        quantity<S>("sections", &S::sections, {LT_TEXT("Engine", "Sections")}));
    return all;
}

}  // namespace lathelier
