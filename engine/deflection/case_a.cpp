#include "engine/deflection/case_a.h"

namespace lathelier::deflection {

TurningSetup caseASetup()
{
    TurningSetup setup;
    setup.material.elastic.elastic_modulus_MPa = 210150;
    setup.material.elastic.poisson_ratio = 0.28;
    setup.material.cutting = {1748.5, 99.2, 703, 92.5};
    setup.tool.corner_radius_mm = 0.8;
    setup.tool.entering_angle_deg = 95;
    setup.chuck = {33000, 1e15, 6.87e7, 3e7};
    setup.tailstock = HoldingSprings{5500, 1e15, 0, 0};
    return setup;
}

Shaft caseAStock()
{
    Shaft shaft;
    shaft.segments = {{287.5, 34, 34, 0, {}, {}}};
    return shaft;
}

}  // namespace lathelier::deflection
