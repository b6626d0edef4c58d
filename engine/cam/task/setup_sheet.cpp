#include "engine/cam/task/setup_sheet.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "engine/cam/plan_quantities.h"
#include "engine/cam/plan_report.h"
#include "engine/core/units.h"
#include "engine/io/file.h"
#include "engine/report/html.h"
#include "engine/report/understanding_report.h"

namespace lathelier::cam {
namespace {

using gcode::Block;
using gcode::Program;
using gcode::Word;
using gcode::WordKind;

constexpr int wholeStop = 0, optionalStop = 1, clockwise = 3, anticlockwise = 4;  // M words, the same in every control

const Text perMinute = LT_TEXT("Engine", "1/min");

bool isM(const Word& word, int number)
{
    return word.letter == 'M' && word.kind == WordKind::Number && std::lround(word.value) == number;
}

/// The comments directly above a block, without their marks: what its author says of it.
std::string saidAbove(const Program& program, std::size_t block)
{
    std::string said;
    while (block-- > 0) {
        const Block& above = program.blocks[block];
        if (above.word_count != 1 || program.words[above.first_word].kind != WordKind::Comment) break;
        std::string text(program.textOf(program.words[above.first_word]));
        const std::size_t from = text.find_first_not_of("(; ");
        const std::size_t to = text.find_last_not_of(") \r");
        text = from == std::string::npos ? std::string() : text.substr(from, to - from + 1);
        said = said.empty() ? text : text.append(" · ").append(said);
    }
    return said;
}

/// Program stops with what is done there.
report::Table stopTable(const Program& program)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Stops");
    table.columns = {LT_TEXT("Engine", "Line"), LT_TEXT("Engine", "Stop"), LT_TEXT("Engine", "What is done there")};
    table.decimals = {0, 0, 0};
    for (std::size_t b = 0; b < program.blocks.size(); ++b)
        for (std::uint32_t i = 0; i < program.blocks[b].word_count; ++i) {
            const Word& word = program.words[program.blocks[b].first_word + i];
            if (!isM(word, wholeStop) && !isM(word, optionalStop)) continue;
            const std::string said = saidAbove(program, b);
            table.rows.push_back({static_cast<std::int64_t>(b) + 1,
                                  isM(word, wholeStop) ? LT_TEXT("Engine", "stop") : LT_TEXT("Engine", "optional stop"),
                                  said.empty() ? Value() : Value(said)});
        }
    return table;
}

bool isOpen(const Value& value)
{
    return std::holds_alternative<std::monostate>(value);
}

/// How a program calls a tool, and the sense in which the spindle turns for it.
struct ToolCall {
    std::string words;  ///< "T0101", "T1 D1"; empty: none found
    Value spindle;      ///< none: no M3, M4
};

ToolCall callOf(const CheckResult& check, int tool)
{
    ToolCall call;
    const auto& moves = check.path.moves;
    const auto first =
        std::find_if(moves.begin(), moves.end(), [tool](const gcode::Move& move) { return move.tool == tool; });
    if (first == moves.end()) return call;
    const auto before = first == moves.begin() ? std::int64_t{0} : std::prev(first)->line;
    for (auto b = static_cast<std::size_t>(std::max<std::int64_t>(before, 1) - 1); b < check.program.blocks.size();
         ++b) {
        const Block& block = check.program.blocks[b];
        const bool is_before = static_cast<std::int64_t>(b) < first->line;
        std::string words;
        for (std::uint32_t i = 0; i < block.word_count; ++i) {
            const Word& word = check.program.words[block.first_word + i];
            if (word.letter == 'T' || (word.letter == 'D' && !words.empty()))
                words.append(words.empty() ? "" : " ").append(check.program.textOf(word));
            if (isM(word, clockwise) && isOpen(call.spindle)) call.spindle = LT_TEXT("Engine", "clockwise (M3)");
            if (isM(word, anticlockwise) && isOpen(call.spindle))
                call.spindle = LT_TEXT("Engine", "anticlockwise (M4)");
        }
        if (!words.empty() && !is_before) break;  // the next tool
        if (!words.empty()) call.words = words;
    }
    return call;
}

/// The tools of one clamping in the order of their use.
report::Table usedTools(const TurningPlan& plan, const SetupPlan& setup)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Tools");
    table.columns = {LT_TEXT("Engine", "Tool"),
                     LT_TEXT("Engine", "Call in the program"),
                     LT_TEXT("Engine", "Use"),
                     LT_TEXT("Engine", "Name"),
                     LT_TEXT("Engine", "Insert"),
                     LT_TEXT("Engine", "Holder"),
                     report::Labelled{LT_TEXT("Engine", "Radius"), unit::mm},
                     LT_TEXT("Engine", "Tip"),
                     report::Labelled{LT_TEXT("Engine", "Width, diameter"), unit::mm},
                     LT_TEXT("Engine", "Cuts"),
                     LT_TEXT("Engine", "Spindle")};
    table.decimals = {0, 0, 0, 0, 0, 0, 3, 0, 3, 0, 0};
    std::vector<int> listed;
    for (const PlannedOperation& operation : setup.operations) {
        if (std::find(listed.begin(), listed.end(), operation.tool) != listed.end()) continue;
        listed.push_back(operation.tool);
        const JobTool* const tool = plan.job.tool(operation.tool);
        if (!tool) continue;
        const std::optional<double>& across_mm = tool->isDrill() ? tool->diameter_mm : tool->width_mm;
        const ToolCall call = callOf(setup.check, operation.tool);
        const auto stated = [](const std::string& text) { return text.empty() ? Value() : Value(text); };
        table.rows.push_back(
            {std::int64_t{tool->number}, stated(call.words), nameOf(tool->use), stated(tool->name),
             stated(tool->insert), stated(tool->holder_name), tool->isDrill() ? Value() : Value(tool->radius_mm()),
             tool->isDrill() ? Value() : Value(std::int64_t{tool->tip}), across_mm ? Value(*across_mm) : Value(),
             tool->hand == Hand::TowardChuck ? LT_TEXT("Engine", "toward the chuck")
                                             : LT_TEXT("Engine", "from the chuck"),
             call.spindle});
    }
    return table;
}

