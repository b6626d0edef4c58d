// Outcome of the panel Program.
#pragma once

#include <memory>

#include "engine/core/input_file.h"
#include "engine/stock/program_check.h"
#include "widgets/core/files/stores.h"
#include "widgets/deflection_common/deflection_question.h"

namespace lathelier::program_panel {

struct ProgramOutcome {
    deflection_common::DeflectionQuestion question;    ///< question with only the used draft
    std::shared_ptr<const stock::ProgramCheck> check;  ///< never null
    std::string file;                                  ///< path of the program, or name and digest of its item
    std::string item;                                  ///< name of the item; empty: a file
    std::string sha256;                                ///< digest of that file or item
    std::string file_text;                             ///< text of the file, UTF-8
    std::string text;                                  ///< checked text, UTF-8: draft or file
    stock::StockParameters parameters;                 ///< parameters of the check against stock; tools for drawing
    std::vector<InputFile> inputs;                     ///< files and items
    Notes notes;                                       ///< of the files and of the result
    bool synthetic = false;                            ///< a source is marked as synthetic

    bool isDraft() const { return !question.drafts.empty(); }
};

/// Reads and runs; thread-safe. Set-up and stock are used if given. Errors: those of the readers and of
/// stock::checkProgram(). Throws Cancelled.
ProgramOutcome programOutcome(const project::PanelState& state, Stores& stores, const Progress& progress);

report::Document reportOf(const ProgramOutcome& outcome, const Language& language);

}  // namespace lathelier::program_panel
