// Outcome of the panel Spindle.
#pragma once

#include <memory>
#include <optional>

#include "engine/project/project.h"
#include "engine/receptance/eirc/spindle_check.h"
#include "engine/receptance/spindle_kind.h"
#include "engine/report/document.h"
#include "engine/task/file_cache.h"
#include "engine/task/stores.h"
#include "widgets/spindle_machine/machine_question.h"

namespace lathelier::machine_panel {

inline constexpr const char* measurementsRole = "measurements";

/// Errors as receptance::loadTapTests().
class MeasurementStore : public FileCache<receptance::TapTests> {
public:
    MeasurementStore() : FileCache(6) {}

protected:
    receptance::TapTests read(const project::Source& source, io::InputFiles& inputs,
                              const Progress& progress) const override;
};

struct MachineOutcome {
    receptance::SpindleReceptance spindle;                                ///< receptance of the spindle
    std::shared_ptr<const receptance::SpindleIdentification> identified;  ///< null: springs
    std::shared_ptr<const receptance::SpindleCheck> check;  ///< residuals of the identification; null: springs
    MachineQuestion question;                               ///< question of the request
    UsedValues used;                                        ///< springs or materials with their origin
    std::vector<InputFile> inputs;                          ///< the tap tests and their responses
    Notes notes;                                            ///< of files and result
    bool synthetic = false;                                 ///< the source is marked as synthetic
};

/// Reads and computes; thread-safe. Errors of the store and of identifySpindle(). Throws Cancelled.
MachineOutcome machineOutcome(const project::PanelState& state, Stores& stores, const Progress& progress);

/// The residual against its limit, or the static compliance of the springs.
report::Answer answer(const MachineOutcome& outcome, const Language& language = {});

report::Document reportOf(const MachineOutcome& outcome, const Language& language = {});

}  // namespace lathelier::machine_panel
