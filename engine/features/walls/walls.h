// The meridian of a scan in bins: in each bin along the axis the walls found in the points, and chains of walls.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/features/walls/meridian_cloud.h"

namespace lathelier::features {

/// One wall in one bin.
struct Wall {
    double z_mm = 0;       ///< mean of its points
    double r_mm = 0;       ///< mean of its points within 4 robust standard deviations
    double sigma_mm = 0;   ///< robust scatter of its points along r
    double width_mm = 0;   ///< of an even spread of z with the same variance as its points have
    double points = 0;     ///< number of points
    double coverage = 0;   ///< share of the circle covered by its points, 0…1
    double spread_mm = 0;  ///< of the radii of its points, from their 8 % to their 92 % quantile
    double slope = 0;      ///< dr/dz of a steep flank (findSteepWalls()); 0: of none
    bool compact = true;   ///< its points lie as close together as noise and a slope of 45° explain
    double form_mm = 0;    ///< of a worn seat: wear that was subtracted from r_mm because its row does not describe it
    double shared_mm = 0;  ///< standard uncertainty of r_mm beside that of independent points (withSharedErrors())
};

/// Walls that follow each other along z.
struct Chain {
    std::vector<Wall> walls;  ///< in order of z
    bool bore = false;        ///< walls of a bore, else of the outside

    double zFirst_mm() const { return walls.front().z_mm; }
    double zLast_mm() const { return walls.back().z_mm; }
};

struct Walls {
    double bin_mm = 0;
    double sigma_mm = 0;        ///< noise of single points, from the smooth bins
    std::vector<Chain> chains;  ///< by the z of their first wall, outside before bores
};

/// Radii of one bin that are further apart belong to different walls; `sigma_mm`: noise of single points.
double clusterGap_mm(double sigma_mm);

/// Bins of `bin_mm`. `sigma_mm`: noise of single points, from the axis fit.
Walls findWalls(const MeridianCloud& cloud, double bin_mm, double sigma_mm, const Progress& progress = {});

/// The walls with errors that the points of a wall share: noise whose variance of a mean is `variance_ratio` times that
/// of independent points, and passes of the scanner that differ by `passes_mm` (standard uncertainty).
Walls withSharedErrors(Walls walls, double variance_ratio, double passes_mm);

}  // namespace lathelier::features
