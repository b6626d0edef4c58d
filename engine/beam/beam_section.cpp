#include "engine/beam/beam_section.h"

#include <numbers>

namespace lathelier::beam {

BeamSection roundSection(double outer_mm, double bore_mm)
{
    const double outer2 = outer_mm * outer_mm;
    const double bore2 = bore_mm * bore_mm;
    const double area_mm2 = std::numbers::pi / 4 * (outer2 - bore2);
    return {area_mm2, area_mm2 / 16 * (outer2 + bore2)};
}

double shearCoefficient(ShearModel model, double bore_ratio, double poisson_ratio)
{
    const double nu = poisson_ratio;
    const double m2 = bore_ratio * bore_ratio;
    const double m4 = m2 * m2;
    const double ring = (1 + m2) * (1 + m2);
    if (model == ShearModel::Cowper) return 6 * (1 + nu) * ring / ((7 + 6 * nu) * ring + (20 + 12 * nu) * m2);
    return 6 * ring * (1 + nu) * (1 + nu) /
           (7 + 34 * m2 + 7 * m4 + nu * (12 + 48 * m2 + 12 * m4) + nu * nu * (4 + 16 * m2 + 4 * m4));
}

}  // namespace lathelier::beam
