// A turned shaft: its outer contour in segments from the free end toward the chuck, its bores, its material, and
// tolerances and measured values. The one definition that receptance, deflection, stock, recognition, drawing and CAD
// share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/material.h"
#include "engine/shaft/mark_kind.h"

namespace lathelier {

/// Limits of a row's diameter: a class of ISO 286-1 or the deviations themselves.
struct SizeTolerance {
    std::string iso_class;           ///< "h6"; empty: the deviations apply
    std::optional<double> lower_um;  ///< lower limit deviation of the diameter
    std::optional<double> upper_um;  ///< upper limit deviation of the diameter
    friend bool operator==(const SizeTolerance&, const SizeTolerance&) = default;
};

/// Expanded uncertainties (k = 2) of a measured row; missing ones were not measured.
struct SizeUncertainty {
    std::optional<double> z_start_um, z_end_um;  ///< of z at the row's ends
    std::optional<double> length_um;
    std::optional<double> start_diameter_um, end_diameter_um;
    std::optional<double> arc_radius_um;
    std::optional<double> angle_deg;  ///< half angle of a cone
    friend bool operator==(const SizeUncertainty&, const SizeUncertainty&) = default;
};

/// Measured values of a row, kept beside nominal values that were set later. A row with the same values is as measured.
struct MeasuredSize {
    std::optional<double> length_mm;  ///< along the axis
    std::optional<double> start_diameter_mm, end_diameter_mm;
    std::optional<double> arc_radius_mm;  ///< signed as ShaftSegment::arc_radius_mm
    SizeUncertainty uncertainty;          ///< k = 2
    friend bool operator==(const MeasuredSize&, const MeasuredSize&) = default;
};

/// One segment: a cylinder, a cone, or with `arc_radius_mm` an arc. Diameters that jump between segments are shoulders.
struct ShaftSegment {
    double length_mm = 0;                         ///< 0: a plane; < 0 only where a face is undercut (DIN 509 form F)
    double start_diameter_mm = 0;                 ///< outer, at the end toward the free end
    double end_diameter_mm = 0;                   ///< outer, at the end toward the chuck
    double bore_diameter_mm = 0;                  ///< 0: solid, or bored by Shaft::bores
    std::optional<double> arc_radius_mm;          ///< > 0 convex (material bulges beyond the chord), < 0 concave
    std::string role;                             ///< "chamfer", "fillet", "groove"…; geometry never depends on it
    std::optional<SizeTolerance> tolerance = {};  ///< of the diameter; none: the general tolerance
    std::optional<MeasuredSize> measured = {};    ///< none: the values themselves are measured, or nothing was measured
    std::string tie = {};  ///< cylinders with the same one share a diameter when it is edited; empty: none
    std::optional<double> tolerance_um = {};  ///< width T of the diameter's limits, where the limits are not stated
    std::optional<double> Rz_um = {};         ///< roughness that the drawing allows; none: not stated
    std::string thread = {};                  ///< cut on this row: "M16x1.5"; empty: none
    friend bool operator==(const ShaftSegment&, const ShaftSegment&) = default;
};

enum class ShaftEnd { Free, Chuck };

/// A row of a bore; diameters are those of the hole, an arc that is > 0 bulges into the hole.
struct BoreSegment {
    double length_mm = 0;  ///< along the axis
    double start_diameter_mm = 0;
    double end_diameter_mm = 0;
    std::optional<double> arc_radius_mm;          ///< none: straight
    std::string role;                             ///< as ShaftSegment::role
    std::optional<SizeTolerance> tolerance = {};  ///< as ShaftSegment::tolerance
    std::optional<MeasuredSize> measured = {};    ///< as ShaftSegment::measured
    friend bool operator==(const BoreSegment&, const BoreSegment&) = default;
};

/// A bore from one end; as long as the part: a through bore.
struct ShaftBore {
    ShaftEnd from = ShaftEnd::Free;     ///< the end that its mouth is at
    std::vector<BoreSegment> segments;  ///< from the mouth inward
    friend bool operator==(const ShaftBore&, const ShaftBore&) = default;
};

/// A feature that is not a body of revolution. `kind` determines which members are set.
struct ShaftMark {
    MarkKind kind = MarkKind::Other;
    std::optional<double> z_start_mm = {}, z_end_mm = {};  ///< from the free end
    std::optional<double> angle_deg = {};        ///< of its middle about the axis; bolt circle, spline: of one of them
    std::optional<double> width_mm = {};         ///< keyway: width of the slot; spline: of a tooth
    std::optional<double> across_flats_mm = {};  ///< hexagon, square: between opposite faces
    std::optional<double> floor_mm = {};         ///< keyway: floor from the axis
    std::optional<double> distance_mm = {};      ///< flat: from the axis
    std::optional<double> pitch_mm = {};         ///< thread: pitch; knurl: pitch around the circle
    std::optional<double> major_mm = {};         ///< thread, spline: crest diameter
    std::optional<double> minor_mm = {};         ///< thread, spline: root diameter
    std::optional<double> starts = {};           ///< thread: number of starts
    std::optional<double> hand = {};             ///< thread: 1 right, -1 left
    std::optional<double> teeth = {};            ///< knurl, spline: number of teeth around the circle
    std::optional<double> helix_deg = {};        ///< knurl: angle of its ridges to the axis
    std::optional<double> diameter_mm = {};      ///< of a hole, eccentric, sphere; over crests or corners
    std::optional<double> depth_mm = {};         ///< knurl: from crest to root; keyway, blind hole: from the surface
    std::optional<double> through = {};          ///< hole, bolt circle: 1 through, 0 blind
    std::optional<double> count = {};            ///< bolt circle: number of holes
    std::optional<double> pitch_circle_mm = {};  ///< bolt circle: diameter of the circle of their centres
    std::optional<double> offset_mm = {};        ///< eccentric: of its axis from that of the part
    std::optional<double> deviation_mm = {};     ///< free form: the largest from the plain body
    // Expanded uncertainties, k = 2; missing ones are not known.
    std::optional<double> uncertainty_mm = {};  ///< of the size that its kind is named by
    std::optional<double> place_uncertainty_mm =
        {};  ///< of each end along z, of a hole's middle; bolt circle: of its ⌀
    std::optional<double> depth_uncertainty_mm = {};  ///< of floor_mm or depth_mm; spline: of minor_mm
    std::optional<double> angle_uncertainty_deg = {};
    std::string designation = {};  ///< "M16×2", "DIN 82 RGE 1.25"
    std::string other_kind = {};   ///< of MarkKind::Other: its key, as read; else empty
    friend bool operator==(const ShaftMark&, const ShaftMark&) = default;
};

/// Key of its kind, as files have it.
std::string key(const ShaftMark& mark);

/// Name of its kind for people: a Text, of MarkKind::Other the key.
Value nameOf(const ShaftMark& mark);

/// What a shaft was recovered from, for title blocks.
struct RecoveredFrom {
    std::string scan;                             ///< name of the file; empty: the shaft was not recovered from a scan
    std::string scan_sha256;                      ///< of its content, lower-case hexadecimal
    std::string method;                           ///< of the recognition: "robust"
    std::optional<double> stated_length_mm = {};  ///< by a person, where the scan does not show an end
    friend bool operator==(const RecoveredFrom&, const RecoveredFrom&) = default;
};

struct Shaft {
    std::string name;                    ///< display name of the part; may be empty
    std::vector<ShaftSegment> segments;  ///< from the free end toward the chuck
    std::optional<Material> material;    ///< none: not stated
    std::vector<ShaftBore> bores = {};   ///< at most one from each end; not beside ShaftSegment::bore_diameter_mm
    std::vector<ShaftMark> marks = {};   ///< in the order of z
    std::string general_tolerance = {};  ///< "ISO 2768-m"; empty: none
    RecoveredFrom recovered = {};        ///< rows without MeasuredSize were stated by a person
    friend bool operator==(const Shaft&, const Shaft&) = default;

    double length_mm() const;
};

const std::vector<Field<SizeTolerance>>& fieldsOf(const SizeTolerance*);
const std::vector<Field<SizeUncertainty>>& fieldsOf(const SizeUncertainty*);
const std::vector<Field<MeasuredSize>>& fieldsOf(const MeasuredSize*);
const std::vector<Field<ShaftSegment>>& fieldsOf(const ShaftSegment*);
const std::vector<Field<BoreSegment>>& fieldsOf(const BoreSegment*);
const std::vector<Field<ShaftBore>>& fieldsOf(const ShaftBore*);
const std::vector<Field<ShaftMark>>& fieldsOf(const ShaftMark*);
const std::vector<Field<RecoveredFrom>>& fieldsOf(const RecoveredFrom*);
const std::vector<Field<Shaft>>& fieldsOf(const Shaft*);

}  // namespace lathelier
