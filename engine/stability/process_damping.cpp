#include "engine/stability/process_damping.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace lathelier::stability {
namespace {

using std::numbers::pi;

constexpr int mostNewtonSteps = 80;
constexpr double angleExact_rad = 1e-14;

/// One lobe: φ = kπ + t, t in (0, π).
struct DampedLobe {
    double beta = 0;
    double turned = 0;  ///< kπ
    double fold = 0;    ///< t at the minimum of cot φ + β φ/sin²φ

    /// (cot φ + β φ/sin²φ - ρ) sin²φ
    double excess(double t, double rho) const
    {
        const double sine = std::sin(t), cosine = std::cos(t);
        return sine * cosine + beta * (turned + t) - rho * sine * sine;
    }
    double excessSlope(double t, double rho) const { return std::cos(2 * t) + beta - rho * std::sin(2 * t); }
};

DampedLobe dampedLobe(int k, double beta)
{
    DampedLobe lobe{beta, k * pi, 0};
    double low = 0, high = pi;
    while (high - low > angleExact_rad) {
        const double t = (low + high) / 2;
        if (t <= low || t >= high) break;
        const double slope = (beta - 1) * std::sin(t) - 2 * beta * (lobe.turned + t) * std::cos(t);
        (slope < 0 ? low : high) = t;
    }
    lobe.fold = (low + high) / 2;
    return lobe;
}

/// The angle between `inside`, where the excess is below 0, and `outside`, where it is above: Newton with bracketing.
double solve(const DampedLobe& lobe, double rho, double inside, double outside, double start)
{
    double t = start > std::min(inside, outside) && start < std::max(inside, outside) ? start : (inside + outside) / 2;
    for (int step = 0; step < mostNewtonSteps; ++step) {
        const double value = lobe.excess(t, rho);
        (value < 0 ? inside : outside) = t;
        double next = t - value / lobe.excessSlope(t, rho);
        if (!(next > std::min(inside, outside) && next < std::max(inside, outside))) next = (inside + outside) / 2;
        const double change = std::abs(next - t);
        t = next;
        if (change < angleExact_rad * (1 + t)) break;
    }
    return t;
}

CurvePoint curvePointAt(const BoundaryPoint& point, const DampedLobe& lobe, double t)
{
    const double ratio = std::sin(pi * point.phase_turns) / std::sin(t);
    return {60 * pi * point.frequency_hz / (lobe.turned + t), ratio * ratio / point.compliance_mm_N,
            point.frequency_hz};
}

/// A run of boundary points of a lobe: along the first solution, back along the second where both merge at the fold.
struct Run {
    std::vector<CurvePoint> early, late;

    void finish(bool folded, std::vector<std::vector<CurvePoint>>& stretches)
    {
        if (!early.empty()) {
            if (folded) {
                early.insert(early.end(), late.rbegin(), late.rend());
                stretches.push_back(std::move(early));
            } else {
                stretches.push_back(std::move(early));
                stretches.push_back(std::move(late));
            }
        }
        early.clear();
        late.clear();
    }
};

}  // namespace

double dampingRatioOf(double process_damping_N_mm, double diameter_mm, double cutting_coefficient_N_mm2)
{
    return process_damping_N_mm / (pi * diameter_mm * cutting_coefficient_N_mm2);
}

LobeCurve dampedLobeCurve(const Boundary& boundary, int k, double beta)
{
    if (!(beta > 0)) return lobeCurve(boundary, k, SpeedRelation::Exact);
    const DampedLobe lobe = dampedLobe(k, beta);
    LobeCurve curve{k, {}};
    for (const auto& stretch : boundary) {
        Run run;
        double early = 0, late = 0;
        for (const BoundaryPoint& point : stretch) {
            const double rho = 1 / std::tan(pi * point.phase_turns);
            if (!std::isfinite(rho) || !(lobe.excess(lobe.fold, rho) < 0)) {
                run.finish(true, curve.stretches);
                continue;
            }
            early = solve(lobe, rho, lobe.fold, 0, early);
            late = solve(lobe, rho, lobe.fold, pi, late);
            run.early.push_back(curvePointAt(point, lobe, early));
            run.late.push_back(curvePointAt(point, lobe, late));
        }
        run.finish(false, curve.stretches);
    }
    return curve;
}

}  // namespace lathelier::stability
