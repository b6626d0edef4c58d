// The shape of a section that is not round, the same along a stretch: a circle beside the axis, a regular polygon whose
// corners a circle may cut, teeth; or teeth that wind along it: a deep thread, a worm.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/shaft/shaft.h"

namespace lathelier::features {

/// Points of a stretch about the axis.
struct StretchPoints {
    std::vector<double> z_mm, r_mm, turn;  ///< turn: direction about the axis as a share of a turn, 0…1
    double sigma_mm = 0;                   ///< noise of single points
    double axis_sigma_mm = 0;              ///< standard uncertainty of the axis there, across

    std::size_t size() const { return r_mm.size(); }
    Eigen::Vector2d across_mm(std::size_t i) const;
    double onShape_mm() const;     ///< points nearer to a shape lie on it
    double largestRms_mm() const;  ///< of the points on a shape
};

struct SectionShape {
    MarkKind kind = MarkKind::Eccentric;
    /// Radius of the round that stands for it in the table: own radius of an eccentric, circle through the corners of a
    /// prism or that cuts them, crests of teeth.
    double level_mm = 0;
    Eigen::Vector2d centre_mm{0, 0};  ///< eccentric
    std::size_t count = 0;            ///< faces, teeth
    double phase_turn = 0;            ///< direction of a face's normal, of the middle of a tooth
    double waves_per_mm = 0;          ///< helix: pitches along the axis; > 0 a right-hand one
    double face_mm = 0;               ///< prism: of a face from the axis
    std::vector<double> pitch_mm;     ///< teeth: radius over a pitch from the middle of a tooth on; NaN on flanks

    double radiusAt_mm(double turn, double z_mm) const;  ///< NaN: on a flank, or not within the shape
    double pitchPhase(double turn, double z_mm) const;   ///< place within a pitch from the phase on, 0…1
    double faceAngle(double turn) const;                 ///< rad, from the normal of the nearest face
};

/// A shape that the points of a stretch prove, and its mark without z.
struct FoundShape {
    SectionShape shape;
    ShaftMark mark;
};

/// Angle as marks state it: 0…360.
double markAngle_deg(double turn);

}  // namespace lathelier::features
