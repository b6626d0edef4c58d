// Philips CNC 3000: recognised, not read.
#include "engine/gcode/controls/controls.h"

namespace lathelier::gcode {

Control philips()
{
    Control control;
    control.key = "philips";
    control.label = LT_TEXT("Engine", "Philips CNC 3000");
    control.is_read = false;
    control.evidence.texts = {{20, {"%PM*", "*N1=?*", "*N2=?*"}}};
    control.evidence.certain = 20;
    control.evidence.rank = -2;
    return control;
}

}  // namespace lathelier::gcode
