// Data shared by all operations of one clamping: turned contour, its end, and safe positions for rapid moves.
#pragma once

#include "engine/cam/contour.h"
#include "engine/cam/envelope.h"
#include "engine/cam/job.h"
#include "engine/cam/reach.h"

namespace lathelier::cam {

inline constexpr double faceLeft_mm = 0.15;    ///< finishing allowance on the face
inline constexpr double clearance_mm = 2;      ///< of rapid moves from the bar, radially
inline constexpr double approach_mm = 1;       ///< of rapid moves from the face that is left, along z
inline constexpr double retract_mm = 0.5;      ///< distance of a return move from the cut surface
inline constexpr double rapidAbove_mm = 1;     ///< height of rapid moves above the stock in rest operations
inline constexpr double restOverlap_mm = 0.5;  ///< overlap onto the finished surface at both ends of a rest
inline constexpr double slowShare = 0.6;       ///< feed reduction for plunging into the stock
inline constexpr double largestFacing_mm = 1;  ///< depth of a facing pass

struct WorkFrame {
    const Job* job = nullptr;
    HeightContour contour;  ///< including the stretch turned beyond the part for parting off
    double end_mm = 0;      ///< last u of the nose centre
    double stock_radius_mm = 0;
    double safe_x_mm = 0;        ///< radius for rapid moves along z
    double face_mm = 0;          ///< allowance of the raw face
    double face_left_mm = 0;     ///< remaining face allowance when the contour is turned
    bool has_tailstock = false;  ///< engaged while the contour is turned; curves avoid it
    bool faces_end = true;       ///< finishing includes the face
    /// Rz limit of the drawing for each contour piece; 0: not stated.
    std::vector<double> Rz_um;

    double frontZ_mm() const
    {
        return -face_left_mm - approach_mm;
    }  ///< approach position in front of the roughed face
};

/// Error noSetupPossible if a tool would enter the chuck or the clamped length is too short.
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

/// The same as a reach. Sharp corners of a blade get a radius of 1e-6 mm.
ToolReach reachOf(const WorkFrame& frame, const JobTool& tool, double allowance_mm = 0);

/// Of facing alone: the finished face, from the axis to the bar.
ToolReach faceReachOf(const WorkFrame& frame, const JobTool& tool);

}  // namespace lathelier::cam
