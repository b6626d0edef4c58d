// What an answer about deflection hangs on, each as a factor on the set-up: for robustness, sensitivities, uncertainty
// and identification.
#pragma once

#include <vector>

#include "engine/core/text.h"
#include "engine/deflection/setup.h"

namespace lathelier::deflection {

enum class Influence {
    Tailstock,    ///< its radial and tilting stiffness
    ChuckRadial,  ///< radial stiffness of the chuck
    ChuckTilt,    ///< tilting stiffness of the chuck
    Rests,        ///< steady rests and follower rest
    ToolPost,     ///< tool and turret
    Modulus,      ///< E of the work
    Forces        ///< all four cutting coefficients
};

struct InfluenceName {
    Influence influence;
    const char* key;  ///< "tailstock"
    Text name;        ///< for tables
};

/// All of them, in order.
const std::vector<InfluenceName>& influences();
const InfluenceName& nameOf(Influence influence);

/// False: nothing in the set-up that it could change.
bool hasInfluence(const TurningSetup& setup, Influence influence);

/// The set-up with that part `factor` times as large.
TurningSetup scaled(TurningSetup setup, Influence influence, double factor);

/// Every spring that holds the work, likewise.
TurningSetup withSpringsScaled(TurningSetup setup, double factor);

}  // namespace lathelier::deflection
