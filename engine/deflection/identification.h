// Stiffness of the machine from a few measured diameters: the factors on springs and forces with which the predicted
// errors come nearest to the measured ones.
//
// Least squares over the logarithms of the factors (Levenberg-Marquardt, derivatives by differences), each diameter
// weighted by its standard uncertainty. Covariance (JᵀWJ)⁻¹. E_n = |predicted - measured|/√(U_p² + U_m²), k = 2
// (ISO/IEC 17043).
#pragma once

#include <span>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/deflection/deflection.h"
#include "engine/deflection/influences.h"

namespace lathelier::deflection {

/// A measured diameter of the finished part.
struct MeasuredDiameter {
    double z_mm = 0;  ///< from the free end
    double diameter_mm = 0;
    double uncertainty_um = 2;  ///< standard uncertainty, > 0
    friend bool operator==(const MeasuredDiameter&, const MeasuredDiameter&) = default;
};

const std::vector<Field<MeasuredDiameter>>& fieldsOf(const MeasuredDiameter*);

/// Factors to identify.
struct IdentificationParameters {
    bool tailstock = true;      ///< k_tail
    bool chuck_radial = false;  ///< k_chuck
    bool chuck_tilt = true;     ///< k_rot
    bool forces = false;        ///< scale of all forces; strongly correlated with the springs
    friend bool operator==(const IdentificationParameters&, const IdentificationParameters&) = default;
};

const std::vector<Field<IdentificationParameters>>& fieldsOf(const IdentificationParameters*);

struct IdentifiedFactor {
    Influence influence = Influence::Forces;
    double factor = 1;               ///< on the value in the set-up
    double value = 1;                ///< identified value; for forces the factor
    double uncertainty_percent = 0;  ///< standard, of the factor
};

/// Predicted beside measured.
struct ComparedDiameter {
    double z_mm = 0;
    double measured_um = 0;     ///< error of the measured diameter against the program
    double before_um = 0;       ///< predicted with the original set-up
    double after_um = 0;        ///< with what was found
    double uncertainty_um = 0;  ///< standard uncertainty of the prediction, from the covariance
    double E_n = 0;             ///< with the identified set-up
};

struct IdentificationResult {
    IdentificationParameters parameters;
    TurningSetup setup;                       ///< with the identified values
    std::vector<IdentifiedFactor> factors;    ///< in order of Influence
    std::vector<double> correlation;          ///< of the logarithms, row by row
    std::vector<ComparedDiameter> diameters;  ///< in the order given
    double rms_before_um = 0, rms_after_um = 0;
    int iterations = 0;
    Notes notes;  ///< poorlyDetermined, atItsLimit
};

/// Errors: tooFewMeasured (fewer diameters than unknowns, or no unknown), measuredOutsideCut, notConverged, those of
/// predictDeflection(). Throws Cancelled.
IdentificationResult identify(const Shaft& stock, std::span<const ToolRun> runs, const TurningSetup& setup,
                              std::span<const MeasuredDiameter> measured,
                              const IdentificationParameters& parameters = {}, const Progress& progress = {});

}  // namespace lathelier::deflection
