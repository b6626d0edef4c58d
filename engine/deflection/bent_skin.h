// The bent work as a closed surface, for its view.
#pragma once

#include "engine/core/skin.h"
#include "engine/deflection/deflected_shape.h"

namespace lathelier::deflection {

/// The work after all cuts of the plan, displaced as its axis is; x toward the tool, y along the cutting speed, z from
/// the free end. Values: the diameter error in µm where the contour has one, the same all round; else NaN. Bores are
/// not drawn.
Skin bentSkin(const WorkPlan& plan, const DeflectedShape& shape, const FinalContour& error);

/// A readable magnification: with it the largest displacement is about a third of the largest radius.
double bendMagnification(const Skin& skin);

}  // namespace lathelier::deflection
