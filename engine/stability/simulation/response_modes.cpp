#include "engine/stability/simulation/response_modes.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>

#include "engine/stability/boundary.h"
#include "engine/stability/stability_codes.h"

namespace lathelier::stability {
namespace {

constexpr double preciseShare = 0.3;  ///< of the receptance that chatters: smaller values need no relative precision
constexpr double allowedShare = 0.8;  ///< of it, outside the lines
constexpr double targetShare = 0.7;   ///< of it, where more was found
constexpr double outsideWeight = 10;  ///< of a line outside
constexpr int mostCorrections = 12;
constexpr std::size_t linesToCompare = 5;  ///< around the frequency of the vibration

/// Lines outside those of the response: two decades below, more than one above.
std::vector<double> linesOutside(double from_hz, double to_hz)
{
    constexpr int below = 60, above = 140;
    constexpr double lowest = 0.01, highest = 30;
    std::vector<double> lines;
    lines.reserve(below + above);
    for (int i = 0; i < below; ++i) lines.push_back(from_hz * std::pow(lowest, 1 - i / static_cast<double>(below)));
    for (int i = 1; i <= above; ++i) lines.push_back(to_hz * std::pow(highest, i / static_cast<double>(above)));
    return lines;
}

/// Columns: the two parts of each pole, the compliance without mass.
Eigen::MatrixXcd columnsOf(const std::vector<Pole>& poles, const std::vector<double>& frequency_hz)
{
    const Eigen::MatrixXcd terms = termsOf(poles, frequency_hz);
    Eigen::MatrixXcd columns(terms.rows(), terms.cols() + 1);
    columns.leftCols(terms.cols()) = terms;
    columns.rightCols(1).setOnes();
    return columns;
}

/// Receptance at which a cut of this stiffness chatters; of the least stable cut where it is softer than that.
double receptanceAtLimit(const Frf& frf, double stiffness_N_mm)
{
    const double least = -leastRealPart(frf, stiffness_N_mm < 0 ? -1 : 1).real_mm_N;
    const double here = stiffness_N_mm == 0 ? least : 1 / (2 * std::abs(stiffness_N_mm));
    if (least > 0) return std::min(here, least);
    double largest = 0;
    for (const auto& g : frf.value) largest = std::max(largest, std::abs(g));
    return std::min(here, largest);
}

std::vector<Mode> modesOf(const std::vector<Pole>& poles, const Eigen::VectorXd& found)
{
    constexpr double leastPart = 1e-9;  // a mode has a stiffness
    std::vector<Mode> modes;
    for (std::size_t p = 0; p < poles.size(); ++p) {
        double real = found[static_cast<Eigen::Index>(2 * p)];
        const double slope = found[static_cast<Eigen::Index>(2 * p + 1)];
        if (std::abs(real) < leastPart * std::abs(slope)) real = leastPart * slope;
        if (real == 0) continue;
        modes.push_back({poles[p].frequency_hz, poles[p].damping_ratio, 1 / real, slope / real});
    }
    if (const double rest = found[found.size() - 1]; rest != 0) modes.push_back(complianceMode(rest));
    return modes;
}

/// 100 |model - G|/|G| over the nearest lines, without what their noise explains.
double errorAt(double frequency_hz, const std::vector<Mode>& modes, const Frf& frf)
{
    const auto& lines = frf.frequency_hz;
    const auto at =
        static_cast<std::size_t>(std::lower_bound(lines.begin(), lines.end(), frequency_hz) - lines.begin());
    const std::size_t count = std::min(linesToCompare, lines.size());
    const std::size_t first = std::min(at > count / 2 ? at - count / 2 : 0, lines.size() - count);
    double error = 0, size = 0;
    for (std::size_t i = first; i < first + count; ++i) {
        error += std::norm(receptanceOf(modes, lines[i]) - frf.value[i]);
        if (i < frf.noise.size() && std::isfinite(frf.noise[i])) error -= 2 * frf.noise[i] * frf.noise[i];
        size += std::norm(frf.value[i]);
    }
    return size > 0 ? 100 * std::sqrt(std::max(0.0, error) / size) : 0;
}

}  // namespace

std::vector<Mode> modesThrough(const Frf& frf, const std::vector<Pole>& poles, const std::vector<Pole>& broad,
                               double stiffness_N_mm)
{
    const Frf lines = linesAround(frf, poles);
    const double from = lines.frequency_hz.front(), to = lines.frequency_hz.back();
    std::vector<Pole> all = poles;
    for (const std::vector<Pole>& more : {smoothTerms(from, to), broad})
        all.insert(all.end(), more.begin(), more.end());
    const double limit = receptanceAtLimit(lines, stiffness_N_mm), sign = stiffness_N_mm < 0 ? -1 : 1;

    Eigen::MatrixXcd inside = columnsOf(all, lines.frequency_hz);
    Eigen::VectorXcd wanted(inside.rows());
    for (Eigen::Index row = 0; row < inside.rows(); ++row) {
        const std::complex<double> g = lines.value[static_cast<std::size_t>(row)];
        const double weight = 1 / std::max(std::abs(g), preciseShare * limit);
        wanted[row] = weight * g;
        inside.row(row) *= weight;
    }
    const Eigen::MatrixXd known = realRows(inside);
    const Eigen::VectorXd known_right = realRows(wanted);
    const Eigen::MatrixXd outside = columnsOf(all, linesOutside(from, to)).real();
    std::vector<Eigen::Index> bounded;
    Eigen::VectorXd found = leastSquares(known, known_right);
    for (int correction = 0; correction < mostCorrections; ++correction) {
        const Eigen::VectorXd real = sign * (outside * found);
        const std::size_t before = bounded.size();
        for (Eigen::Index i = 0; i < real.size(); ++i)
            if (real[i] < -allowedShare * limit && std::find(bounded.begin(), bounded.end(), i) == bounded.end())
                bounded.push_back(i);
        if (bounded.size() == before) break;
        const double weight = outsideWeight / limit;
        Eigen::MatrixXd rows(known.rows() + static_cast<Eigen::Index>(bounded.size()), known.cols());
        Eigen::VectorXd right(rows.rows());
        rows.topRows(known.rows()) = known;
        right.head(known.rows()) = known_right;
        for (std::size_t i = 0; i < bounded.size(); ++i) {
            const Eigen::Index row = known.rows() + static_cast<Eigen::Index>(i);
            rows.row(row) = weight * outside.row(bounded[i]);
            right[row] = -weight * sign * targetShare * limit;
        }
        found = leastSquares(std::move(rows), right);
    }
    return modesOf(all, found);
}

double overallError_percent(const std::vector<Mode>& modes, const Frf& frf)
{
    double error = 0, size = 0;
    for (std::size_t i = 0; i < frf.value.size(); ++i) {
        if (!(frf.frequency_hz[i] > 0)) continue;
        error += std::norm(receptanceOf(modes, frf.frequency_hz[i]) - frf.value[i]);
        size += std::norm(frf.value[i]);
    }
    return size > 0 ? 100 * std::sqrt(error / size) : 0;
}

void judgeModel(SimulationResult& result, const std::vector<Mode>& modes, const Frf& frf)
{
    if (frf.frequency_hz.empty()) return;
    const double f = result.frequency_hz, from = frf.frequency_hz.front(), to = frf.frequency_hz.back();
    result.model_error_overall_percent = overallError_percent(modes, frf);
    if (f >= from && f <= to) {
        result.model_error_percent = errorAt(f, modes, frf);
        if (!(*result.model_error_percent > largestModelError_percent)) return;
        result.notes.push_back({notes::modelLeavesMuch,
                                {{"frequency_hz", std::round(10 * f) / 10},
                                 {"error_percent", std::round(10 * *result.model_error_percent) / 10},
                                 {"limit_percent", largestModelError_percent}}});
    } else {
        const bool is_stable = result.cut == CutVerdict::Stable;
        result.notes.push_back({is_stable ? notes::growthOutsideLines : notes::vibrationOutsideLines,
                                {{"frequency_hz", std::round(10 * f) / 10}, {"from_hz", from}, {"to_hz", to}}});
        if (is_stable) return;
    }
    result.cut = CutVerdict::Undecided;
}

}  // namespace lathelier::stability
