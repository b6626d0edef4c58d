#include "engine/shop/bar_sizes.h"

#include <algorithm>

namespace lathelier::shop {

const std::vector<double>& barDiameters_mm()
{
    static const std::vector<double> all{10,  12,  13,  14,  15,  16,  18,  19,  20,  22,  24,  25,  26,  27,  28,
                                         30,  32,  35,  36,  38,  40,  42,  45,  48,  50,  52,  55,  60,  63,  65,
                                         70,  73,  75,  80,  85,  90,  95,  100, 105, 110, 115, 120, 125, 130, 135,
                                         140, 145, 150, 155, 160, 165, 170, 175, 180, 190, 200, 220, 250};
    return all;
}

std::optional<double> barFor_mm(double diameter_mm)
{
    const std::vector<double>& all = barDiameters_mm();
    const auto found = std::lower_bound(all.begin(), all.end(), diameter_mm - 1e-9);
    return found == all.end() ? std::nullopt : std::optional(*found);
}

}  // namespace lathelier::shop
