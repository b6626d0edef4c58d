// Points of stretches that are not round, moved onto the round that stands for them.
//
// A point is moved along the radius by the distance between its shape and the round, those of an axis that lies far off
// with that axis. What they leave of the shape stays: damage on a spline is still seen. Points on flanks of teeth are
// left out. Where gaps or faces go on in a chamfer, the round is the cone through crests or corners.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/features/outline/outline.h"
#include "engine/features/recognition.h"
#include "engine/features/stretches/not_round.h"

namespace lathelier::features {

/// The points in the frame of the scan, in their order. Throws Cancelled.
std::vector<Eigen::Vector3d> madeRound(const std::vector<Eigen::Vector3d>& points_mm,
                                       const registration::RevolutionFit& fit,
                                       const std::vector<NotRoundStretch>& stretches, double sigma_mm,
                                       const Progress& progress = {});

/// Walls within the stretches, of which `marks` are, with the form of the shapes as an error that their points share.
void shareForm(const std::vector<ShaftMark>& marks, Walls& walls);

/// The diameter of a row that a stretch makes is as uncertain as its shape.
void widenRows(const std::vector<ShaftMark>& stretches, std::vector<RecognizedRow>& rows);

/// An end of a stretch whose chamfer does not explain its points.
struct UnsureEnd {
    double z_mm = 0, sigma_mm = 0;
};

/// Such ends in the frame of another fit of the same part.
std::vector<UnsureEnd> unsureEndsIn(const registration::RevolutionFit& other, const registration::RevolutionFit& fit,
                                    const std::vector<NotRoundStretch>& stretches);

/// An end of the part there is as uncertain as its chamfer, unless the face at the end is seen.
void widenEnds(const std::vector<UnsureEnd>& unsure, Outline& outside);

/// Marks of the stretches in the frame of another fit of the same part.
std::vector<ShaftMark> marksIn(const registration::RevolutionFit& other, const registration::RevolutionFit& fit,
                               const std::vector<NotRoundStretch>& stretches);

/// The marks without those that lie within stretches, and with these, in order of z.
std::vector<ShaftMark> withStretches(std::vector<ShaftMark> marks, const std::vector<ShaftMark>& stretches);

}  // namespace lathelier::features
