// The task deflection: program, set-up, stock and machine to prediction and correction. The verb and the panels
// Deflection and Correction.
//
// Precedence: a stock that is given rules over the one that the set-up names, and that over the bar of a planned
// program, which brings its zero. The springs of a spindle become those of the chuck. A shaft of the project brings its
// material as well, a shaft file its contour only; a material of the library, and numbers, rule over all.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/deflection/deflection_question.h"
#include "engine/gcode/program_item.h"
#include "engine/stock/drawn_path.h"
#include "engine/task/task.h"

namespace lathelier::deflection {

inline constexpr const char* setupRole = "setup";
inline constexpr const char* stockRole = "shaft";      ///< key in projects; --stock on the command line
inline constexpr const char* spindleRole = "spindle";  ///< in place of the chuck of the set-up

/// The set-up, the stock and the chuck as inputs of a task; `required`: of the set-up.
task::Input setupAsInput(bool required);
task::Input stockAsInput();
task::Input spindleAsInput();

/// The computation: prediction, or prediction with correction.
enum class StudyKind { Prediction, Correction };

struct DeflectionOutcome : task::Answered {
    DeflectionQuestion question;                ///< the parameters as a value
    std::shared_ptr<const TurningJob> job;      ///< never null
    std::shared_ptr<const TurningStudy> study;  ///< never null
    std::optional<gcode::ProgramItem> program;  ///< item of the program; none: a file
    std::string program_sha256;                 ///< digest of the text read
    stock::DrawnPath drawn;                     ///< path of the program, with the stock for a prediction
};

/// Errors: those of the readers and of studyTurning(); stockMissing; the first error of the program. Throws Cancelled.
DeflectionOutcome answerDeflection(const project::PanelState& state, StudyKind kind, Stores& stores,
                                   task::Sources& sources, const Progress& progress);

/// For callers that work with every task.
task::Outcome outcomeOf(const std::shared_ptr<const DeflectionOutcome>& outcome);

/// Exports of the outcome by option: with a correction "compensate" and "correction-csv".
inline constexpr const char* compensateExport = "compensate";
inline constexpr const char* correctionExport = "correction-csv";
inline constexpr const char* errorsExport = "csv";
inline constexpr const char* setupExport = "changed-setup";

const task::Task& deflectionTask();

}  // namespace lathelier::deflection
