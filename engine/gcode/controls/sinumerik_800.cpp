// Sinumerik 810, 820, 850 and their kin: recognised, not read.
#include "engine/gcode/controls/controls.h"

namespace lathelier::gcode {

Control sinumerik800()
{
    Control control;
    control.key = "sinumerik_800";
    control.label = LT_TEXT("Engine", "Sinumerik 810, 820 or 850");
    control.is_read = false;
    control.evidence.texts = {{20, {"%MPF*", "%SPF*", "@???*", "* @???*"}}};
    control.evidence.certain = 20;
    control.evidence.variant_of = "sinumerik";
    control.evidence.rank = 1;
    return control;
}

}  // namespace lathelier::gcode
