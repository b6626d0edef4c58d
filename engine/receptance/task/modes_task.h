// The task modes: which modes does a measured response show, and does that of the computed shaft agree? The verb modes
// and the panel FRF.
//
// The modes of the measured response are fitted; without one those of the computed response. The lines of the computed
// response are those of the measured one, evenly spaced, else those of the range; a spindle's table rules over their
// range.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/io/frf/measured_frf.h"
#include "engine/receptance/modal/response_study.h"
#include "engine/receptance/shaft/shaft_receptance.h"
#include "engine/task/task.h"

namespace lathelier::receptance {

enum class HandedOn { Measured, Model };

struct ModesQuestion {
    bool all_responses = false;               ///< fit all responses of the file with common poles
    bool fit = true;                          ///< fit modes
    ModalParameters modal;                    ///< number of modes and range
    std::vector<ModalMode> modes;             ///< modes replacing those of the fit; empty: fitted modes
    HandedOn handed_on = HandedOn::Measured;  ///< response handed on to the lobes
    ReceptanceParameters computing;           ///< computation of the shaft; its lines follow from the measured ones
};

const std::vector<Field<ModesQuestion>>& fieldsOf(const ModesQuestion*);

inline constexpr const char* responseRole = "frf";
inline constexpr const char* changedModesKey = "modes";

struct ModesOutcome : task::Answered {
    ModesQuestion question;    ///< the parameters as a value
    ResponseStudy study;       ///< responses and model
    io::MeasuredFrf measured;  ///< nodes and directions of the measured response, without its lines
    std::string name;          ///< name of the response, for its item

    /// Receptance that is handed on; null: the model is requested and there is none.
    FrfPtr handedOn() const;
};

/// Errors: those of the readers, fitModes(), shaftReceptance(). Throws Cancelled.
ModesOutcome answerModes(const project::PanelState& state, Stores& stores, task::Sources& sources,
                         const Progress& progress);

task::Outcome outcomeOf(const std::shared_ptr<const ModesOutcome>& outcome);

const task::Task& modesTask();

}  // namespace lathelier::receptance