report::Table operationsInOrder(const SetupPlan& setup)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Operations");
    table.columns = {LT_TEXT("Engine", "No."),
                     LT_TEXT("Engine", "Operation"),
                     LT_TEXT("Engine", "Tool"),
                     LT_TEXT("Engine", "First line"),
                     report::Labelled{LT_TEXT("Engine", "Cutting speed"), unit::m_min},
                     report::Labelled{LT_TEXT("Engine", "Speed"), perMinute},
                     report::Labelled{LT_TEXT("Engine", "Largest feed, lead"), LT_TEXT("Engine", "mm/rev")},
                     report::Labelled{LT_TEXT("Engine", "Depth"), unit::mm},
                     report::Labelled{LT_TEXT("Engine", "Time"), unit::s}};
    table.decimals = {0, 0, 0, 0, 0, 0, 3, 2, 1};
    for (std::size_t i = 0; i < setup.operations.size(); ++i) {
        const PlannedOperation& operation = setup.operations[i];
        const Operation& exact = setup.moves[i];
        double feed_mm_rev = 0;
        for (const CutMove& move : exact.moves) feed_mm_rev = std::max(feed_mm_rev, move.feed_mm_rev);
        table.rows.push_back({static_cast<std::int64_t>(i) + 1, nameOf(operation.kind), std::int64_t{operation.tool},
                              operation.first_line > 0 ? Value(operation.first_line) : Value(),
                              exact.speed_rpm ? Value() : Value(exact.cutting_speed_m_min),
                              exact.speed_rpm ? Value(*exact.speed_rpm) : Value(), feed_mm_rev,
                              operation.depth_mm > 0 ? Value(operation.depth_mm) : Value(), operation.time_s});
    }
    return table;
}

report::QuantityTable partTable(const TurningPlan& plan)
{
    const JobStock& stock = plan.job.stock;
    double largest_mm = 0;
    for (const ShaftSegment& row : plan.part.segments)
        largest_mm = std::max({largest_mm, row.start_diameter_mm, row.end_diameter_mm});
    const auto stated = [](const std::string& text) { return text.empty() ? Value() : Value(text); };
    return {LT_TEXT("Engine", "Part and stock"),
            {{LT_TEXT("Engine", "Part"), stated(plan.part.name), {}},
             {LT_TEXT("Engine", "Job"), stated(plan.job.title), {}},
             {LT_TEXT("Engine", "Length"), plan.part.length_mm(), unit::mm},
             {LT_TEXT("Engine", "Largest diameter"), largest_mm, unit::mm},
             {LT_TEXT("Engine", "Material"), stated(plan.job.cutting.material), {}},
             {LT_TEXT("Engine", "Bar diameter"), stock.diameter_mm, unit::mm},
             {LT_TEXT("Engine", "Bar length"),
              stock.length_mm ? Value(*stock.length_mm) : Value(LT_TEXT("Engine", "not stated")),
              stock.length_mm ? unit::mm : Text{}},
             {LT_TEXT("Engine", "Faced off"), stock.face_allowance_mm, unit::mm}}};
}

