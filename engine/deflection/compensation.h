// A corrected tool path: what to program so that the work, once it has given way, has the programmed diameters.
//
// After correction the depth of cut is that from the stock to the target, so forces, deflection and radius to program
// follow directly, without iteration: X = dx + √(R_t² - dy²) (turning_work.h). A program holds straight blocks with
// ends on a grid: corners are chosen by written_contour.h, with one where the cut enters the material, since the
// approach through air knows nothing of the correction. Each run is cut as written before the next is corrected, so
// that a run knows the stock that it will find. The written path is simulated again, on finer steps.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/deflection/corrected_run.h"
#include "engine/deflection/deflection.h"

namespace lathelier::deflection {

/// Which runs are corrected.
enum class CorrectedRuns { All, Finish };

struct CompensationParameters {
    CorrectedRuns runs = CorrectedRuns::All;  ///< Finish: those that leave a part of the final contour
    double grid_um = 1;                       ///< of X, on diameter
    double tolerance_um = 0.6;                ///< of the written path, on diameter
    double largest_correction_um = 1000;      ///< on diameter: more is refused
    std::vector<Interval> kept_lines;         ///< blocks of the program that stay as they are
    bool robustness = true;                   ///< try the corrected path on other springs and forces
    friend bool operator==(const CompensationParameters&, const CompensationParameters&) = default;
};

const std::vector<Field<CompensationParameters>>& fieldsOf(const CompensationParameters*);

/// One run as it is to be written.
struct CorrectedRun {
    std::size_t run = 0;               ///< index among the runs that were given
    std::vector<CorrectedNode> nodes;  ///< from the run's start to its end
    bool changed = false;              ///< false: stays as it was
};

/// The corrected path on a plant that is not the model.
struct RobustnessRow {
    std::string key;                ///< "tailstock_plus_20"
    Text name;                      ///< for tables
    double mean_abs_before_um = 0;  ///< of the program as it was, on that plant
    double mean_abs_after_um = 0;   ///< of the corrected one
    double max_after_um = 0;        ///< its largest |e|
    double reduction_percent() const { return 100 * (1 - mean_abs_after_um / mean_abs_before_um); }
};

struct CompensationResult {
    CompensationParameters parameters;      ///< as asked
    DeflectionResult before;                ///< the program as it was
    std::vector<CorrectedRun> runs;         ///< those toward the chuck that meet stock, in order
    std::vector<ToolRun> written;           ///< all runs as they are to be written
    FinalContour after;                     ///< of the written path, against the original targets
    ErrorSummary residual;                  ///< of `after`
    std::int64_t blocks_changed = 0;        ///< blocks of the original whose end moves
    std::int64_t blocks_added = 0;          ///< corners that the original has not
    double largest_correction_um = 0;       ///< on diameter, with its sign
    std::vector<RobustnessRow> robustness;  ///< as asked
    Notes notes;
};

/// Errors: those of predictDeflection(); correctionTooLarge; cannotBeWritten (a tolerance below half the grid). An arc
/// that cuts becomes straight blocks. Throws Cancelled.
CompensationResult compensate(const Shaft& stock, std::span<const ToolRun> runs, const TurningSetup& setup,
                              const CompensationParameters& parameters = {}, const Progress& progress = {});

/// Programmed and written runs on one row of nodes, twice as fine as the set-up asks.
struct ComparedPlans {
    WorkPlan before;  ///< with the programmed runs
    WorkPlan after;   ///< with the written ones
};

/// Error writtenRunsDiffer where the two do not have the same number of runs that reach the stock.
ComparedPlans comparedPlans(const Shaft& stock, std::span<const ToolRun> programmed, std::span<const ToolRun> written,
                            TurningSetup setup);

/// Simulates what was written and fills in `after`, `residual`, `robustness` and the note on the residual. Errors of
/// comparedPlans().
void judgeWritten(const Shaft& stock, std::span<const ToolRun> programmed, std::span<const ToolRun> written,
                  CompensationResult& result);

/// Mean |e| before and after on plants with other springs and forces: tailstock ±20 %, all springs ±20 %, forces
/// ±20 %, forces +20 % with springs -20 %. Both plans have the same nodes; errors are against the contours of `before`.
std::vector<RobustnessRow> robustnessOf(const WorkPlan& before, const WorkPlan& after, const TurningSetup& setup);

}  // namespace lathelier::deflection
