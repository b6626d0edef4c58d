// The frequency response of a shaft, free or on a machine: w per F between two places.
// Sources: exact Timoshenko beam (engine/beam), receptance coupling (coupling.h).
#pragma once

#include <optional>
#include <vector>

#include "engine/beam/beam_model.h"
#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/frf.h"
#include "engine/core/progress.h"
#include "engine/core/units.h"
#include "engine/core/used_value.h"
#include "engine/receptance/spindle/spindle_receptance.h"
#include "engine/shaft/shaft.h"

namespace lathelier::receptance {

/// Parameters of the response of a shaft. z is measured from the free end toward the chuck.
struct ReceptanceParameters {
    double respond_z_mm = 0;                                ///< z of the deflection
    double excite_z_mm = 0;                                 ///< z of the force
    std::optional<double> from_hz;                          ///< first frequency; none: see withinLines()
    std::optional<double> to_hz;                            ///< upper limit of the frequency; none: likewise
    double step_hz = 1;                                     ///< frequency step
    beam::ShearModel shear = beam::ShearModel::Hutchinson;  ///< formula of the shear coefficient κ
    beam::BeamMethod method = beam::BeamMethod::Exact;      ///< motion within a uniform piece
    bool step_correction = false;                           ///< limit the stiffness beside steps to a 45° cone
    friend bool operator==(const ReceptanceParameters&, const ReceptanceParameters&) = default;
};

const std::vector<Field<ReceptanceParameters>>& fieldsOf(const ReceptanceParameters*);

struct ShaftReceptanceResult {
    ReceptanceParameters parameters;  ///< with the range that was computed
    double length_mm = 0;             ///< length of the shaft; the chuck face is at this z
    Frf frf;                          ///< receptance, mm/N; NaN where undefined: a free shaft at 0 Hz
    std::optional<std::vector<double>> natural_frequencies_hz;  ///< undamped, up to the last frequency; with a spindle
                                                                ///< those on its springs; none for a spindle table
    UsedValues used;                                            ///< the material with its origin
    Notes notes;                                                ///< codes materialAssumed, spindleHasNoModes
};

/// Lines where none were asked for and no table says which there are.
inline constexpr Interval usualLines_hz{50, 5000};

/// The parameters with their range. An end that was not asked for is that of the spindle's table, which says which
/// frequencies are known, else that of `usual`. An end that was asked for stays, also where the table does not reach.
ReceptanceParameters withinLines(ReceptanceParameters asked, const std::optional<SpindleReceptance>& spindle,
                                 const Interval& usual = usualLines_hz);

/// The frequency lines of the parameters; see withinLines(). Error valueNotUnderstood for more than a million, or a
/// range reversed.
std::vector<double> linesOf(const ReceptanceParameters& parameters);

/// Supports of a shaft.
struct ShaftHolding {
    std::optional<SpindleReceptance> spindle;  ///< at the chuck face, z = length; none: free
    std::vector<beam::Support> supports;       ///< additional supports: tailstock, steady rests, a rigid chuck
};

/// Parameters of the beam model; `springs`: the spindle, where it is springs, becomes one of its supports.
beam::BeamParameters beamParametersOf(const ReceptanceParameters& parameters, const ShaftHolding& holding,
                                      double length_mm, bool springs);

/// Refined: as limits need them: more lines where it curves (refined_lines.h), usual ones from below the lowest mode.
enum class LinesOf { Parameters, Refined };

/// The receptance alone, without natural frequencies; errors as shaftReceptance(). Throws Cancelled.
Frf receptanceOf(const Shaft& shaft, const Material& material, const ReceptanceParameters& parameters,
                 const ShaftHolding& holding = {}, const Progress& progress = {}, LinesOf lines = LinesOf::Parameters);

/// Without a spindle the shaft is free; with one it is joined to its chuck face at z = length.
/// Errors: placeOutsideShaft (wrong usage), valueNotUnderstood, valueOutOfRange, frequencyOutsideSpindle,
/// shaftSegmentUnusable, shaftEmpty. Throws Cancelled.
ShaftReceptanceResult shaftReceptance(const Shaft& shaft, const ReceptanceParameters& parameters = {},
                                      const std::optional<SpindleReceptance>& spindle = {},
                                      const Progress& progress = {}, LinesOf lines = LinesOf::Parameters);

/// The same with additional supports.
ShaftReceptanceResult heldShaftReceptance(const Shaft& shaft, const ReceptanceParameters& parameters,
                                          const ShaftHolding& holding, const Progress& progress = {},
                                          LinesOf lines = LinesOf::Parameters);

/// The material of a shaft, or steel with the note materialAssumed; its values enter `used`.
Material materialOf(const Shaft& shaft, UsedValues& used, Notes& notes);

}  // namespace lathelier::receptance
