// The receptance of a spindle by inverse coupling from tap tests on several rods (EIRC). After Jasiewicz and Miądlicki,
// An integrated CNC system for chatter suppression in turning ("extended number of configurations"); the equations are
// in spindle_line.h. One rod determines H well, L and P require several rods of different length: judge the result by
// the predicted response of a new part, not by L.
#pragma once

#include <optional>
#include <vector>

#include "engine/beam/beam_section.h"
#include "engine/core/progress.h"
#include "engine/core/used_value.h"
#include "engine/receptance/eirc/spindle_measurements.h"
#include "engine/receptance/eirc/spindle_noise.h"
#include "engine/receptance/eirc/spindle_remedy.h"
#include "engine/receptance/spindle/spindle_receptance.h"

namespace lathelier::receptance {

struct IdentificationParameters {
    bool smooth = false;  ///< smooth by a local quadratic along frequency, weighted by the information of each line
    int hold_out = 0;     ///< number (from 1) of the rod excluded and predicted instead; 0: none
    beam::ShearModel shear = beam::ShearModel::Hutchinson;  ///< formula of the shear coefficient of the rods
    friend bool operator==(const IdentificationParameters&, const IdentificationParameters&) = default;
};

const std::vector<Field<IdentificationParameters>>& fieldsOf(const IdentificationParameters*);

/// A mistake of the measurements that was found by trying its remedy (spindle_remedy.h). It is not applied.
struct TriedRemedy {
    SpindleRemedy remedy;
    double rms_percent = 0;  ///< residual_rms_percent with it; of LeaveOut without that response
    Values values;           ///< of its note: rod and nodes as people count them, both residuals
};

struct SpindleIdentification {
    IdentificationParameters parameters;
    SpindleReceptance spindle;         ///< identified receptance, a table on the measured frequencies
    std::vector<double> frequency_hz;  ///< frequencies of the lines used
    std::vector<double> condition;  ///< by line: largest over smallest singular value of the weighted Jacobian, with L
                                    ///< × 100 mm and P × (100 mm)²
    double residual_rms_percent = 0;             ///< 100·rms(|G_fit - G|/|G|) over all lines and responses used
    std::optional<double> expected_rms_percent;  ///< what the noise alone leaves of it; none: noise not known
    std::optional<double> chi2_per_dof;          ///< of the fit line by line; none: noise or freedom not there
    std::vector<std::optional<double>> chi2_per_dof_of_frfs;  ///< by SpindleMeasurements::frfs; none: held out
    NoiseSource noise_from = NoiseSource::Unknown;            ///< source of the size of the noise
    std::optional<TriedRemedy> remedy;                        ///< the mistake found
    std::optional<double> hold_out_rms_percent;               ///< the same on the held-out rod; none without one
    std::size_t frfs = 0;                                     ///< number of responses used
    UsedValues used;                                          ///< the materials with their origin
    Notes notes;  ///< codes materialAssumed, spindleIllConditioned, spindleNotConverged, spindleNotPassive,
                  ///< spindleNotExplained and those of the remedies
};

/// A residual above this is undecided, unless the noise explains it.
inline constexpr double largestResidual_percent = 10;

/// Weights: 1/σ of spindle_noise.h. Lines at 0 Hz are excluded.
/// Errors: tooFewMeasuredPoints, measuredPointBeyondRod, measuredPairUnknown, frfLinesDiffer, holdOutUnknown, and those
/// of beam::beamModel(). Throws Cancelled.
SpindleIdentification identifySpindle(const SpindleMeasurements& measurements,
                                      const IdentificationParameters& parameters = {}, const Progress& progress = {});

}  // namespace lathelier::receptance
