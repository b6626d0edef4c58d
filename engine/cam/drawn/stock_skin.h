// The stock and the tool of a turning program as surfaces, for the view of the part as it is cut.
#pragma once

#include <optional>
#include <vector>

#include "engine/cam/drawn/plan_charts.h"
#include "engine/core/skin.h"
#include "engine/stock/tool_outline.h"

namespace lathelier::cam {

/// One closed surface for each piece of the stock and each cavity in it; x of the frame is the radius toward the tool,
/// z runs from the raw end. Without values. Empty: the program has errors.
std::vector<Skin> stockSkins(const TurningOutcome& outcome, std::size_t setup, const StockShown& shown);

/// Of the tool `number`, from its imaginary tip. None: the job has no such tool, or the program has errors.
std::optional<stock::ToolOutline> outlineOfTool(const ClampingOutcome& clamping, int number);

/// Holder and insert of the tool `number` with its imaginary tip at (z, x), to scale in their plane, the upper face at
/// the height of the axis; thicknesses are assumed (insert 5 mm, holder 20 mm). Empty: no such tool.
Scan toolMesh(const ClampingOutcome& clamping, double tip_z_mm, double tip_x_mm, int number);

}  // namespace lathelier::cam
