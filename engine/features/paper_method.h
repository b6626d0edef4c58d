// The published method, for comparison: sections across a coordinate axis, a circle in each, sections of like radius.
//
// Source: Miądlicki et al., "Remanufacturing System with Chatter Suppression for CNC Turning", section 2.3, equations
// (1), (2), (13)-(16), with the signs corrected: x_c = +A/2, y_c = +B/2, C = R² - x_c² - y_c², so that
// R = √((A² + B² + 4C)/4). Sections of width s lie s·100/p apart for a coverage of p percent. A section belongs to a
// step when its radius lies within the radial tolerance of the one before, or of the step's first (the text allows
// both). Steps of fewer than 3 sections are dropped; their sections beside a step form its chamfer where they lie more
// than 0.15 mm below the step's radius. It finds no cones, arcs or undercuts, and locates shoulders to a section only.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "engine/features/recognition.h"

namespace lathelier::features {

struct PaperResult {
    std::vector<ShaftStep> steps;                     ///< z from the first section
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< through the centres of all sections, least squares
};

/// `direction`: about the axis of the part; sections lie across the coordinate that it is nearest to. No error: a cloud
/// without sections gives no steps.
PaperResult paperSteps(const std::vector<Eigen::Vector3d>& points_mm, const Eigen::Vector3d& direction,
                       const RecognitionParameters& parameters, const Progress& progress = {});

/// Cylinders with their chamfers, as the steps have them; gaps between steps are closed by the later one.
Shaft shaftOf(const std::vector<ShaftStep>& steps);

}  // namespace lathelier::features
