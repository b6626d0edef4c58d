// Cutting forces in longitudinal turning with a corner radius: mechanistic coefficients (Y. Altintas, Manufacturing
// Automation, ch. 2) over the contact length, direction of the chip by L. V. Colwell (Predicting the angle of chip flow
// for single-point cutting tools, Trans. ASME 76 (1954) 199): perpendicular to the chord that joins the ends of the
// edge in cut.
//
// Plane of the edge: u along the feed, h outward from the deepest point of the corner, whose centre is at (0, r). The
// edge leaves the corner at the entering angle κ from the feed, at the height lim = r (1 - cos κ).
// With depth a and feed f the edge in cut runs from D, its intersection with the corner of the previous revolution, to
// A:
//   D = (-f/2, r - √(r² - f²/4))
//   A = (r sin κ + L cos κ, a),  L = (a - lim)/sin κ         where a ≥ lim
//   A = (√(r² - (r - a)²), a)                                where a < lim
//   Ω = atan2(A_u - D_u, A_h - D_h) from the direction of the feed: F_f = F_rf cos Ω, F_ap = F_rf sin Ω
// Contact length b: arc r (κ + asin f/2r) + L, or r (acos(1 - a/r) + asin f/2r) within the corner; chord |AD|;
// straight a/sin κ. Chip area b·h: f a less the scallop f r - (f/4) √(4r² - f²) - r² asin(f/2r), exact; straight f a.
// Forces: F_t = K_tc b h + K_te b, F_rf = K_rfc b h + K_rfe b.
//
// F_ap is not monotonic in the depth: beyond the corner the chip flow turns toward the feed.
#pragma once

#include <vector>

#include "engine/core/fields.h"
#include "engine/core/tool.h"

namespace lathelier::cutting {

/// Coefficients of a pair of workpiece material and insert. Cutting (c) by chip area, edge (e) by contact length;
/// tangential (t) and, in the plane of the rake face, along the flow of the chip (rf).
struct CuttingCoefficients {
    double K_tc_N_mm2 = 0;   ///< tangential, by area
    double K_te_N_mm = 0;    ///< tangential, by length of edge
    double K_rfc_N_mm2 = 0;  ///< along the chip, by area
    double K_rfe_N_mm = 0;   ///< along the chip, by length of edge
    friend bool operator==(const CuttingCoefficients&, const CuttingCoefficients&) = default;
};

/// Definition of the length of the edge in cut.
enum class ContactLength { Arc, Chord, Straight };

const std::vector<Field<CuttingCoefficients>>& fieldsOf(const CuttingCoefficients*);
/// The choices of ContactLength, for the structs that have one.
const std::vector<FieldChoice>& contactLengthChoices();

/// Uncut chip.
struct Chip {
    double contact_mm = 0;     ///< b
    double area_mm2 = 0;       ///< b·h
    double along_feed = 0;     ///< cos Ω
    double across_feed = 0;    ///< sin Ω
    bool is_cut = false;       ///< false: depth within the scallop, no force
    double flowAngle() const;  ///< Ω in rad, from the direction of the feed
};

/// Magnitudes of the forces on the tool; the forces on the workpiece are opposite.
struct CuttingForces {
    double F_t_N = 0;   ///< along the cutting speed
    double F_f_N = 0;   ///< against the feed
    double F_ap_N = 0;  ///< radially outward from the workpiece
};

/// An edge at one feed.
class CuttingEdge {
public:
    CuttingEdge() = default;  ///< an edge without forces
    /// `turned_rad`: angle of the feed direction outward from the axis, which reduces κ; depths are then normal to the
    /// feed. Of the tool count corner radius and entering angle, which have to be stated. Errors feedMissing,
    /// feedBeyondCorner, edgeCannotEnter.
    CuttingEdge(const Tool& tool, double feed_mm_rev, ContactLength contact, double turned_rad = 0);

    /// Height of the scallop that the corner leaves, r - √(r² - f²/4): no force at this depth or less.
    double scallop_mm() const { return scallop_mm_; }

    /// Chip at a depth normal to the feed. A few square roots and, within the corner, one arc cosine.
    Chip chipAt(double depth_mm) const;

private:
    double feed_mm_ = 0, radius_mm_ = 0;
    double sin_ = 1, cos_ = 0;  ///< sine and cosine of κ
    double corner_mm_ = 0;      ///< lim
    double scallop_mm_ = 0;
    double trailing_mm_ = 0;  ///< arc behind the deepest point, r asin(f/2r)
    double cornerArc_mm_ = 0;
    double cusp_mm2_ = 0;
    ContactLength contact_ = ContactLength::Arc;
};

inline CuttingForces forcesOf(const CuttingCoefficients& k, const Chip& chip)
{
    const double along_chip = k.K_rfc_N_mm2 * chip.area_mm2 + k.K_rfe_N_mm * chip.contact_mm;
    return {k.K_tc_N_mm2 * chip.area_mm2 + k.K_te_N_mm * chip.contact_mm, along_chip * chip.along_feed,
            along_chip * chip.across_feed};
}

/// One depth and feed. Zero at a depth of the scallop or less. Errors of CuttingEdge.
CuttingForces cuttingForces(const CuttingCoefficients& coefficients, const Tool& tool, double feed_mm_rev,
                            double depth_mm, ContactLength contact = ContactLength::Arc);

}  // namespace lathelier::cutting
