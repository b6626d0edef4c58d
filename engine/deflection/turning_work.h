// Equilibrium of tool and workpiece at each node of a run, on the workpiece left by all previous runs.
//
// At a node the cutting forces deflect the workpiece by (dx, dy); the radius left is
//   R_eff = √((X - dx)² + dy²)      (G. Grossi et al., "A digital solution for slender workpiece turning", eq. 3)
// where X is the programmed radius, x points toward the tool and y along the cutting speed. Loads on the work: -F_ap
// along x, +F_t along y, and if the moment of the feed force counts M = -F_f (R_stock - a/2). The depth a = R_stock -
// R_eff is iterated with the forces to 1e-10 mm. Behind the tool the material has the machined radius. Correction: the
// depth is known, a = R_stock - R_target, so forces and (dx, dy) follow at once, and the radius to program is X = dx +
// √(R_target² - dy²).
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

inline constexpr double noDepth_mm = 1e-9;        ///< smaller depths are rounding errors of coincident contours
inline constexpr double steepestSlope_rad = 1.4;  ///< limit of the contour slope used for the forces

/// State of tool and workpiece at one position.
struct Station {
    double z_mm = 0;            ///< of the tool
    double x_mm = 0;            ///< X: programmed radius; with CutTask::Correct the radius to program
    double stock_mm = 0;        ///< radius before the cut
    double radius_mm = 0;       ///< radius after the cut
    double depth_mm = 0;        ///< radial depth of cut
    double dx_mm = 0;           ///< relative deflection of workpiece and tool toward the tool
    double dy_mm = 0;           ///< relative deflection along the cutting speed
    double stiffness_N_mm = 0;  ///< radial, of work and tool post at the tool
    cutting::CuttingForces forces;
    std::size_t piece = 0;  ///< piece of the run it belongs to
    bool at_start = true;   ///< at the start of that piece; false: at its end
    bool rubs = false;      ///< the depth is that of the scallop or less
};

/// Unknown of a run.
enum class CutTask {
    Predict,  ///< the programmed contour is given, the radius left is computed
    Correct   ///< the radius to be left is given, the radius to program is computed
};

/// Workpiece during turning. Keeps references to plan and set-up.
class TurningWork {
public:
    /// Error notHeld.
    TurningWork(const WorkPlan& plan, const TurningSetup& setup);

    /// Restores the stock.
    void reset();

    /// Simulates and removes `cut`. Stations where the tool cuts, z ascending; two at the z of a shoulder; empty if
    /// nothing is cut. Runs toward the free end remove their contour without stations. Errors nothingLeft,
    /// workGivesWay, those of cutting::CuttingEdge.
    void take(const CutPlan& cut, CutTask task, std::vector<Station>& stations);

    /// True if a run toward the free end would remove material from the current workpiece.
    bool meets(const CutPlan& cut) const;

    /// Current radii at the ends of the pieces.
    const std::vector<double>& outerStart_mm() const { return start_mm_; }
    const std::vector<double>& outerEnd_mm() const { return end_mm_; }

    /// True if the radius at the start or end of a piece was left by a run toward the free end, which is not predicted.
    bool isUnpredicted(std::size_t piece, bool at_start) const
    {
        return (at_start ? unpredictedStart_ : unpredictedEnd_)[piece];
    }

    /// After take(): compliance of the workpiece at a node of that run, with the tool there.
    Symmetric2 complianceAt(std::size_t node) const { return compliance_[node]; }

    /// Motions of all nodes in one plane under a load at `node`, for the current workpiece; a follower rest acts at the
    /// node nearest to its position.
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
    double convergedDepth(const Symmetric2& c, double x_mm, double stock_mm) const;
    double boundedDepth(const Symmetric2& c, double x_mm, double stock_mm) const;
    bool cutStation(const Symmetric2& c, double contour_mm, double bore_mm, CutTask task, Station& station);
    double stationAt(const CutPlan& cut, std::size_t piece, bool at_start, double stock_mm, CutTask task,
                     std::vector<Station>& stations);
    bool meetsBefore(const CutPlan& cut, std::size_t piece) const;
    void removeContour(const CutPlan& cut);

    const WorkPlan* plan_;
    const TurningSetup* setup_;
    Elasticity elasticity_;
    std::vector<double> start_mm_, end_mm_;                ///< current radii
    std::vector<bool> unpredictedStart_, unpredictedEnd_;  ///< left by a run toward the free end
    std::vector<double> rest_N_mm_;
    std::vector<Symmetric2> left_, right_;  ///< condensed stiffness of both sides, without a rest at the node itself
    std::vector<Symmetric2> compliance_;    ///< of the nodes of the run
    double tool_mm_N_ = 0, toolAcross_mm_N_ = 0;
    // State of the current block.
    cutting::CuttingEdge edge_;
    double feed_mm_rev_ = 0, slope_rad_ = 0, slope_sin_ = 0, slope_cos_ = 1;
    double pushed_mm_ = 0;        ///< R_eff - X at the previous station: start value
    double pushedBefore_mm_ = 0;  ///< at the station before that
    bool wasCut_ = false;         ///< the previous station cut
    std::size_t lastNode_ = 0;    ///< of the last station of the last run; 0: nothing was cut
};

}  // namespace lathelier::deflection
