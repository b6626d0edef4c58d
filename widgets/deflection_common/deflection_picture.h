// What the workers of the panels "Deflection" and "Correction" compute.
#pragma once

#include <memory>

#include "engine/core/input_file.h"
#include "engine/report/document.h"
#include "engine/stock/drawn_path.h"
#include "widgets/core/files/stores.h"
#include "widgets/deflection_common/deflection_question.h"
#include "widgets/deflection_common/turning_files.h"

namespace lathelier::deflection_common {

struct DeflectionPicture {
    DeflectionQuestion question;                            ///< as asked
    std::shared_ptr<const deflection::TurningJob> job;      ///< never null
    std::shared_ptr<const deflection::TurningStudy> study;  ///< never null
    std::optional<gcode::ProgramItem> program;              ///< item that the program was taken from; none: a file
    std::string program_sha256;                             ///< of the text that was read
    stock::DrawnPath drawn;                                 ///< of the program; with the stock of a prediction
    std::vector<InputFile> inputs;                          ///< files and items
    Notes notes;                                            ///< of the files and of the result
    bool synthetic = false;                                 ///< a source is marked as synthetic
};

/// Which of the two panels asks.
enum class Wanted { Prediction, Correction };

/// Reads and computes; safe from any thread. Errors: those of the readers and of studyTurning(); stockMissing; the
/// first error of the program. Throws Cancelled.
DeflectionPicture deflectionPicture(const project::PanelState& state, Wanted wanted, Stores& stores,
                                    const Progress& progress);

report::Document reportOf(const DeflectionPicture& picture, const Language& language);

}  // namespace lathelier::deflection_common
