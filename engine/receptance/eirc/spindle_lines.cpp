#include "engine/receptance/eirc/spindle_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/beam/beam_receptance.h"
#include "engine/core/parallel.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/shaft/shaft_receptance.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t linesPerRodTask = 32;
constexpr double tonnes = 1e-6;  // per g

/// A rod with its accelerometer at one of its points; no point: without it.
struct Loading {
    std::size_t rod = 0;
    std::optional<std::size_t> point;
    double mass_g = 0;
    friend bool operator==(const Loading&, const Loading&) = default;
};

/// Receptances between the places of a free rod, the last one the joint.
struct FreeRod {
    std::size_t places = 0;
    std::vector<ReceptanceMatrix> values;

    const ReceptanceMatrix& at(std::size_t p, std::size_t q) const { return values[p * places + q]; }
    std::size_t joint() const { return places - 1; }
};

/// The free rod with a mass at a point. Only translations at points and all motions at the joint are used: those.
FreeRod withMassAt(const FreeRod& bare, std::size_t point, double mass_g, double frequency_hz)
{
    const double omega = 2 * std::numbers::pi * frequency_hz;
    const double inertia = omega * omega * mass_g * tonnes;
    const Complex force = inertia / (1.0 - inertia * bare.at(point, point)(0, 0));  // per free motion of the point
    FreeRod loaded = bare;
    for (std::size_t p = 0; p < bare.places; ++p)
        for (std::size_t q = 0; q < bare.places; ++q)
            loaded.values[p * bare.places + q] += bare.at(p, point).col(0) * force * bare.at(point, q).row(0);
    return loaded;
}

/// The rods without mass in their order, then each loading that occurs.
struct Loadings {
    std::vector<Loading> all;
    std::vector<std::size_t> of_frf;  ///< index in `all`

    explicit Loadings(const SpindleMeasurements& measurements)
    {
        for (std::size_t rod = 0; rod < measurements.rods.size(); ++rod) all.push_back({rod, {}, 0});
        for (const RodFrf& one : measurements.frfs) {
            const double mass_g = measurements.rods[one.rod].massAt(one.point_a);
            const Loading wanted = mass_g > 0 ? Loading{one.rod, one.point_a, mass_g} : Loading{one.rod, {}, 0};
            const auto found = std::find(all.begin(), all.end(), wanted);
            of_frf.push_back(static_cast<std::size_t>(found - all.begin()));
            if (found == all.end()) all.push_back(wanted);
        }
    }
};

/// Line of the responses, on rods with their loadings or all without.
SpindleLine lineOf(const SpindleMeasurements& measurements, const SpindleNoise& noise, std::size_t line,
                   const std::vector<FreeRod>& free, const std::vector<std::size_t>& of_frf)
{
    SpindleLine result;
    for (const FreeRod& rod : free) result.free_jj.push_back(rod.at(rod.joint(), rod.joint()));
    for (std::size_t k = 0; k < measurements.frfs.size(); ++k) {
        const RodFrf& one = measurements.frfs[k];
        const FreeRod& rod = free[of_frf[k]];
        result.responses.push_back({one.rod, one.point_a, one.point_b, measuredReceptance(one.frf, line),
                                    1 / noise.sigma_mm_N[k][line], of_frf[k], rod.at(one.point_a, one.point_b)(0, 0),
                                    rod.at(rod.joint(), one.point_a).col(0), rod.at(rod.joint(), one.point_b).col(0)});
    }
    return result;
}

}  // namespace

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

SpindleLines spindleLines(const SpindleMeasurements& measurements, const SpindleNoise& noise, beam::ShearModel shear,
                          UsedValues& used, Notes& notes, const Progress& progress)
{
    std::vector<beam::BeamReceptance> prepared;
    for (const MeasuredRod& rod : measurements.rods) {
        const double length_mm = rod.shaft.length_mm();
        std::vector<double> places_z_mm;
        for (const double distance_mm : rod.distance_from_chuck_mm) places_z_mm.push_back(length_mm - distance_mm);
        places_z_mm.push_back(length_mm);
        beam::BeamParameters model;
        model.shear = shear;
        prepared.emplace_back(beam::beamModel(rod.shaft, materialOf(rod.shaft, used, notes), model, places_z_mm));
    }
    const Loadings loadings(measurements);
    std::vector<std::size_t> bare_of_frf;
    for (const RodFrf& one : measurements.frfs) bare_of_frf.push_back(one.rod);
    const bool is_loaded = loadings.all.size() > measurements.rods.size();
    const std::vector<double>& frequency_hz = measurements.frfs.front().frf.frequency_hz;
    const auto skipped = static_cast<std::size_t>(
        std::find_if(frequency_hz.begin(), frequency_hz.end(), [](double f) { return f > 0; }) - frequency_hz.begin());
    SpindleLines result;
    result.frequency_hz.assign(frequency_hz.begin() + static_cast<std::ptrdiff_t>(skipped), frequency_hz.end());
    result.lines.resize(result.frequency_hz.size());
    if (is_loaded) result.bare.resize(result.frequency_hz.size());
    parallelFor(result.lines.size(), linesPerRodTask, progress, [&](std::size_t begin, std::size_t end) {
        std::vector<beam::BeamReceptance> rods = prepared;
        for (std::size_t i = begin; i < end; ++i) {
            std::vector<FreeRod> free;
            for (beam::BeamReceptance& rod : rods) {
                free.push_back({rod.places(), std::vector<ReceptanceMatrix>(rod.places() * rod.places())});
                rod.at(result.frequency_hz[i], free.back().values);
            }
            if (is_loaded) result.bare[i] = lineOf(measurements, noise, skipped + i, free, bare_of_frf);
            for (std::size_t k = rods.size(); k < loadings.all.size(); ++k) {
                const Loading& one = loadings.all[k];
                free.push_back(withMassAt(free[one.rod], *one.point, one.mass_g, result.frequency_hz[i]));
            }
            result.lines[i] = lineOf(measurements, noise, skipped + i, free, loadings.of_frf);
        }
    });
    return result;
}

}  // namespace lathelier::receptance
