// What the worker of the panel "Program" computes.
#pragma once

#include <memory>

#include "engine/core/input_file.h"
#include "engine/stock/program_check.h"
#include "widgets/core/files/stores.h"
#include "widgets/deflection_common/deflection_question.h"

namespace lathelier::program_panel {

struct ProgramPicture {
    deflection_common::DeflectionQuestion question;    ///< as asked; of the drafts the one that is used
    std::shared_ptr<const stock::ProgramCheck> check;  ///< never null
    std::string file;                                  ///< path of the program, or what tells its item from others
    std::string item;                                  ///< name of the item; empty: a file
    std::string sha256;                                ///< of that file or item
    std::string file_text;                             ///< of the file, UTF-8
    std::string text;                                  ///< that was read, UTF-8: of the draft or of the file
    stock::StockParameters parameters;                 ///< of the check against stock; tools for the drawing
    std::vector<InputFile> inputs;                     ///< files and items
    Notes notes;                                       ///< of the files and of the result
    bool synthetic = false;                            ///< a source is marked as synthetic

    bool isDraft() const { return !question.drafts.empty(); }
};

/// Reads and runs; safe from any thread. Set-up and stock are taken where they are there. Errors: those of the readers
/// and of stock::checkProgram(). Throws Cancelled.
ProgramPicture programPicture(const project::PanelState& state, Stores& stores, const Progress& progress);

report::Document reportOf(const ProgramPicture& picture, const Language& language);

}  // namespace lathelier::program_panel
