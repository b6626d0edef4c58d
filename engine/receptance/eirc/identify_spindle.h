// The receptance of a spindle by inverse coupling from tap tests on several rods (EIRC).
// After Jasiewicz and Miądlicki, An integrated CNC system for chatter suppression in turning ("extended number of
// configurations"); the equations are in spindle_line.h. One rod tells H well, but L and P only with several rods of
// different length: judge the result by the frequency response of a new part, not by L.
#pragma once

#include <optional>
#include <vector>

#include "engine/beam/beam_section.h"
#include "engine/core/progress.h"
#include "engine/core/used_value.h"
#include "engine/receptance/eirc/spindle_measurements.h"
#include "engine/receptance/spindle_receptance.h"

namespace lathelier::receptance {

struct IdentificationParameters {
    bool smooth = false;  ///< local quadratic along frequency, weighted by what each line knows
    int hold_out = 0;     ///< rod, from 1, that is not used but predicted; 0: all are used
    beam::ShearModel shear = beam::ShearModel::Hutchinson;  ///< shear coefficient of the rods
    friend bool operator==(const IdentificationParameters&, const IdentificationParameters&) = default;
};

const std::vector<Field<IdentificationParameters>>& fieldsOf(const IdentificationParameters*);

struct SpindleIdentification {
    IdentificationParameters parameters;         ///< as asked
    SpindleReceptance spindle;                   ///< a table on the lines of the measurements
    std::vector<double> frequency_hz;            ///< of those lines
    std::vector<double> condition;               ///< of each line: largest over smallest singular value of the weighted
                                                 ///< Jacobian, with L × 100 mm and P × (100 mm)²
    double residual_rms_percent = 0;             ///< 100·rms(|G_fit - G|/|G|) over all lines and responses used
    std::optional<double> hold_out_rms_percent;  ///< the same on the rod held out; none without one
    std::size_t frfs = 0;                        ///< number of responses used
    UsedValues used;                             ///< the materials, and who stated them
    Notes notes;                                 ///< materialAssumed, spindleIllConditioned, spindleNotConverged,
                                                 ///< spindleNotPassive
};

/// Weights: with coherence σ² ∝ |G|² (1-γ²)/γ², averaged over 9 lines, else σ ∝ |G|. Lines at 0 Hz are left out.
/// Errors: tooFewMeasuredPoints, measuredPointBeyondRod, measuredPairUnknown, frfLinesDiffer, holdOutUnknown, and
/// those of beam::beamModel(). Throws Cancelled.
SpindleIdentification identifySpindle(const SpindleMeasurements& measurements,
                                      const IdentificationParameters& parameters = {}, const Progress& progress = {});

}  // namespace lathelier::receptance
