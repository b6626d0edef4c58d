#include "engine/receptance/shaft/held_beam.h"

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "engine/receptance/coupling.h"

namespace lathelier::receptance {
namespace {

constexpr double singular = 1e-14;

}  // namespace

void receptancesOnSpindle(beam::BeamReceptance& shaft, const beam::ReceptanceMatrix& spindle, std::size_t chuck,
                          double frequency_hz, std::span<beam::ReceptanceMatrix> result)
{
    const Complex determinant = spindle(0, 0) * spindle(1, 1) - spindle(0, 1) * spindle(1, 0);
    const double size = std::abs(spindle(0, 0) * spindle(1, 1)) + std::abs(spindle(0, 1) * spindle(1, 0));
    if (std::abs(determinant) > singular * size) {
        shaft.at(frequency_hz, spindle.inverse(), result);
        return;
    }
    shaft.at(frequency_hz, result);  // a chuck face without any stiffness has no inverse
    const std::vector<beam::ReceptanceMatrix> free(result.begin(), result.end());
    const std::size_t count = shaft.places();
    const auto g = [&](std::size_t at, std::size_t of) { return free[at * count + of]; };
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t c = 0; c < count; ++c)
            result[a * count + c] = coupled({g(a, c), g(a, chuck), g(chuck, chuck), g(chuck, c)}, spindle);
}

}  // namespace lathelier::receptance
