// The cut itself: tool and work at each node of a run, the work as it has been left by all before.
//
// At a node the work gives way by (dx, dy) to the forces of the chip that is taken there; it is left with
//   R_eff = √((X - dx)² + dy²)      (G. Grossi et al., "A digital solution for slender workpiece turning", eq. 3)
// where X is the programmed radius, x points toward the tool and y along the cutting speed. Loads on the work:
// -F_ap along x, +F_t along y, and if the moment of the feed force counts M = -F_f (R_stock - a/2). The depth
// a = R_stock - R_eff is settled with the forces to 1e-10 mm. Behind the tool the material has the machined radius.
// Correction: the depth is known, a = R_stock - R_target, so forces and (dx, dy) follow at once, and the radius to
// program is X = dx + √(R_target² - dy²).
//
// Cost: O(1) a node (condensed_beam.h), two sweeps over the nodes a run; a follower rest beside the tool costs the
// nodes between both.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/deflection/condensed_beam.h"
#include "engine/deflection/work_plan.h"

namespace lathelier::deflection {

inline constexpr double noDepth_mm = 1e-9;        ///< no more is rounding of contours that coincide
inline constexpr double steepestSlope_rad = 1.4;  ///< of a contour, as forces take it

/// Tool and work at one place.
struct Station {
    double z_mm = 0;            ///< of the tool
    double x_mm = 0;            ///< X, programmed; Correct: to be programmed
    double stock_mm = 0;        ///< radius before
    double radius_mm = 0;       ///< radius left
    double depth_mm = 0;        ///< taken, radial
    double dx_mm = 0;           ///< deflection toward the tool; with a tool post that of the tool is in it
    double dy_mm = 0;           ///< along the cutting speed, likewise
    double stiffness_N_mm = 0;  ///< radial, of work and tool post at the tool
    cutting::CuttingForces forces;
    std::size_t piece = 0;  ///< of the run: the block it belongs to
    bool at_start = true;   ///< it stands at the start of that piece, else at its end
    bool rubs = false;      ///< the depth is that of the scallop or less
};

/// What a run is for.
enum class CutTask {
    Predict,  ///< the contour is programmed
    Correct   ///< the contour is what is to be left: it is left, and the stations say what to program
};

/// The work while it is turned. Reads plan and set-up, which have to live as long.
class TurningWork {
public:
    /// Error notHeld.
    TurningWork(const WorkPlan& plan, const TurningSetup& setup);

    /// The stock again.
    void reset();

    /// Takes `cut` off. Stations where the tool cuts, z ascending; at a shoulder two at one z. None: it meets nothing.
    /// Runs toward the free end remove their contour, and give none. Errors nothingLeft, workGivesWay, those of
    /// cutting::CuttingEdge.
    void take(const CutPlan& cut, CutTask task, std::vector<Station>& stations);

    /// Whether a run toward the free end would take material off, the work as it is now.
    bool meets(const CutPlan& cut) const;

    /// Radii that are there now, at the ends of the pieces.
    const std::vector<double>& outerStart_mm() const { return start_mm_; }
    const std::vector<double>& outerEnd_mm() const { return end_mm_; }

    /// Whether a run that is not predicted, one toward the free end, left the radius at the start or end of a piece.
    bool isUnpredicted(std::size_t piece, bool at_start) const
    {
        return (at_start ? unpredicted_start_ : unpredicted_end_)[piece];
    }

    /// After take(): compliance of the work at a node of that run, as it was when the tool was there.
    Symmetric2 complianceAt(std::size_t node) const { return compliance_[node]; }

    /// Motions of all nodes in one plane under a load at `node`, the work as it is now; a follower rest stands beside
    /// that node, at the nearest one.
    std::vector<Motion2> shapeUnder(std::size_t node, const Motion2& load) const;

private:
    struct Pull {
        double dx_mm, dy_mm, radius_mm;
        cutting::CuttingForces forces;
    };
    Symmetric2 flexibilityOf(std::size_t piece) const;
    Symmetric2 flexibilityOf(std::size_t piece, double length_mm) const;
    Symmetric2 withRest(Symmetric2 s, std::size_t node) const;
    void sweepFromChuck(std::size_t node);
    void sweepFromFreeEnd(std::size_t node);
    Symmetric2 heldAt(std::size_t node) const;
    Symmetric2 followedAt(std::size_t node) const;
    void enter(const CutPiece& piece);
    cutting::CuttingForces forcesAt(double depth_mm) const;
    Pull pulled(const Symmetric2& c, double x_mm, double stock_mm, double depth_mm) const;
    double settledDepth(const Symmetric2& c, double x_mm, double stock_mm) const;
    double boundedDepth(const Symmetric2& c, double x_mm, double stock_mm) const;
    bool cutStation(const Symmetric2& c, double contour_mm, double bore_mm, CutTask task, Station& station);
    double stationAt(const CutPlan& cut, std::size_t piece, bool at_start, double stock_mm, CutTask task,
                     std::vector<Station>& stations);
    bool meetsBefore(const CutPlan& cut, std::size_t piece) const;
    void removeContour(const CutPlan& cut);

    const WorkPlan* plan_;
    const TurningSetup* setup_;
    Elasticity elasticity_;
    std::vector<double> start_mm_, end_mm_;                  ///< radii now
    std::vector<bool> unpredicted_start_, unpredicted_end_;  ///< left by a run toward the free end
    std::vector<double> rest_N_mm_;                          ///< of the nodes
    std::vector<Symmetric2> left_, right_;  ///< stiffness of what lies to both sides, without the node's own rest
    std::vector<Symmetric2> compliance_;    ///< of the nodes of the run
    double tool_mm_N_ = 0, tool_across_mm_N_ = 0;
    // Of the block in cut.
    cutting::CuttingEdge edge_;
    double feed_mm_rev_ = 0, slope_rad_ = 0, slope_sin_ = 0, slope_cos_ = 1;
    double pushed_mm_ = 0;         ///< R_eff - X at the station before: a good start
    double pushed_before_mm_ = 0;  ///< at the one before that
    bool was_cut_ = false;         ///< the station before was one
    std::size_t last_node_ = 0;    ///< of the last station of the last run; 0: it met nothing
};

}  // namespace lathelier::deflection
