#include "engine/report/ring_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/units.h"

namespace lathelier::report {
namespace {

bool overlap(const PolarPlace& a, const PolarPlace& b, double width_px, double height_px)
{
    return std::abs(a.x_px - b.x_px) < width_px && std::abs(a.y_px - b.y_px) < height_px;
}

/// Cost of the labels at this angle; places them there.
double placeOnRay(std::vector<RingLabel>& labels, const std::vector<PolarPlace>& drawn, double angle_rad, double rim_px)
{
    constexpr double air_px = 2;
    constexpr double aside = 0.1;  // cost of a position beside the ring, between that of a free position and of one on
                                   // a curve
    constexpr double crossed = 0.3, few = 100, dropped = 2;
    const PolarPlace along{std::cos(angle_rad), std::sin(angle_rad)};
    double widest = 0, apart_px = rim_px;
    for (const RingLabel& label : labels) {
        widest = std::max(widest, label.width_px + label.height_px);
        if (&label != &labels.front())
            apart_px = std::min(apart_px, std::abs(label.radius_px - labels.front().radius_px));
    }
    std::vector<PolarPlace> near;
    for (const PolarPlace& place : drawn)
        if (place.x_px * along.x_px + place.y_px * along.y_px > 0 &&
            std::abs(place.x_px * along.y_px - place.y_px * along.x_px) < widest)
            near.push_back(place);
    double cost = 0;
    for (RingLabel& label : labels) {
        const double halfWidth = label.width_px / 2 + air_px, halfHeight = label.height_px / 2;
        double least = dropped;
        label.place.reset();
        for (const double shift : {0.0, -0.6, 0.6, -0.9, 0.9, -1.2, 1.2}) {
            const double away_px = shift * label.height_px;
            if (std::abs(away_px) > apart_px / 2) break;  // it would be closer to another ring
            const double radius = label.radius_px + away_px;
            if (shift > 0 && radius + halfHeight > rim_px) continue;
            const PolarPlace middle{radius * along.x_px, radius * along.y_px};
            const auto touches = [&](const RingLabel& other) {
                return &other < &label && other.place &&
                       overlap(*other.place, middle, halfWidth + other.width_px / 2, halfHeight + other.height_px / 2);
            };
            if (std::any_of(labels.begin(), labels.end(), touches)) continue;
            const auto lies = [&](const PolarPlace& place) { return overlap(place, middle, halfWidth, halfHeight); };
            const auto hits = static_cast<double>(std::count_if(near.begin(), near.end(), lies));
            const double here = (hits > 0 ? crossed + hits / (hits + few) : 0) + aside * std::abs(shift);
            if (here >= least) continue;
            least = here;
            label.place = middle;
        }
        cost += least;
    }
    return cost;
}

}  // namespace

void placeRingLabels(std::vector<RingLabel>& labels, const std::vector<PolarPlace>& drawn, double rim_px)
{
    double least = std::numeric_limits<double>::infinity();
    std::vector<RingLabel> best = labels;
    // Starting at the preferred angle: three rays between any two spokes.
    for (const int spoke : {60, 90, 240, 270, 30, 120, 210, 300, 0, 150, 180, 330})
        for (const int beside : {15, 9, 21}) {
            const double cost = placeOnRay(labels, drawn, (spoke + beside) * rad_per_deg, rim_px);
            if (cost >= least) continue;
            least = cost;
            best = labels;
        }
    labels = std::move(best);
}

}  // namespace lathelier::report
