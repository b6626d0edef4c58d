// Roundness of one profile: filter, four reference circles, deviations, harmonics, uncertainty, verdict.
// Source: ISO 12181-1/-2, ISO 16610-21, ISO 14253-1 (decision rule); Yurkevich & Orlova, "The System of Accuracy
// Control on Lathes", with its formulas corrected (their own values are kept as labelled extras).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/conformity.h"
#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/profile.h"
#include "engine/core/progress.h"
#include "engine/form/circle/circles.h"
#include "engine/signal/closed_profile.h"
#include "engine/signal/harmonics.h"

namespace lathelier::form {

enum class OutlierRule { None, Hampel };

struct RoundnessParameters {
    std::optional<double> cutoff_upr;          ///< Gaussian long-wave pass: 1…cutoff
    std::vector<Interval> band_upr;            ///< one interval low:high, or none; excludes cutoff_upr
    std::vector<Interval> exclude_deg;         ///< keyways, interruptions: angles as seen from the LSC centre, may wrap
    OutlierRule outliers = OutlierRule::None;  ///< outlier rejection
    ReferenceCircle circle = ReferenceCircle::MZCI;  ///< reference circle of the headline and the verdict
    std::optional<double> tolerance_um;              ///< largest RONt allowed; none: no verdict
    DecisionRule decision = DecisionRule::Simple;    ///< whether the uncertainty counts (ISO 14253-1)
    std::optional<double> probe_uncertainty_um;  ///< one standard deviation of a point, for the uncertainty; default
                                                 ///< is found from the profile's own point-to-point noise
};

const std::vector<Field<RoundnessParameters>>& fieldsOf(const RoundnessParameters*);

/// The band that the parameters ask for; a lower end of 1 UPR or less damps nothing. Error valueNotUnderstood when
/// both are given, or more than one band, or an empty one.
signal::TransmissionBand bandOf(const RoundnessParameters& parameters);

/// Sizes measured across the section.
struct TwoPointSize {
    double range_um = 0;       ///< range of d(θ) + d(θ + 180°): ISO 14405-1 two-point size, the paper's D_i
    double half_range_um = 0;  ///< ovality by GOST 24642-81
    double largest_mm = 0, smallest_mm = 0;  ///< of d(θ) + d(θ + 180°); NaN where no point has an opposite
    double caliper_largest_mm = 0, caliper_smallest_mm = 0;  ///< width between parallel jaws
    std::size_t without_opposite = 0;                        ///< points opposite a gap, without a two-point size
};

/// RONt by one circle, filter and outlier rule: sensitivity of the verdict to the method.
struct MethodRow {
    signal::TransmissionBand band;             ///< filter of this row
    OutlierRule outliers = OutlierRule::None;  ///< outlier rule of this row
    std::array<double, 4> RONt_um{};  ///< in the order of ReferenceCircle; NaN where the sampling is too coarse for the
                                      ///< filter
    bool undersampled = false;        ///< fewer than 7 points for each wave of the upper cut-off
};

/// Whether the table of methods is computed (about half of the total cost). LeftOut: the result's `methods` is empty.
enum class MethodTable { Made, LeftOut };

/// A usual cause of a strong harmonic on a lathe.
struct RoundnessHint {
    int upr = 0;               ///< 1: eccentricity from the origin of the coordinates (not a form deviation)
    double amplitude_um = 0;   ///< zero to peak; of 1 UPR the distance of the LSC centre from the origin
    double share_percent = 0;  ///< of the form's variance; NaN for 1 UPR
    Text meaning;              ///< "oval: clamping between two jaws, or an out-of-round bore", …
};

/// The paper's own formulas about the origin of the coordinates; not roundness. NaN when the origin is outside.
struct PaperValues {
    double run_out_um = 0;                                        ///< max R_i - min R_i about the origin
    Eigen::Vector2d limacon_centre_um = Eigen::Vector2d::Zero();  ///< 2ΣX/n, 2ΣY/n of the deviations from R0
};

struct RoundnessResult {
    RoundnessParameters parameters;
    std::string name;                           ///< name of the profile
    std::size_t points = 0;                     ///< number of input points
    std::vector<std::uint8_t> used;             ///< one for each given point: 0 excluded or outlier
    std::vector<double> angle_rad;              ///< of each given point about the LSC centre of the raw profile
    std::vector<Eigen::Vector2d> evaluated_mm;  ///< evaluated points: filtered, in order of angle
    std::vector<std::size_t> evaluated_index;   ///< index of the input point of each evaluated point
    signal::FilterMethod filter_method = signal::FilterMethod::Uniform;  ///< filter method applied to uneven angles and
                                                                         ///< gaps
    ReferenceCircles circles;                 ///< of the evaluated points; contacts are indices of input points
    TwoPointSize two_point;                   ///< of the evaluated points
    std::vector<signal::Harmonic> harmonics;  ///< amplitudes in µm, of the unfiltered profile about its LSC centre
    std::vector<MethodRow> methods;           ///< RONt by filter and outlier rule; empty with MethodTable::LeftOut
    std::vector<RoundnessHint> hints;  ///< at most four harmonics of 10 % of the variance or more, and eccentricity
    PaperValues paper;                 ///< of the used points, unfiltered
    /// 95 %, of RONt about `parameters.circle`: effect of the point noise, filtered like the profile (Monte Carlo), and
    /// of an error of the nominal radius. NaN when the noise is unknown.
    double RONt_expanded_uncertainty_um = 0;
    double point_noise_um = 0;              ///< standard deviation of a point: stated, or estimated from the profile
    double resolution_um = 0;               ///< step of the measured values; 0: none found
    double noise_correlation_points = 1;    ///< integral scale of the noise in points; 1: independent
    std::vector<double> harmonic_floor_um;  ///< by harmonic: amplitude exceeded by noise alone with probability 1/3000
    std::optional<Verdict> verdict;         ///< none without a tolerance
    Notes notes;                            ///< codes: see roundness()
};

/// Evaluates `profile` about its fitted centres, independent of the origin. Deterministic. Without a filter the circles
/// are fitted to the input points. Notes: undersampled, gapsInProfile, partialArc, anglesUneven, pointsNotFinite,
/// duplicatePoints, revolutionsOverlaid, outliersRemoved, sectorsExcluded, minimumZoneNotUnique, inscribedNotUnique,
/// certificateOpen, noiseNotKnown, sizeNominal, nominalRadiusMatters, harmonicsLimited, harmonicsEstimated,
/// resolutionCounted, noiseCorrelated, spikesCounted, twoPointIncomplete. Errors as fitCircles(); valueNotUnderstood.
/// Throws Cancelled.
RoundnessResult roundness(const Profile& profile, const RoundnessParameters& parameters = {},
                          const Progress& progress = {}, MethodTable table = MethodTable::Made);

/// RONt_um of the circle selected in the parameters.
double headlineDeviation_um(const RoundnessResult& result);

}  // namespace lathelier::form
