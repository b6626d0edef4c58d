// Fanuc's other G code systems of turning: the words of system A, but for the numbers of G words. Increments are G91
// or, as machine builders keep them, U and W. Source: the tables of G codes in the manuals of Series 0i and 30i.
#include "engine/gcode/controls/add_words.h"
#include "engine/gcode/controls/controls.h"

namespace lathelier::gcode {
namespace {

/// What tells both from system A: there G90, G92 and G94 are cycles, G50 limits the speed, and G98 and G99 state the
/// kind of feed.
std::vector<BlockSign> signsOfBoth()
{
    return {{.points = 5, .g = {92}, .letters = "S", .none_of = "XZUW"},
            {.points = 3, .g = {91}},
            {.points = 2, .g = {90}, .none_of = "XZUW"},
            {.points = 3, .g = {90}, .also_g = {0, 1, 2, 3}, .one_of = "XZUW"},
            {.points = 3, .g = {94, 95}, .none_of = "XZUW"},
            {.points = 3, .g = {94, 95}, .also_g = {0, 1, 2, 3}, .one_of = "XZUW"},
            {.points = -2, .g = {98, 99}, .no_g = {80, 81, 82, 83, 84, 85, 86, 87, 88, 89}, .none_of = "XZ"},
            {.points = -4, .g = {50}, .letters = "S"}};
}

/// The words of both: those of system A without the numbers that mean something else.
Control withoutThoseOfSystemA(std::initializer_list<int> numbers)
{
    Control control = fanuc();
    control.extensions = {".nc"};
    control.evidence = {};
    control.evidence.variant_of = "fanuc";
    control.evidence.speaks_for_base = true;
    control.evidence.blocks = signsOfBoth();
    for (const int number : {32, 50, 90, 92, 94, 98, 99}) control.g.erase(10 * number);
    for (const int number : numbers) control.g.erase(10 * number);
    addWords(control.g, G::Absolute, {90});
    addWords(control.g, G::Incremental, {91});
    addWords(control.g, G::SpeedLimit, {92});
    addWords(control.g, G::PerMinute, {94});
    addWords(control.g, G::PerRevolution, {95});
    addWords(control.g, G::NoEffect, {98});
    addWords(control.g, G::ReturnToLevel, {99});
    return control;
}

}  // namespace

Control fanucB()
{
    Control control = withoutThoseOfSystemA({});
    control.key = "fanuc_b";
    control.label = LT_TEXT("Engine", "Fanuc, system B");
    control.evidence.blocks.push_back(
        {.points = 4, .g = {77, 78, 79}, .letters = "F", .one_of = "XZUW", .none_of = "PQ"});
    control.evidence.certain = 2;
    control.evidence.rank = 2;

    addWords(control.g, G::TurnCycle, {77});
    addWords(control.g, G::ThreadCycle, {78});
    addWords(control.g, G::FaceCycle, {79});
    return control;
}

Control fanucC()
{
    Control control = withoutThoseOfSystemA({20, 21, 70, 71, 72, 73, 74, 75, 76});
    control.key = "fanuc_c";
    control.label = LT_TEXT("Engine", "Fanuc, system C");
    const std::vector<BlockSign> own{
        {.points = 4, .g = {70, 71}, .none_of = "XZUWPQRDIK"},
        {.points = 6, .g = {20, 21}, .no_g = {0, 1, 2, 3}, .letters = "F", .one_of = "XZUW"},
        {.points = 6, .g = {24}, .one_of = "XZUW"},
        {.points = 4, .g = {77, 78}, .letters = "PQ", .one_of = "XZUW"},
        {.points = -4, .g = {20, 21}, .none_of = "XZUW"},
        {.points = -4, .g = {70, 71}, .letters = "PQ"}};
    control.evidence.blocks.insert(control.evidence.blocks.end(), own.begin(), own.end());
    control.evidence.certain = 4;
    control.evidence.rank = 1;

    addWords(control.g, G::TurnCycle, {20});
    addWords(control.g, G::ThreadCycle, {21});
    addWords(control.g, G::FaceCycle, {24});
    addWords(control.g, G::InchAll, {70});
    addWords(control.g, G::Metric, {71});
    addWords(control.g, G::Finish, {72});
    addWords(control.g, G::RoughTurn, {73});
    addWords(control.g, G::RoughFace, {74});
    addWords(control.g, G::Pattern, {75});
    addWords(control.g, G::FacePeck, {76});
    addWords(control.g, G::TurnPeck, {77});
    addWords(control.g, G::ThreadMulti, {78});
    return control;
}

}  // namespace lathelier::gcode
