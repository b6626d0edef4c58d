// Stiffness and forces of the machine from the diameters of its copy, by the identification of the room deflection.
//
// Only the first clamping is fitted: its springs are those that the set-up states.
#pragma once

#include <optional>
#include <string>

#include "engine/chain/dossier.h"
#include "engine/chain/proof.h"
#include "engine/deflection/identification.h"
#include "engine/receptance/spindle_receptance.h"

namespace lathelier::chain {

struct MachineFit {
    deflection::IdentificationResult found;  ///< factors, set-up, what was predicted before and after
    std::string setup_text;                  ///< SETUP.json with what was found; the chain lays the bar into it anew
    std::string whole_text;                  ///< the same with the stock that was used, by its full path
    std::optional<receptance::SpindleSprings> springs;  ///< of the machine of the chain; none: it is a table
    double zero_mm = 0;                                 ///< z of its stock less z of the part
};

/// Which places are fitted, and in what z of the stock. Diameters are those that the program left without bending, plus
/// what was measured. Standard uncertainties are U / 2.
std::vector<deflection::MeasuredDiameter> fittedDiameters(const deflection::FinalContour& contour, const Proof& proof,
                                                          double zero_mm);

/// None: deflection is not done, or nothing was measured along z. Errors: those of readers and of identify(). Throws
/// Cancelled.
std::optional<MachineFit> fitMachine(const std::string& folder, const Dossier& dossier, const Proof& proof,
                                     const deflection::IdentificationParameters& parameters,
                                     const Progress& progress = {});

}  // namespace lathelier::chain
