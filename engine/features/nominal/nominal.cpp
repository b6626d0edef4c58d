#include "engine/features/nominal/nominal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/units.h"
#include "engine/features/nominal/nominal_limits.h"

namespace lathelier::features {
namespace {

/// Multiples of whole/parts mm: exact decimals, unlike multiples of 0.1.
struct Grid {
    double whole_mm, parts, least_mm;
    double size_mm() const { return whole_mm / parts; }
    double nearest_mm(double x_mm) const { return std::round(x_mm * parts / whole_mm) * whole_mm / parts; }
};
constexpr std::array<Grid, 4> sizeGrids{{{5, 1, 10}, {1, 1, 0}, {1, 2, 0}, {1, 10, 0}}};

template <class HalfTolerance>
std::optional<Suggestion> onGrid(double measured_mm, double U_mm, HalfTolerance halfTolerance_mm)
{
    if (!std::isfinite(measured_mm) || !(U_mm >= 0)) return {};
    for (const Grid& grid : sizeGrids) {
        const double nominal = grid.nearest_mm(measured_mm), share = grid.size_mm() / nominalLimits.grid_share;
        if (!(nominal > 0) || nominal < grid.least_mm || U_mm > share + nominalLimits.rounding_mm) continue;
        const std::optional<double> tolerance = halfTolerance_mm(nominal);
        if (!tolerance) continue;
        const double window = std::min(U_mm + *tolerance, share);
        if (std::abs(measured_mm - nominal) > window + nominalLimits.rounding_mm) continue;
        Suggestion found;
        found.measured_mm = measured_mm;
        found.nominal_mm = nominal;
        found.difference_um = 1000 * (measured_mm - nominal);
        found.grid_mm = grid.size_mm();
        found.chance_percent = 100 * 2 * window / grid.size_mm();
        return found;
    }
    return {};
}

/// The member of an ascending series that is nearest, within `window(member)`.
template <class Window>
std::optional<Suggestion> inSeries(double measured, std::span<const double> series, Window window)
{
    if (!std::isfinite(measured)) return {};
    std::size_t best = 0;
    for (std::size_t i = 1; i < series.size(); ++i)
        if (std::abs(series[i] - measured) < std::abs(series[best] - measured)) best = i;
    const double w = window(series[best]);
    if (!(std::abs(measured - series[best]) <= w + nominalLimits.rounding_mm)) return {};
    const std::size_t before = best > 0 ? best - 1 : best, after = std::min(best + 1, series.size() - 1);
    const double spacing = (series[after] - series[before]) / static_cast<double>(after - before);
    Suggestion found;
    found.measured_mm = measured;
    found.nominal_mm = series[best];
    found.difference_um = 1000 * (measured - series[best]);
    found.chance_percent = std::min(100.0, 100 * 2 * w / spacing);
    return found;
}

bool isWithin(Measured measured, double nominal_mm, double lower_mm, double upper_mm)
{
    const double off = measured.value_mm - nominal_mm;
    return off >= lower_mm - measured.U_mm - nominalLimits.rounding_mm &&
           off <= upper_mm + measured.U_mm + nominalLimits.rounding_mm;
}

double ratioOf(double half_angle_deg)
{
    return 2 * std::tan(half_angle_deg * rad_per_deg);
}

}  // namespace

std::optional<Suggestion> suggestDiameter(double measured_mm, double U_mm, Surface surface)
{
    auto found = onGrid(measured_mm, U_mm, [](double nominal_mm) -> std::optional<double> {
        const double size_mm = std::min(nominal_mm, nominalLimits.largest_iso_size_mm);
        return standardTolerance_um(nominalLimits.diameter_grade, size_mm).value_or(0) / 2000;
    });
    if (!found) return {};
    found->quantity = "diameter_mm";
    found->fits = fitsOf(measured_mm, U_mm, found->nominal_mm, surface);
    return found;
}

std::optional<Suggestion> suggestLength(double measured_mm, double U_mm, std::string_view quantity)
{
    auto found = onGrid(measured_mm, U_mm, [](double nominal_mm) -> std::optional<double> {
        const auto tolerance = generalTolerance_mm(nominal_mm);
        if (!tolerance) return {};
        return *tolerance / 2;
    });
    if (found) found->quantity = quantity;
    return found;
}

std::optional<double> nominalChamferAngle_deg(double angle_deg, double U_deg)
{
    std::optional<double> best;
    for (const double angle : chamferAngles_deg()) {
        const double off = std::abs(std::abs(angle_deg) - angle);
        if (off > U_deg + nominalLimits.chamfer_angle_deg + nominalLimits.rounding_mm) continue;
        if (!best || off < std::abs(std::abs(angle_deg) - *best)) best = angle;
    }
    return best;
}

std::optional<Suggestion> suggestChamfer(double leg_mm, double U_mm, double angle_deg, double U_deg)
{
    const auto angle = nominalChamferAngle_deg(angle_deg, U_deg);
    if (!angle) return {};
    auto found = inSeries(leg_mm, chamferLegs_mm(), [&](double) { return U_mm + nominalLimits.chamfer_leg_mm; });
    if (!found) return {};
    found->quantity = "leg_mm";
    found->designation = fmt::format("{}×{}°", found->nominal_mm, *angle);
    return found;
}

std::optional<Suggestion> suggestRadius(double radius_mm, double U_mm)
{
    const double radius = std::abs(radius_mm);
    auto found = inSeries(radius, radii_mm(),
                          [&](double nominal) { return std::max(U_mm, nominalLimits.radius_share * nominal); });
    if (!found && radius > radii_mm().back()) found = suggestLength(radius, U_mm);
    if (!found) return {};
    found->quantity = "radius_mm";
    found->designation = fmt::format("R{}", found->nominal_mm);
    return found;
}

std::vector<Suggestion> suggestTapers(const MeasuredCone& cone)
{
    const double angle = std::abs(cone.half_angle_deg);
    std::vector<std::pair<double, Suggestion>> found;
    const auto consider = [&](double nominal_deg, double ratio, double window_deg, double spacing_deg,
                              std::string designation) {
        const double off = std::abs(angle - nominal_deg);
        if (!(off <= window_deg + nominalLimits.rounding_mm)) return;
        Suggestion one;
        one.quantity = "taper";
        one.measured_mm = ratioOf(angle);
        one.nominal_mm = ratio;
        one.difference_um = 1000 * (one.measured_mm - ratio);
        one.chance_percent = std::min(100.0, 100 * 2 * window_deg / spacing_deg);
        one.designation = std::move(designation);
        found.emplace_back(off, std::move(one));
    };
    std::vector<double> angles;
    for (const StandardTaper& taper : standardTapers())
        if (taper.gauge_mm == 0) angles.push_back(std::atan(taper.ratio / 2) / rad_per_deg);
    std::sort(angles.begin(), angles.end());
    for (const StandardTaper& taper : standardTapers()) {
        if (taper.gauge_mm > 0 &&
            (cone.small_mm < nominalLimits.smallest_morse_ratio * taper.gauge_mm ||
             cone.large_mm > nominalLimits.largest_morse_ratio * taper.gauge_mm || cone.large_mm < cone.small_mm))
            continue;
        const double nominal = std::atan(taper.ratio / 2) / rad_per_deg;
        // Spacing of the plain series about it: Morse tapers have nearly equal ratios and are distinguished by their
        // diameters.
        const auto above = std::upper_bound(angles.begin(), angles.end(), nominal + nominalLimits.rounding_mm);
        const auto at = std::lower_bound(angles.begin(), angles.end(), nominal - nominalLimits.rounding_mm);
        const double high = above != angles.end() ? *above : 2 * nominal;
        const double low = at != angles.begin() ? *(at - 1) : 0;
        consider(nominal, taper.ratio, cone.U_deg + nominalLimits.taper_angle_deg, (high - low) / 2,
                 std::string(taper.name));
    }
    if (angle > nominalLimits.steepest_taper_deg) {
        const double side = std::min(cone.length_mm, std::abs(cone.large_mm - cone.small_mm) / 2);
        const double window = cone.U_deg + generalAngleTolerance_deg(side) / 2;
        for (const double one : chamferAngles_deg())
            consider(one, ratioOf(one), window, nominalLimits.chamfer_angle_spacing_deg, fmt::format("{}°", one));
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Suggestion> result;
    for (auto& [off, one] : found)
        if (result.size() < nominalLimits.most_tapers) result.push_back(std::move(one));
    return result;
}

std::optional<Suggestion> suggestThread(double crest_mm, double U_mm, double pitch_mm)
{
    double pitch = 0;
    const auto consider = [&](double one) {
        if (std::abs(one - pitch_mm) < std::abs(pitch - pitch_mm)) pitch = one;
    };
    for (const double one : finePitches_mm()) consider(one);
    for (const CoarseThread& thread : coarseThreads()) consider(thread.pitch_mm);
    if (!(std::abs(pitch - pitch_mm) <= nominalLimits.pitch_share * pitch)) return {};
    const double upper_mm = -(15 + 11 * pitch) / 1000;
    const double lower_mm = upper_mm - (180 * std::cbrt(pitch * pitch) - 3.15 / std::sqrt(pitch)) / 1000;
    const double expanded_mm = std::max(U_mm, -upper_mm);  // a crest without the deviation g is accepted too
    std::optional<double> diameter;
    for (const CoarseThread& thread : coarseThreads()) {
        if (pitch > thread.pitch_mm || !isWithin({crest_mm, expanded_mm}, thread.diameter_mm, lower_mm, upper_mm))
            continue;
        if (!diameter || std::abs(thread.diameter_mm - crest_mm) < std::abs(*diameter - crest_mm))
            diameter = thread.diameter_mm;
    }
    if (!diameter) return {};
    Suggestion found;
    found.quantity = "diameter_mm";
    found.measured_mm = crest_mm;
    found.nominal_mm = *diameter;
    found.difference_um = 1000 * (crest_mm - *diameter);
    found.designation = fmt::format("M{}×{}", *diameter, pitch);
    return found;
}

std::optional<CirclipGroove> circlipGrooveOf(Measured shaft, Measured bottom, Measured width)
{
    const auto tolerance_mm = [](int grade, double size_mm) {
        return standardTolerance_um(grade, size_mm).value_or(0) / 1000;
    };
    std::optional<CirclipGroove> best;
    for (const CirclipGroove& groove : circlipGrooves()) {
        const double below_shaft = tolerance_mm(nominalLimits.circlip_shaft_grade, groove.shaft_mm);
        const double below_bottom = tolerance_mm(nominalLimits.circlip_bottom_grade, groove.groove_mm);
        // Rings are also fitted on seats of bearings, which lie above the nominal size.
        const std::optional<Limits> seat = limitsOf(nominalLimits.circlip_seat_class, groove.shaft_mm);
        if (!isWithin(shaft, groove.shaft_mm, -below_shaft, seat ? seat->upper_um / 1000 : 0) ||
            !isWithin(width, groove.width_mm, 0, nominalLimits.circlip_width_mm) ||
            !isWithin(bottom, groove.groove_mm, -below_bottom, 0))
            continue;
        if (!best || std::abs(groove.groove_mm - bottom.value_mm) < std::abs(best->groove_mm - bottom.value_mm))
            best = groove;
    }
    return best;
}

std::string designationOf(const CirclipGroove& groove)
{
    return fmt::format("DIN 471 - {}", groove.shaft_mm);
}

std::optional<Undercut> undercutOf(const MeasuredUndercut& measured)
{
    constexpr double depth_mm = nominalLimits.undercut_depth_mm, width_mm = nominalLimits.undercut_width_mm,
                     radius_mm = nominalLimits.undercut_radius_mm;
    std::optional<Undercut> best;
    double least = 0;
    for (const Undercut& one : undercuts()) {
        if (!isWithin(measured.depth, one.depth_mm, 0, depth_mm) ||
            !isWithin(measured.width, one.width_mm, 0, width_mm) ||
            !isWithin(measured.radius, one.radius_mm, -radius_mm, radius_mm))
            continue;
        double distance = std::abs(measured.depth.value_mm - one.depth_mm) / depth_mm +
                          std::abs(measured.width.value_mm - one.width_mm) / width_mm +
                          std::abs(measured.radius.value_mm - one.radius_mm) / radius_mm;
        if (measured.shaft_mm <= one.over_mm || measured.shaft_mm > one.to_mm)
            distance += nominalLimits.unusual_shaft_price;
        if (best && distance >= least) continue;
        best = one;
        least = distance;
    }
    return best;
}

std::optional<std::pair<Undercut, UndercutForm>> undercutOf(std::string_view designation)
{
    for (const Undercut& one : undercuts())
        for (const UndercutForm form : {UndercutForm::E, UndercutForm::F})
            if (designationOf(one, form) == designation) return std::pair(one, form);
    return {};
}

}  // namespace lathelier::features
