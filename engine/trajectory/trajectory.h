// From the signals of probes around a spindle to the image of the machined surface, section by section.
// Source: Yurkevich & Orlova, "The System of Accuracy Control on Lathes" ("Lagrang"), equation (1) with the corrected
// polar angle; ISO 230-7 (axes of rotation, fixed sensitive direction).
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/profile.h"
#include "engine/core/progress.h"
#include "engine/core/units.h"
#include "engine/core/used_value.h"
#include "engine/form/roundness/roundness.h"
#include "engine/io/probe/probe_reader.h"

namespace lathelier::trajectory {

enum class Rotation { Same, Opposite };  ///< sense of the body angle relative to the recorded one
enum class Drift { None, Section };  ///< Section: removes the slope within and between revolutions; the mean is kept

enum class Probe { X3, Y3, Xp, Yp };

/// Calibration of a displacement probe.
struct ProbeCalibration {
    Probe probe = Probe::X3;           ///< calibrated probe
    double sensitivity_um_per_V = 50;  ///< used when its channel is recorded in volts
    std::string calibrated;            ///< date or number of the certificate; may be empty
};

const std::vector<Field<ProbeCalibration>>& fieldsOf(const ProbeCalibration*);

struct TrajectoryParameters {
    std::optional<double> workpiece_diameter_mm;            ///< default: the record's own ("D_mm"); else Error
    int points = 200;                                       ///< number of angles per revolution
    int revolutions = 40;                                   ///< number of revolutions per section
    std::optional<double> channel_skew_s;                   ///< default: the record's own, else 0
    std::string channels = "marker=0,X3=1,Y3=2,Xp=3,Yp=4";  ///< places among the record's channels; "angle=0" too;
                                                            ///< "-X3=1" inverts a sign
    std::optional<double> sensitivity_um_per_V;  ///< of displacement channels in volts; none: assumed, with a note
    std::vector<ProbeCalibration> probes;        ///< overrides for single probes; each probe at most once
    std::optional<double> marker_threshold_V;    ///< default: half way between its levels
    Rotation rotation = Rotation::Same;          ///< sense of the body angle against the recorded one
    std::string z_mm;                            ///< "5,10,15": one value per record
    std::optional<double> feed_mm_rev;  ///< with `sections`: segments one record along the workpiece. Default: as the
                                        ///< record itself says when it states both feed_mm_rev and sections
    int sections = 20;
    Drift drift = Drift::None;                             ///< whether probe drift is removed first
    form::OutlierRule outliers = form::OutlierRule::None;  ///< outlier rule for samples and revolutions
    double outlier_sigmas = 4;                             ///< limit of the outlier rule, in robust standard deviations
    form::RoundnessParameters form;                        ///< filter, circle and tolerance of every section
};

const std::vector<Field<TrajectoryParameters>>& fieldsOf(const TrajectoryParameters*);

/// One probe over the revolutions of a section.
struct ProbeStatistics {
    std::vector<double> mean_um, std_um, min_um, max_um, confidence_um;  ///< for each angle; 95 % of the mean
};

inline constexpr double mandrelForm_um = 0.2;  ///< two probes cannot separate it from the motion of the axis

/// ISO 230-7 error motion of one probe, fixed sensitive direction, k = 0 and 1 removed from the mean.
struct ErrorMotion {
    double synchronous_um = 0;   ///< synchronous error motion: range of the mean curve
    double asynchronous_um = 0;  ///< NaN when only averages are known
    double total_um = 0;         ///< NaN when only averages are known
    /// k = 2, by the spread of the revolutions and the mandrel's form; NaN for fewer than three revolutions.
    double synchronous_expanded_uncertainty_um = notANumber;
    double total_expanded_uncertainty_um = notANumber;
    std::vector<double> synchronous_curve_um;  ///< mean curve by angle, k = 0 and 1 removed
};

struct TrajectorySection {
    int section = 0;                                         ///< number from 1, or that of an averaged file
    std::string record;                                      ///< name of the record
    double z_mm = std::numeric_limits<double>::quiet_NaN();  ///< from the free end; NaN: not known
    int revolutions_found = 0;                               ///< regular ones; averages: as stated in the file, else 0
    int revolutions_used = 0;                  ///< number after outlier rejection; averages: revolutions_found
    std::int64_t samples_rejected = 0;         ///< single samples rejected as outliers, all probes together
    std::array<double, 4> drift_um_per_rev{};  ///< slope of each probe, removed only with Drift::Section
    double speed_rpm = std::numeric_limits<double>::quiet_NaN();    ///< over the chosen revolutions; NaN without times
    std::vector<double> angle_deg;                                  ///< recorded angle, uniform
    std::array<ProbeStatistics, 4> probes;                          ///< in the order of Probe
    std::array<std::vector<std::vector<float>>, 4> revolutions_um;  ///< [probe][revolution][angle]; empty for averages
    std::vector<double> radius_mm;                                  ///< |AP| of the mean trajectories
    std::vector<double> body_angle_deg;                             ///< its corrected polar angle on the part
    std::vector<double> envelope_min_mm, envelope_max_mm;           ///< of the images of single revolutions
    std::vector<double> revolution_RONt_um;                         ///< RONt(LSCI) of each single revolution's image
    Profile image;                                                  ///< the geometric image, size nominal
    double run_out_um = 0;            ///< max R_i - min R_i about the spindle axis: the paper's
    form::RoundnessResult roundness;  ///< its verdict is Undecided unless form_measured
    bool form_measured = true;        ///< false: RONt is not significant against noise, drift and asynchronous motion
    ErrorMotion spindle;              ///< of the sensitive direction (X3)
    std::array<ErrorMotion, 4> error_motion;  ///< error motion by Probe
    std::optional<ErrorMotion> rotating;      ///< X cosθ + Y sinθ of the workpiece axis

