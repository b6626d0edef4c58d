// Fagor: recognised, not read.
#include "engine/gcode/controls/controls.h"

namespace lathelier::gcode {

Control fagor()
{
    Control control;
    control.key = "fagor";
    control.label = LT_TEXT("Engine", "Fagor");
    control.is_read = false;
    control.evidence.texts = {{8, {"%*,MX*"}}};
    control.evidence.certain = 8;
    control.evidence.rank = -2;
    return control;
}

}  // namespace lathelier::gcode
