// Dimensions of a shaft's drawing before layout, in millimetres of the part.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/drawing/dimension_texts.h"
#include "engine/drawing/marks/cross_section.h"
#include "engine/drawing/size_texts.h"

namespace lathelier::drawing {

/// Crest minus root diameter of a metric thread over its pitch (ISO 68-1, rounded root).
inline constexpr double rootDepth = 1.2268;

/// The ⌀ of a cylinder.
struct DiameterDimension {
    double from_z_mm = 0, to_z_mm = 0;  ///< from < to
    double diameter_mm = 0;
    DimensionText label;
    double clear_diameter_mm = 0;  ///< between the lines inside that a text is not to cross: a thread's root
    double offset_mm = 0;          ///< height of its axis above that of the part: an eccentric
};

/// The ⌀ of a bore's cylinder.
struct BoreDimension {
    DiameterDimension size;
    bool open_free = false;   ///< no narrower place between it and the free end
    bool open_chuck = false;  ///< the same toward the chuck
};

/// Which free space beside the view a callout of a bore can be reached from.
enum class Mouth : std::uint8_t { None, Free, Chuck };

/// A text that a leader ties to a place of the contour.
struct Callout {
    Eigen::Vector2d at_mm = Eigen::Vector2d::Zero();  ///< z, r
    DimensionText label;
    Mouth mouth = Mouth::None;  ///< of a bore, where the row is its first one
};

/// A length from an end, or from the place before, to a place.
struct LengthDimension {
    double from_z_mm = 0;
    double to_z_mm = 0;
    double from_radius_mm = 0, to_radius_mm = 0;  ///< of the contour there, where extension lines begin
    DimensionText label;
};

struct Features {
    std::vector<DiameterDimension> diameters;   ///< outside, in the order of z
    std::vector<BoreDimension> bores;           ///< in the order of travel
    std::vector<Callout> callouts;              ///< outside and bores
    std::vector<LengthDimension> lengths;       ///< as DrawingOptions::lengths_from has them, the overall length last
    std::vector<LengthDimension> bore_lengths;  ///< from the mouths
    std::vector<CrossSection> sections;         ///< of marks, in the order of z
    std::vector<Difference> differences;        ///< nominal sizes in place of measured ones, as numbered in the texts
};

/// `shaft` with its bores stated as bores (withStatedBores).
Features featuresOf(const Shaft& shaft, const DrawingOptions& options);

}  // namespace lathelier::drawing
