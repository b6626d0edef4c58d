// The task toolpath: an NC program to moves, remarks and time; with a stock, to what the tool meets. The verb and the
// panel Program.
//
// The stock is that which is given, else that of the set-up, else the bar of a planned program with its zero.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/deflection/deflection_question.h"
#include "engine/gcode/program_draft.h"
#include "engine/gcode/toolpath.h"
#include "engine/stock/program_check.h"
#include "engine/task/task.h"

namespace lathelier::deflection {

struct ToolpathQuestion {
    gcode::ToolpathParameters reading;
    SetupChanges changes;                     ///< of the set-up, for the check against the stock
    std::vector<gcode::ProgramDraft> drafts;  ///< edited texts used instead of program files
};

const std::vector<Field<ToolpathQuestion>>& fieldsOf(const ToolpathQuestion*);

struct ToolpathOutcome : task::Answered {
    ToolpathQuestion question;                         ///< the parameters as a value
    std::shared_ptr<const stock::ProgramCheck> check;  ///< never null
    std::string file;                                  ///< path of the program, or name and digest of its item
    std::string item;                                  ///< name of the item; empty: a file
    std::string sha256;                                ///< digest of that file or item
    std::string file_text;                             ///< text of the file, UTF-8
    std::string text;                                  ///< checked text, UTF-8: draft or file
    stock::StockParameters parameters;                 ///< of the check against stock; tools for drawing

    bool isDraft() const { return !question.drafts.empty(); }
};

/// Errors in the program are part of the outcome. Errors: those of the readers and of stock::checkProgram(). Throws
/// Cancelled.
ToolpathOutcome answerToolpath(const project::PanelState& state, Stores& stores, task::Sources& sources,
                               const Progress& progress);

/// For callers that work with every task; errors: the first one of the program.
task::Outcome outcomeOf(const std::shared_ptr<const ToolpathOutcome>& outcome);

inline constexpr const char* movesExport = "csv";
inline constexpr const char* rewriteExport = "rewrite";

const task::Task& toolpathTask();

}  // namespace lathelier::deflection
