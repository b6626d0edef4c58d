// From the scan of a turned part to its table of rows: axis, meridian, cylinders, cones, arcs, shoulders, ends.
//
// The cloud collapses onto one curve, the meridian (z, r). Bins of it carry all the information; an exact segmentation
// finds its pieces, model selection (Schwarz's criterion) decides the kind of each small piece, and one damped least
// squares over all parameters, with exact junctions, gives every size with its covariance. Shoulders, which a radial
// ray does not hit, are located by maximum likelihood from hits and misses of single rays.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/core/scan.h"
#include "engine/features/scene/scene.h"
#include "engine/shaft/shaft.h"
#include "engine/shaft/shaft_step.h"

namespace lathelier::features {

struct RecognitionBasis;

enum class RecognitionMethod { Robust, Paper };
enum class Snap { Suggest, None, Apply };
enum class FreeEnd { First, Last };          ///< which end of the data z = 0 is: along the axis' positive sense
enum class CompareWith { Previous, First };  ///< the paper's section that the next one is compared with
enum class Unexplained { Refuse, Damage };   ///< what is made of structure that no row and no mark explains

struct RecognitionParameters {
    RecognitionMethod method = RecognitionMethod::Robust;  ///< robust or published
    SceneUse scene = SceneUse::Auto;                       ///< removal of objects other than the part
    Snap snap = Snap::Suggest;                      ///< nominal sizes: none, suggested, or put in place of the measured
    double form_tolerance_mm = 0.02;                ///< on radius: rows that one element describes within it are one
    std::optional<double> scanner_accuracy_mm;      ///< systematic, added to every uncertainty
    Unexplained unexplained = Unexplained::Refuse;  ///< Damage: a person says that it is damage of the part
    FreeEnd free_end = FreeEnd::First;              ///< origin of z
    std::optional<double> length_mm;                ///< confirms the length where an end is not seen
    std::vector<Interval> exclude_z_mm;             ///< left out, along the axis from the first data at the free end
    std::optional<double> length_of_chucked_mm;     ///< the last part, in the chuck: not in the stock file
    double band_width_mm = 0.2;                     ///< paper: width of a section
    double coverage_percent = 100;                  ///< paper: sections cover this share of the length
    double radial_tolerance_mm = 0.1;               ///< paper: sections whose radius is this near form a step
    CompareWith compare_with = CompareWith::Previous;  ///< of the published method
};

const std::vector<Field<RecognitionParameters>>& fieldsOf(const RecognitionParameters*);

enum class RowKind { Cylinder, Cone, Arc };

/// A candidate nominal size of a measured one, with its false-match probability.
struct Suggestion {
    std::string quantity;  ///< "diameter_mm", "length_mm", "z_mm", "leg_mm", "radius_mm", "taper", "undercut"
    double measured_mm = 0;
    double nominal_mm = 0;                 ///< multiple of the grid
    double difference_um = 0;              ///< measured - nominal
    double grid_mm = 0;                    ///< multiples of this are candidates
    std::optional<double> chance_percent;  ///< false-match probability: an arbitrary size lies as near to a multiple;
                                           ///< none: not known, or every size does
    std::vector<std::string> fits;  ///< ISO 286 classes whose zone contains the measured value ± U, tightest first
    std::string designation;        ///< "1×45°", "DIN 509 - E 0.6×0.2"; empty: only the number
    std::string tolerance;          ///< class of ISO 286 that goes with the nominal size: "k5"; empty: none
    bool agrees = false;  ///< the measured value lies within its U of the nominal size, or of the tolerance of its
                          ///< class or standard; else only a person puts the nominal size in place
};

/// Departure of a row from a circle about the common axis; nothing where it is not sure.
struct RowLobes {
    std::optional<double> offset_mm;    ///< of its centre
    std::optional<double> offset_deg;   ///< direction of the offset about the axis
    std::optional<std::int64_t> lobes;  ///< undulations per revolution of the largest harmonic; 2: oval
    std::optional<double> height_um;    ///< of these, peak to valley of the radius
};

/// One row of the table as it was measured. z counts from the free end.
struct RecognizedRow {
    RowKind kind = RowKind::Cylinder;
    std::string role;                     ///< as ShaftSegment::role
    double z_start_mm = 0, z_end_mm = 0;  ///< the start of the next row before a face undercut lies before the end
    double start_diameter_mm = 0, end_diameter_mm = 0;
    std::optional<double> arc_radius_mm;  ///< signed as ShaftSegment::arc_radius_mm
    double half_angle_deg = 0;            ///< of a cone, + when the diameter grows with z
    std::string ties;                     ///< of an arc: "free", "tangent", "plane" for start and end, "tangent-plane"
    std::int64_t points = 0;              ///< number of points
    double coverage_deg = 360;            ///< of the circle
    double residual_um = 0;               ///< rms of the bins about the row
    double form_pv_um = 0;                ///< peak to valley of means over five bins about the row
    double taper_um = 0;                  ///< of a worn cylinder: change of the radius along it
    RowLobes lobes;                       ///< of the circle
    bool fully_visible = true;            ///< false: an undercut's arc that is partly hidden
    SizeUncertainty uncertainty;          ///< k = 2
    std::vector<Suggestion> suggestions;
};

/// A feature formed by several rows, or a shoulder between two.
struct RecognizedFeature {
    std::string kind;                     ///< shoulder | chamfer | fillet | edge_break | groove | undercut | taper
    double z_start_mm = 0, z_end_mm = 0;  ///< from the free end
    std::vector<std::int64_t> rows;       ///< numbers from 1
    std::string designation;              ///< "1×45°", "1:10"; empty: none
};

/// An end of the part or of the data.
struct RecognizedEnd {
    double z_mm = 0;            ///< from the free end
    double uncertainty_mm = 0;  ///< k = 2
    std::string closed_by;      ///< face | chamfer | round | edge | data | undecided
    /// Where the end lies; undecided: if the part ends there. None: the part goes on beyond the data.
    std::optional<Interval> span_mm = {};
};

/// Is it an end of the part?
bool isClosed(const RecognizedEnd& end);

/// A stretch without data.
struct Gap {
    double z_start_mm = 0, z_end_mm = 0;  ///< from the free end
};

/// A junction removed within the form tolerance.
struct MergedJunction {
    double z_mm = 0;       ///< from the free end
    double step_um = 0;    ///< of the radius
    double angle_deg = 0;  ///< bend between the two
};

enum class StructureKind {
    Raised,     ///< above the model
    Sunken,     ///< below it
    NoPoints,   ///< a round place of a wall or a face that is seen has no points: a hole
    Rough,      ///< too rough for a row, and neither a thread nor a knurl
    Eccentric,  ///< a row off the common axis
};

/// Structure that neither a row nor a mark explains.
struct UnexplainedStructure {
    StructureKind kind = StructureKind::Raised;
    double z_start_mm = 0, z_end_mm = 0;                  ///< from the free end
    std::optional<double> angle_deg = {}, span_deg = {};  ///< its middle and width about the axis; none: several places
    double area_mm2 = 0;                                  ///< of all places
    std::optional<double> height_mm = {};  ///< largest mean deviation of a place; Eccentric: offset; none: no points
    std::int64_t places = 1;               ///< number of places around the axis
};

/// One wall of one bin of the meridian, for plots.
struct MeridianPoint {
    double z_mm = 0, radius_mm = 0;  ///< z from the free end
    double sigma_mm = 0;             ///< standard uncertainty of the radius
    double residual_mm = 0;          ///< measured - model, along the radius; NaN where no row is
    std::int32_t row = -1;           ///< index into `segments`, or of `bores` when `bore`; -1: none
    bool bore = false;               ///< a point of a bore, else of the outside
};

struct Recognition {
    RecognitionParameters parameters;
    std::string method_used;                                        ///< "robust" | "paper"
    Eigen::Isometry3d part_T_scan = Eigen::Isometry3d::Identity();  ///< into z along the axis from the free end
    Eigen::Vector3d axis_point_mm = Eigen::Vector3d::Zero();        ///< free end on the axis, in the scan's frame
    Eigen::Vector3d axis_direction = Eigen::Vector3d::UnitZ();      ///< toward the chuck
    std::optional<double> length_mm;                                ///< none: an end is not seen
    double length_uncertainty_mm = 0;                               ///< k = 2
    std::vector<RecognizedEnd> ends;                                ///< free end, chuck end
    std::vector<RecognizedRow> segments;                            ///< of the outside, from the free end
    std::vector<std::vector<RecognizedRow>> bores;                  ///< each from its mouth inward, as Shaft::bores
    std::vector<RecognizedFeature> features;                        ///< in order of z
    std::vector<ShaftMark> marks;                                   ///< in order of z
    std::vector<UnexplainedStructure> unexplained;                  ///< in order of z; not CAD, not a program
    std::vector<Gap> gaps;                                          ///< stretches without data
    std::vector<SceneGroup> scene;                                  ///< empty: nothing was cut off
    std::vector<MergedJunction> merged;                             ///< within the form tolerance
    double coverage_percent = 0;                                    ///< of the length that rows cover
    double residual_rmse_mm = 0;                                    ///< of the bins about the rows
    double chi2_per_bin = 0;
    double spot_mm = 0;                ///< width that an edge is blurred by
    double noise_mm = 0;               ///< of single points along the normal
    double variance_ratio = 1;         ///< of a row's mean over that of independent points: correlation of the noise
    double passes_differ_um = 0;       ///< standard deviation of neighbouring bins beyond the noise, on the radius
    std::optional<double> volume_mm3;  ///< of the table, exact; none: the shaft is not complete
    std::int64_t points_used = 0;
    bool complete = true;  ///< no gap, both ends seen or confirmed: CAD may be made
    Shaft shaft;           ///< measured; with Snap::Apply nominal beside `measured`
    /// By RecognitionMethod::Paper: centres in the scan's coordinates, z along the scan's axis from its first section;
    /// the rows above stay those of the robust one.
    std::vector<ShaftStep> paper_steps;
    double paper_axis_off_deg = 0;                       ///< its axis against the robust one
    std::vector<MeridianPoint> meridian;                 ///< in order of z
    Notes notes;                                         ///< remarks, see recognize()
    std::shared_ptr<const RecognitionBasis> basis = {};  ///< for refit.h
};

/// Errors: tooFewPoints, pointsDegenerate, notABodyOfRevolution, coverageTooSmall (registration); those of its
/// parameters; lengthAgainstData. Notes: sceneCut, endOnSupport, partIsBent, coverageBelowHalf, coveragePartial,
/// gapInData, endNotSeen, endUndecided, endConfirmed,
/// segmentNotCoaxial, freeFormLeftOut… (features_codes.h). Throws Cancelled.
Recognition recognize(const Scan& scan, const RecognitionParameters& parameters, const Progress& progress = {});

}  // namespace lathelier::features
