// Rays at a wall about a mark: the points of the wall, and the rays of a rotary scanner that passed the wall there.
//
// A rotary scanner measures columns of points, one at each step of its table. About its axis the columns are equally
// spaced; along a column points follow each other at one pitch. A step or a pitch without a point of the wall is a ray
// that hit something else or nothing. Where no such columns are found, only the points are given.
#pragma once

#include <optional>

#include "engine/features/marks/rim_fit.h"
#include "engine/features/model/model.h"
#include "engine/features/walls/walls.h"
#include "engine/registration/revolution/scanner_axis.h"

namespace lathelier::features {

/// A window on the wall of a run, in the frame of the cloud.
struct WallWindow {
    double from_mm = 0, to_mm = 0;       ///< along z
    double angle_rad = 0, half_rad = 0;  ///< middle and half width about the axis
};

/// What all windows of one outline share.
struct WallScan {
    const MeridianCloud& cloud;
    const Model& model;                                     ///< of the outside
    std::optional<registration::ScannerAxis> scanner = {};  ///< in the frame of the cloud
    bool surface_scan = false;                              ///< seen from all sides: no columns
};

/// Distance from the model within which a point is on the wall.
double wallLimit_mm(const Model& model);

/// z where the wall of a run is judged: not beside its planes, where the spot blurs it.
WallWindow withinRun(const Run& run, WallWindow window);

/// Rays in the window; `radius_mm` of the view is that of the run at its middle. Throws Cancelled.
RimView raysAt(const WallScan& scan, const Run& run, const WallWindow& window, const Progress& progress = {});

/// Columns of rays in angles: the step and the first one. None where they are not equally spaced.
struct Columns {
    double first_rad = 0, step_rad = 0;
};
std::optional<Columns> columnsOf(std::vector<double> angles_rad);

}  // namespace lathelier::features
