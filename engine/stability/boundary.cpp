#include "engine/stability/boundary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/error.h"
#include "engine/stability/stability_codes.h"

namespace lathelier::stability {
namespace {

constexpr std::size_t fewestLines = 4;
constexpr double straightDepth = 2e-5;   ///< relative tolerance of the depth
constexpr double straightTurns = 1e-6;   ///< tolerance of the phase, in turns
constexpr double straightSpeed = 1e-6;   ///< relative tolerance of the speed
constexpr std::size_t mostLeftOut = 64;  ///< largest number of consecutive omitted points

void checkReceptance(const Frf& frf)
{
    if (frf.quantity != FrfQuantity::Receptance) throw Error(errors::notAReceptance, {});
    if (frf.frequency_hz.size() < fewestLines || frf.value.size() != frf.frequency_hz.size())
        throw Error(errors::tooFewLines, {{"found", static_cast<std::int64_t>(frf.frequency_hz.size())},
                                          {"minimum", static_cast<std::int64_t>(fewestLines)}});
}

/// Lagrange's cubic through the lines around interval `i` (between lines i and i + 1).
std::complex<double> cubic(const Frf& frf, std::size_t i, double f)
{
    const std::size_t first = std::min(i == 0 ? 0 : i - 1, frf.frequency_hz.size() - 4);
    std::complex<double> sum = 0;
    for (std::size_t a = first; a < first + 4; ++a) {
        double weight = 1;
        for (std::size_t b = first; b < first + 4; ++b)
            if (b != a) weight *= (f - frf.frequency_hz[b]) / (frf.frequency_hz[a] - frf.frequency_hz[b]);
        sum += weight * frf.value[a];
    }
    return sum;
}

/// True if the response is linear between line i and the next within the tolerance of the depth.
bool isStraight(const Frf& frf, std::size_t i)
{
    const std::complex<double> a = frf.value[i], b = frf.value[i + 1];
    const std::complex<double> bend =
        cubic(frf, i, (frf.frequency_hz[i] + frf.frequency_hz[i + 1]) / 2) - (a + b) / 2.0;
    // If G is linear, depth and phase are not: their curvature grows with the square of the change of G.
    const double least = std::min(std::abs(a.real()), std::abs(b.real()));
    return std::abs(bend) < straightDepth * least && std::norm(b - a) < straightDepth * least * least;
}

/// ε/2π of G with a negative real part. ψ runs from -3π/2 to -π/2, through -π for a real G.
double phaseTurns(const std::complex<double>& g)
{
    double psi = std::arg(g);
    if (psi > 0) psi -= 2 * std::numbers::pi;
    return (3 * std::numbers::pi + 2 * psi) / (2 * std::numbers::pi);
}

}  // namespace

std::complex<double> interpolated(const Frf& frf, double frequency_hz)
{
    checkReceptance(frf);
    const auto above = std::upper_bound(frf.frequency_hz.begin(), frf.frequency_hz.end(), frequency_hz);
    if (above == frf.frequency_hz.begin()) return frf.value.front();
    if (above == frf.frequency_hz.end()) return frf.value.back();
    return cubic(frf, static_cast<std::size_t>(above - frf.frequency_hz.begin()) - 1, frequency_hz);
}

Boundary boundaryOf(const Frf& frf, double factor, int steps)
{
    checkReceptance(frf);
    Boundary boundary(1);
    const auto take = [&](double f, const std::complex<double>& g) {
        if (g.real() < 0 && f > 0)
            boundary.back().push_back({f, -2 * g.real(), phaseTurns(g)});
        else if (!boundary.back().empty())
            boundary.emplace_back();
    };
    for (std::size_t i = 0; i < frf.frequency_hz.size(); ++i) {
        take(frf.frequency_hz[i], factor * frf.value[i]);
        if (i + 1 == frf.frequency_hz.size()) break;
        const double width = frf.frequency_hz[i + 1] - frf.frequency_hz[i];
        if (steps > 1 && isStraight(frf, i)) continue;
        for (int step = 1; step < steps; ++step) {
            const double f = frf.frequency_hz[i] + width * step / steps;
            take(f, factor * cubic(frf, i, f));
        }
    }
    std::erase_if(boundary, [](const auto& stretch) { return stretch.size() < 2; });
    return boundary;
}

std::vector<BoundaryPoint> thinned(const std::vector<BoundaryPoint>& stretch, double looser)
{
    const auto isLine = [&](std::size_t from, std::size_t to) {
        const BoundaryPoint& a = stretch[from];
        const BoundaryPoint& b = stretch[to];
        const double depth_a = 1 / a.compliance_mm_N, depth_b = 1 / b.compliance_mm_N;
        // Speeds are f/(k + turns): nearly linear only if f or the turns hardly change. k = 0 is the worst case.
        const double bend = std::abs(b.phase_turns - a.phase_turns) / std::min(a.phase_turns, b.phase_turns) *
                            (b.frequency_hz / a.frequency_hz - 1) / 4;
        if (!(bend < looser * straightSpeed)) return false;
        for (std::size_t i = from + 1; i < to; ++i) {
            const BoundaryPoint& p = stretch[i];
            const double share = (p.frequency_hz - a.frequency_hz) / (b.frequency_hz - a.frequency_hz);
            const double depth = depth_a + share * (depth_b - depth_a);
            const double turns = a.phase_turns + share * (b.phase_turns - a.phase_turns);
            if (std::abs(depth * p.compliance_mm_N - 1) > looser * straightDepth ||
                std::abs(turns - p.phase_turns) > looser * straightTurns)
                return false;
        }
        return true;
    };
    std::vector<BoundaryPoint> kept;
    if (stretch.empty()) return kept;
    kept.push_back(stretch.front());
    for (std::size_t i = 0; i + 1 < stretch.size();) {
        std::size_t step = mostLeftOut;
        while (step > 1 && (i + step >= stretch.size() || !isLine(i, i + step))) step /= 2;
        i += step;
        kept.push_back(stretch[i]);
    }
    return kept;
}

LeastRealPart leastRealPart(const Frf& frf, double factor)
{
    checkReceptance(frf);
    std::size_t least = 0;
    for (std::size_t i = 1; i < frf.value.size(); ++i)
        if (factor * frf.value[i].real() < factor * frf.value[least].real()) least = i;
    LeastRealPart result{frf.frequency_hz[least], factor * frf.value[least].real(), false};
    result.at_edge = least == 0 || least + 1 == frf.value.size();
    // Golden section on either side of the line.
    const double shrink = (std::sqrt(5.0) - 1) / 2;
    for (const std::size_t i : {least - 1, least}) {
        if (i >= frf.frequency_hz.size() - 1) continue;  // index -1 wraps for the first line
        double from = frf.frequency_hz[i], to = frf.frequency_hz[i + 1];
        const auto real = [&](double f) { return factor * cubic(frf, i, f).real(); };
        for (int step = 0; step < 60; ++step) {
            const double a = to - shrink * (to - from), b = from + shrink * (to - from);
            if (real(a) < real(b))
                to = b;
            else
                from = a;
        }
        const double f = (from + to) / 2;
        if (real(f) < result.real_mm_N) result = {f, real(f), result.at_edge};
    }
    return result;
}

}  // namespace lathelier::stability