/// How the work is held, and where the program's zero is.
report::QuantityTable clampingTable(const SetupPlan& setup)
{
    const JobSetup& held = setup.clamping.job.setup;
    const auto or_not = [](const std::optional<double>& value) {
        return value ? Value(*value) : Value(LT_TEXT("Engine", "not stated"));
    };
    report::QuantityTable table{LT_TEXT("Engine", "Clamping"), {}};
    auto& rows = table.rows;
    rows.push_back({LT_TEXT("Engine", "End that is turned"),
                    setup.clamping.is_mirrored ? LT_TEXT("Engine", "the other end: the work is turned round")
                                               : LT_TEXT("Engine", "the free end of the drawing"),
                    {}});
    rows.push_back({LT_TEXT("Engine", "Zero point Z0"), quantityOf<SetupPlan>("z_zero").get(setup), {}});
    rows.push_back({LT_TEXT("Engine", "Chuck face at Z"), setup.z_zero_mm - held.chuck_face_z_mm, unit::mm});
    rows.push_back({LT_TEXT("Engine", "Stands out of the chuck before facing"),
                    held.chuck_face_z_mm + setup.clamping.job.stock.face_allowance_mm, unit::mm});
    rows.push_back({LT_TEXT("Engine", "Diameter of the jaws"), or_not(held.jaw_diameter_mm), unit::mm});
    rows.push_back({LT_TEXT("Engine", "Clamped at least"), or_not(held.grip_length_mm), unit::mm});
    if (held.tailstock)
        rows.push_back({LT_TEXT("Engine", "Tailstock, centre hole up to"), held.tailstock->centre_hole_mm, unit::mm});
    else
        rows.push_back({LT_TEXT("Engine", "Tailstock"), LT_TEXT("Engine", "none"), {}});
    if (setup.clamping.cut_off_to_mm)
        rows.push_back({LT_TEXT("Engine", "Cut off first to"), *setup.clamping.cut_off_to_mm, unit::mm});
    if (setup.clamping.parts_off)
        rows.push_back({LT_TEXT("Engine", "Cut off at Z"), setup.z_zero_mm - setup.clamping.part_off_z_mm, unit::mm});
    const std::optional<double>& limit = setup.clamping.job.max_rpm;
    rows.push_back({limit ? LT_TEXT("Engine", "Speed limit of the spindle")
                          : LT_TEXT("Engine", "Speed limit of the spindle (assumed)"),
                    limit.value_or(assumedLimit_rpm), perMinute, 0});
    return table;
}

report::QuantityTable programTable(const TurningPlan& plan, const SetupPlan& setup)
{
    const auto lines = static_cast<std::int64_t>(std::count(setup.text.begin(), setup.text.end(), '\n'));
    return {LT_TEXT("Engine", "Program"),
            {{LT_TEXT("Engine", "File"),
              setup.program.empty() ? Value(LT_TEXT("Engine", "not written"))
                                    : Value(std::filesystem::path(setup.program).filename().string()),
              {}},
             {"SHA-256", io::sha256(setup.text), {}},
             {LT_TEXT("Engine", "Control"), plan.post, {}},
             {LT_TEXT("Engine", "Lines"), lines, {}},
             {LT_TEXT("Engine", "Time with tool changes"), setup.time_s, unit::s, 1}}};
}

report::Section clampingSection(const TurningPlan& plan, std::size_t number, const Language& language)
{
    const SetupPlan& setup = plan.setups[number];
    report::Section section{
        number == 0 ? LT_TEXT("Engine", "First clamping") : LT_TEXT("Engine", "Second clamping"),
        {clampingTable(setup), programTable(plan, setup), usedTools(plan, setup), operationsInOrder(setup)}};
    if (report::Table stops = stopTable(setup.check.program); !stops.rows.empty())
        section.blocks.emplace_back(std::move(stops));
    if (setup.check.stock) section.blocks.emplace_back(meridianPlot(plan, number, language));
    return section;
}

}  // namespace

report::Document setupSheet(const TurnOutcome& outcome, const Language& language)
{
    const TurningPlan& plan = *outcome.plan;
    report::Document sheet;
    sheet.title = LT_TEXT("Engine", "Set-up sheet");
    sheet.inputs = outcome.sources.inputs;
    sheet.synthetic = outcome.sources.synthetic;
    sheet.sections.push_back({LT_TEXT("Engine", "Work"), {answer(outcome, language), partTable(plan)}});
    for (std::size_t i = 0; i < plan.setups.size(); ++i) sheet.sections.push_back(clampingSection(plan, i, language));
    report::Section left{LT_TEXT("Engine", "What is left"), {}};
    if (!plan.rest.empty()) left.blocks.emplace_back(restTable(plan));
    if (!plan.not_made.empty()) left.blocks.emplace_back(notMadeTable(plan));
    if (!outcome.notes.empty()) left.blocks.emplace_back(outcome.notes);
    if (left.blocks.empty())
        left.blocks.emplace_back(report::Paragraph{LT_TEXT("Engine", "Nothing stays on the drawing."), {}});
    sheet.sections.push_back(std::move(left));
    if (auto understood = report::understandingSection(outcome.understanding))
        sheet.sections.push_back(*std::move(understood));
    return sheet;
}

void writeSetupSheet(const TurnOutcome& outcome, const std::string& path, const Language& language)
{
    requireWritable(outcome);
    io::writeFile(path, report::toHtml(setupSheet(outcome, language), language));
}

}  // namespace lathelier::cam
