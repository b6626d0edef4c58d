// How much of a sample lies on one surface of revolution.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "engine/registration/revolution/meridian_bins.h"

namespace lathelier::registration {

/// Share of the sample that lies on one surface of revolution: within 6 standard deviations of the bins, and these no
/// wider than 3 times the noise seen between neighbours or 2 % of the radius. Points at shoulders count, and those of
/// rough zones (a thread, a knurl) that are round on the whole.
double consistentShare(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan,
                       const MeridianBins& bins, double noise_mm);

/// Side bins of rough zones: they scatter too much to vote, but are round on the whole, their mean radius the same in
/// every direction. A prism scatters as much, but its corners lie in some directions.
std::vector<bool> roughBins(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan,
                            const MeridianBins& bins);

/// The same of points on bins alone, without shoulders and rough zones: a wrong axis makes much of the surface look
/// like shoulders.
double shareOnBins(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan,
                   const MeridianBins& bins, double noise_mm);

}  // namespace lathelier::registration
