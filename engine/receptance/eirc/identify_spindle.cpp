#include "engine/receptance/eirc/identify_spindle.h"

#include <algorithm>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/receptance/eirc/smooth_spindle.h"
#include "engine/receptance/eirc/spindle_lines.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/receptance_fields.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t linesPerFitTask = 16;
constexpr std::size_t fewestFrfs = 3;  // number of unknowns per line
constexpr double illConditioned = 1e4;
constexpr double better = 0.99;  // a start from a neighbour is accepted if it lowers the cost to this share

/// Each line is started from its linear solution; lines without one from a rigid clamp.
std::vector<LineFit> fitLines(const std::vector<SpindleLine>& lines, const Progress& progress)
{
    std::vector<LineFit> fits(lines.size());
    parallelFor(lines.size(), linesPerFitTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            fits[i] = refine(lines[i], linearStart(lines[i]).value_or(ScaledSpindle::Zero()));
    });
    return fits;
}

/// Gauss-Newton may converge to another minimum: each line is also started from the solutions of both neighbours.
void improveFromNeighbours(const std::vector<SpindleLine>& lines, std::vector<LineFit>& fits, const Progress& progress)
{
    const auto improve = [&](std::size_t line, std::size_t neighbour) {
        progress.check();
        LineFit other = refine(lines[line], fits[neighbour].spindle);
        if (other.cost < better * fits[line].cost) fits[line] = other;
    };
    for (std::size_t i = 1; i < lines.size(); ++i) improve(i, i - 1);
    progress.report(0.5);
    for (std::size_t i = lines.size(); i-- > 1;) improve(i - 1, i);
    progress.report(1);
}

/// 100·rms(|G_fit - G|/|G|); NaN without any response.
double misfitPercent(const std::vector<SpindleLine>& lines, const std::vector<ScaledSpindle>& spindle)
{
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (const LineResponse& one : lines[i].responses) {
            if (!(std::abs(one.measured) > 0)) continue;
            sum += std::norm((responseOn(lines[i], one, spindle[i]) - one.measured) / one.measured);
            ++count;
        }
    return 100 * std::sqrt(sum / count);
}

SpindleTable identifiedTable(const std::vector<double>& frequency_hz, const std::vector<ScaledSpindle>& spindle)
{
    SpindleTable table;
    table.frequency_hz = frequency_hz;
    for (const ScaledSpindle& one : spindle) {
        const ReceptanceMatrix matrix = matrixOf(one);
        table.H_mm_N.push_back(matrix(0, 0));
        table.L_mm_Nmm.push_back(matrix(0, 1));
        table.P_rad_Nmm.push_back(matrix(1, 1));
    }
    return table;
}

/// A spindle is passive: the imaginary part of its receptance matrix has no positive eigenvalue.
bool isPassive(const ScaledSpindle& spindle)
{
    const Eigen::Vector3d loss = -spindle.imag();
    return loss[0] >= 0 && loss[2] >= 0 && loss[0] * loss[2] - loss[1] * loss[1] >= 0;
}

void noteDoubts(const std::vector<LineFit>& fits, const std::vector<ScaledSpindle>& spindle, Notes& notes)
{
    const auto all = static_cast<std::int64_t>(fits.size());
    const std::int64_t ill =
        std::count_if(fits.begin(), fits.end(), [](const LineFit& fit) { return !(fit.condition <= illConditioned); });
    const std::int64_t open =
        std::count_if(fits.begin(), fits.end(), [](const LineFit& fit) { return !fit.converged; });
    const std::int64_t active =
        std::count_if(spindle.begin(), spindle.end(), [](const ScaledSpindle& one) { return !isPassive(one); });
    if (ill > 0)
        notes.push_back({notes::spindleIllConditioned, {{"lines", ill}, {"all", all}, {"limit", illConditioned}}});
    if (open > 0) notes.push_back({notes::spindleNotConverged, {{"lines", open}, {"all", all}}});
    if (active > 0) notes.push_back({notes::spindleNotPassive, {{"lines", active}, {"all", all}}});
}

}  // namespace

const std::vector<Field<IdentificationParameters>>& fieldsOf(const IdentificationParameters*)
{
    using P = IdentificationParameters;
    static const std::vector<Field<P>> all{
        field("smooth", &P::smooth,
              Label{LT_TEXT("Engine", "Smooth"),
                    LT_TEXT("Engine", "Along frequency, by what each line knows and does not know.")}),
        field("hold_out", &P::hold_out, Range{0, 100},
              Label{LT_TEXT("Engine", "Hold out rod"),
                    LT_TEXT("Engine", "This rod is not used but predicted; 0: all are used.")}),
        shearField(&P::shear),
    };
    return all;
}

SpindleIdentification identifySpindle(const SpindleMeasurements& measurements,
                                      const IdentificationParameters& parameters, const Progress& progress)
{
    SpindleIdentification result;
    result.parameters = parameters;
    const auto rods = static_cast<std::int64_t>(measurements.rods.size());
    if (parameters.hold_out < 0 || parameters.hold_out > rods)
        throw Error(errors::holdOutUnknown, {{"rod", std::int64_t{parameters.hold_out}}, {"rods", rods}});
    progress.report(0);
    SpindleLines all = spindleLines(measurements, parameters, result.used, result.notes, progress.part(0, 0.1));
    std::vector<SpindleLine> held;
    if (parameters.hold_out > 0)
        for (SpindleLine& line : all.lines) {
            const auto rod = static_cast<std::size_t>(parameters.hold_out) - 1;
            held.push_back(onlyRod(line, rod, true));
            line = onlyRod(line, rod, false);
        }
    result.frfs = all.lines.empty() ? 0 : all.lines.front().responses.size();
    if (result.frfs < fewestFrfs) {
        std::size_t points = 0;
        for (const MeasuredRod& rod : measurements.rods) points += rod.distance_from_chuck_mm.size();
        throw Error(errors::tooFewMeasuredPoints,
                    {{"points", static_cast<std::int64_t>(points)}, {"frfs", static_cast<std::int64_t>(result.frfs)}});
    }
    progress.report(0.1);
    std::vector<LineFit> fits = fitLines(all.lines, progress.part(0.1, 0.4));
    improveFromNeighbours(all.lines, fits, progress.part(0.4, 0.8));
    std::vector<ScaledSpindle> spindle;
    if (parameters.smooth)
        spindle = smoothed(all.frequency_hz, fits, progress.part(0.8, 1));
    else
        for (const LineFit& fit : fits) spindle.push_back(fit.spindle);
    for (const LineFit& fit : fits) result.condition.push_back(fit.condition);
    result.frequency_hz = all.frequency_hz;
    result.residual_rms_percent = misfitPercent(all.lines, spindle);
    if (!held.empty()) result.hold_out_rms_percent = misfitPercent(held, spindle);
    noteDoubts(fits, spindle, result.notes);
    result.spindle = {identifiedTable(all.frequency_hz, spindle)};
    progress.report(1);
    return result;
}

}  // namespace lathelier::receptance
