#include "engine/deflection/written_arc.h"

#include <algorithm>
#include <cmath>

namespace lathelier::deflection {
namespace {

constexpr std::size_t triedMiddles = 24;  ///< places where two arcs may meet
constexpr int radiusSteps = 3;            ///< of the least-squares search
constexpr int besideBest = 2;             ///< grid values tried to either side

double onArc(double centre_z_mm, double centre_x_mm, double radius_mm, bool is_upper, double z_mm)
{
    const double along_mm = z_mm - centre_z_mm;
    const double across_mm = std::sqrt(std::max(0.0, radius_mm * radius_mm - along_mm * along_mm));
    return centre_x_mm + (is_upper ? across_mm : -across_mm);
}

/// Fits arcs between places.
class ArcFitter {
public:
    ArcFitter(const std::vector<WantedPlace>& wanted, const WantedArc& arc, const ArcLimits& limits)
        : wanted_(wanted), arc_(arc), limits_(limits)
    {
    }

    struct Fit {
        ArcCentre centre;
        double off_mm = 0;
    };

    /// The best arc from place `i` at `from_mm` to place `j` at `to_mm`.
    Fit fit(std::size_t i, double from_mm, std::size_t j, double to_mm) const
    {
        Ends ends{i, j, wanted_[i].z_mm, from_mm, wanted_[j].z_mm, to_mm};
        const double least_mm = ends.chord_mm() / 2 * (1 + 1e-9);
        const double programmed_mm =
            std::hypot(wanted_[arc_.first].z_mm - arc_.centre.z_mm, wanted_[arc_.first].x_mm - arc_.centre.x_mm);
        double radius_mm = std::max(least_mm, programmed_mm);
        for (int step = 0; step < radiusSteps && j > i + 1; ++step) radius_mm = improved(ends, radius_mm, least_mm);
        return arc_.centre.by_centre ? bestCentre(ends, radius_mm) : bestRadius(ends, radius_mm, least_mm);
    }

private:
    struct Ends {
        std::size_t i, j;
        double from_z_mm, from_x_mm, to_z_mm, to_x_mm;
        double chord_mm() const { return std::hypot(to_z_mm - from_z_mm, to_x_mm - from_x_mm); }
    };

    /// Centre of the arc of this radius that passes both ends; the contour lies on the other side of the chord.
    ArcCentre centreOf(const Ends& ends, double radius_mm) const
    {
        ArcCentre centre = arc_.centre;
        const double dz_mm = ends.to_z_mm - ends.from_z_mm, dx_mm = ends.to_x_mm - ends.from_x_mm;
        const double half_mm = ends.chord_mm() / 2;
        const double height_mm = std::sqrt(std::max(0.0, radius_mm * radius_mm - half_mm * half_mm));
        const double side = (arc_.is_upper ? -1 : 1) * height_mm / (2 * half_mm);
        centre.z_mm = (ends.from_z_mm + ends.to_z_mm) / 2 - side * dx_mm;
        centre.x_mm = (ends.from_x_mm + ends.to_x_mm) / 2 + side * dz_mm;
        return centre;
    }

    double at(const ArcCentre& centre, double radius_mm, std::size_t place) const
    {
        return onArc(centre.z_mm, centre.x_mm, radius_mm, arc_.is_upper, wanted_[place].z_mm);
    }

    /// One step of least squares for the curvature.
    double improved(const Ends& ends, double radius_mm, double least_mm) const
    {
        constexpr double change = 1e-5;
        const double beside_mm = radius_mm * (1 + change);
        const ArcCentre here = centreOf(ends, radius_mm), beside = centreOf(ends, beside_mm);
        double up = 0, down = 0;
        for (std::size_t k = ends.i + 1; k < ends.j; ++k) {
            if (wanted_[k].is_free) continue;
            const double x_mm = at(here, radius_mm, k);
            const double slope = (at(beside, beside_mm, k) - x_mm) / (1 / beside_mm - 1 / radius_mm);
            up += slope * (wanted_[k].x_mm - x_mm);
            down += slope * slope;
        }
        if (!(down > 0)) return radius_mm;
        const double curvature = std::clamp(1 / radius_mm + up / down, 0.5 / radius_mm, 2 / radius_mm);
        return std::max(least_mm, 1 / curvature);
    }

