#include "engine/receptance/eirc/spindle_check.h"

#include <cmath>

#include "engine/receptance/eirc/spindle_lines.h"

namespace lathelier::receptance {
namespace {

double rmsPercent(double sum, std::size_t count)
{
    return count > 0 ? 100 * std::sqrt(sum / static_cast<double>(count)) : 0;
}

}  // namespace

SpindleCheck checkSpindle(const SpindleMeasurements& measurements, const SpindleIdentification& found,
                          const Progress& progress)
{
    UsedValues used;
    Notes notes;
    const SpindleLines lines =
        spindleLines(measurements, spindleNoise(measurements), found.parameters.shear, used, notes, progress);
    SpindleCheck check;
    check.frequency_hz = lines.frequency_hz;
    check.responses.resize(measurements.frfs.size());
    for (std::size_t i = 0; i < check.responses.size(); ++i) {
        const RodFrf& one = measurements.frfs[i];
        CheckedResponse& response = check.responses[i];
        response.rod = one.rod;
        response.respond = measurements.rods[one.rod].nodeOf(one.point_a);
        response.excite = measurements.rods[one.rod].nodeOf(one.point_b);
        response.chi2_per_dof = found.chi2_per_dof_of_frfs[i];
        response.used = found.parameters.hold_out != static_cast<int>(one.rod) + 1;
        response.measured.frequency_hz = response.predicted.frequency_hz = lines.frequency_hz;
        response.measured.value.reserve(lines.lines.size());
        response.predicted.value.reserve(lines.lines.size());
    }
    std::vector<double> sums(check.responses.size());
    std::vector<std::size_t> counts(check.responses.size());
    check.residual_percent.reserve(lines.lines.size());
    for (std::size_t line = 0; line < lines.lines.size(); ++line) {
        const ScaledSpindle spindle = scaledOf(found.spindle.at(lines.frequency_hz[line]));
        double of_line = 0;
        std::size_t count = 0;
        for (std::size_t i = 0; i < check.responses.size(); ++i) {
            const LineResponse& response = lines.lines[line].responses[i];
            const Complex predicted = responseOn(lines.lines[line], response, spindle);
            check.responses[i].measured.value.push_back(response.measured);
            check.responses[i].predicted.value.push_back(predicted);
            if (!(response.weight > 0)) continue;
            const double square = std::norm((predicted - response.measured) / response.measured);
            sums[i] += square;
            ++counts[i];
            if (!check.responses[i].used) continue;
            of_line += square;
            ++count;
        }
        check.residual_percent.push_back(rmsPercent(of_line, count));
    }
    for (std::size_t i = 0; i < sums.size(); ++i) check.responses[i].rms_percent = rmsPercent(sums[i], counts[i]);
    return check;
}

}  // namespace lathelier::receptance
