#include "engine/gcode/word_tables.h"

#include <array>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <string>

#include "engine/gcode/gcode_codes.h"

namespace lathelier::gcode {
namespace {

using Table = std::array<G, 8000>;  ///< by ten times the number

struct Entry {
    int code10;
    G meaning;
};

void fillTable(Table& table, std::initializer_list<Entry> entries)
{
    for (const Entry& entry : entries) table.at(static_cast<std::size_t>(entry.code10)) = entry.meaning;
}

void fillTable(Table& table, G meaning, std::initializer_list<int> codes)
{
    for (const int code : codes) table.at(static_cast<std::size_t>(code) * 10) = meaning;
}

Table common()
{
    Table table{};
    fillTable(table, {{0, G::Rapid},
                      {10, G::Line},
                      {20, G::ArcCw},
                      {30, G::ArcCcw},
                      {40, G::Dwell},
                      {170, G::PlaneOther},
                      {180, G::PlaneZX},
                      {190, G::PlaneOther},
                      {400, G::NoseOff},
                      {410, G::NoseLeft},
                      {420, G::NoseRight},
                      {960, G::CssOn},
                      {970, G::CssOff}});
    return table;
}

Table fanuc(bool isHaas)
{
    Table table = common();
    fillTable(table, {{200, G::Inch},      {210, G::Metric},        {280, G::Home},        {300, G::Home},
                      {320, G::Thread},    {500, G::SpeedLimit},    {520, G::Shift},       {530, G::MachineMove},
                      {650, G::MacroCall}, {700, G::Finish},        {710, G::RoughTurn},   {720, G::RoughFace},
                      {730, G::Pattern},   {740, G::FacePeck},      {750, G::TurnPeck},    {760, G::ThreadMulti},
                      {800, G::CycleOff},  {900, G::TurnCycle},     {920, G::ThreadCycle}, {940, G::FaceCycle},
                      {980, G::PerMinute}, {990, G::PerRevolution}, {330, G::Thread}});
    fillTable(table, G::Drill, {81, 82, 83, 84, 85, 86, 87, 88, 89});
    fillTable(table, G::WorkOffset, {54, 55, 56, 57, 58, 59});
    fillTable(table, G::NoEffect, {9, 22, 23, 25, 26, 61, 64, 67, 69, 27, 43, 44, 49, 63, 62});
    fillTable(table, G::NotModelled, {5, 7, 8, 10, 11, 12, 13, 31, 34, 35, 36, 37, 51, 66, 68, 107, 112, 113});
    fillTable(
        table,
        {{71, G::NotModelled}, {121, G::NotModelled}, {131, G::NoEffect}, {102, G::NotModelled}, {541, G::WorkOffset}});
    if (isHaas) {
        fillTable(table, G::NoEffect, {14, 103, 105, 187, 199, 29, 47, 160, 161});
        fillTable(table, G::NotModelled, {77, 95, 101, 114, 115, 178, 179, 184, 186, 195, 196, 198});
        fillTable(table, G::WorkOffset, {154, 110, 111});
        fillTable(table, {{950, G::Drill}, {1130, G::NoEffect}});
    }
    return table;
}

Table linuxCnc()
{
    Table table = common();
    fillTable(table, {{70, G::Diameter},        {80, G::Radius},       {200, G::Inch},        {210, G::Metric},
                      {280, G::Home},           {300, G::Home},        {330, G::Thread},      {411, G::NoseLeft},
                      {421, G::NoseRight},      {530, G::MachineMove}, {520, G::Shift},       {760, G::ThreadMulti},
                      {800, G::CycleOff},       {900, G::Absolute},    {910, G::Incremental}, {901, G::ArcAbsolute},
                      {911, G::ArcIncremental}, {930, G::InverseTime}, {940, G::PerMinute},   {950, G::PerRevolution},
                      {920, G::Shift}});
    fillTable(table, G::Drill, {73, 81, 82, 83, 84, 85, 86, 87, 88, 89});
    fillTable(table, G::WorkOffset, {54, 55, 56, 57, 58, 59});
    fillTable(table, {{591, G::WorkOffset}, {592, G::WorkOffset}, {593, G::WorkOffset}});
    fillTable(table, G::NoEffect, {43, 49, 61, 64, 98, 99});
    fillTable(table, {{431, G::NoEffect},
                      {432, G::NoEffect},
                      {611, G::NoEffect},
                      {281, G::NoEffect},
                      {301, G::NoEffect},
                      {921, G::NoEffect},
                      {922, G::NoEffect},
                      {923, G::NoEffect}});
    fillTable(table, G::NotModelled, {5, 10, 70, 71, 72});
    fillTable(table, {{51, G::NotModelled},
                      {52, G::NotModelled},
                      {53, G::NotModelled},
                      {331, G::NotModelled},
                      {382, G::NotModelled},
                      {383, G::NotModelled},
                      {384, G::NotModelled},
                      {385, G::NotModelled},
                      {711, G::NotModelled},
                      {712, G::NotModelled},
                      {721, G::NotModelled},
                      {722, G::NotModelled},
                      {171, G::PlaneOther},
                      {181, G::PlaneOther},
                      {191, G::PlaneOther}});
    return table;
}

Table sinumerik()
{
    Table table = common();
    fillTable(table, {{330, G::Thread},
                      {700, G::Inch},
                      {710, G::Metric},
                      {740, G::FixedPoint},
                      {750, G::FixedPoint},
                      {900, G::Absolute},
                      {910, G::Incremental},
                      {940, G::PerMinute},
                      {950, G::PerRevolution},
                      {930, G::InverseTime},
                      {530, G::MachineMove},
                      {1530, G::MachineMove},
                      {250, G::NoEffect},
                      {260, G::SpeedLimit},
                      {961, G::CssOn},
                      {971, G::CssOff}});
    fillTable(table, G::WorkOffset, {54, 55, 56, 57});
    fillTable(table, G::NoEffect, {9, 60, 64, 450, 451, 452});
    fillTable(table, G::NotModelled, {34, 35, 63, 331, 332, 110, 111, 112, 58, 59});
    return table;
}

const Table& tableOf(Dialect dialect)
{
    static const Table fanucTable = fanuc(false), haasTable = fanuc(true), linuxTable = linuxCnc(),
                       sinumerikTable = sinumerik();
    switch (dialect) {
        case Dialect::Haas: return haasTable;
        case Dialect::LinuxCnc: return linuxTable;
        case Dialect::Sinumerik: return sinumerikTable;
        default: return fanucTable;
    }
}

bool isModelledLetter(Dialect dialect, char letter)
{
    const std::string_view all = dialect == Dialect::LinuxCnc    ? "NOGMXZIKRFSTPQLDHEJ"
                                 : dialect == Dialect::Sinumerik ? "NGMXZIKFSTDLP"
                                                                 : "NOGMXZUWIKRFSTPQLDEAcr";
    return all.find(letter) != std::string_view::npos;
}

void mark(Program& program, const Block& block, Word& word, const NoteCode& code)
{
    word.is_understood = false;
    report(program, program.diagnostics, block, word.begin, code, {{"found", shown(program, program.textOf(word))}});
}

bool isKnownName(std::string_view name)
{
    std::string upper(name.substr(0, name.find_first_of("=([: ")));
    for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (name.ends_with(':')) return true;
    for (const char* known :
         {"DIAMON", "DIAMOF", "DIAM90", "LIMS",  "CR",    "MSG",  "CHF",   "CHR",     "RND",       "RNDM",  "AR",
          "SF",     "CIP",    "I1",     "K1",    "X1",    "Z1",   "FP",    "SUPA",    "STOPRE",    "T",     "D",
          "S1",     "M1",     "S2",     "M2",    "G",     "SPOS", "FFWON", "FFWOF",   "SOFT",      "BRISK", "SETMS",
          "WAITMC", "CUT2D",  "CUT2DF", "NORM",  "KONT",  "FRC",  "FRCM",  "ENDPROC", "DISPLOF",   "SAVE",  "COMPOF",
          "CFTCP",  "CFC",    "CFIN",   "SBLOF", "SBLON", "G601", "G602",  "F",       "WORKPIECE", "G700"})
        if (upper == known) return true;
    return false;
}

/// Classifies G and M words with literal numbers; computed ones are classified at run time.
void classifyNumber(Program& program, const Block& block, Word& word)
{
    const Dialect dialect = program.dialect;
    if (word.letter == 'G') {
        const double code10 = word.value * 10;
        const G meaning = code10 >= 0 && code10 < 1e6 && std::abs(code10 - std::round(code10)) < 1e-6
                              ? meaningOf(dialect, static_cast<int>(std::lround(code10)))
                              : G::Unknown;
        if (meaning == G::Unknown) mark(program, block, word, notes::ncWordUnknown);
        if (meaning == G::NotModelled) mark(program, block, word, notes::ncWordNotModelled);
    } else if (word.letter == 'M') {
        if (word.value < 0 || word.value > 9999 || !isKnownM(dialect, static_cast<int>(word.value)))
            mark(program, block, word, notes::ncWordUnknown);
    } else if (!isModelledLetter(dialect, word.letter)) {
        const bool isAxis = std::string_view("YABCUVWHE").find(word.letter) != std::string_view::npos;
        mark(program, block, word, isAxis ? notes::ncWordNotModelled : notes::ncWordUnknown);
    }
}

}  // namespace

G meaningOf(Dialect dialect, int code10)
{
    if (code10 < 0) return G::Unknown;
    if (dialect == Dialect::Sinumerik) {
        if (code10 == 7000) return G::InchAll;
        if (code10 == 7100) return G::MetricAll;
        if (code10 == 5000 || (code10 >= 5050 && code10 <= 5990)) return G::WorkOffset;
        if (code10 == 9610 || code10 == 9620) return G::CssOn;
        if (code10 == 9710 || code10 == 9720 || code10 == 9730) return G::CssOff;
        if (code10 == 4500 || code10 == 4510 || code10 == 6010 || code10 == 6020 || code10 == 6410 || code10 == 6420 ||
            code10 == 2900 || code10 == 2910)
            return G::NoEffect;
    }
    return code10 < 8000 ? tableOf(dialect)[static_cast<std::size_t>(code10)] : G::Unknown;
}

bool isKnownM(Dialect dialect, int number)
{
    if (dialect == Dialect::LinuxCnc) {
        for (const int m : {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  19, 30, 48, 49, 50, 51, 52,
                            53, 60, 61, 62, 63, 64, 65, 66, 67, 68, 70, 71, 72, 73, 98, 99})
            if (m == number) return true;
        return number >= 100 && number <= 199;
    }
    return number <= 99 || (isFanucLike(dialect) && number <= 299);  // most are assigned by the machine builder
}

void classifyWords(Program& program, Block& block)
{
    for (std::uint32_t i = 0; i < block.word_count; ++i) {
        Word& word = program.words[block.first_word + i];
        switch (word.kind) {
            case WordKind::Number:
                if (word.letter != 0)
                    classifyNumber(program, block, word);
                else if (!isKnownName(program.textOf(word)))
                    mark(program, block, word, notes::ncWordUnknown);
                break;
            case WordKind::Expression:
                if (word.letter != 0 && word.letter != 'G' && word.letter != 'M') {
                    if (!isModelledLetter(program.dialect, word.letter))
                        mark(program, block, word, notes::ncWordNotModelled);
                } else if (word.letter == 0 && !isKnownName(program.textOf(word))) {
                    mark(program, block, word, notes::ncWordUnknown);
                }
                break;
            case WordKind::Name:
            case WordKind::Call:
                if (!isKnownName(program.textOf(word))) mark(program, block, word, notes::ncWordUnknown);
                break;
            default: break;
        }
    }
}

}  // namespace lathelier::gcode
