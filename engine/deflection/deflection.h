// The diameter error of a slender shaft: what a program leaves when the work gives way to the cutting forces.
// Source: G. Grossi et al., "A digital solution for slender workpiece turning: the DRITTO project". Forces:
// engine/cutting; beam: engine/beam (Timoshenko); the cut at one place: turning_work.h; the O(1) step:
// condensed_beam.h.
//
// Two equal planes of bending suffice: axial and torsional motion never couple to the diameter. What a run leaves is
// the stock of the next, so errors carry over.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/core/shaft.h"
#include "engine/core/units.h"
#include "engine/deflection/turning_work.h"

namespace lathelier::deflection {

/// From millimetres of a radius to micrometres of its diameter.
inline constexpr double um_per_mm_of_diameter = 2 * um_per_mm;

/// One run toward the chuck that met stock. All lists are of one length, z ascending; twice the same z is a shoulder.
struct PassResult {
    std::int64_t line = 0;                     ///< of its first block that cuts
    std::vector<double> z_mm;                  ///< places where the tool cuts
    std::vector<double> x_mm;                  ///< programmed radius
    std::vector<double> radius_mm;             ///< radius left
    std::vector<double> diameter_error_um;     ///< of the diameter left against the programmed one
    std::vector<double> F_t_N, F_f_N, F_ap_N;  ///< forces
    std::vector<double> depth_mm;              ///< taken, radial
    std::vector<double> dx_um, dy_um;          ///< deflection toward the tool, and along the cutting speed
    std::vector<double> stiffness_N_mm;        ///< radial, at the tool
};

/// What is left where anything was cut, but for places that a run toward the free end cut last: that is not predicted.
struct FinalContour {
    std::vector<double> z_mm;               ///< ascending; twice the same z is a shoulder
    std::vector<double> target_radius_mm;   ///< X of the last pass that cut there
    std::vector<double> radius_mm;          ///< left
    std::vector<double> diameter_error_um;  ///< 2 (radius - target)
    std::vector<std::size_t> gaps;          ///< places before which there is a stretch without an answer
};

/// One number each for a curve of errors.
struct ErrorSummary {
    double max_um = 0;          ///< largest |e|
    double mean_abs_um = 0;     ///< mean of |e| over z
    double range_um = 0;        ///< largest less least e
    double wear_offset_um = 0;  ///< change of the X offset, on diameter, that leaves the least max |e|: -(max + min)/2
};

struct DeflectionResult {
    TurningSetup setup;              ///< as used
    double length_mm = 0;            ///< of the stock, chuck face
    std::vector<PassResult> passes;  ///< in order
    FinalContour final;              ///< after all
    ErrorSummary summary;            ///< of `final`
    Notes notes;
};

/// Errors: those of workPlan() and TurningWork; noCut. About 1 µs a node and run. Throws Cancelled.
DeflectionResult predictDeflection(const Shaft& stock, std::span<const ToolRun> runs, const TurningSetup& setup,
                                   const Progress& progress = {});

/// The same where the plan is there already. `setup` may differ from that of the plan in all but rests' places and
/// step.
DeflectionResult predictDeflection(const WorkPlan& plan, const TurningSetup& setup, const Progress& progress = {});

/// The final contour alone, against the contours of `targets` (null: of the plan itself): what maps and samples repeat.
FinalContour finalContour(const WorkPlan& plan, const TurningSetup& setup,
                          const std::vector<CutPlan>* targets = nullptr);

/// The mean is that of the straight lines between the places; across gaps nothing counts.
ErrorSummary summaryOf(const FinalContour& contour);

/// One station as lists have it, and the reverse of none: what a run did, as a result.
PassResult passResultOf(const CutPlan& cut, std::span<const Station> stations);

/// What was asked of a run that has to be said: rubbing, steep slopes.
void noteStations(const CutPlan& cut, std::span<const Station> stations, const TurningSetup& setup, Notes& notes);

/// Keeps the contours that were asked for, at the ends of the pieces; NaN where nothing was cut.
class TargetContour {
public:
    explicit TargetContour(const WorkPlan& plan);
    void take(const CutPlan& contour, std::span<const Station> stations);
    FinalContour against(const WorkPlan& plan, const TurningWork& work) const;

private:
    std::vector<double> start_mm_, end_mm_;
};

}  // namespace lathelier::deflection
