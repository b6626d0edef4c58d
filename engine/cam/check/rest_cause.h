// Cause of residual material: where a tool that touched the drawing at that point would gouge or collide.
#pragma once

#include "engine/cam/check/surface_deviation.h"
#include "engine/core/text.h"

namespace lathelier::cam {

/// Nose: the corner is sharper than the nose. Back and leading angle: an edge would cut into the drawing. Blade:
/// corners of a blade. Holder, chuck and tailstock: collisions that a plan avoided. Uncut: reachable by the tool, but
/// not cut by the program.
enum class RestCause : std::uint8_t { NoseRadius, BackAngle, LeadingAngle, Blade, Holder, Chuck, Uncut, Tailstock };

/// "nose_radius", "back_angle", "leading_angle", "blade", "holder", "chuck", "not_cut", "tailstock".
const char* key(RestCause cause);
Text nameOf(RestCause cause);

/// Evaluated for the nearest tool at sampled points of the stretch: a gouging edge at any point takes precedence over
/// the nose. The edges are rays; the back angle is reduced by the margin of the tool.
RestCause causeOf(const LeftStretch& stretch, const DrawnContour& drawing, const AllStrokes& all, const Job& job);

}  // namespace lathelier::cam
