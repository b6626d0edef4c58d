#include "engine/receptance/shaft/shaft_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/beam/beam_receptance.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t placesOfShape = 121;
constexpr double kilogramsOfTonne = 1000;
constexpr double beyond = 1e-6;  ///< relative margin, so that a mode at the upper limit is included

/// Static: without damping.
std::optional<double> staticCompliance(beam::BeamModel model)
{
    model.loss_factor = 0;
    for (beam::NodeSupport& support : model.supports) support.radial_loss_N_mm = support.tilt_loss_N_mm = 0;
    std::array<beam::ReceptanceMatrix, 4> g;
    beam::BeamReceptance(std::move(model)).at(0, g);
    const double compliance = g[1](0, 0).real();
    return std::isfinite(compliance) ? std::optional(compliance) : std::nullopt;
}

}  // namespace

ShaftStudy studyShaft(const Shaft& shaft, const ReceptanceParameters& parameters, const ShaftHolding& holding,
                      const Progress& progress)
{
    ShaftStudy study;
    study.response = heldShaftReceptance(shaft, parameters, holding, progress.part(0, 0.7));
    const double length_mm = study.response.length_mm;
    UsedValues used;
    Notes notes;
    const Material material = materialOf(shaft, used, notes);
    const beam::BeamParameters held = beamParametersOf(parameters, holding, length_mm, true);
    const bool has_modes = study.response.natural_frequencies_hz.has_value();

    study.places_z_mm.reserve(placesOfShape);
    for (std::size_t i = 0; i < placesOfShape; ++i)
        study.places_z_mm.push_back(length_mm * static_cast<double>(i) / static_cast<double>(placesOfShape - 1));
    const beam::BeamModel model = beam::beamModel(shaft, material, held, study.places_z_mm);
    for (const beam::BeamPiece& piece : model.pieces)
        study.mass_kg += kilogramsOfTonne * piece.mass_t_mm * piece.length_mm;
    if (!has_modes) return study;

    const std::vector<double> between{parameters.respond_z_mm, parameters.excite_z_mm};
    study.static_mm_N = staticCompliance(beam::beamModel(shaft, material, held, between));
    const std::vector<double>& frequencies_hz = *study.response.natural_frequencies_hz;
    if (!frequencies_hz.empty()) {
        const double highest_hz = frequencies_hz[std::min(mostShapes, frequencies_hz.size()) - 1];
        study.modes = beam::modeShapes(model, highest_hz * (1 + beyond), progress.part(0.7, 1));
        if (study.modes.size() > mostShapes) study.modes.resize(mostShapes);
    }
    progress.report(1);
    return study;
}

}  // namespace lathelier::receptance
