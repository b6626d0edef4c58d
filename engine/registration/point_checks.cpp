#include "engine/registration/point_checks.h"

#include <algorithm>

#include "engine/core/error.h"
#include "engine/core/point_spread.h"

namespace lathelier::registration {
namespace {

constexpr double largestCoordinate_mm = 1e7;  // beyond ten kilometres, squares of differences lose micrometres

}  // namespace

void checkPoints(const std::vector<Eigen::Vector3d>& points, const char* role, const Progress& progress,
                 std::size_t least)
{
    try {
        const PointSpread spread = spreadOf(points, least, largestCoordinate_mm, progress);
        // An extent within the rounding of the coordinates counts as none.
        const double rounding = 1e-7 * spread.largest_mm;
        refuseDegenerate(spread, rounding, std::max(1e-6 * spread.extent_mm[2], rounding));
    } catch (const Error& error) {
        Values values = error.values();
        values.emplace_back("role", std::string(role));
        throw Error(error.code(), std::move(values));
    }
}

}  // namespace lathelier::registration
