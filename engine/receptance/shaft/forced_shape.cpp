#include "engine/receptance/shaft/forced_shape.h"

#include <algorithm>
#include <cmath>

#include "engine/core/interpolate.h"
#include "engine/core/units.h"
#include "engine/receptance/shaft/held_beam.h"
#include "engine/receptance/shaft/shaft_contour.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t placesOfSwing = 121;
constexpr double stationsOverLength = 200;
constexpr int angles = 72;

const Complex& largestOf(const std::vector<Complex>& values)
{
    return *std::max_element(values.begin(), values.end(),
                             [](const Complex& a, const Complex& b) { return std::abs(a) < std::abs(b); });
}

}  // namespace

double ForcedShape::largestDeflection() const
{
    return std::abs(largestOf(deflection_mm_N));
}

double ForcedShape::phaseBehindForce() const
{
    return std::arg(largestOf(deflection_mm_N));
}

ForcedShape forcedShape(const Shaft& shaft, const ReceptanceParameters& parameters, const ShaftHolding& holding,
                        double frequency_hz)
{
    ForcedShape shape;
    shape.frequency_hz = frequency_hz;
    shape.force_z_mm = parameters.excite_z_mm;
    const double length_mm = shaft.length_mm();
    shape.z_mm.reserve(placesOfSwing);
    for (std::size_t i = 0; i < placesOfSwing; ++i)
        shape.z_mm.push_back(length_mm * static_cast<double>(i) / static_cast<double>(placesOfSwing - 1));
    std::vector<double> places_z_mm = shape.z_mm;
    places_z_mm.push_back(parameters.excite_z_mm);
    UsedValues used;
    Notes notes;
    beam::BeamReceptance beam(beam::beamModel(shaft, materialOf(shaft, used, notes),
                                              beamParametersOf(parameters, holding, length_mm, false), places_z_mm));
    const std::size_t count = places_z_mm.size(), force = count - 1, chuck = placesOfSwing - 1;
    std::vector<ReceptanceMatrix> g(count * count);
    if (holding.spindle)
        receptancesOnSpindle(beam, holding.spindle->at(frequency_hz), chuck, frequency_hz, g);
    else
        beam.at(frequency_hz, g);
    shape.deflection_mm_N.reserve(placesOfSwing);
    for (std::size_t i = 0; i < placesOfSwing; ++i) shape.deflection_mm_N.push_back(g[i * count + force](0, 0));
    return shape;
}

Skin swingingSkin(const Shaft& shaft, const ForcedShape& shape, double phase_rad)
{
    const ShaftContour contour = contourOf(shaft);
    std::vector<Eigen::Vector2d> line{{0, 0}};
    for (std::size_t i = 0; i < contour.z_mm.size(); ++i) line.emplace_back(contour.z_mm[i], contour.radius_mm[i]);
    line.emplace_back(contour.z_mm.back(), 0);
    const Complex turned = std::polar(1.0, -shape.phaseBehindForce());
    const double largest_mm_N = shape.largestDeflection();

    Skin skin;
    skin.stations = stationsAlong(line, shape.z_mm.back() / stationsOverLength);
    skin.angle_count = angles;
    skin.values.reserve(skin.vertexCount());
    skin.shift_mm.reserve(skin.vertexCount());
    for (const SkinStation& station : skin.stations) {
        const Complex deflection_mm_N = linearAt(shape.z_mm, shape.deflection_mm_N, station.z_mm) * turned;
        const double now = (deflection_mm_N * std::polar(1.0, phase_rad)).real() / largest_mm_N;
        skin.values.insert(skin.values.end(), angles, static_cast<float>(um_per_mm * deflection_mm_N.real()));
        skin.shift_mm.insert(skin.shift_mm.end(), angles, Eigen::Vector3d(now, 0, 0).cast<float>());
    }
    return skin;
}

}  // namespace lathelier::receptance
