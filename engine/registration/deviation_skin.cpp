#include "engine/registration/deviation_skin.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/registration/compare_plots.h"
#include "engine/registration/surface_form.h"

namespace lathelier::registration {
namespace {

constexpr double endMargin_mm = 3;     // between an end of the data and the face, the bore or the chamfer beside it
constexpr double mostStations = 400;   // along the meridian: with mostAngles still drawn whole while it is turned
constexpr double leastStep_mm = 0.05;  // between stations
constexpr int fewestAngles = 96, mostAngles = 240;

using Line = std::vector<Eigen::Vector2d>;  // (z, r)

/// The sides of one kind, in order of z.
std::vector<MeridianStretch> sidesOf(const SurfaceWindows& all, bool bore)
{
    std::vector<MeridianStretch> sides;
    for (const MeridianStretch& stretch : all.stretches)
        if (!stretch.isFace() && stretch.is_bore == bore) sides.push_back(stretch);
    std::sort(sides.begin(), sides.end(),
              [](const MeridianStretch& a, const MeridianStretch& b) { return a.start_mm < b.start_mm; });
    return sides;
}

/// The place of a face within [from, to] that faces that way; none: NaN.
double faceWithin_mm(const SurfaceWindows& all, double from_mm, double to_mm, int facing)
{
    for (const MeridianStretch& stretch : all.stretches)
        if (stretch.isFace() && stretch.facing == facing && stretch.start_mm >= from_mm && stretch.start_mm <= to_mm)
            return stretch.start_mm;
    return notANumber;
}

class ReferenceLine {
public:
    explicit ReferenceLine(const CompareResult& result) : result_(result), all_(*result.windows) {}

    /// From the middle of the first end along the outside to the middle of the last one, through blind bores where
    /// there are some. With a bore from end to end: closed, from the last end through the bore to the first and back
    /// along the outside.
    Line all() const
    {
        const std::vector<MeridianStretch> outside = sidesOf(all_, false), bores = sidesOf(all_, true);
        if (outside.empty()) return {};
        const double first_mm = endOf(outside.front().start_mm, -1), last_mm = endOf(outside.back().end_mm, 1);
        const bool is_through = !bores.empty() && bores.front().start_mm < first_mm + endMargin_mm &&
                                bores.back().end_mm > last_mm - endMargin_mm;
        std::vector<MeridianStretch> at_first, at_last;
        for (const MeridianStretch& bore : bores)
            (is_through || bore.start_mm - first_mm < last_mm - bore.end_mm ? at_first : at_last).push_back(bore);

        Line line = along(at_first, true);
        if (line.empty()) {
            line.emplace_back(first_mm, 0);
        } else {
            line.back().x() = first_mm;
            if (is_through) line.front().x() = last_mm;
            if (!is_through) line.insert(line.begin(), Eigen::Vector2d(line.front().x(), 0));
        }
        const Line sides = along(outside, false);
        line.emplace_back(first_mm, sides.front().y());
        line.insert(line.end(), sides.begin(), sides.end());
        line.emplace_back(last_mm, sides.back().y());
        if (is_through) {
            line.push_back(Eigen::Vector2d(line.front()));
            return line;
        }
        Line inside = along(at_last, true);
        if (!inside.empty()) inside.front().x() = last_mm;
        line.insert(line.end(), inside.begin(), inside.end());
        line.emplace_back(line.back().x(), 0);
        return line;
    }

private:
    /// The face that closes an end of the outside, as the scan shows it; none: where its data end.
    double endOf(double side_mm, int facing) const
    {
        const double face_mm = facing < 0 ? faceWithin_mm(all_, side_mm - endMargin_mm, side_mm, facing)
                                          : faceWithin_mm(all_, side_mm, side_mm + endMargin_mm, facing);
        return std::isnan(face_mm) ? side_mm : face_mm;
    }

    double radiusAt_mm(const MeridianStretch& stretch, double z_mm) const
    {
        const double straight = stretch.radius_mm + stretch.slope * (z_mm - (stretch.start_mm + stretch.end_mm) / 2);
        if (stretch.is_bore || !result_.meridian) return straight;
        const Meridian& meridian = *result_.meridian;
        const auto after = std::lower_bound(meridian.z_mm.begin(), meridian.z_mm.end(), z_mm);
        if (after == meridian.z_mm.end()) return straight;
        const double known = meridian.reference_radius_mm[static_cast<std::size_t>(after - meridian.z_mm.begin())];
        const bool is_same_side = std::abs(known - straight) < 0.1 * stretch.radius_mm;
        return is_same_side ? known : straight;
    }

