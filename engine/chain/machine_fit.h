// Stiffness and forces of the machine from the measured diameters of the copy, identified by engine/deflection.
//
// Only the first clamping is fitted, as the springs of the set-up refer to it.
#pragma once

#include <optional>
#include <string>

#include "engine/chain/dossier.h"
#include "engine/chain/proof.h"
#include "engine/deflection/identification.h"
#include "engine/receptance/spindle/spindle_receptance.h"

namespace lathelier::chain {

struct MachineFit {
    deflection::IdentificationResult found;  ///< factors, set-up, predictions before and after
    std::string setup_text;                  ///< SETUP.json with the identified values; the chain replaces the stock
    std::string whole_text;                  ///< the same with the full path of the stock file
    std::optional<receptance::SpindleSprings> springs;  ///< of the machine model; none: it is tabulated
    double zero_mm = 0;                                 ///< z of its stock less z of the part
};

/// Fitted positions in z of the stock. Diameters: nominal contour plus measured error. Standard uncertainties are U /
/// 2.
std::vector<deflection::MeasuredDiameter> fittedDiameters(const deflection::FinalContour& contour, const Proof& proof,
                                                          double zero_mm);

/// None: no deflection step, or no measurement along z. Errors: those of readers and of identify(). Throws Cancelled.
std::optional<MachineFit> fitMachine(const std::string& folder, const Dossier& dossier, const Proof& proof,
                                     const deflection::IdentificationParameters& parameters,
                                     const Progress& progress = {});

}  // namespace lathelier::chain
