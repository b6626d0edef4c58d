// A cross section of a shaft with the marks that it cuts, in millimetres of the part.
//
// The section is seen from the free end toward the chuck (first angle: it stands right of the main view). Angles turn
// with the axis, clockwise in the section; 0 is the direction toward the viewer of the main view, right in the section.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/drawing/dimension_texts.h"

namespace lathelier::drawing {

/// A keyway.
struct Slot {
    double angle_deg = 0;
    double width_mm = 0, floor_mm = 0;   ///< floor: from the axis
    DimensionText width, across, angle;  ///< across: from the floor to the opposite side; angle: empty at 0
};

/// A flat, or a face of a prism.
struct FlatCut {
    double angle_deg = 0, distance_mm = 0;   ///< from the axis
    DimensionText across, angle;             ///< empty: not dimensioned here
    std::optional<double> opposite_mm = {};  ///< of the flat that `across` is measured from; none: the round side
};

/// A hole across the axis, in the plane of the section.
struct RadialHole {
    double angle_deg = 0, diameter_mm = 0;
    std::optional<double> depth_mm = {};  ///< from the surface; none: through
    DimensionText size, angle;
};

/// Holes along the axis on a circle.
struct HoleCircle {
    double angle_deg = 0;  ///< of one of them
    std::size_t count = 0;
    double diameter_mm = 0, pitch_circle_mm = 0;
    DimensionText angle = {};  ///< of the hole that `angle_deg` is of
};

/// Teeth of a spline, by convention (ISO 6413): crest and root circle, one tooth.
struct Teeth {
    double angle_deg = 0;
    double root_mm = 0;                   ///< diameter
    std::optional<double> width_mm = {};  ///< of a tooth; none: not known
    DimensionText width;
};

/// An axis that is not that of the part.
struct OffsetAxis {
    double angle_deg = 0, offset_mm = 0;
    DimensionText offset, angle;
};

struct CrossSection {
    double from_z_mm = 0, to_z_mm = 0;  ///< where the plane may lie
    double diameter_mm = 0, bore_diameter_mm = 0;
    std::vector<Slot> slots = {};
    std::vector<FlatCut> flats = {};  ///< of flats and prisms
    std::vector<RadialHole> holes = {};
    std::vector<HoleCircle> circles = {};
    std::optional<Teeth> teeth = {};
    std::optional<OffsetAxis> eccentric = {};
    std::vector<DimensionText> captions = {};  ///< under its letters
};

/// "A" for 0, "B"…
std::string letterOf(std::size_t section);

}  // namespace lathelier::drawing
