// Charts and tables of a turning plan for the screen.
#pragma once

#include <optional>

#include "engine/cam/drawn/drawn_plan.h"
#include "engine/report/chart.h"
#include "engine/report/document.h"

namespace lathelier::cam {

/// How much of the stock is taken off: all of it, nothing yet, or up to a pass.
struct StockShown {
    bool is_whole = true;             ///< after the whole program
    std::optional<std::size_t> pass;  ///< else after this pass; none: nothing is cut yet
    friend bool operator==(const StockShown&, const StockShown&) = default;
};

/// The stock while the block at `line` runs: after the passes that are finished by then.
StockShown stockAt(const TurningOutcome& outcome, std::size_t setup, std::int64_t line, bool is_cutting);

/// Drawing, stock, path, findings; what stays with its number and cause. `pixels`: how finely the path is drawn.
report::Plot contourPlot(const TurningOutcome& outcome, std::size_t setup, const StockShown& shown, int pixels,
                         const Language& language);

/// What is drawn along the part below the contour.
enum class Course { Speed, CuttingSpeed, Frequency, Roughness };

/// Of the finish in this clamping, over the z of its stock. No curve where it is not known.
report::Plot coursePlot(const TurningOutcome& outcome, std::size_t setup, Course course);

/// "Why this speed": the lobes of the work at the moment when the section is cut. No curve without dynamics.
report::Plot whyPlot(const TurningOutcome& outcome, std::size_t section, const Language& language);

/// An operation of the list: planned, or left out.
struct ListedOperation {
    cam::SkippedOperation which;
    std::optional<std::size_t> planned;  ///< index; none: left out
};
std::vector<ListedOperation> listedOperations(const TurningOutcome& outcome, std::size_t setup);
/// The same as steps of the order, each once.
std::vector<cam::OperationStep> stepsOf(const TurningOutcome& outcome, std::size_t setup);
/// The step that an operation belongs to: passes of the finishing tool over what is too deep for one are its finish.
cam::OperationStep stepOf(cam::OperationStep operation, const cam::Job& job);
report::Table operationTable(const TurningOutcome& outcome, std::size_t setup);  ///< a row for each of them

/// Set-up sheet of one clamping: control, bar, zero, chuck, time, what stays.
report::QuantityTable sheetOf(const TurningOutcome& outcome, std::size_t setup);

report::Document reportOf(const TurningOutcome& outcome, const Language& language);

}  // namespace lathelier::cam
