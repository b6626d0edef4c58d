// Corrected tool path: the radii to program so that the deflected workpiece gets the nominal diameters.
//
// After correction the depth of cut is that from the stock to the target, so forces, deflection and radius to program
// follow directly, without iteration: X = dx + √(R_t² - dy²) (turning_work.h). A program consists of straight blocks
// with end points on a grid: corners are chosen by written_contour.h, with one where the cut enters the material, as
// the approach in air is not corrected. Each run is simulated as written before the next is corrected, so that its
// stock is known. The written path is simulated again with finer steps.
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
    CorrectedRuns runs = CorrectedRuns::All;  ///< Finish: runs that generate part of the final contour
    double grid_um = 1;                       ///< of X, on diameter
    double tolerance_um = 0.6;                ///< of the written path, on diameter
    double largest_correction_um = 1000;      ///< on diameter; larger ones are refused
    std::vector<Interval> kept_lines;         ///< program lines that are not changed
    bool robustness = true;                   ///< evaluate the corrected path for other springs and forces
    bool is_inch = false;                     ///< the program counts inches; not a user parameter
    friend bool operator==(const CompensationParameters&, const CompensationParameters&) = default;
};

const std::vector<Field<CompensationParameters>>& fieldsOf(const CompensationParameters*);

/// Grid of X of the program, on diameter, and of a length in it.
double writtenGrid_um(const CompensationParameters& parameters);
double lengthGrid_mm(const CompensationParameters& parameters);

/// The residual that the written program holds, on diameter: of lines, and of arcs.
double residualOfLines_um(const CompensationParameters& parameters);
double residualOfArcs_um(const CompensationParameters& parameters);

/// Is this line of the program among those that stay?
bool isKept(const CompensationParameters& parameters, std::int64_t line);

/// One corrected run.
struct CorrectedRun {
    std::size_t run = 0;               ///< index in the input
    std::vector<CorrectedNode> nodes;  ///< from the run's start to its end
    bool changed = false;              ///< false: not corrected
};

/// The corrected path evaluated on a plant that differs from the model.
struct RobustnessRow {
    std::string key;  ///< "tailstock_plus_20"
    Text name;
    double mean_abs_before_um = 0;  ///< of the original program, on that plant
    double mean_abs_after_um = 0;   ///< of the corrected program
    double max_after_um = 0;        ///< largest |e| of the corrected program
    double reduction_percent() const { return 100 * (1 - mean_abs_after_um / mean_abs_before_um); }
};

struct CompensationResult {
    CompensationParameters parameters;
    DeflectionResult before;           ///< the original program
    std::vector<CorrectedRun> runs;    ///< runs toward the chuck that cut stock, in order
    std::vector<ToolRun> written;      ///< all runs after correction
    FinalContour after;                ///< of the written path, against the original targets
    ErrorSummary residual;             ///< of `after`; its max_um is that of all corrected runs
    std::int64_t blocks_changed = 0;   ///< blocks of the original whose end moves
    std::int64_t blocks_added = 0;     ///< additional corners
    double largest_correction_um = 0;  ///< on diameter, with its sign
    std::vector<RobustnessRow> robustness;
    Notes notes;
};

/// Errors: those of predictDeflection(); correctionTooLarge; cannotBeWritten (a tolerance below half the grid). Throws
/// Cancelled.
CompensationResult compensate(const Shaft& stock, std::span<const ToolRun> runs, const TurningSetup& setup,
                              const CompensationParameters& parameters = {}, const Progress& progress = {});

/// Programmed and corrected runs on common nodes with half the step of the set-up.
struct ComparedPlans {
    WorkPlan before;  ///< with the programmed runs
    WorkPlan after;   ///< with the corrected runs
};

/// Error writtenRunsDiffer if the numbers of runs that reach the stock differ.
ComparedPlans comparedPlans(const Shaft& stock, std::span<const ToolRun> programmed, std::span<const ToolRun> written,
                            TurningSetup setup);

/// Simulates the corrected runs and sets `after`, `residual`, `robustness` and the note on the residual. Errors of
/// comparedPlans().
void evaluateWritten(const Shaft& stock, std::span<const ToolRun> programmed, std::span<const ToolRun> written,
                     CompensationResult& result);

/// Mean |e| before and after correction on plants with other springs and forces: tailstock ±20 %, all springs ±20 %,
/// forces ±20 %, forces +20 % with springs -20 %. Both plans have the same nodes; errors are against the contours of
/// `before`.
std::vector<RobustnessRow> robustnessOf(const WorkPlan& before, const WorkPlan& after, const TurningSetup& setup);

}  // namespace lathelier::deflection
