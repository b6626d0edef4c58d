#include "engine/registration/revolution/revolution_shift.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/core/units.h"

namespace lathelier::registration {
namespace {

/// Between the middles of two bins; NaN where there is none.
double radiusAt(const RadiusProfile& p, double z)
{
    const double place = (z - p.z_start_mm) / p.step_mm - 0.5;
    if (!(place >= 0) || place >= static_cast<double>(p.size()) - 1) return notANumber;
    const auto i = static_cast<std::size_t>(place);
    const double t = place - static_cast<double>(i);
    return (1 - t) * p.radius_mm[i] + t * p.radius_mm[i + 1];
}

/// Cost of one shift: mean difference of the radii, capped, plus half the cap for bins without overlap. `known`: bins
/// of the reference that have a radius.
double costOf(const RadiusProfile& reference, double known, const RadiusProfile& copy, double shift, double cap,
              std::size_t stride)
{
    double sum = 0;
    double both = 0;
    double all = 0;
    for (std::size_t i = 0; i < copy.size(); i += stride) {
        if (std::isnan(copy.radius_mm[i])) continue;
        ++all;
        const double there = radiusAt(reference, copy.middle_mm(i) + shift);
        if (std::isnan(there)) continue;
        ++both;
        sum += std::min(cap, std::abs(there - copy.radius_mm[i]));
    }
    const double length = std::min(all * copy.step_mm * static_cast<double>(stride), known * reference.step_mm);
    const double overlap = std::min(1.0, both * copy.step_mm * static_cast<double>(stride) / length);
    if (overlap < 0.25) return std::numeric_limits<double>::infinity();
    return sum / both + 0.5 * cap * (1 - overlap);
}

}  // namespace

double lengthOf(const RadiusProfile& p)
{
    return p.step_mm * static_cast<double>(p.size());
}
double middleOf(const RadiusProfile& p)
{
    return p.z_start_mm + lengthOf(p) / 2;
}

std::optional<RadiusReading> readRadius(const RadiusProfile& p, double z)
{
    const double place = (z - p.z_start_mm) / p.step_mm - 0.5;
    if (!(place >= 0) || place >= static_cast<double>(p.size()) - 1) return std::nullopt;
    const auto i = static_cast<std::size_t>(place);
    const double t = place - static_cast<double>(i);
    const double radius = (1 - t) * p.radius_mm[i] + t * p.radius_mm[i + 1];
    if (std::isnan(radius)) return std::nullopt;
    const double own = (1 - t) * p.sigma_mm[i], next = t * p.sigma_mm[i + 1];
    return RadiusReading{radius, (p.radius_mm[i + 1] - p.radius_mm[i]) / p.step_mm, std::sqrt(own * own + next * next)};
}

ShiftMatch findShift(const RadiusProfile& reference, const RadiusProfile& copy, double centre, double reach,
                     double home, double cap)
{
    ShiftMatch best;
    double step = std::max(reference.step_mm, copy.step_mm);
    const double even = 1e-3 * cap;  // differences below this are noise
    double known = 0;
    for (const double r : reference.radius_mm) known += std::isnan(r) ? 0 : 1;
    const auto scan = [&](double from, double to, std::size_t stride) {
        const int count = static_cast<int>((to - from) / step) + 1;
        std::vector<ShiftMatch> matches;
        for (int k = 0; k <= count; ++k) {
            const double shift = from + k * step;
            matches.push_back({shift, costOf(reference, known, copy, shift, cap, stride)});
        }
        double least = std::numeric_limits<double>::infinity();
        for (const ShiftMatch& m : matches) least = std::min(least, m.cost);
        for (const ShiftMatch& m : matches)
            if (m.cost <= least + even &&
                (best.cost > least + even || std::abs(m.shift - home) < std::abs(best.shift - home)))
                best = m;
    };
    scan(centre - reach, centre + reach, 4);
    if (!std::isfinite(best.cost)) return best;
    for (int i = 0; i < 3; ++i) {
        const double around = best.shift;
        const double width = 4 * step;
        if (i > 0) step /= 4;
        best.cost = std::numeric_limits<double>::infinity();
        scan(around - width, around + width, 1);
    }
    return best;
}

}  // namespace lathelier::registration
