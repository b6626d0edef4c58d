// Question of the panel FRF: response, fit, modes edited by hand, computation of the shaft.
#pragma once

#include <string>
#include <vector>

#include "engine/receptance/modal/modal_fit.h"
#include "engine/receptance/shaft_receptance.h"

namespace lathelier::frf_panel {

enum class HandedOn { Measured, Model };

struct FrfQuestion {
    std::string response;                        ///< selection in a file: number, or nodes as "12/5"; empty: the first
    bool fit = true;                             ///< fit modes
    receptance::ModalParameters modal;           ///< number of modes and range
    std::vector<receptance::ModalMode> modes;    ///< modes replacing those of the fit; empty: fitted modes
    HandedOn handed_on = HandedOn::Measured;     ///< response handed on to the lobes
    receptance::ReceptanceParameters computing;  ///< computation of the shaft; its lines follow from the measured ones
};

const std::vector<Field<FrfQuestion>>& fieldsOf(const FrfQuestion*);

}  // namespace lathelier::frf_panel
