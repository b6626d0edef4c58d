#include "engine/features/model/model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/features/model/model_limits.h"

namespace lathelier::features {
namespace {

double square(double x)
{
    return x * x;
}

/// Squared penalty of a junction that is off by this length.
double penaltyOf(double off_mm)
{
    return square(off_mm / fitLimits.penalty_mm);
}

/// The side of the line that an arc's centre lies on: below it for a convex one.
double sideOf(const Element& arc)
{
    return arc.convex ? 1 : -1;
}

/// Centre of an arc from its ties.
void placeCentre(const Model& model, Run& run, std::size_t k)
{
    Element& arc = run.elements[k];
    const double rho = arc.radius_mm(), g = sideOf(arc);
    if (arc.flat) {
        const double q = std::sqrt(1 + square(arc.slope));
        arc.centre_z_mm = arc.at_mm + g * rho * arc.slope / q;
        arc.centre_r_mm = arc.level_mm - g * rho / q;
        return;
    }
    const Element* const before = k > 0 ? &run.elements[k - 1] : nullptr;
    const Element* const after = k + 1 < run.elements.size() ? &run.elements[k + 1] : nullptr;
    if (arc.start == Tie::Plane) arc.centre_z_mm = model.planes[run.left].z_mm + rho;
    if (arc.end == Tie::Plane) arc.centre_z_mm = model.planes[run.right].z_mm - rho;
    // r_c = level + slope (z_c - at) - g ρ √(1 + slope²): the offset of the line.
    const auto offset = [&](const Element& line) {
        return line.level_mm - g * rho * std::sqrt(1 + square(line.slope));
    };
    const bool tangent_start = arc.start == Tie::Tangent && before, tangent_end = arc.end == Tie::Tangent && after;
    if (isOnAxis(arc)) {
        arc.centre_r_mm = 0;
        if (!tangent_start && !tangent_end) return;
        const Element& line = tangent_start ? *before : *after;
        const double distance_mm = std::abs(line.radiusAt_mm(arc.centre_z_mm)) / std::sqrt(1 + square(line.slope));
        arc.log_radius = std::log(std::max(fitLimits.least_element_mm, distance_mm));
        return;
    }
    if (tangent_start && tangent_end) {
        const double bend = before->slope - after->slope;
        if (std::abs(bend) > fitLimits.parallel_slope) {
            const double a = offset(*before) - before->slope * before->at_mm;
            const double b = offset(*after) - after->slope * after->at_mm;
            arc.centre_z_mm = (b - a) / bend;
            arc.centre_r_mm = a + before->slope * arc.centre_z_mm;
        } else {
            run.violation += fitLimits.no_junction_penalty;
        }
    } else if (tangent_start || tangent_end) {
        const Element& line = tangent_start ? *before : *after;
        arc.centre_r_mm = offset(line) + line.slope * (arc.centre_z_mm - line.at_mm);
    }
}

/// Foot of the perpendicular from the centre of a tangent arc to the line.
double foot(const Element& arc, const Element& line)
{
    return arc.centre_z_mm - sideOf(arc) * arc.radius_mm() * line.slope / std::sqrt(1 + square(line.slope));
}

/// Where a line and an arc meet, nearest to `hint`; the gap between them is a penalty.
double meetLineAndArc(const Element& line, const Element& arc, double hint, double& violation)
{
    // (z - z_c)² + (m + s (z - z_c))² = ρ² with m the line's height over the centre.
    const double s = line.slope, m = line.level_mm + s * (arc.centre_z_mm - line.at_mm) - arc.centre_r_mm;
    const double a = 1 + s * s, b = s * m, c = m * m - square(arc.radius_mm());
    const double disc = b * b - a * c;
    if (disc < 0) {
        violation += penaltyOf(std::abs(m) / std::sqrt(a) - arc.radius_mm());
        return arc.centre_z_mm - b / a;
    }
    const double one = arc.centre_z_mm + (-b - std::sqrt(disc)) / a, two = arc.centre_z_mm + (-b + std::sqrt(disc)) / a;
    return std::abs(one - hint) < std::abs(two - hint) ? one : two;
}

double meetArcs(const Element& p, const Element& q, double hint, double& violation)
{
    const double dz = q.centre_z_mm - p.centre_z_mm, dr = q.centre_r_mm - p.centre_r_mm, d = std::hypot(dz, dr);
    const double a = p.radius_mm(), b = q.radius_mm();
    if (!(d > fitLimits.coincident_mm)) {
        violation += fitLimits.no_junction_penalty;
        return hint;
    }
    const double at = (d * d + a * a - b * b) / (2 * d), disc = a * a - at * at;
    const double z = p.centre_z_mm + at * dz / d;
    if (disc < 0) {
        violation += penaltyOf(std::abs(at) - a);
        return z;
    }
    const double half = std::sqrt(disc) * dr / d;
    return std::abs(z - half - hint) < std::abs(z + half - hint) ? z - half : z + half;
}

double meet(const Element& p, const Element& q, double hint, double& violation)
{
    if (!p.arc && !q.arc) {
        const double bend = p.slope - q.slope;
        const double gap = (q.level_mm - q.slope * q.at_mm) - (p.level_mm - p.slope * p.at_mm);
        if (std::abs(bend) > fitLimits.parallel_slope) return gap / bend;
        violation += penaltyOf(gap);
        return hint;
    }
    if (p.arc && q.arc) return meetArcs(p, q, hint, violation);
    if (p.arc) return p.end == Tie::Tangent ? foot(p, q) : meetLineAndArc(q, p, hint, violation);
    return q.start == Tie::Tangent ? foot(q, p) : meetLineAndArc(p, q, hint, violation);
}

std::size_t elementAt(const Run& run, double z_mm)
{
    const auto next = std::upper_bound(run.nodes_mm.begin() + 1, run.nodes_mm.end() - 1, z_mm);
    return static_cast<std::size_t>(next - run.nodes_mm.begin()) - 1;
}

/// How far the mean radius of a bin lies off an arc when the noise is along the normal and the points lie evenly over
/// the surface: to second order in the noise σ² f'' (1 + s²/(2 (1 + s²))), f'' = ∓(1 + s²)^(3/2)/ρ, s the slope.
double normalNoiseShift_mm(const Element& arc, double z_mm, double sigma_mm)
{
    constexpr double steepest = fitLimits.steepest_slope;
    const double s = std::clamp(arc.slopeAt(z_mm), -steepest, steepest), q = 1 + s * s;
    const double bend = (arc.convex ? -1 : 1) * q * std::sqrt(q) / arc.radius_mm();
    return sigma_mm * sigma_mm * bend * (1 + s * s / (2 * q));
}

}  // namespace

bool isOnAxis(const Element& arc)
{
    return arc.start == Tie::Axis || arc.end == Tie::Axis;
}

double Element::radius_mm() const
{
    return std::exp(log_radius);
}

double Element::radiusAt_mm(double z_mm) const
{
    if (!arc) return level_mm + slope * (z_mm - at_mm);
    const double rho = radius_mm(), off = z_mm - centre_z_mm;
    if (flat) {
        // level + g (√(ρ² - off²) - ρ/q) without the difference of large numbers.
        const double g = sideOf(*this), from_mm = z_mm - at_mm, at_middle_mm = rho / std::sqrt(1 + square(slope));
        return level_mm + g * from_mm * (2 * g * slope * at_middle_mm - from_mm) /
                              (std::sqrt(std::max(0.0, rho * rho - off * off)) + at_middle_mm);
    }
    return centre_r_mm + (convex ? 1 : -1) * std::sqrt(std::max(0.0, rho * rho - off * off));
}

double Element::slopeAt(double z_mm) const
{
    if (!arc) return slope;
    const double rho = radius_mm(), off = z_mm - centre_z_mm;
    return -(convex ? 1 : -1) * off /
           std::sqrt(std::max(fitLimits.least_depth_share * rho * rho, rho * rho - off * off));
}

void resolve(const Model& model, Run& run)
{
    const std::size_t n = run.elements.size();
    run.violation = 0;
    for (std::size_t k = 0; k < n; ++k)
        if (run.elements[k].arc) placeCentre(model, run, k);
    if (run.nodes_mm.size() != n + 1) run.nodes_mm.assign(n + 1, 0);
    const Element &first = run.elements.front(), &last = run.elements.back();
    run.nodes_mm.front() =
        first.start == Tie::Axis ? first.centre_z_mm - first.radius_mm() : model.planes[run.left].z_mm;
    run.nodes_mm.back() = last.end == Tie::Axis ? last.centre_z_mm + last.radius_mm() : model.planes[run.right].z_mm;
    for (std::size_t k = 0; k + 1 < n; ++k)
        run.nodes_mm[k + 1] = meet(run.elements[k], run.elements[k + 1], run.nodes_mm[k + 1], run.violation);
    for (std::size_t k = 0; k < n; ++k) {
        const double length = run.nodes_mm[k + 1] - run.nodes_mm[k];
        if (!(length > fitLimits.least_element_mm)) run.violation += penaltyOf(length - fitLimits.least_element_mm);
        const Element& e = run.elements[k];
        if (!e.arc) continue;
        // An arc is less than half a turn and single-valued along z.
        const double over =
            std::max(run.nodes_mm[k + 1] - e.centre_z_mm, e.centre_z_mm - run.nodes_mm[k]) - e.radius_mm();
        if (over > fitLimits.arc_overrun_mm) run.violation += penaltyOf(over);
    }
}

void releaseLostTies(Run& run)
{
    for (std::size_t i = 0; i < run.elements.size(); ++i) {
        Element& e = run.elements[i];
        if (!e.arc) continue;
        const bool first = i == 0, last = i + 1 == run.elements.size();
        if (e.start == Tie::Tangent && (first || run.elements[i - 1].arc)) e.start = Tie::Free;
        if (e.end == Tie::Tangent && (last || run.elements[i + 1].arc)) e.end = Tie::Free;
        if ((e.start == Tie::Plane || e.start == Tie::Axis) && !first) e.start = Tie::Free;
        if ((e.end == Tie::Plane || e.end == Tie::Axis) && !last) e.end = Tie::Free;
    }
}

double radiusAt_mm(const Run& run, double z_mm)
{
    return run.elements[elementAt(run, z_mm)].radiusAt_mm(z_mm);
}

double predicted_mm(const Model& model, const Run& run, const Wall& wall)
{
    const double reach = (model.spot_mm + wall.width_mm) / 2;
    const double half = model.spot_mm / 2;
    const std::size_t low = elementAt(run, wall.z_mm - reach), high = elementAt(run, wall.z_mm + reach);
    const Plane& left = model.planes[run.left];
    const Plane& right = model.planes[run.right];
    const bool cut_left = left.is_clear && wall.z_mm - reach < left.z_mm,
               cut_right = right.is_clear && wall.z_mm + reach > right.z_mm;
    if (low == high && !run.elements[low].arc && (run.elements[low].slope == 0 || (!cut_left && !cut_right)))
        return run.elements[low].radiusAt_mm(wall.z_mm);
    constexpr std::array<double, 3> weight{5.0 / 18, 8.0 / 18, 5.0 / 18};
    const double step = std::sqrt(0.6) / 2;
    const double first = run.nodes_mm.front(), last = run.nodes_mm.back();
    double sum = 0;
    for (std::size_t j = 0; j < 3; ++j) {
        const double ray = wall.z_mm + step * (static_cast<double>(j) - 1) * wall.width_mm;
        const double from = cut_left ? std::clamp(left.z_mm - ray, -half, half) : -half;
        const double to = cut_right ? std::clamp(right.z_mm - ray, -half, half) : half;
        for (std::size_t i = 0; i < 3; ++i) {
            const double z = ray + (from + to) / 2 + step * (static_cast<double>(i) - 1) * (to - from);
            sum += weight[i] * weight[j] * radiusAt_mm(run, std::clamp(z, first, last));
        }
    }
    const std::size_t own = elementAt(run, wall.z_mm);
    if (model.corner_mm > 0 && run.elements[own].arc && model.sigma_mm > 0) {
        // Noise displaces points of an arc of similar length to its neighbours.
        const double length = run.nodes_mm[own + 1] - run.nodes_mm[own];
        const double share = std::clamp(length / (fitLimits.short_arc_sigmas * model.sigma_mm) - 1, 0.0, 1.0);
        if (share > 0) sum += share * normalNoiseShift_mm(run.elements[own], wall.z_mm, model.sigma_mm);
    }
    return sum;
}

bool counts(const Model& model, const Run& run, const Wall& wall)
{
    const auto reach = [&](const Plane& plane, int side) {
        const double blurred = (model.spot_mm + wall.width_mm) / 2 + model.edge_mm;
        const double lean = plane.low_side == -side ? 0 : plane.lean;
        if (!plane.is_clear || model.spot_mm <= 0) return blurred + lean;
        const double margin = std::max(fitLimits.clear_margin_mm, fitLimits.clear_margin_sigmas * plane.sigma_mm);
        return std::min(blurred, wall.width_mm / 2 + margin) + lean;
    };
    const Plane& left = model.planes[run.left];
    const Plane& right = model.planes[run.right];
    if (wall.z_mm < left.z_mm + reach(left, 1) || wall.z_mm > right.z_mm - reach(right, -1)) return false;
    if (model.corner_mm > 0)
        for (std::size_t k = 0; k + 1 < run.elements.size(); ++k) {
            const double node = run.nodes_mm[k + 1];
            if (std::abs(wall.z_mm - node) > model.corner_mm + wall.width_mm / 2) continue;
            const double bend = std::atan(run.elements[k].slopeAt(node)) - std::atan(run.elements[k + 1].slopeAt(node));
            if (std::abs(bend) > fitLimits.sharp_corner_rad) return false;
        }
    return true;
}

double sigmaOf(const Model& model, const Wall& wall)
{
    constexpr double floor_mm = fitLimits.wall_floor_mm;
    const double own = std::max(wall.sigma_mm, fitLimits.least_scatter_share * model.sigma_mm);
    return std::sqrt(own * own / std::max(1.0, wall.points) + floor_mm * floor_mm + wall.shared_mm * wall.shared_mm);
}

double startRadius_mm(const Run& run)
{
    return run.elements.front().radiusAt_mm(run.nodes_mm.front());
}

double endRadius_mm(const Run& run)
{
    return run.elements.back().radiusAt_mm(run.nodes_mm.back());
}

}  // namespace lathelier::features
