// inspect FILE...: facts of each file.
#include <nlohmann/json.hpp>

#include "app/cli/verbs.h"
#include "engine/core/texts.h"
#include "engine/io/facts_json.h"
#include "engine/report/plain_text.h"

namespace lathelier::cli {
namespace {

std::string corner(const std::optional<std::array<double, 3>>& point)
{
    if (!point) return {};
    return text(Value((*point)[0])) + "  " + text(Value((*point)[1])) + "  " + text(Value((*point)[2]));
}

/// "type 58, line 2, function 4"; what an item does not have is left out.
std::string itemText(const Row& row)
{
    std::string line;
    for (const auto& [name, value] : row.cells) {
        if (std::holds_alternative<std::monostate>(value)) continue;
        if (!line.empty()) line += ", ";
        line.append(name).append(" ").append(text(value));
    }
    return line;
}

/// A list gives one row per item, up to a limit.
void addDetail(const std::string& name, const Value& value, report::QuantityTable& table)
{
    constexpr std::size_t mostItems = 100;
    const auto* list = std::get_if<Rows>(&value);
    if (!list) {
        table.rows.push_back({name, value, {}});
        return;
    }
    table.rows.push_back({name, static_cast<std::int64_t>(list->rows.size()), {}});
    for (std::size_t k = 0; k < std::min(list->rows.size(), mostItems); ++k)
        table.rows.push_back({name + ' ' + std::to_string(k + 1), itemText(list->rows[k]), {}});
}

/// The facts of one file as rows; what does not apply is left out.
report::QuantityTable factsTable(const io::FileFacts& facts)
{
    report::QuantityTable table{facts.path, {}};
    const auto add = [&table](Text name, const Value& value) {
        const auto* word = std::get_if<std::string>(&value);
        if (!word || !word->empty()) table.rows.push_back({name, value, {}});
    };
    add(LT_TEXT("Engine", "Format"), facts.format);
    add(LT_TEXT("Engine", "Encoding"), facts.encoding);
    add(LT_TEXT("Engine", "Delimiter"), facts.delimiter);
    add(LT_TEXT("Engine", "Decimal mark"), facts.decimal);
    add(LT_TEXT("Engine", "Unit"), facts.unit.empty() ? "" : facts.unit + " (" + facts.unit_source + ")");
    if (facts.rows > 0) add(LT_TEXT("Engine", "Rows"), facts.rows);
    if (facts.columns > 0) add(LT_TEXT("Engine", "Columns"), facts.columns);
    for (const auto& [name, value] : facts.details) addDetail(name, value, table);
    add(LT_TEXT("Engine", "Smallest x, y, z (mm)"), corner(facts.min_mm));
    add(LT_TEXT("Engine", "Largest x, y, z (mm)"), corner(facts.max_mm));
    for (const io::SkippedRow& row : facts.skipped)
        table.rows.push_back(
            {fill(text(LT_TEXT("Engine", "Skipped line {line}")), {{"line", row.line}}), row.reason, {}});
    return table;
}

report::Section factsSection(const std::vector<io::FileFacts>& files)
{
    report::Section section{LT_TEXT("Engine", "Files"), {}};
    for (const io::FileFacts& facts : files) section.blocks.push_back(factsTable(facts));
    return section;
}

/// All kinds of file read by any verb; anything else is treated as a cloud.
io::FileKinds knownKinds()
{
    io::FileKinds kinds;
    for (const Verb& verb : verbs()) io::unite(kinds, verb.kinds);
    return kinds;
}

io::FileFacts readFacts(const std::string& path, const Request& request, io::InputFiles& inputs,
                        const Progress& progress, Answer& answer)
{
    const std::string_view bytes = inputs.open(path, progress);
    const io::FileKind* kind = io::likeliestKind(knownKinds(), path, bytes, request.parameters).kind;
    io::FileFacts facts =
        (kind ? *kind : io::scanFiles()).facts({path, bytes, request.parameters, inputs, progress}, answer.notes);
    inputs.drop();
    return facts;
}

void runInspect(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    auto files = std::make_shared<std::vector<io::FileFacts>>();
    answer.json = [files] {
        Json result{{"files", Json::array()}};
        for (const io::FileFacts& facts : *files) result["files"].push_back(toJson(facts));
        return result;
    };
    const double share = 1.0 / static_cast<double>(request.operands.size());
    for (std::size_t i = 0; i < request.operands.size(); ++i) {
        const double done = static_cast<double>(i) * share;
        try {
            const Progress part = progress.part(done, done + share, LT_TEXT("Engine", "Reading"));
            files->push_back(readFacts(request.operands[i], request, inputs, part, answer));
            answer.understanding.add(files->back().understanding, request.operands[i]);
        } catch (Error& error) {  // the other files are answered all the same
            answer.errors.push_back(error.with("path", request.operands[i]));
        }
    }
    answer.summary = report::toPlainText(factsSection(*files));
    answer.report = [files, notes = answer.notes] {
        report::Document document;
        document.title = LT_TEXT("Engine", "What was understood of the files");
        document.sections = {factsSection(*files)};
        if (!notes.empty()) document.sections[0].blocks.push_back(notes);
        return document;
    };
}

}  // namespace

Verb inspectVerb(const io::FileKinds& kinds)
{
    return {
        "inspect",
        "Say what was understood of files: format, units, columns, rows, extent.",
        {{"FILE",
          "A point cloud or mesh (XYZ/ASC/CSV/TXT/PTS, PLY, PCD, STL, OBJ), a profile, a probe record "
          "(CSV, L-Graph .dat/.par), frequency responses (UFF, CSV, MAT), a shaft, a spindle or tap tests (JSON, stock "
          "text), an NC program, a picture (PNG, JPEG, TIFF), characteristics (Q-DAS .dfq), a recipe, an archive, "
          "or a link to a control (ASSIST.json).",
          true}},
        {},
        kinds,
        {},
        true,
        runInspect};
}

}  // namespace lathelier::cli
