// A turned shaft: its outer contour in segments from the free end toward the chuck, its bore, its material.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/material.h"

namespace lathelier {

/// One segment: a cylinder, a cone, or with `arc_radius_mm` an arc. Diameters that jump between segments are shoulders.
struct ShaftSegment {
    double length_mm = 0;  ///< 0: a plane
    double start_diameter_mm = 0;
    double end_diameter_mm = 0;
    double bore_diameter_mm = 0;          ///< 0: solid
    std::optional<double> arc_radius_mm;  ///< > 0 convex (material bulges beyond the chord), < 0 concave
    std::string role;                     ///< "chamfer", "fillet", "groove"…; geometry never depends on it
    friend bool operator==(const ShaftSegment&, const ShaftSegment&) = default;
};

struct Shaft {
    std::string name;
    std::vector<ShaftSegment> segments;  ///< from the free end toward the chuck
    std::optional<Material> material;    ///< none: not stated
    friend bool operator==(const Shaft&, const Shaft&) = default;

    double length_mm() const;
};

const std::vector<Field<ShaftSegment>>& fieldsOf(const ShaftSegment*);
const std::vector<Field<Shaft>>& fieldsOf(const Shaft*);

}  // namespace lathelier
