// Sinumerik 802S and 802C, whose cycles LCYC… take their values from R100 to R149: recognised, not read.
#include "engine/gcode/controls/controls.h"

namespace lathelier::gcode {

Control sinumerik802()
{
    Control control;
    control.key = "sinumerik_802";
    control.label = LT_TEXT("Engine", "Sinumerik 802");
    control.is_read = false;
    control.evidence.texts = {{20, {"*LCYC*"}}};
    control.evidence.certain = 20;
    control.evidence.variant_of = "sinumerik";
    return control;
}

}  // namespace lathelier::gcode
