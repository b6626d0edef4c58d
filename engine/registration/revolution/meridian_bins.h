// The meridian of a body of revolution in bins: radius over z at its side, z over radius on its faces.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace lathelier::registration {

/// A piece of meridian: value + slope · (along - middle), where at the side `along` is z and the value a radius, and on
/// a face `along` is the radius and the value z.
struct MeridianBin {
    double middle = 0;    ///< of the bin in `along`, in mm
    double value = 0;     ///< radius or z at the middle, in mm: the median, then fitted
    double slope = 0;     ///< change of `value` with `along`; 0 where the slopes to both neighbours differ
    double cosine = 1;    ///< from the difference in value to the distance along the normal
    double sigma = 1;     ///< scatter along the normal
    double own_mm = 0;    ///< scatter of this bin alone
    double points = 0;    ///< number of points it was made from
    bool active = false;  ///< false: too few points or too much scatter to count
};

/// Side bins first; when the scan shows a bore too, as many bins for the bore; then `face_columns` bins for each face.
struct MeridianBins {
    double z_start_mm = 0;         ///< lower end of the first side bin
    double step_mm = 1;            ///< of side bins in z and of face bins in radius
    double size_mm = 1;            ///< lever for tilts: half the larger extent
    double sigma_mm = 0;           ///< scatter at the side
    double largest_mm = 0;         ///< radius that 99 % of the points stay within
    int side_count = 0;            ///< number of side bins
    int wall_count = 0;            ///< number of bins of side and bore together: those of the faces follow
    int face_columns = 0;          ///< bins of each face, from the axis outward
    std::vector<double> split_mm;  ///< for each side bin: points inside this radius lie on the bore; empty without bore
    std::vector<int> face_of;      ///< for each side bin: the face its points belong to when it is not active, or -1
    std::vector<MeridianBin> bins;  ///< in the order that the struct names

    /// Index of the bin for a point at (z, r), or -1.
    int find(double z, double r) const
    {
        const double place = (z - z_start_mm) / step_mm;
        if (!(place >= 0) || place >= side_count) return -1;
        const int side = static_cast<int>(place);
        if (!split_mm.empty() && r < split_mm[static_cast<std::size_t>(side)]) {
            const int bore = side_count + side;
            return bins[static_cast<std::size_t>(bore)].active ? bore : -1;
        }
        if (bins[static_cast<std::size_t>(side)].active) return side;
        const int face = face_of[static_cast<std::size_t>(side)];
        if (face < 0) return -1;
        const double column = r / step_mm;
        if (column >= face_columns) return -1;
        const int key = wall_count + face * face_columns + static_cast<int>(column);
        return bins[static_cast<std::size_t>(key)].active ? key : -1;
    }
};

/// Robust bins (median, scatter) of a sample. `count` is the wished number of bins along the part. Where the radii of a
/// bin fall into two walls with a gap between them, each wall has a bin. Rough zones (a thread, a knurl) do not
/// determine the scatter: when the 20 % quantile over the bins is a third below their median, it is used, and bins
/// above 1.7 times that stay inactive.
MeridianBins makeBins(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan, int count);

/// Recomputes the slopes from the values of neighbouring bins.
void refineSlopes(MeridianBins& bins);

}  // namespace lathelier::registration
