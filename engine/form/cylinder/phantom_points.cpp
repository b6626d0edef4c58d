#include "engine/form/cylinder/phantom_points.h"

#include <algorithm>

#include "engine/form/form_codes.h"

namespace lathelier::form {
namespace {

using Eigen::Vector3d;

constexpr std::size_t fewestPoints = 20;
constexpr std::size_t equalPoints = 10;        ///< least number of points at a place that was not measured
constexpr std::size_t equalAtOrigin = 3;       ///< the same at the exact origin
constexpr std::size_t timesOthers = 10;        ///< so many times the points of a usual place
constexpr std::size_t enoughToSearch = 20000;  ///< points among which such places are searched
constexpr std::size_t mostPlaces = 8;

struct Place {
    Vector3d at = Vector3d::Zero();
    std::size_t count = 0;  ///< of the searched points, then of all
};

bool isBefore(const Vector3d& a, const Vector3d& b)
{
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// Places held by several of the searched points, the fullest first.
std::vector<Place> crowdedPlaces(std::span<const Vector3d> points_mm, std::size_t stride)
{
    std::vector<Vector3d> searched;
    for (std::size_t i = 0; i < points_mm.size(); i += stride)
        if (points_mm[i].allFinite()) searched.push_back(points_mm[i]);  // the fit refuses the others
    if (searched.empty()) return {};
    std::sort(searched.begin(), searched.end(), isBefore);
    std::vector<Place> places;
    std::vector<std::size_t> counts;
    for (std::size_t begin = 0, end = 0; begin < searched.size(); begin = end) {
        while (end < searched.size() && searched[end] == searched[begin]) ++end;
        counts.push_back(end - begin);
        if (end - begin >= equalAtOrigin) places.push_back({searched[begin], end - begin});
    }
    std::nth_element(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2), counts.end());
    const std::size_t usual = counts[counts.size() / 2];
    std::erase_if(places, [&](const Place& place) {
        const bool isOrigin = place.at == Vector3d::Zero() && usual == 1;
        const bool isCrowded = place.count >= timesOthers * usual || (stride > 1 && usual == 1);
        return !isOrigin && !isCrowded;
    });
    std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.count > b.count; });
    if (places.size() > mostPlaces) places.resize(mostPlaces);
    return places;
}

}  // namespace

std::vector<std::size_t> withoutPhantoms(std::span<const Vector3d> points_mm, Notes& notes, const Progress& progress)
{
    if (points_mm.size() < fewestPoints) return {};
    const std::size_t stride = points_mm.size() / enoughToSearch + 1;
    std::vector<Place> places = crowdedPlaces(points_mm, stride);
    if (places.empty()) return {};
    for (Place& place : places) {
        progress.check();
        place.count = static_cast<std::size_t>(std::count(points_mm.begin(), points_mm.end(), place.at));
    }
    std::erase_if(places, [](const Place& place) {
        return place.count < (place.at == Vector3d::Zero() ? equalAtOrigin : equalPoints);
    });
    const auto isPhantom = [&places](const Vector3d& point) {
        return std::any_of(places.begin(), places.end(), [&point](const Place& place) { return place.at == point; });
    };
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < points_mm.size(); ++i)
        if (!isPhantom(points_mm[i])) kept.push_back(i);
    // Nothing but such places: a measurement of its own kind, which the fit judges.
    if (places.empty() || kept.size() < fewestPoints) return {};
    for (const Place& place : places)
        notes.push_back({notes::phantomPoints,
                         {{"count", static_cast<std::int64_t>(place.count)},
                          {"x_mm", place.at.x()},
                          {"y_mm", place.at.y()},
                          {"z_mm", place.at.z()}}});
    return kept;
}

}  // namespace lathelier::form
