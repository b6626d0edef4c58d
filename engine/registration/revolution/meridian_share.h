// Share of a sample that lies on one surface of revolution.
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

/// Side bins of rough zones: their scatter is too large for the axis fit, but their mean radius is the same in every
/// sector. A prism has the same scatter, but a mean radius that varies with the sector.
std::vector<bool> roughBins(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan,
                            const MeridianBins& bins);

/// The same of points on bins alone, without shoulders and rough zones: with a wrong axis much of the surface appears
/// as shoulders.
double shareOnBins(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan,
                   const MeridianBins& bins, double noise_mm);

}  // namespace lathelier::registration
