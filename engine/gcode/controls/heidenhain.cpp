// Heidenhain: recognised, not read.
#include "engine/gcode/controls/controls.h"

namespace lathelier::gcode {

Control heidenhain()
{
    Control control;
    control.key = "heidenhain";
    control.label = LT_TEXT("Engine", "Heidenhain");
    control.extensions = {".h"};
    control.is_read = false;
    control.evidence.texts = {
        {10, {"BEGIN PGM*", "TOOL CALL*", "BLK FORM*", "CYCL DEF*", "END PGM*", "* FMAX*", "*DIN/ISO*"}}};
    control.evidence.certain = 10;
    control.evidence.rank = -2;
    return control;
}

}  // namespace lathelier::gcode
