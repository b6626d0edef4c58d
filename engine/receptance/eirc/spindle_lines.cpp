#include "engine/receptance/eirc/spindle_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/beam/beam_receptance.h"
#include "engine/core/parallel.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/shaft_receptance.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t linesPerRodTask = 32;
constexpr double smallestNoise = 1e-6;      // lower bound of (1-γ²)/γ², so that a coherence of 1 does not dominate
constexpr double smallestCoherence = 1e-6;  // coherence below which a response has no information
constexpr std::size_t linesOfNoise = 4;     // lines averaged on either side, since a single coherence estimate scatters
                                            // strongly

void checkMeasurements(const SpindleMeasurements& measurements)
{
    std::size_t points = 0;
    for (std::size_t rod = 0; rod < measurements.rods.size(); ++rod) {
        const std::vector<double>& distances_mm = measurements.rods[rod].distance_from_chuck_mm;
        const double length_mm = measurements.rods[rod].shaft.length_mm();
        points += distances_mm.size();
        for (std::size_t point = 0; point < distances_mm.size(); ++point)
            if (!(distances_mm[point] >= 0 && distances_mm[point] <= length_mm))
                throw Error(errors::measuredPointBeyondRod, {{"rod", static_cast<std::int64_t>(rod) + 1},
                                                             {"point", static_cast<std::int64_t>(point) + 1},
                                                             {"distance_mm", distances_mm[point]},
                                                             {"length_mm", length_mm}});
    }
    for (const RodFrf& one : measurements.frfs) {
        const bool is_known =
            one.rod < measurements.rods.size() &&
            std::max(one.point_a, one.point_b) < measurements.rods[one.rod].distance_from_chuck_mm.size();
        if (!is_known)
            throw Error(errors::measuredPairUnknown, {{"rod", static_cast<std::int64_t>(one.rod) + 1},
                                                      {"first", static_cast<std::int64_t>(one.point_a) + 1},
                                                      {"second", static_cast<std::int64_t>(one.point_b) + 1}});
        const Frf& first = measurements.frfs.front().frf;
        if (one.frf.frequency_hz != first.frequency_hz || one.frf.value.size() != one.frf.frequency_hz.size())
            throw Error(errors::frfLinesDiffer, {{"first", first.name},
                                                 {"second", one.frf.name},
                                                 {"rod", static_cast<std::int64_t>(one.rod) + 1},
                                                 {"point", static_cast<std::int64_t>(one.point_a) + 1}});
    }
    if (points < 2 || measurements.frfs.empty() || measurements.frfs.front().frf.frequency_hz.empty())
        throw Error(errors::tooFewMeasuredPoints, {{"points", static_cast<std::int64_t>(points)},
                                                   {"frfs", static_cast<std::int64_t>(measurements.frfs.size())}});
}

Complex measuredReceptance(const Frf& frf, std::size_t line)
{
    const Complex velocity(0, 2 * std::numbers::pi * frf.frequency_hz[line]);
    switch (frf.quantity) {
        case FrfQuantity::Receptance: break;
        case FrfQuantity::Mobility: return frf.value[line] / velocity;
        case FrfQuantity::Accelerance: return frf.value[line] / (velocity * velocity);
    }
    return frf.value[line];
}

/// (1-γ²)/γ², the square of noise by signal, averaged over the neighbouring lines.
double noiseOf(const Frf& frf, std::size_t line)
{
    const std::size_t first = line > linesOfNoise ? line - linesOfNoise : 0;
    const std::size_t last = std::min(frf.coherence.size() - 1, line + linesOfNoise);
    double sum = 0;
    for (std::size_t k = first; k <= last; ++k) {
        const double coherence = std::clamp(frf.coherence[k], smallestCoherence, 1.0);
        sum += (1 - coherence) / coherence;
    }
    return std::max(smallestNoise, sum / static_cast<double>(last - first + 1));
}

double weightOf(const Frf& frf, std::size_t line, const Complex& receptance)
{
    const double size = std::abs(receptance);
    if (!(size > 0) || !std::isfinite(size)) return 0;
    if (frf.coherence.size() != frf.value.size()) return 1 / size;
    if (!(frf.coherence[line] > smallestCoherence)) return 0;
    return 1 / (size * std::sqrt(noiseOf(frf, line)));
}

}  // namespace

SpindleLines spindleLines(const SpindleMeasurements& measurements, const IdentificationParameters& parameters,
                          UsedValues& used, Notes& notes, const Progress& progress)
{
    checkMeasurements(measurements);
    std::vector<beam::BeamReceptance> prepared;
    for (const MeasuredRod& rod : measurements.rods) {
        const double length_mm = rod.shaft.length_mm();
        std::vector<double> places_z_mm;
        for (const double distance_mm : rod.distance_from_chuck_mm) places_z_mm.push_back(length_mm - distance_mm);
        places_z_mm.push_back(length_mm);
        beam::BeamParameters model;
        model.shear = parameters.shear;
        prepared.emplace_back(beam::beamModel(rod.shaft, materialOf(rod.shaft, used, notes), model, places_z_mm));
    }
    const std::vector<double>& frequency_hz = measurements.frfs.front().frf.frequency_hz;
    const auto skipped = static_cast<std::size_t>(
        std::find_if(frequency_hz.begin(), frequency_hz.end(), [](double f) { return f > 0; }) - frequency_hz.begin());
    SpindleLines result;
    result.frequency_hz.assign(frequency_hz.begin() + static_cast<std::ptrdiff_t>(skipped), frequency_hz.end());
    result.lines.resize(result.frequency_hz.size());
    parallelFor(result.lines.size(), linesPerRodTask, progress, [&](std::size_t begin, std::size_t end) {
        std::vector<beam::BeamReceptance> rods = prepared;
        for (std::size_t i = begin; i < end; ++i) {
            SpindleLine& line = result.lines[i];
            std::vector<std::vector<ReceptanceMatrix>> free;
            for (beam::BeamReceptance& rod : rods) {
                free.emplace_back(rod.places() * rod.places());
                rod.at(result.frequency_hz[i], free.back());
                line.free_jj.push_back(free.back().back());
            }
            for (const RodFrf& one : measurements.frfs) {
                const std::size_t n = rods[one.rod].places();
                const std::vector<ReceptanceMatrix>& g = free[one.rod];
                const Complex measured = measuredReceptance(one.frf, skipped + i);
                line.responses.push_back({one.rod, one.point_a, one.point_b, measured,
                                          weightOf(one.frf, skipped + i, measured),
                                          g[one.point_a * n + one.point_b](0, 0), g[(n - 1) * n + one.point_a].col(0),
                                          g[(n - 1) * n + one.point_b].col(0)});
            }
        }
    });
    return result;
}

SpindleLine onlyRod(const SpindleLine& line, std::size_t rod, bool keep)
{
    SpindleLine result{{}, line.free_jj};
    for (const LineResponse& one : line.responses)
        if ((one.rod == rod) == keep) result.responses.push_back(one);
    return result;
}

}  // namespace lathelier::receptance
