// The interpreter of LinuxCNC, and what GRBL has of it: radii and feed per minute at the start, O words.
#include "engine/gcode/controls/add_words.h"
#include "engine/gcode/controls/controls.h"

namespace lathelier::gcode {
namespace {

Evidence evidenceOfLinuxCnc()
{
    Evidence evidence;
    evidence.texts = {{20, {"O<*", "*#<*", "O?*SUB*", "O?*CALL*", "O?*WHILE*", "O?*IF*", "O?*REPEAT*", "O?* DO*"}}};
    evidence.names = {{8, {"*.NGC"}}};
    evidence.blocks = {{.points = 4, .exact = {43.1, 43.2}},
                       {.points = 4, .exact = {61.1}},
                       {.points = 4, .exact = {90.1}},
                       {.points = 4, .exact = {91.1}},
                       {.points = 4, .exact = {92.1, 92.2, 92.3}},
                       {.points = 10, .exact = {7, 8}, .none_of = "CP"},
                       {.points = 2, .g = {64}, .no_g = {96}},
                       {.points = 4, .g = {33}, .letters = "K"},
                       {.points = 5, .g = {96}, .letters = "D"},
                       {.points = 3, .g = {43, 49}, .none_of = "H"},
                       {.points = 3, .m = {6}, .letters = "T", .most_digits = 2},
                       {.points = 2, .g = {90, 91}, .none_of = "XZ"},
                       {.points = 1, .g = {94, 95}, .none_of = "XZ"},
                       {.points = 1, .letters = "T", .most_digits = 2},
                       {.points = 6, .g = {76}, .letters = "JK"},
                       {.points = -6, .g = {70, 71, 72}, .none_of = "Q"}};  // cycles, which need it
    evidence.certain = 20;
    evidence.rank = -1;
    return evidence;
}

std::map<int, G> wordsOfLinuxCnc()
{
    std::map<int, G> g = commonWords();
    addWords(g, G::Diameter, {7});
    addWords(g, G::Radius, {8});
    addWords(g, G::PlaneOther, {17.1, 18.1, 19.1});
    addWords(g, G::InchAll, {20});
    addWords(g, G::Metric, {21});
    addWords(g, G::Home, {28, 30});
    addWords(g, G::Thread, {33});
    addWords(g, G::NoseLeftByWords, {41.1});
    addWords(g, G::NoseRightByWords, {42.1});
    addWords(g, G::SetData, {10});
    addWords(g, G::LocalShift, {52});
    addWords(g, G::MachineMove, {53});
    addWords(g, G::WorkOffsetNamed, {54, 55, 56, 57, 58, 59, 59.1, 59.2, 59.3});
    addWords(g, G::SubroutineFinish, {70});
    addWords(g, G::SubroutineTurn, {71, 71.1, 71.2});
    addWords(g, G::SubroutineFace, {72, 72.1, 72.2});
    addWords(g, G::DrillChipBreak, {73});
    addWords(g, G::DriveThread, {76});
    addWords(g, G::CycleOff, {80});
    addWords(g, G::Drill, {81, 82, 83, 86, 87});
    addWords(g, G::Tap, {84, 88});
    addWords(g, G::DrillFeedOut, {85, 89});
    addWords(g, G::Absolute, {90});
    addWords(g, G::ArcAbsolute, {90.1});
    addWords(g, G::Incremental, {91});
    addWords(g, G::ArcIncremental, {91.1});
    addWords(g, G::SetPosition, {92});
    addWords(g, G::SetPositionClear, {92.1});
    addWords(g, G::SetPositionOff, {92.2});
    addWords(g, G::SetPositionBack, {92.3});
    addWords(g, G::InverseTime, {93});
    addWords(g, G::PerMinute, {94});
    addWords(g, G::PerRevolution, {95});
    addWords(g, G::ReturnToLevel, {99});
    addWords(g, G::NoEffect, {28.1, 30.1, 43, 43.1, 43.2, 49, 61, 61.1, 64, 98});
    addWords(g, G::NotModelled, {5, 5.1, 5.2, 5.3, 33.1, 38.2, 38.3, 38.4, 38.5});
    return g;
}

}  // namespace

Control linuxCnc()
{
    Control control;
    control.key = "linuxcnc";
    control.label = LT_TEXT("Engine", "LinuxCNC");
    control.extensions = {".ngc"};
    control.evidence = evidenceOfLinuxCnc();

    control.grammar.has_open_functions = true;
    control.grammar.assigns_many = true;
    control.grammar.flow = FlowStyle::Labelled;
    control.arithmetic.last_local = 30;
    control.arithmetic.last_zero = 5000;
    control.arithmetic.position_numbers = {{5420, PositionValue::X}, {5422, PositionValue::Z}};
    control.arithmetic.position_names = {{"_x", PositionValue::X}, {"_z", PositionValue::Z}};
    control.arithmetic.position_is_radius = true;

    control.g = wordsOfLinuxCnc();
    addWords(control.m, M::End, {2, 30});
    addWords(control.m, M::Spindle, {3, 4});
    addWords(control.m, M::NoEffect,
             {0, 1, 5, 6, 7, 8, 9, 19, 48, 49, 50, 51, 52, 53, 60, 61, 62, 63, 64, 65, 66, 67, 68, 70, 71, 72, 73});
    addWords(control.m, M::CallProgram, {98});
    addWords(control.m, M::Return, {99});
    control.call_stands_alone = true;
    addWords(control.m, M::NoEffect, 100, 199);  // assigned by the user
    addWords(control.letters, Letter::Always, "NOFSTLXZ");
    addWords(control.letters, Letter::InBlock, "IKRPQDHEJ");
    addWords(control.letters, Letter::NotModelled, "YABCUVW");

    control.start.is_diameter = false;
    control.start.is_per_revolution = false;
    control.start.is_at_origin = true;
    control.set_position_shifts = true;
    control.set_position_is_absolute = true;
    control.local_shift_is_position = true;
    control.can_state_diameter = true;
    control.refuses_conflicts = true;
    control.dwell = {{'P', DwellWord::Unit::Seconds}};
    control.feed_ends_with_its_kind = true;
    control.css_limit = 'D';
    control.thread_lead_is_ik = true;
    return control;
}

}  // namespace lathelier::gcode