    /// Sides one after another; between two of them a face across the axis where the radius changes by more than the
    /// way between them. `backward`: from the last to the first.
    Line along(const std::vector<MeridianStretch>& sides, bool backward) const
    {
        Line forward;
        for (const MeridianStretch& side : sides) {
            const Eigen::Vector2d start(side.start_mm, radiusAt_mm(side, side.start_mm));
            if (!forward.empty()) {
                const Eigen::Vector2d before = forward.back();
                const double rise_mm = start.y() - before.y(), gap_mm = start.x() - before.x();
                const int facing = (rise_mm > 0) != side.is_bore ? -1 : 1;
                double face_mm = faceWithin_mm(all_, before.x(), start.x(), facing);
                if (std::isnan(face_mm) && std::abs(rise_mm) > gap_mm) face_mm = (before.x() + start.x()) / 2;
                if (!std::isnan(face_mm)) {
                    forward.emplace_back(face_mm, before.y());
                    forward.emplace_back(face_mm, start.y());
                }
            }
            forward.push_back(start);
            const auto parts = std::max(1L, std::lround((side.end_mm - side.start_mm) / side.reference_step_mm / 2));
            for (long part = 1; part <= parts; ++part) {
                const double z_mm = side.start_mm + (side.end_mm - side.start_mm) * static_cast<double>(part) /
                                                        static_cast<double>(parts);
                forward.emplace_back(z_mm, radiusAt_mm(side, z_mm));
            }
        }
        if (backward) std::reverse(forward.begin(), forward.end());
        return forward;
    }

    const CompareResult& result_;
    const SurfaceWindows& all_;
};

double lengthOf_mm(const Line& line)
{
    double length_mm = 0;
    for (std::size_t i = 1; i < line.size(); ++i) length_mm += (line[i] - line[i - 1]).norm();
    return length_mm;
}

/// Side of the smallest windows: a finer skin would show their edges.
double windowSize_mm(const SurfaceWindows& all)
{
    std::vector<float> sizes;
    forEachSmallest(all, [&sizes](const SurfaceWindow& window) { sizes.push_back(window.size_mm); });
    if (sizes.empty()) return 1;
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return static_cast<double>(*middle);
}

}  // namespace

Skin deviationSkin(const CompareResult& result, const Progress& progress)
{
    Skin skin;
    if (!result.windows || !result.axis_T_reference || result.windows->windows.empty()) return skin;
    const SurfaceWindows& all = *result.windows;
    const Line line = ReferenceLine(result).all();
    if (line.empty()) return skin;
    double largest_mm = 0;
    for (const Eigen::Vector2d& place : line) largest_mm = std::max(largest_mm, place.y());
    const double window_mm = windowSize_mm(all);
    const double step_mm = std::max({leastStep_mm, window_mm / 2, lengthOf_mm(line) / mostStations});
    skin.stations = stationsAlong(line, step_mm);
    skin.angle_count =
        std::clamp(static_cast<int>(std::lround(4 * M_PI * largest_mm / window_mm)), fewestAngles, mostAngles);

    const Eigen::Isometry3d reference_T_axis = result.axis_T_reference->inverse();
    skin.values.assign(skin.vertexCount(), std::numeric_limits<float>::quiet_NaN());
    for (const WindowsOn on : {WindowsOn::Sides, WindowsOn::Faces}) {
        std::vector<std::size_t> vertices;
        std::vector<Eigen::Vector3d> places_mm;
        for (std::size_t vertex = 0; vertex < skin.vertexCount(); ++vertex) {
            const SkinStation& station = skin.stations[vertex / static_cast<std::size_t>(skin.angle_count)];
            if (station.isFace() != (on == WindowsOn::Faces)) continue;
            vertices.push_back(vertex);
            places_mm.emplace_back(reference_T_axis * vertexOf(skin, vertex, 0));
        }
        const std::vector<float> means =
            meansOf(all, windowsOfPlaces(places_mm, result, on, progress), colourSigmaLimit_mm(result));
        for (std::size_t i = 0; i < vertices.size(); ++i) skin.values[vertices[i]] = means[i];
    }
    skin.shift_mm = normalShift_mm(skin);
    return skin;
}

}  // namespace lathelier::registration
