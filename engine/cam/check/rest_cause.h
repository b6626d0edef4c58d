// Why material stays: what a tool that touched the drawing there would cut into elsewhere.
#pragma once

#include "engine/cam/check/surface_deviation.h"
#include "engine/core/text.h"

namespace lathelier::cam {

/// Nose: the corner is sharper than the nose. Back and leading angle: an edge would cut into the drawing. Blade:
/// corners of a blade. Holder, chuck and tailstock: what a plan kept clear of. Uncut: the tool could reach it, the
/// program does not.
enum class RestCause : std::uint8_t { NoseRadius, BackAngle, LeadingAngle, Blade, Holder, Chuck, Uncut, Tailstock };

/// "nose_radius", "back_angle", "leading_angle", "blade", "holder", "chuck", "not_cut", "tailstock".
const char* key(RestCause cause);
Text nameOf(RestCause cause);

/// Of the tool that comes nearest, at points spread over the stretch: an edge that hinders anywhere counts before the
/// nose. The edges are rays; the back angle is less by the tool's margin.
RestCause causeOf(const LeftStretch& stretch, const DrawnContour& drawing, const AllStrokes& all, const Job& job);

}  // namespace lathelier::cam
