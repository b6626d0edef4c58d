// Outcome of the panels Deflection and Correction.
#pragma once

#include <memory>

#include "engine/core/input_file.h"
#include "engine/report/document.h"
#include "engine/stock/drawn_path.h"
#include "widgets/core/files/stores.h"
#include "widgets/deflection_common/deflection_question.h"
#include "widgets/deflection_common/turning_files.h"

namespace lathelier::deflection_common {

struct DeflectionOutcome {
    DeflectionQuestion question;                            ///< question of the request
    std::shared_ptr<const deflection::TurningJob> job;      ///< never null
    std::shared_ptr<const deflection::TurningStudy> study;  ///< never null
    std::optional<gcode::ProgramItem> program;              ///< item of the program; none: a file
    std::string program_sha256;                             ///< digest of the text read
    stock::DrawnPath drawn;                                 ///< path of the program, with the stock for a prediction
    std::vector<InputFile> inputs;                          ///< files and items
    Notes notes;                                            ///< of the files and of the result
    bool synthetic = false;                                 ///< true: a source is marked as synthetic
};

/// The computation: prediction, or prediction with correction.
enum class StudyKind { Prediction, Correction };

/// Reads and computes; thread-safe. Errors: those of the readers and of studyTurning(); stockMissing; the first error
/// of the program. Throws Cancelled.
DeflectionOutcome deflectionOutcome(const project::PanelState& state, StudyKind studyKind, Stores& stores,
                                    const Progress& progress);

report::Document reportOf(const DeflectionOutcome& outcome, const Language& language);

}  // namespace lathelier::deflection_common
