#include "engine/shaft/shaft_step.h"

#include "engine/core/units.h"

namespace lathelier {

const std::vector<QuantityOf<ShaftStep>>& quantitiesOf(const ShaftStep*)
{
    using S = ShaftStep;
    static const auto all = describedBy<S>(
        quantity<S>("x_mm", &S::x_mm, {LT_TEXT("Engine", "x"), unit::mm, 3}),
        quantity<S>("y_mm", &S::y_mm, {LT_TEXT("Engine", "y"), unit::mm, 3}),
        quantity<S>("radius_mm", &S::radius_mm, {LT_TEXT("Engine", "Radius"), unit::mm, 4}),
        quantity<S>("z_start_mm", &S::z_start_mm, {LT_TEXT("Engine", "Start z"), unit::mm, 2}),
        quantity<S>("z_end_mm", &S::z_end_mm, {LT_TEXT("Engine", "End z"), unit::mm, 2}),
        quantity<S>("chamfer_start_mm", &S::chamfer_start_mm, {LT_TEXT("Engine", "Chamfer at its start"), unit::mm, 2}),
        quantity<S>("chamfer_end_mm", &S::chamfer_end_mm, {LT_TEXT("Engine", "Chamfer at its end"), unit::mm, 2}),
        quantity<S>("sections", &S::sections, {LT_TEXT("Engine", "Sections")}));
    return all;
}

}  // namespace lathelier
