// What the panel "FRF" is asked: which response, how it is fitted, modes changed by hand, how the shaft is computed.
#pragma once

#include <string>
#include <vector>

#include "engine/receptance/modal/modal_fit.h"
#include "engine/receptance/shaft_receptance.h"

namespace lathelier::frf_panel {

enum class HandedOn { Measured, Model };

struct FrfQuestion {
    std::string response;                        ///< of several in a file: number, or nodes as "12/5"; empty: the first
    bool fit = true;                             ///< find modes
    receptance::ModalParameters modal;           ///< how many, in which range
    std::vector<receptance::ModalMode> modes;    ///< in place of those of the fit; empty: the fit's
    HandedOn handed_on = HandedOn::Measured;     ///< what goes to the lobes
    receptance::ReceptanceParameters computing;  ///< of the shaft; its lines follow from the measured ones
};

const std::vector<Field<FrfQuestion>>& fieldsOf(const FrfQuestion*);

}  // namespace lathelier::frf_panel
