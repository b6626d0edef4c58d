#include "engine/deflection/measured_places.h"

#include <algorithm>

#include "engine/core/units.h"
#include "engine/deflection/deflection_codes.h"

namespace lathelier::deflection {
namespace {

}  // namespace

MeasuredPlaces::MeasuredPlaces(const FinalContour& contour, std::span<const MeasuredDiameter> measured)
{
    if (contour.z_mm.empty()) throw Error(errors::noCut, {});
    places_.reserve(measured.size());
    for (const MeasuredDiameter& one : measured) {
        const auto after = std::lower_bound(contour.z_mm.begin(), contour.z_mm.end(), one.z_mm - same_mm);
        if (after == contour.z_mm.end() || one.z_mm < contour.z_mm.front() - same_mm)
            throw Error(errors::measuredOutsideCut,
                        {{"z_mm", one.z_mm}, {"from_mm", contour.z_mm.front()}, {"to_mm", contour.z_mm.back()}});
        const auto k = static_cast<std::size_t>(after - contour.z_mm.begin());
        const std::size_t before = k > 0 ? k - 1 : 0;
        const double width_mm = contour.z_mm[k] - contour.z_mm[before];
        if (std::binary_search(contour.gaps.begin(), contour.gaps.end(), k) && one.z_mm < contour.z_mm[k] - same_mm)
            throw Error(errors::measuredOutsideCut,
                        {{"z_mm", one.z_mm}, {"from_mm", contour.z_mm[before]}, {"to_mm", contour.z_mm[k]}});
        places_.push_back({before, k, width_mm > 0 ? std::min(1.0, (one.z_mm - contour.z_mm[before]) / width_mm) : 1});
    }
}

Eigen::VectorXd MeasuredPlaces::of(const std::vector<double>& values) const
{
    Eigen::VectorXd result(static_cast<Eigen::Index>(places_.size()));
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const Place& place = places_[i];
        result(static_cast<Eigen::Index>(i)) =
            (1 - place.share) * values[place.before] + place.share * values[place.after];
    }
    return result;
}

}  // namespace lathelier::deflection
