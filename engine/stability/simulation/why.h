// Explanation of the stability of a cut in lines: statement, formula, numerical values of this cut. Source: J. Tlusty,
// "Manufacturing Processes and Equipment"; Y. Altintas, "Manufacturing Automation".
#pragma once

#include <string>
#include <vector>

#include "engine/core/frf.h"
#include "engine/core/texts.h"
#include "engine/stability/lobes.h"
#include "engine/stability/simulation/simulation.h"

namespace lathelier::stability {

struct WhyLine {
    Text idea;            ///< one sentence
    std::string formula;  ///< the same in every language
    std::string numbers;  ///< the formula with the numbers of this cut
};

/// The delay, the chip, whole waves and phase, chatter marks, the growth, the limit at this speed, the speed by both
/// relations. Lines without values (no limiting lobe) are omitted.
std::vector<WhyLine> whyOf(const SimulationResult& cut, const LobeResult& lobes, const Frf& frf,
                           const Language& language = {});

}  // namespace lathelier::stability
