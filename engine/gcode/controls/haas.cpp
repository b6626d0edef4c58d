// Haas lathes: the words of Fanuc's system A, with cycles that state everything in one block.
#include "engine/gcode/controls/add_words.h"
#include "engine/gcode/controls/controls.h"

namespace lathelier::gcode {

Control haas()
{
    Control control = fanuc();
    control.key = "haas";
    control.label = LT_TEXT("Engine", "Haas");
    control.extensions = {".nc"};
    control.evidence = {};
    control.evidence.variant_of = "fanuc";
    control.evidence.certain = 4;
    control.evidence.blocks = {{.points = 6, .g = {71, 72, 73}, .letters = "PQD"},
                               {.points = 6, .g = {76}, .letters = "DK", .none_of = "J"},
                               {.points = 4, .g = {53}, .no_g = {28}},
                               {.points = 4, .g = {103, 112, 154, 187, 199}},
                               {.points = 4, .m = {97}, .letters = "P"},
                               {.points = 2, .m = {24, 97}}};

    addWords(control.g, G::Tap, {95});
    addWords(control.g, G::WorkOffset, {110, 111, 154});
    addWords(control.g, G::NoEffect, {14, 29, 47, 103, 105, 160, 161, 187, 199});
    addWords(control.g, G::NotModelled, {77, 101, 114, 115, 178, 179, 184, 186, 195, 196, 198});
    control.m[97] = M::CallBlock;

    control.drill_level_is_increment = false;
    control.groove_step_is_diameter = true;
    control.call_holds_repeats = false;
    return control;
}

}  // namespace lathelier::gcode
