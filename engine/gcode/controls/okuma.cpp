// Okuma OSP: recognised, not read.
#include "engine/gcode/controls/controls.h"

namespace lathelier::gcode {

Control okuma()
{
    Control control;
    control.key = "okuma";
    control.label = LT_TEXT("Engine", "Okuma OSP");
    control.extensions = {".min"};
    control.is_read = false;
    control.evidence.texts = {{6, {"$*%", "*NLAP*", "*NAT0*", "*NOEX*", "*VZOF*", "*CALL O*", "*G140 *", "*VLMON*"}}};
    control.evidence.blocks = {{.points = 3, .g = {85}, .letters = "ND", .none_of = "XZ"},
                               {.points = 3, .g = {13, 14, 140, 141}}};
    control.evidence.certain = 6;
    control.evidence.rank = -2;
    return control;
}

}  // namespace lathelier::gcode
