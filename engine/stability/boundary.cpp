#include "engine/stability/boundary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/error.h"
#include "engine/stability/stability_codes.h"

namespace lathelier::stability {
namespace {

constexpr std::size_t fewestLines = 4;

void check(const Frf& frf)
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
    check(frf);
    const auto above = std::upper_bound(frf.frequency_hz.begin(), frf.frequency_hz.end(), frequency_hz);
    if (above == frf.frequency_hz.begin()) return frf.value.front();
    if (above == frf.frequency_hz.end()) return frf.value.back();
    return cubic(frf, static_cast<std::size_t>(above - frf.frequency_hz.begin()) - 1, frequency_hz);
}

Boundary boundaryOf(const Frf& frf, double factor, int steps)
{
    check(frf);
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
        for (int step = 1; step < steps; ++step) {
            const double f = frf.frequency_hz[i] + width * step / steps;
            take(f, factor * cubic(frf, i, f));
        }
    }
    std::erase_if(boundary, [](const auto& stretch) { return stretch.size() < 2; });
    return boundary;
}

LeastRealPart leastRealPart(const Frf& frf, double factor)
{
    check(frf);
    std::size_t least = 0;
    for (std::size_t i = 1; i < frf.value.size(); ++i)
        if (factor * frf.value[i].real() < factor * frf.value[least].real()) least = i;
    LeastRealPart result{frf.frequency_hz[least], factor * frf.value[least].real(), false};
    result.at_edge = least == 0 || least + 1 == frf.value.size();
    // Golden section on either side of the line.
    const double shrink = (std::sqrt(5.0) - 1) / 2;
    for (const std::size_t i : {least - 1, least}) {
        if (i >= frf.frequency_hz.size() - 1) continue;  // least - 1 of the first line wraps round
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
