// Mazatrol: recognised, not read.
#include "engine/gcode/controls/controls.h"

namespace lathelier::gcode {

Control mazatrol()
{
    Control control;
    control.key = "mazatrol";
    control.label = LT_TEXT("Engine", "Mazatrol");
    control.extensions = {".eia"};
    control.is_read = false;
    control.evidence.texts = {{6, {"*MAZATROL*", "UNIT *"}}};
    control.evidence.certain = 6;
    control.evidence.rank = -2;
    return control;
}

}  // namespace lathelier::gcode
