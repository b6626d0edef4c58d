// Rows of a contour, outside or bore, with their kind in a drawing.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/shaft/shaft.h"

namespace lathelier::drawing {

enum class RowKind : std::uint8_t { Cylinder, Taper, Curve, Chamfer, Radius, Groove, Undercut, Face };

/// A row in the order of travel: from the free end, or from a bore's mouth inward.
struct ContourRow {
    RowKind kind = RowKind::Cylinder;
    double start_z_mm = 0, end_z_mm = 0;  ///< z of the shaft
    double start_diameter_mm = 0, end_diameter_mm = 0;
    double arc_radius_mm = 0;  ///< signed as ShaftSegment::arc_radius_mm; 0: straight
    std::size_t index = 0;     ///< in ShaftSegment or BoreSegment lists
    std::optional<SizeTolerance> tolerance = {};
    std::optional<MeasuredSize> measured = {};
    std::optional<double> measured_start_z_mm = {}, measured_end_z_mm = {};  ///< where some row of the contour has it

    double length_mm() const;
    double middleZ_mm() const { return (start_z_mm + end_z_mm) / 2; }
    /// z and radius of the row's middle, on the arc where it is one.
    Eigen::Vector2d middle_mm() const;
    /// Largest diameter of the row, of an arc that of its crest where it has one.
    double crestDiameter_mm() const;
    /// Angle between the surface and the axis, of a cone.
    double angle_deg() const;
    /// Part of a ball that ends on the axis, where its centre lies.
    bool isBall() const;
    /// Chamfers, radii, grooves and undercuts: no length of their own is given.
    bool isMinor() const;
};

/// The shaft with ShaftSegment::bore_diameter_mm turned into bores, equal neighbours joined.
Shaft withStatedBores(const Shaft& shaft);

/// Roles determine the kind; without a role: a cone of 10° or more and at most a tenth of its large diameter long
/// is a chamfer, an arc no longer than 15 % of its diameter a radius.
std::vector<ContourRow> outerRows(const Shaft& shaft);
std::vector<ContourRow> boreRows(const Shaft& shaft, std::size_t bore);

/// Largest radius of a contour at z, both sides of a shoulder.
double outerRadius(const std::vector<ContourRow>& rows, double z_mm);

}  // namespace lathelier::drawing
