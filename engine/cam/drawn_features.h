// What a drawing shows besides the outside that turning makes: bores, threads, and marks such as keyways or cross
// holes. Only threads have an operation, and no check of a program looks at any of them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/quantities.h"
#include "engine/gcode/move.h"
#include "engine/shaft/shaft.h"

namespace lathelier::cam {

struct DrawnFeature {
    MarkKind kind = MarkKind::Bore;    ///< of a bore, of a thread, or of the mark
    std::optional<double> z_start_mm;  ///< from the drawn free end; none: the drawing states no place
    std::optional<double> z_end_mm;
    std::optional<double> diameter_mm;  ///< of a bore its largest, of a thread that over its crests
    std::string designation;            ///< "M16x1.5"; empty: none
    std::string other_kind = {};        ///< as ShaftMark::other_kind
    friend bool operator==(const DrawnFeature&, const DrawnFeature&) = default;
};

/// Bores first, then threads, then marks, each in the order of the drawing.
std::vector<DrawnFeature> featuresBesideOutside(const Shaft& part);

/// "bore", "thread"…: key of its kind.
std::string key(const DrawnFeature& feature);

/// For people: a Text of the known kinds, else the kind as the drawing has it.
Value nameOf(const DrawnFeature& feature);

/// Values of a note or a finding on it: feature, z_start_mm, z_end_mm, diameter_mm, designation.
Values valuesOf(const DrawnFeature& feature);

/// For the head of a program: "bore D20 z 0-50".
std::string plainText(const DrawnFeature& feature);

/// True if a move cuts a thread over the place of this one. `zero_mm`: z of the program's Z0, counted as the feature
/// is.
bool isThreaded(const DrawnFeature& feature, std::span<const gcode::Move> moves, double zero_mm);

const std::vector<QuantityOf<DrawnFeature>>& quantitiesOf(const DrawnFeature*);

}  // namespace lathelier::cam
