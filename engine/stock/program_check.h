// Check of an NC program before it runs: unsupported words, machining time, material removed by each pass, collisions.
#pragma once

#include <optional>
#include <string>

#include "engine/core/json.h"
#include "engine/gcode/program_time.h"
#include "engine/gcode/toolpath.h"
#include "engine/report/document.h"
#include "engine/stock/drawn_path.h"
#include "engine/stock/stock_plots.h"

namespace lathelier::stock {

/// Stock and simulation parameters, if known.
struct CheckedStock {
    Shaft shaft;                 ///< before the first cut
    StockParameters parameters;  ///< zero, tools, chuck, tailstock, rapid rates
};

struct ProgramCheck {
    gcode::Program program;
    gcode::Toolpath path;
    gcode::ProgramTimes times;         ///< at the rapid rates of the parameters
    DrawnPath drawn;                   ///< of `path`, in the coordinates of the stock
    std::optional<StockResult> stock;  ///< none: no stock given, or the program has errors
    double z_zero_mm = 0;              ///< z = z_zero - Z in `drawn`
    Notes notes;                       ///< of the stock; programTimeIncomplete
};

/// `tools`: nose radii by tool. Errors in the program are part of the result, not exceptions. Errors: those of
/// gcode::readProgram() and simulateStock(). Throws Cancelled.
ProgramCheck checkProgram(std::string text, const gcode::ToolpathParameters& parameters,
                          const std::optional<CheckedStock>& stock = {}, const gcode::ToolTable& tools = {},
                          const Progress& progress = {});

/// Machining time; fail if the program has errors or a tool collides, pass if it was checked against stock. Findings
/// refer to program lines.
report::Answer answer(const ProgramCheck& check, const Language& language = {});

/// Stock with the path, or the path alone in program coordinates. `parts.path` is set here.
report::Plot meridianPlot(const ProgramCheck& check, StockPlotParts parts = {}, const Language& language = {});

/// Diagnostics of the text and collisions, by line: Line, Severity, Remark, Block.
struct Remark {
    std::int64_t line = 0;    ///< from 1
    std::int64_t column = 0;  ///< in characters, from 1; 0: the whole block
    bool is_error = false;    ///< else a warning
    std::string text;         ///< in the requested language
    std::string block;        ///< of the program, at most 40 characters
};
std::vector<Remark> remarksOf(const ProgramCheck& check, const Language& language = {});

report::Table passTable(const ProgramCheck& check);  ///< empty without stock
report::Table toolTable(const ProgramCheck& check);  ///< by tool: line, times, ways
Json toJson(const ProgramCheck& check);              ///< moves, words, diagnostics; times; keys of the stock
/// `notes`: of the check and its files.
report::Document programReport(const ProgramCheck& check, const Notes& notes, const Language& language = {});

}  // namespace lathelier::stock
