// An operation of a plan: moves of the imaginary tip, exact, before rounding by a post. Places are (z, x): z from the
// free end toward the chuck, x the radius, both in mm.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/cam/curve.h"
#include "engine/cam/job.h"
#include "engine/gcode/move.h"

namespace lathelier::cam {

enum class OperationKind : std::uint8_t {
    Face,
    CentreDrill,
    Rough,
    SemiFinish,
    Finish,
    FinishBack,
    Groove,
    PartOff,
    Thread
};

/// "face", "centre_drill", "rough", "semi_finish", "finish", "finish_back", "groove", "part_off", "thread".
const char* key(OperationKind kind);
Text nameOf(OperationKind kind);

enum class CutKind : std::uint8_t { Rapid, Line, Arc, Thread };

/// One move to a place.
struct CutMove {
    CutKind kind = CutKind::Rapid;
    Eigen::Vector2d to = Eigen::Vector2d::Zero();      ///< of the tip
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< of an arc of the tip
    bool clockwise = false;                            ///< of an arc: G2, seen with Z to the right and X upward
    double feed_mm_rev = 0;                            ///< of feed moves; the lead of a thread
    std::optional<double> speed_rpm{};                 ///< from this move on, where it changes
    /// From this move on constant; controls without it use `speed_rpm`.
    std::optional<double> cutting_speed_m_min{};
};

struct Operation {
    OperationKind kind = OperationKind::Rough;
    int tool = 0;
    double cutting_speed_m_min = 0;   ///< v_c that is selected
    std::optional<double> speed_rpm;  ///< fixed speed at its start; none: constant cutting speed
    std::string reason;               ///< of a fixed speed, for the program's comment
    std::vector<CutMove> moves;       ///< the first is a rapid move from the tool change point
    bool stops_before = false;        ///< program stop before it, to engage the tailstock
    /// Of a rest operation: begin of the interval that it is for (Unreached::z_start_mm).
    std::optional<double> rest_z_start_mm{};
};

/// Largest radius that feed moves of an operation work at, at least 0.5 mm.
double largestRadius_mm(const Operation& operation);

/// From the centre of the nose (of a blade: of its corner toward the chuck) to the imaginary tip.
Eigen::Vector2d tipOffset(const JobTool& tool);

/// Builds the moves of an operation. Places are those of the tip; moves of zero length are omitted.
class MoveList {
public:
    explicit MoveList(const Eigen::Vector2d& tip_offset) : offset_(tip_offset) {}

    void rapid(const Eigen::Vector2d& tip);
    void rapidX(double x_mm) { rapid({at_.x(), x_mm}); }
    void rapidZ(double z_mm) { rapid({z_mm, at_.y()}); }
    void line(const Eigen::Vector2d& tip, double feed_mm_rev);
    void thread(const Eigen::Vector2d& tip, double lead_mm);
    /// Along a curve of the centre, from its start or, `backwards`, from its end; first in a line to that place.
    void follow(const Curve& curve, double feed_mm_rev, bool backwards = false);
    /// The same with a feed for each piece of the contour, by CurvePiece::source.
    void follow(const Curve& curve, const std::vector<double>& feeds_mm_rev, double other_mm_rev,
                bool backwards = false);

    const Eigen::Vector2d& at() const { return at_; }
    const Eigen::Vector2d& offset() const { return offset_; }
    bool isEmpty() const { return moves_.empty(); }
    std::vector<CutMove> taken() { return std::move(moves_); }
    std::vector<CutMove>& moves() { return moves_; }

private:
    void follow(const CurvePiece& piece, double feed_mm_rev, bool backwards);

    std::vector<CutMove> moves_;
    Eigen::Vector2d offset_;
    Eigen::Vector2d at_ = Eigen::Vector2d::Zero();
};

/// Chords of an arc move without its start point.
std::vector<Eigen::Vector2d> chordsOf(const Eigen::Vector2d& from, const CutMove& move, double chord_mm);

}  // namespace lathelier::cam
