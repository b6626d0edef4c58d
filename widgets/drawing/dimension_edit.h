// In-place editing of a dimension: text of the field and resulting rows.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "engine/drawing/drawing.h"
#include "engine/shaft/shaft_sizes.h"

namespace lathelier::drawing_panel {

/// The size as editable text, in the user's locale, in millimetres and degrees as on the sheet: "45", "1 × 45" (leg and
/// angle of a chamfer), "2 × 27" (width and bottom of a groove), "1:10" or the whole angle of a cone.
QString typedSize(const ShaftRows& rows, const drawing::DimensionTarget& target);

/// The same of a bore: the diameter of its row, or the depth of its end.
QString typedBoreSize(const std::vector<ShaftBore>& bores, const drawing::DimensionTarget& target);

/// The typed number if there is exactly one; none otherwise.
std::optional<double> typedNumber(const QString& typed);

/// Input format, for the tooltip of the field.
QString typingHelp(const drawing::DimensionTarget& target);

/// The rows with the typed size. Errors: valueNotUnderstood; those of shaft_sizes.h.
ShaftRows withTypedSize(ShaftRows rows, const drawing::DimensionTarget& target, const QString& typed, KeepAfter keep);

/// Text of the undo step.
QString stepOf(const drawing::DimensionTarget& target);

}  // namespace lathelier::drawing_panel
