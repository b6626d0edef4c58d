// Local means of the deviation over windows of many sizes, each with its uncertainty: the data of the verdict about the
// surface. The noise of a mean is estimated from the data: neighbouring points of a scan are correlated, and the
// variance of means over cells of increasing size shows by how much.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "engine/core/value.h"

namespace lathelier::registration {

/// A window of the surface and the mean deviation over it.
struct SurfaceWindow {
    Eigen::Vector3f place_mm = Eigen::Vector3f::Zero();  ///< mean of its points, in the reference's frame
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();    ///< mean of the unit normals: short where they differ
    float z_start_mm = 0;                                ///< extent along the axis, from the reference's first data
    float z_end_mm = 0;                                  ///< both 0 without an axis
    float size_mm = 0;                                   ///< side of a square of the same area
    float points = 0;                                    ///< number of points of the copy
    float mean_mm = 0;                                   ///< of their deviations
    float sigma_mm = 0;                                  ///< standard uncertainty of the mean
    std::uint32_t wider = noWiderWindow;                 ///< the next larger window about the same place
    std::int32_t stretch = -1;                           ///< of `stretches`; -1 without an axis
    bool smallest = false;  ///< one of the smallest windows, which together cover the surface once
    static constexpr std::uint32_t noWiderWindow = 0xffffffff;  ///< `wider` of the largest
};

/// A smooth piece of the reference's meridian between shoulders, kinks and gaps, or a face across the axis, without the
/// zones at its ends that the scanner's spot smears.
struct MeridianStretch {
    double start_mm = 0;            ///< along the axis, from the reference's first data
    double end_mm = 0;              ///< of a face: equal to start_mm
    bool is_bore = false;           ///< of the inside
    double radius_mm = 0;           ///< of the reference at the middle
    double slope = 0;               ///< dR/dz; of a face: 0
    double reference_sigma_mm = 0;  ///< standard uncertainty of the reference's radius in one of its bins
    double reference_step_mm = 1;   ///< width of such a bin along the axis
    int facing = 0;                 ///< of a face: direction of its outward normal along z; else 0
    double inner_mm = 0;            ///< of a face: radius where it begins
    double outer_mm = 0;            ///< of a face: radius where it ends

    bool isFace() const { return facing != 0; }
    /// Along the axis, of a face along its radius.
    double extent_mm() const { return isFace() ? outer_mm - inner_mm : end_mm - start_mm; }
};

/// Mean deviation of one ring of a stretch, or of a whole face.
struct SurfaceRow {
    double z_start_mm = 0;     ///< along the axis, from the reference's first data
    double z_end_mm = 0;       ///< of a face: equal to z_start_mm
    std::int32_t stretch = 0;  ///< of `stretches`
    double points = 0;         ///< number of points of the copy
    double mean_mm = 0;        ///< of their deviations; 0 without points
};

/// The data of a comparison that judge() needs, for any limits.
struct SurfaceWindows {
    std::vector<SurfaceWindow> windows;  ///< `about` of them about each place, from small to large; the smallest first
    std::uint32_t about = 2;             ///< number of windows about a place
    double scatter_mm = 0;               ///< standard deviation of the points about their local means
    /// Variance of a mean over cells of a size relative to that of as many independent points.
    std::vector<std::pair<double, double>>
        variance_inflation;  ///< pairs of size in mm and ratio (1: independent), by increasing size
    double factor = 2;       ///< coverage factor for the extreme of all windows (coverageFactorOfWorst())
    double facets_mm = 0;    ///< sagitta of the reference's facets
    bool has_sign = true;    ///< false: the sign of a mean is undefined
    std::vector<MeridianStretch> stretches;  ///< in order of z, the bore's behind, then faces; body of revolution only
    std::vector<SurfaceRow> rows;            ///< by stretch, in order of z, without faces; body of revolution only
    std::vector<SurfaceRow> faces;           ///< one for each face with points; body of revolution only
    std::vector<Interval> automatic_zones_mm;  ///< where no zones are given: along the axis from the first data
    std::vector<float> z_mm;                   ///< of each point of the copy; NaN where it is not used. Revolution only
    std::vector<std::uint8_t> counted;         ///< 1 for points that are part of a window, 2 for those on a face
    std::optional<Eigen::Isometry3d> axis_T_reference;  ///< z from the reference's first data. Revolution only
    double axial_sigma_mm = 0;                          ///< of the registration, along the axis (or in any direction)
    double radial_sigma_mm = 0;                         ///< across the axis; 0 without one
    double tilt_sigma = 0;                              ///< of the axis's direction (or of the rotation), in radians
    Eigen::Vector3d middle_mm =
        Eigen::Vector3d::Zero();  ///< centre of rotation of tilt errors, in the reference's frame
};

/// Calls `take` with each of the smallest windows, which cover the surface once.
template <class F>
void forEachSmallest(const SurfaceWindows& all, const F& take)
{
    for (std::size_t i = 0; i < all.windows.size() && all.windows[i].smallest; i += all.about) take(all.windows[i]);
}

}  // namespace lathelier::registration
