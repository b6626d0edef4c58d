// The outline of a tool where it stands, for charts.
#pragma once

#include <QPolygonF>
#include <vector>

#include "engine/cam/drawn/drawn_plan.h"

namespace lathelier::turning_panel {

/// Holder and insert of the tool `number` with its imaginary tip at `tip` (z of the stock, radius). Empty: the job has
/// no such tool, or the program has errors.
std::vector<QPolygonF> toolShapes(const cam::ClampingOutcome& clamping, const QPointF& tip, int number);

}  // namespace lathelier::turning_panel