    /// Mean of one probe over the revolutions, for each angle.
    const std::vector<double>& mean_um(Probe probe) const { return probes[static_cast<std::size_t>(probe)].mean_um; }
};

/// The sections along the workpiece, z from the free end. Profile R(u) = c0 + c1 u + c2 u² over u in [-1, 1].
struct LongitudinalSection {
    std::vector<double> z_mm;                ///< of each section, in their order
    std::vector<double> radius_mm;           ///< LSC radius of each section
    std::vector<Eigen::Vector2d> centre_um;  ///< LSC centre of each section
    double taper_diameter_um = 0;            ///< + when the diameter grows with z: 4 c1
    double barrel_um = 0;                    ///< + barrel, - saddle, on radius: -c2
    double diameter_range_um = 0;            ///< largest - smallest LSC diameter; half of it: GOST 24642-81
    double half_diameter_range_um = 0;
    double axis_straightness_um = 0;     ///< of the LSC centres
    double profile_straightness_um = 0;  ///< residual of R(z) about its line
    double CYLt_LSCY_um = 0;         ///< NaN, as the next one, when the stack is too short for an axis (noCylindricity)
    double CYLt_MZCY_um = 0;         ///< NaN like CYLt_LSCY_um
    std::array<double, 3> fit_mm{};  ///< coefficients c0, c1, c2 of R(u)
};

struct TrajectoryResult {
    TrajectoryParameters parameters;
    double workpiece_diameter_mm = 0;         ///< diameter used
    UsedValues used;                          ///< values of optional parameters with their origin
    Values cutting;                           ///< cutting data stated in the records: speed, feed, workpiece, tool…
    std::vector<TrajectorySection> sections;  ///< in the order of the records
    std::optional<LongitudinalSection> longitudinal;  ///< with at least 3 sections of known z
    double mandrel_form_um = mandrelForm_um;          ///< lower limit of the uncertainty
    std::optional<Verdict> verdict;                   ///< of the worst section, with form.tolerance_um
    Notes notes;                                      ///< codes: see trajectory()

    /// Index of the section with the largest deviation by form.circle; none without sections.
    std::optional<std::size_t> worstSection() const;
};

/// Evaluates one or several records, in order. An averaged record contains its sections. One record with `feed_mm_rev`
/// is divided into `sections` segments of equal length from its first mark on, z = 0 at that mark; the first
/// `revolutions` of each segment make the section, whose z_mm is the middle of them. The same bits for any number of
/// threads. Errors (with `path`): diameterMissing, channelsUnknown (the map does not fit the record), markerNotFound,
/// markerElsewhere, angleNotTurning, timeNotIncreasing, tooFewRevolutions (`section`), recordTooShort, recordsDiffer;
/// valueNotUnderstood (channels, probes, z_mm, feed_mm_rev); those of roundness(). Notes: skewUnknown,
/// revolutionsRejected, fewerRevolutions, revolutionsIncomplete, revolutionsUnused, noCylindricity, speedDiffers,
/// Channel…, displacementsLarge, motionOutliers, averagesOnly, formNotMeasured, zUnknown or tooFewSections (no
/// longitudinal section), valueAssumed, sizeReferenced, mandrelFloor; those of roundness() once each. Throws Cancelled.
TrajectoryResult trajectory(const std::vector<const io::ProbeFile*>& records,
                            const TrajectoryParameters& parameters = {}, const Progress& progress = {});
TrajectoryResult trajectory(const std::vector<io::ProbeFile>& records, const TrajectoryParameters& parameters = {},
                            const Progress& progress = {});

/// One signal with its revolutions, for the time plot: decimated to at most `limit` points, extremes preserved.
struct TimeSignal {
    std::string channel;                      ///< its name in the record
    std::string signal;                       ///< "X3"…, "marker", "angle"; empty when the map does not name it
    std::vector<double> time_s, value;        ///< µm for displacements, as recorded for others
    std::vector<double> revolution_starts_s;  ///< of all found in the record; empty when there are none
};

/// Every channel of a record. An inconsistent map or marker is not an error here, since the plot serves to find the
/// reason.
std::vector<TimeSignal> timeSignals(const io::ProbeRecord& record, const TrajectoryParameters& parameters,
                                    int limit = 4000, const Progress& progress = {});

}  // namespace lathelier::trajectory
