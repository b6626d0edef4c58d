// Comparison of a copy with its original: registration, then signed surface deviation with its uncertainty.
// Source: Miądlicki et al., "Remanufacturing System with Chatter Suppression for CNC Turning", section 3 (ICP
// comparison of the copy), with a point-to-surface deviation in place of the paper's nearest-point RMSE.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "engine/core/conformity.h"
#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/core/scan.h"
#include "engine/registration/alignment.h"
#include "engine/registration/verdict/surface_windows.h"
#include "engine/registration/verdict/verdict_values.h"

namespace lathelier::registration {

enum class CompareMethod { Auto, Revolution, Plane, Point };  ///< Auto: Revolution for a body of revolution, else Plane
enum class Symmetry { Auto, Revolution, None };
enum class InitialPose { Auto, Identity };

struct CompareParameters {
    CompareMethod method = CompareMethod::Auto;       ///< alignment method
    Symmetry symmetry = Symmetry::Auto;               ///< whether the parts may be taken as bodies of revolution
    InitialPose initial = InitialPose::Auto;          ///< Identity: the search stays near the poses as scanned
    std::optional<double> tolerance_mm;               ///< band ±T; without it and without zones there is no verdict
    VerdictRule verdict_rule = VerdictRule::Surface;  ///< compare local means or single points with the limits
    DecisionRule decision = DecisionRule::GuardedRejection;  ///< core/conformity.h; rule surface only
    double pass_percent = 95;                   ///< rule points: pass when at least this share is within the limits
    std::vector<ZoneLimits> zones;              ///< limits of their own along the axis
    std::optional<double> scanner_accuracy_mm;  ///< one standard deviation of the scanner
    std::optional<double> max_distance_mm;      ///< points further away are left out; default: default_reach.h
    std::vector<Interval> exclude_z_mm;         ///< clamping areas, along the reference's axis from its first data
};

const std::vector<Field<CompareParameters>>& fieldsOf(const CompareParameters*);

/// Signed surface deviation of every point of the copy; + = material in excess. NaN where not used.
struct DeviationStatistics {
    std::int64_t points_used = 0;      ///< that have a deviation and lie in no excluded zone
    std::int64_t points_excluded = 0;  ///< all others of the copy
    double overlap_percent = 0;        ///< points_used as a share of all points of the copy
    double rmse_mm = 0;                ///< root mean square
    double mean_mm = 0;
    double std_mm = 0;        ///< standard deviation about the mean, over n
    double min_mm = 0;        ///< smallest signed deviation
    double max_mm = 0;        ///< largest signed deviation
    double p95_abs_mm = 0;    ///< 95 % quantile of the absolute deviation
    double median_mm = 0;     ///< 50 % quantile
    double mad_sigma_mm = 0;  ///< 1.4826 × median absolute deviation
    double p2_5_mm = 0;       ///< 2.5 % quantile
    double p97_5_mm = 0;      ///< 97.5 % quantile
};

struct Histogram {
    std::vector<double> edges_mm;      ///< one more than counts
    std::vector<std::int64_t> counts;  ///< number of points in each bin
};

/// The reference's meridian and the copy's mean deviation along it, for the plot with magnified error.
/// z runs along the reference axis from its first data.
struct Meridian {
    std::vector<double> z_mm;                 ///< middle of each bin
    std::vector<double> reference_radius_mm;  ///< NaN where there is no single radius
    std::vector<double> deviation_mm;         ///< NaN where the copy has no points
    std::vector<double> std_mm;               ///< standard deviation in the bin, over n - 1; NaN for fewer than 2
};

/// Mean deviation on a z × θ grid: the unrolled map. Row-major, z slow. NaN where there are no points.
struct UnrolledMap {
    double z_start_mm = 0;  ///< lower edge of the first row
    double z_step_mm = 1;   ///< height of a row
    int z_count = 0;
    int angle_count = 0;         ///< over 360°, cell centres at (j + ½)·360/angle_count
    std::vector<float> mean_mm;  ///< of the deviations in each cell
};

struct CompareResult {
    CompareParameters parameters;
    CompareMethod method_used = CompareMethod::Plane;  ///< the method that was used; never Auto
    Alignment alignment;                               ///< pose of the copy, its free motions and its uncertainty
    bool has_sign = true;             ///< false: the deviation is unsigned and min/mean/… are null in JSON
    std::vector<float> deviation_mm;  ///< one per point (vertex) of the copy, in input order; NaN where none
    std::vector<std::uint8_t> used;   ///< 1 where the point counts
    DeviationStatistics statistics;   ///< of the points that count
    Histogram histogram;              ///< of their deviations; empty with CompareDetail::Summary
    /// The frame in which zones, meridian and map are given: its z is their z (0 at the first data), its x axis lies at
    /// angle 0. Body of revolution only.
    std::optional<Eigen::Isometry3d> axis_T_reference;
    std::vector<Zone> zones;              ///< those given, else automatic ones; body of revolution only
    std::optional<Meridian> meridian;     ///< body of revolution only
    std::optional<UnrolledMap> unrolled;  ///< body of revolution only
    double cloud_to_cloud_rmse_mm = std::numeric_limits<double>::quiet_NaN();  ///< the paper's figure
    double cloud_to_cloud_rmse_error_mm =
        std::numeric_limits<double>::quiet_NaN();  ///< its standard error: a large cloud is sampled; 0: all points
    double sampling_floor_mm =
        std::numeric_limits<double>::quiet_NaN();   ///< value of cloud_to_cloud_rmse_mm for identical parts
    std::shared_ptr<const SurfaceWindows> windows;  ///< local means, the input of judge()
    double scatter_mm = std::numeric_limits<double>::quiet_NaN();  ///< noise of the points about the local means
    std::optional<double> within_tolerance_percent;                ///< of the points that count; with a tolerance
    std::optional<Verdict> verdict;                                ///< with a tolerance, or zones that have limits
    std::optional<WorstPlace> worst;                               ///< none where nothing is judged
    std::vector<Finding> findings;                                 ///< the largest relative to its limit first
    std::optional<bool> distinguishable_from_scanner;              ///< rmse_mm > 1.1 × scanner_accuracy_mm, when given
    Notes notes;                                                   ///< those of the alignment included
};

/// Summary: verdict only; histogram, automatic zones, meridian, map and the cloud-to-cloud figures keep their defaults.
/// All other members are the same as with Full.
enum class CompareDetail { Full, Summary };

/// Compares `copy` with `reference`; either may be a cloud or a mesh. The same bits for any number of threads.
/// Errors: tooFewPoints, pointsDegenerate, partsDoNotMatch (with overlap_percent), notConverged,
/// notABodyOfRevolution with `reason` and coverageTooSmall (with method revolution), valueNotUnderstood for
/// zones that overlap or have no axis. Throws Cancelled.
/// An error about one of the two scans names its `role`.
CompareResult compare(const Scan& reference, const Scan& copy, const CompareParameters& parameters = {},
                      const Progress& progress = {}, CompareDetail detail = CompareDetail::Full);

}  // namespace lathelier::registration
