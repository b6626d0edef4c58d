// Fanuc, G code system A of turning (G90, G92, G94 are cycles; feeds are selected by G98, G99).
#include "engine/gcode/controls/add_words.h"
#include "engine/gcode/controls/controls.h"

namespace lathelier::gcode {
namespace {

/// Lines that hold the number of the program alone: O1234, :1234 in ISO code, %O1234.
std::vector<std::string> programNumbers()
{
    std::vector<std::string> patterns{"%O?*"};
    for (const char* letter : {"O", "O ", ":"}) {
        const std::vector<std::string> all = numbered(letter, 8);
        patterns.insert(patterns.end(), all.begin(), all.end());
    }
    return patterns;
}

Evidence evidenceOfFanuc()
{
    Evidence evidence;
    evidence.texts = {{8,
                       {"*IF*[*]*GOTO*", "*GOTO*IF*[*", "*IF*[*]*THEN*", "WHILE*[*]*DO*", "N?*WHILE*[*]*DO*",
                        "*#3000*=*", "*#3006*=*"}},
                      {4, programNumbers()}};
    evidence.remarks = {{2, {"T???", "T??? *", "T????", "T???? *"}}};
    evidence.blocks = {{.points = 4, .letters = "T", .least_digits = 3, .most_digits = 5},
                       {.points = 6, .g = {50}, .letters = "S"},
                       {.points = 6, .g = {92}, .letters = "S", .none_of = "XYZUWABCIJKPQ"},
                       {.points = 6, .one_of = "UW"},
                       {.points = 4, .one_of = "acr"},
                       {.points = 2, .g = {99}, .no_g = {81, 83}, .none_of = "XZ"},
                       {.points = 4, .g = {70, 71, 72, 73}, .letters = "PQ"},
                       {.points = 3, .g = {76}, .letters = "Q", .none_of = "J"},
                       {.points = 3, .g = {77, 78, 79}, .one_of = "XZUW"},
                       {.points = 1, .g = {98}, .no_g = {80, 90}, .none_of = "XZ"},
                       {.points = 2, .g = {32}},
                       {.points = 3, .m = {98, 99}},
                       {.points = 3, .m = {97}, .letters = "P"}};
    return evidence;
}

std::map<int, G> wordsOfFanuc()
{
    std::map<int, G> g = commonWords();
    addWords(g, G::InchAll, {20});
    addWords(g, G::Metric, {21});
    addWords(g, G::Home, {28, 30});
    addWords(g, G::Thread, {32, 33});
    addWords(g, G::SpeedLimit, {50});
    addWords(g, G::SetData, {10});
    addWords(g, G::MillOn, {12.1, 112});
    addWords(g, G::MillOff, {13.1, 113});
    addWords(g, G::LocalShift, {52});
    addWords(g, G::MachineMove, {53});
    addWords(g, G::WorkOffset, {54, 54.1, 55, 56, 57, 58, 59});
    addWords(g, G::MacroCall, {65});
    addWords(g, G::Finish, {70});
    addWords(g, G::RoughTurn, {71});
    addWords(g, G::RoughFace, {72});
    addWords(g, G::Pattern, {73});
    addWords(g, G::FacePeck, {74});
    addWords(g, G::TurnPeck, {75});
    addWords(g, G::ThreadMulti, {76});
    addWords(g, G::CycleOff, {80});
    addWords(g, G::Drill, {81, 82, 83});
    addWords(g, G::Tap, {84});
    addWords(g, G::DrillFeedOut, {85});
    addWords(g, G::DrillAcross, {86, 87, 88, 89});
    addWords(g, G::TurnCycle, {90});
    addWords(g, G::ThreadCycle, {92});
    addWords(g, G::FaceCycle, {94});
    addWords(g, G::PerMinute, {98});
    addWords(g, G::PerRevolution, {99});
    addWords(g, G::NoEffect, {9, 22, 23, 25, 26, 27, 43, 44, 49, 61, 62, 63, 64, 67, 69});
    addWords(g, G::NotModelled, {5, 7, 7.1, 8, 10.2, 11, 12, 13, 31, 34, 35, 36, 37, 51, 66, 68, 107});
    return g;
}

}  // namespace

Control fanuc()
{
    Control control;
    control.key = "fanuc";
    control.label = LT_TEXT("Engine", "Fanuc, system A");
    control.extensions = {".nc", ".tap", ".cnc"};
    control.evidence = evidenceOfFanuc();

    control.grammar.has_comma_words = true;
    control.grammar.is_iso_code = true;
    control.grammar.statements = {"IF", "WHILE", "GOTO", "END", "DO"};
    control.arithmetic.last_local = 33;
    control.arithmetic.last_vacant = 33;
    control.arithmetic.position_numbers = {
        {5001, PositionValue::X}, {5002, PositionValue::Z}, {5041, PositionValue::X}, {5042, PositionValue::Z}};
    control.arithmetic.alarm = 3000;

    control.g = wordsOfFanuc();
    addWords(control.m, M::End, {2, 30});
    addWords(control.m, M::CallProgram, {98});
    addWords(control.m, M::Return, {99});
    addWords(control.m, M::Spindle, {3, 4});
    addWords(control.m, M::NotModelled, {97});  // some builders' call of a subprogram in the same program
    addWords(control.m, M::NoEffect, 0, 299);   // most are assigned by the machine builder
    addWords(control.letters, Letter::Always, "NOFSTLXZUW");
    addWords(control.letters, Letter::InBlock, "IKRPQDEAacr");
    addWords(control.letters, Letter::NotModelled, "YBCVH");

    control.start.assumed_motion = G::Rapid;
    control.start.assumed_motion_word = LT_TEXT("Engine", "G0");
    control.increments_are_letters = true;
    control.integers_count_increments = true;
    control.tool_holds_offset = true;
    control.dwell = {{'X', DwellWord::Unit::SecondsOrMilli},
                     {'U', DwellWord::Unit::SecondsOrMilli},
                     {'P', DwellWord::Unit::Milliseconds}};
    control.has_drawing_words = true;
    control.drill_level_is_increment = true;
    control.call_holds_repeats = true;
    return control;
}

}  // namespace lathelier::gcode
