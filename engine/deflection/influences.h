// Input quantities that a predicted deflection depends on, each as a factor on the set-up: for robustness,
// sensitivities, uncertainty and identification.
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
    ToolPost,
    Modulus,  ///< E of the work
    Forces    ///< all cutting coefficients
};

struct InfluenceName {
    Influence influence;
    const char* key;  ///< "tailstock"
    Text name;
};

/// All of them, in order.
const std::vector<InfluenceName>& influences();
const InfluenceName& nameOf(Influence influence);

/// False if the set-up lacks the element.
bool hasInfluence(const TurningSetup& setup, Influence influence);

/// The set-up with that quantity multiplied by `factor`.
TurningSetup scaled(TurningSetup setup, Influence influence, double factor);

/// The set-up with all workpiece springs multiplied by `factor`.
TurningSetup withSpringsScaled(TurningSetup setup, double factor);

}  // namespace lathelier::deflection