    double off(const Ends& ends, const ArcCentre& centre, double radius_mm, double enough_mm) const
    {
        double largest_mm = beyondTurn_mm(ends, centre);
        for (std::size_t k = ends.i + 1; k < ends.j && largest_mm < enough_mm; ++k)
            if (!wanted_[k].is_free)
                largest_mm = std::max(largest_mm, std::abs(at(centre, radius_mm, k) - wanted_[k].x_mm));
        return largest_mm;
    }

    /// How far an end lies behind the place where the circle turns back along z; rounding may bring it there.
    double beyondTurn_mm(const Ends& ends, const ArcCentre& centre) const
    {
        constexpr double rounding_mm = 5e-4;
        const double beyond_mm = arc_.is_upper ? centre.x_mm - std::min(ends.from_x_mm, ends.to_x_mm)
                                               : std::max(ends.from_x_mm, ends.to_x_mm) - centre.x_mm;
        return std::max(0.0, beyond_mm - rounding_mm);
    }

    Fit bestRadius(const Ends& ends, double radius_mm, double least_mm) const
    {
        const double grid_mm = limits_.centre_grid_mm;
        const double middle = std::max(std::round(radius_mm / grid_mm), std::ceil(least_mm / grid_mm) + besideBest);
        Fit best{{}, HUGE_VAL};
        for (double n = middle - besideBest; n <= middle + besideBest; ++n) {
            const ArcCentre centre = centreOf(ends, n * grid_mm);
            const double off_mm = off(ends, centre, n * grid_mm, best.off_mm);
            if (off_mm < best.off_mm) best = {centre, off_mm};
        }
        return best;
    }

    Fit bestCentre(const Ends& ends, double radius_mm) const
    {
        const double grid_mm = limits_.centre_grid_mm;
        const ArcCentre near = centreOf(ends, radius_mm);
        const double z = std::round((near.z_mm - ends.from_z_mm) / grid_mm);
        const double x = std::round((near.x_mm - ends.from_x_mm) / grid_mm);
        Fit best{{}, HUGE_VAL};
        for (double m = z - besideBest; m <= z + besideBest; ++m)
            for (double n = x - besideBest; n <= x + besideBest; ++n) {
                ArcCentre centre = arc_.centre;
                centre.z_mm = ends.from_z_mm + m * grid_mm;
                centre.x_mm = ends.from_x_mm + n * grid_mm;
                const double turned_mm = std::hypot(m * grid_mm, n * grid_mm);
                const double missed_mm =
                    std::abs(std::hypot(ends.to_z_mm - centre.z_mm, ends.to_x_mm - centre.x_mm) - turned_mm);
                if (missed_mm >= best.off_mm) continue;
                const double off_mm = std::max(missed_mm, off(ends, centre, turned_mm, best.off_mm));
                if (off_mm < best.off_mm) best = {centre, off_mm};
            }
        return best;
    }

