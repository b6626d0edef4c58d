// Diameter error of a slender shaft caused by workpiece deflection under the cutting forces. Source: G. Grossi et al.,
// "A digital solution for slender workpiece turning: the DRITTO project". Forces: engine/cutting; beam: engine/beam
// (Timoshenko); the cut at one place: turning_work.h; the O(1) step: condensed_beam.h.
//
// Two equal planes of bending suffice: axial and torsional motion do not affect the diameter. The surface left by a run
// is the stock of the next, so errors propagate.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/core/units.h"
#include "engine/deflection/turning_work.h"
#include "engine/shaft/shaft.h"

namespace lathelier::deflection {

/// From millimetres of a radius to micrometres of its diameter.
inline constexpr double um_per_mm_of_diameter = 2 * um_per_mm;

/// One run toward the chuck that cut stock. All lists have the same length; z ascends, a repeated z is a shoulder.
struct PassResult {
    std::int64_t line = 0;                  ///< its first cutting block
    std::vector<double> z_mm;               ///< positions where the tool cuts
    std::vector<double> x_mm;               ///< programmed radius
    std::vector<double> radius_mm;          ///< radius left
    std::vector<double> diameter_error_um;  ///< of the diameter left against the programmed one
    std::vector<double> F_t_N, F_f_N, F_ap_N;
    std::vector<double> depth_mm;        ///< radial
    std::vector<double> dx_um, dy_um;    ///< deflection toward the tool, and along the cutting speed
    std::vector<double> stiffness_N_mm;  ///< radial, at the tool
};

/// Final contour where material was cut, except where a run toward the free end cut last, which is not predicted.
struct FinalContour {
    std::vector<double> z_mm;              ///< ascending; a repeated z is a shoulder
    std::vector<double> target_radius_mm;  ///< programmed radius of the last pass there
    std::vector<double> radius_mm;
    std::vector<double> diameter_error_um;  ///< 2 (radius - target)
    std::vector<std::size_t> gaps;          ///< indices preceded by a stretch without prediction
};

/// Summary of an error curve.
struct ErrorSummary {
    double max_um = 0;          ///< largest |e|
    double mean_abs_um = 0;     ///< mean of |e| over z
    double range_um = 0;        ///< max e - min e
    double wear_offset_um = 0;  ///< change of the X offset, on diameter, that minimises max |e|: -(max + min)/2
};

struct DeflectionResult {
    TurningSetup setup;    ///< input
    double length_mm = 0;  ///< length of the stock = z of the chuck face
    std::vector<PassResult> passes;
    FinalContour final;  ///< after all passes
    ErrorSummary summary;
    Notes notes;
};

/// Errors: those of workPlan() and TurningWork; noCut. About 1 µs a node and run. Throws Cancelled.
DeflectionResult predictDeflection(const Shaft& stock, std::span<const ToolRun> runs, const TurningSetup& setup,
                                   const Progress& progress = {});

/// The same with a prepared plan. `setup` may differ from that of the plan except in the positions of rests and the
/// step.
DeflectionResult predictDeflection(const WorkPlan& plan, const TurningSetup& setup, const Progress& progress = {});

/// The final contour alone, against the contours of `targets` (null: of the plan itself): used repeatedly by maps and
/// samples.
FinalContour finalContour(const WorkPlan& plan, const TurningSetup& setup,
                          const std::vector<CutPlan>* targets = nullptr);

/// The mean is integrated over the straight lines between points; gaps are excluded.
ErrorSummary summaryOf(const FinalContour& contour);

/// Result of a run from its stations.
PassResult passResultOf(const CutPlan& cut, std::span<const Station> stations);

/// Notes on a run: rubbing, steep slopes.
void noteStations(const CutPlan& cut, std::span<const Station> stations, const TurningSetup& setup, Notes& notes);

/// Radius that a station of a corrected cut is judged against. An arc is corrected beyond where its target leaves the
/// stock, and an edge that cuts takes off no less than its scallop: what lies between is no error there.
double judgedTarget_mm(const CutPiece& asked, const Station& station, const TurningSetup& setup);

/// Target contour at the ends of the pieces; NaN where nothing was cut.
class TargetContour {
public:
    explicit TargetContour(const WorkPlan& plan);
    /// `judged_by`: judgedTarget_mm() with this set-up.
    void take(const CutPlan& contour, std::span<const Station> stations, const TurningSetup* judged_by = nullptr);
    FinalContour against(const WorkPlan& plan, const TurningWork& work) const;

private:
    std::vector<double> start_mm_, end_mm_;
};

}  // namespace lathelier::deflection
