// What all operations of one clamping share: the contour that is turned, how far, and where rapid moves are safe.
#pragma once

#include "engine/cam/contour.h"
#include "engine/cam/envelope.h"
#include "engine/cam/job.h"
#include "engine/cam/reach.h"

namespace lathelier::cam {

inline constexpr double faceLeft_mm = 0.15;    ///< on the face after roughing, for the finish
inline constexpr double clearance_mm = 2;      ///< of rapid moves from the bar, radially
inline constexpr double approach_mm = 1;       ///< of rapid moves from the face that is left, along z
inline constexpr double retract_mm = 0.5;      ///< of a pass from what it has cut
inline constexpr double rapidAbove_mm = 1;     ///< of rapid moves over what is approached, where rest is cut
inline constexpr double restOverlap_mm = 0.5;  ///< onto what is finished, on both sides of a rest
inline constexpr double slowShare = 0.6;       ///< of the feed, where a tool feeds into the stock
inline constexpr double largestFacing_mm = 1;  ///< depth of a facing pass

struct WorkFrame {
    const Job* job = nullptr;    ///< of this clamping
    HeightContour contour;       ///< with what is turned beyond the part for parting off
    double end_mm = 0;           ///< last place of the nose's centre
    double stock_radius_mm = 0;  ///< of the bar
    double safe_x_mm = 0;        ///< radius at which a tip may travel along z
    double face_mm = 0;          ///< raw face before the finished one
    double face_left_mm = 0;     ///< of it, when the contour is turned
    bool has_tailstock = false;  ///< stands while the contour is turned; curves keep clear of it
    bool faces_end = true;       ///< the finish comes up the face
    /// For each piece of the contour what the drawing allows; 0: nothing is stated.
    std::vector<double> Rz_um;

    double frontZ_mm() const { return -face_left_mm - approach_mm; }  ///< before the roughed face
};

/// Errors noSetupPossible where a tool would have to work within the chuck, or the bar is held too short.
WorkFrame frameOf(const Job& job, const Shaft& part);

inline constexpr double leastFeed_mm_rev = 0.02;  ///< of a finish, whatever roughness the drawing allows

/// The feed of a finishing tool as stated; and where the drawing allows an Rz: a smaller one if the ideal Rz would be
/// more, on whole 0.001 mm and no less than leastFeed_mm_rev.
double finishFeed(const Job& job, const JobTool& tool);
double finishFeed(const Job& job, const JobTool& tool, double Rz_um);
/// On each piece of the contour.
std::vector<double> finishFeeds(const WorkFrame& frame, const JobTool& tool);

/// Of an insert of the job, as planned (the margin is off its back angle).
ToolWedge wedgeOf(const JobTool& tool);

/// The curve of a tool's nose for the drawing, in the z of the part, up to the end of the frame; with an allowance the
/// curve of an offset. Of a blade that of its corner toward the chuck.
Curve toolCurve(const WorkFrame& frame, const JobTool& tool, double allowance_mm = 0);

/// The same as a reach. A radius of 1e-6 stands for sharp corners of a blade.
ToolReach reachOf(const WorkFrame& frame, const JobTool& tool, double allowance_mm = 0);

}  // namespace lathelier::cam