    const std::vector<WantedPlace>& wanted_;
    const WantedArc& arc_;
    const ArcLimits& limits_;
};

/// Grid radii within the tolerance of a place, the nearest first; at least one.
std::vector<double> gridRadii(double x_mm, const ArcLimits& limits)
{
    const double nearest = std::round(x_mm / limits.grid_mm);
    const double other = nearest * limits.grid_mm < x_mm ? nearest + 1 : nearest - 1;
    std::vector<double> radii{nearest * limits.grid_mm};
    if (std::abs(other * limits.grid_mm - x_mm) <= limits.tolerance_mm) radii.push_back(other * limits.grid_mm);
    return radii;
}

/// As few arcs as hold the tolerance, each as long as it can be.
std::vector<ArcEnd> manyArcs(const ArcFitter& fitter, const std::vector<WantedPlace>& wanted, const WantedArc& arc,
                             double from_mm, double to_mm, const ArcLimits& limits)
{
    std::vector<ArcEnd> ends;
    std::size_t i = arc.first;
    double x_mm = from_mm;
    const auto reach = [&](std::size_t j) {
        ArcEnd best{j, 0, {}};
        double off_mm = HUGE_VAL;
        for (const double radius_mm : j == arc.last ? std::vector{to_mm} : gridRadii(wanted[j].x_mm, limits)) {
            const ArcFitter::Fit fit = fitter.fit(i, x_mm, j, radius_mm);
            if (fit.off_mm >= off_mm) continue;
            off_mm = fit.off_mm;
            best = {j, radius_mm, fit.centre};
        }
        return std::pair{best, off_mm <= limits.tolerance_mm};
    };
    while (i < arc.last) {
        auto [end, fits] = reach(arc.last);
        if (!fits) {
            std::size_t low = i + 1, high = arc.last;
            end = reach(low).first;
            while (high - low > 1) {
                const std::size_t middle = (low + high) / 2;
                const auto [found, is_near] = reach(middle);
                (is_near ? low : high) = middle;
                if (is_near) end = found;
            }
        }
        ends.push_back(end);
        i = end.place;
        x_mm = end.x_mm;
    }
    return ends;
}

}  // namespace

ArcChain writtenArc(const std::vector<WantedPlace>& wanted, const WantedArc& arc, double from_mm, double to_mm,
                    const ArcLimits& limits)
{
    const ArcFitter fitter(wanted, arc, limits);
    const ArcFitter::Fit one = fitter.fit(arc.first, from_mm, arc.last, to_mm);
    ArcChain single{{{arc.last, to_mm, one.centre}}, 1, one.off_mm};
    if (one.off_mm <= limits.tolerance_mm) return single;

    ArcChain two{{}, 2, HUGE_VAL};
    const std::size_t count = arc.last - arc.first;
    const std::size_t step = std::max<std::size_t>(1, count / triedMiddles);
    for (std::size_t m = arc.first + std::max<std::size_t>(1, step / 2); m < arc.last; m += step) {
        if (wanted[m].is_free) continue;
        for (const double x_mm : gridRadii(wanted[m].x_mm, limits)) {
            const ArcFitter::Fit before = fitter.fit(arc.first, from_mm, m, x_mm);
            if (before.off_mm >= two.off_mm) continue;
            const ArcFitter::Fit behind = fitter.fit(m, x_mm, arc.last, to_mm);
            const double off_mm = std::max({before.off_mm, behind.off_mm, std::abs(x_mm - wanted[m].x_mm)});
            if (off_mm >= two.off_mm) continue;
            two.off_mm = off_mm;
            two.ends = {{m, x_mm, before.centre}, {arc.last, to_mm, behind.centre}};
        }
    }
    if (two.off_mm <= limits.tolerance_mm) return two;
    if (one.off_mm <= limits.coarse_mm) {
        single.rank = 3;
        return single;
    }
    if (two.off_mm <= limits.coarse_mm) {
        two.rank = 4;
        return two;
    }
    ArcChain many{manyArcs(fitter, wanted, arc, from_mm, to_mm, limits), 0, limits.tolerance_mm};
    many.rank = many.ends.size() + 2;
    return many;
}

double radiusOnArc_mm(const ArcCentre& centre, bool is_upper, double z_mm, double x_mm, double at_z_mm)
{
    return onArc(centre.z_mm, centre.x_mm, std::hypot(z_mm - centre.z_mm, x_mm - centre.x_mm), is_upper, at_z_mm);
}

}  // namespace lathelier::deflection
