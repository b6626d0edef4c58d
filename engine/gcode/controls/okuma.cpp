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
    Evidence& evidence = control.evidence;
    evidence.texts = {
        {20, {"$*%", "*NLAP*", "*NAT?*", "*NOEX*", "*VZOF*", "*CALL O*", "*G140 *", "*VLMON*", "*TG=*OG=*"}}};
    evidence.names = {{20, {"*.MIN"}}};
    evidence.blocks = {{.points = 10, .g = {85}, .letters = "ND", .none_of = "XZ"},
                       {.points = 5, .exact = {13, 14}},
                       {.points = 10, .g = {130, 131, 132, 133, 134, 135, 136, 137, 138, 139, 140, 141}},
                       {.points = 10, .g = {2, 3}, .letters = "L", .one_of = "XZ", .none_of = "IKRP"},
                       {.points = 10, .g = {71, 72}, .letters = "BH", .one_of = "XZ"},  // threads
                       {.points = 12, .letters = "T", .least_digits = 6, .most_digits = 6}};
    // G50 S is of those controls that state the kind of feed by G98 and G99
    evidence.programs = {{15, {{.g = {50}, .letters = "S"}, {.g = {94, 95}, .none_of = "XZUW"}}},
                         {15, {{.g = {50}, .letters = "S"}, {.g = {94, 95}, .also_g = {0, 1, 2, 3}}}}};
    evidence.certain = 20;
    evidence.rank = -2;
    return control;
}

}  // namespace lathelier::gcode
