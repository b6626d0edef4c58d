// Sinumerik in its own language (not in G291): names, values behind "=", structured statements.
#include "engine/gcode/controls/add_words.h"
#include "engine/gcode/controls/controls.h"

namespace lathelier::gcode {
namespace {

/// Assignments of R parameters, at the beginning of a block and within one.
std::vector<std::string> assignments()
{
    std::vector<std::string> patterns;
    for (const char* before : {"R", "* R"})
        for (const char* behind : {"=*", " =*"}) {
            const std::vector<std::string> all = numbered(before, 3, behind);
            patterns.insert(patterns.end(), all.begin(), all.end());
        }
    return patterns;
}

Evidence evidenceOfSinumerik()
{
    Evidence evidence;
    for (const char* word : {"%_N_", "DIAMON", "DIAMOF", "DIAM90", "LIMS=", "CR=", "CYCLE9", "CYCLE8", "T=\"", "GOTOF",
                             "GOTOB", "DEF REAL", "SUPA", "STOPRE", "RND=", "CHF=", "CHR=", "LCYC"})
        evidence.texts.push_back({20, {std::string("*") + word + "*"}});
    evidence.texts.push_back({20, assignments()});
    evidence.texts.push_back({20, {"%MPF*", "%SPF*", "@???*", "* @???*"}});
    for (const char* word : {"*MSG*", "*G500*", "*PROC *", "ENDIF*", "N?* ENDIF*", "ENDWHILE*", "N?* ENDWHILE*"})
        evidence.texts.push_back({4, {word}});
    evidence.names = {{8, {"*.MPF", "*.SPF"}}};
    evidence.blocks = {{.points = 6, .no_g = {41, 42, 96}, .letters = "DT"},
                       {.points = 4, .g = {70, 71}, .none_of = "XZUWPQRDIK"}};
    evidence.certain = 20;
    evidence.rank = 1;
    return evidence;
}

std::map<int, G> wordsOfSinumerik()
{
    std::map<int, G> g = commonWords();
    addWords(g, G::SpeedLimit, {26});
    addWords(g, G::Thread, {33});
    addWords(g, G::TranslateCoarse, {58});
    addWords(g, G::TranslateFine, {59});
    addWords(g, G::Translate, {158});
    addWords(g, G::MachineMove, {53, 153});
    addWords(g, G::WorkOffset, {54, 55, 56, 57});
    for (int number = 505; number <= 599; ++number) g[number * 10] = G::WorkOffset;
    addWords(g, G::WorkOffsetNamed, {500});
    addWords(g, G::Inch, {70});
    addWords(g, G::InchAll, {700});
    addWords(g, G::Metric, {71, 710});
    addWords(g, G::FixedPoint, {74, 75});
    addWords(g, G::Absolute, {90});
    addWords(g, G::Incremental, {91});
    addWords(g, G::InverseTime, {93});
    addWords(g, G::PerMinute, {94});
    addWords(g, G::PerRevolution, {95});
    addWords(g, G::CssOn, {961, 962});
    addWords(g, G::CssOff, {971, 972, 973});
    addWords(g, G::NoEffect, {9, 25, 60, 64, 290, 291, 450, 451, 452, 601, 602, 641, 642});
    addWords(g, G::NotModelled, {34, 35, 63, 110, 111, 112, 331, 332});
    return g;
}

std::map<std::string, Name, std::less<>> namesOfSinumerik()
{
    std::map<std::string, Name, std::less<>> names;
    addWords(names, Name::DiameterOn, {"DIAMON"});
    addWords(names, Name::DiameterOff, {"DIAMOF"});
    addWords(names, Name::DiameterAbsolute, {"DIAM90"});
    addWords(names, Name::MachineMove, {"SUPA"});
    addWords(names, Name::ArcThrough, {"CIP"});
    addWords(names, Name::AxisPoint, {"X1", "Z1"});
    addWords(names, Name::SpeedLimit, {"LIMS"});
    addWords(names, Name::Speed, {"S1"});
    addWords(names, Name::ArcRadius, {"CR"});
    addWords(names, Name::ArcAngle, {"AR"});
    addWords(names, Name::ArcMiddleX, {"I1"});
    addWords(names, Name::ArcMiddleZ, {"K1"});
    addWords(names, Name::ChamferChord, {"CHF"});
    addWords(names, Name::ChamferLeg, {"CHR"});
    addWords(names, Name::Round, {"RND"});
    addWords(names, Name::RoundModal, {"RNDM"});
    addWords(names, Name::EndAngle, {"ANG", "ANG1", "ANG2"});
    addWords(names, Name::Translate, {"TRANS"});
    addWords(names, Name::TranslateMore, {"ATRANS"});
    addWords(names, Name::Rotate, {"ROT"});
    addWords(names, Name::RotateMore, {"AROT"});
    addWords(names, Name::RotateAngle, {"RPL"});
    addWords(names, Name::Scale, {"SCALE"});
    addWords(names, Name::ScaleMore, {"ASCALE"});
    addWords(names, Name::Mirror, {"MIRROR"});
    addWords(names, Name::MirrorMore, {"AMIRROR"});
    addWords(names, Name::MillOn, {"TRANSMIT", "TRACYL"});
    addWords(names, Name::MillOff, {"TRAFOOF"});
    addWords(names, Name::CallText, {"CALL"});
    addWords(names, Name::CallModal, {"MCALL"});
    addWords(names, Name::Grooving, {"CYCLE93"});
    addWords(names, Name::StockRemoval, {"CYCLE95"});
    addWords(names, Name::ThreadTurning, {"CYCLE97"});
    addWords(names, Name::Uncomputed, {"T"});
    addWords(names, Name::NoEffect,
             {"MSG",  "SF",    "FP",    "STOPRE", "D",       "M1",      "S2",     "M2",        "G",
              "SPOS", "FFWON", "FFWOF", "SOFT",   "BRISK",   "SETMS",   "WAITMC", "CUT2D",     "CUT2DF",
              "NORM", "KONT",  "FRC",   "FRCM",   "ENDPROC", "DISPLOF", "SAVE",   "COMPOF",    "CFTCP",
              "CFC",  "CFIN",  "SBLOF", "SBLON",  "G601",    "G602",    "F",      "WORKPIECE", "G700"});
    return names;
}

}  // namespace

Control sinumerik()
{
    Control control;
    control.key = "sinumerik";
    control.label = LT_TEXT("Engine", "Sinumerik");
    control.extensions = {".mpf", ".spf"};
    control.evidence = evidenceOfSinumerik();

    control.grammar.has_bracket_comments = false;
    control.grammar.has_names = true;
    control.grammar.has_number_sign = false;
    control.grammar.flow = FlowStyle::Structured;
    control.grammar.statements = {"IF",    "ELSE",    "ENDIF",  "WHILE",   "ENDWHILE", "FOR",  "ENDFOR",
                                  "LOOP",  "ENDLOOP", "REPEAT", "REPEATB", "UNTIL",    "GOTO", "GOTOF",
                                  "GOTOB", "DEF",     "PROC",   "EXTERN",  "RET"};
    control.arithmetic.has_parentheses = true;
    control.arithmetic.has_named_variables = true;
    control.arithmetic.has_comparison_signs = true;
    control.arithmetic.modulo_is_positive = false;

    control.g = wordsOfSinumerik();
    addWords(control.m, M::EndOrReturn, {2, 17, 30});
    addWords(control.m, M::Spindle, {3, 4});
    addWords(control.m, M::NoEffect, 0, 99);                // most are assigned by the machine builder
    addWords(control.letters, Letter::Always, "NXZFSTDL");  // D: the tool offset
    addWords(control.letters, Letter::InBlock, "IKP");
    addWords(control.letters, Letter::NotModelled, "YABCUVWHE");
    control.names = namesOfSinumerik();

    control.start.assumed_diameter = LT_TEXT("Engine", "diameter (DIAMON)");
    control.start.assumed_feed = LT_TEXT("Engine", "mm per revolution (G95)");
    control.start.assumed_motion = G::Line;
    control.start.assumed_motion_word = LT_TEXT("Engine", "G1");
    control.tools_have_names = true;
    control.dwell = {{'S', DwellWord::Unit::Revolutions}, {'F', DwellWord::Unit::Seconds}};
    control.css_is_per_revolution = true;
    control.thread_lead_is_ik = true;
    control.call_letter = 'L';
    control.program_head = "%_N_";
    return control;
}

}  // namespace lathelier::gcode
