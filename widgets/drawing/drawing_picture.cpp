#include "widgets/drawing/drawing_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/cad/cad_notes.h"
#include "engine/core/json.h"
#include "engine/core/shaft_contour.h"
#include "engine/core/shaft_item.h"
#include "engine/core/shaft_rules.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/project/project_codes.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/report/result_json.h"
#include "widgets/drawing/part_store.h"

namespace lathelier::drawing_panel {
namespace {

const project::Source* sourceOf(const project::PanelState& state)
{
    const auto source = state.inputs.find(shaftRole);
    return source == state.inputs.end() ? nullptr : &source->second;
}

void takeItem(DrawingPicture& picture, const project::PanelState& state, const project::Source& source)
{
    const auto item = state.items.find(shaftRole);
    std::optional<Shaft> shaft;
    if (item != state.items.end() && item->second.kind == shaftItem) shaft = shaftOf(item->second.values);
    if (!shaft) throw Error(errors::itemNotThere, {{"item", source.item}, {"kind", std::string(shaftItem)}});
    picture.shaft = *std::move(shaft);
    const std::string content = toJson(item->second.values).dump();
    picture.inputs = {{source.item, static_cast<std::int64_t>(content.size()), io::sha256(content)}};
    picture.synthetic = source.synthetic;
}

void takeFile(DrawingPicture& picture, const project::Source& source, Stores& stores, const Progress& progress)
{
    const auto loaded = stores.of<PartStore>()->load(source, progress);
    picture.shaft = loaded->file.shaft;
    if (picture.shaft.name.empty()) picture.shaft.name = std::filesystem::path(source.path).stem().string();
    picture.inputs = {loaded->inputs.front()};
    picture.notes = loaded->file.notes;
    picture.synthetic = source.synthetic || contains(loaded->file.notes, notes::syntheticData);
}

/// The table where it was changed; where the file it came from is gone by now, the table is enough.
void chooseShaft(DrawingPicture& picture, const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const DrawingQuestion& question = picture.question;
    const bool table_rules = !question.segments.empty() && question.segments_of == identity(state);
    if (const project::Source* source = sourceOf(state)) {
        try {
            if (source->item.empty())
                takeFile(picture, *source, stores, progress);
            else
                takeItem(picture, state, *source);
        } catch (const Error&) {
            if (!table_rules) throw;
        }
        if (table_rules && picture.shaft.segments != question.segments)
            picture.notes.push_back(
                {notes::shaftChanged, {{"source", source->item.empty() ? source->path : source->item}}});
    }
    if (table_rules || picture.shaft.segments.empty()) picture.shaft.segments = question.segments;
    if (!question.name.empty()) picture.shaft.name = question.name;
}

void chooseMaterial(DrawingPicture& picture)
{
    const auto [entry, name] = chatter_common::chosen(picture.question.material);
    if (!entry) return;
    picture.shaft.material = entry->value;
    picture.notes.push_back({notes::materialOfLibrary, {{"material", name}, {"source", entry->source}}});
}

/// The date of today as ISO 8601 has it.
std::string today()
{
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    return fmt::format("{:04}-{:02}-{:02}", local.tm_year + 1900, local.tm_mon + 1, local.tm_mday);
}

std::optional<drawing::Sheet> sheetOf(SheetChoice choice)
{
    switch (choice) {
        case SheetChoice::A4: return drawing::Sheet::A4Landscape;
        case SheetChoice::A4Portrait: return drawing::Sheet::A4Portrait;
        case SheetChoice::A3: return drawing::Sheet::A3Landscape;
        case SheetChoice::Automatic: break;
    }
    return std::nullopt;
}

std::string decimalSeparator(const Language& language)
{
    const std::string half = fixed(0.5, 1, language);
    return half.size() > 2 ? half.substr(1, half.size() - 2) : ".";
}

double largestDiameter_mm(const Shaft& shaft)
{
    double largest_mm = 0;
    for (const ShaftSegment& row : shaft.segments)
        largest_mm = std::max({largest_mm, row.start_diameter_mm, row.end_diameter_mm});
    return largest_mm;
}

}  // namespace

std::string identity(const project::PanelState& state)
{
    const project::Source* source = sourceOf(state);
    if (!source) return {};
    return source->item.empty() ? source->path : "item " + source->item;
}

DrawingPicture drawingPicture(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    DrawingPicture picture;
    picture.question = fromValues<DrawingQuestion>(state.parameters);
    chooseShaft(picture, state, stores, progress.part(0, 0.8, LT_TEXT("Engine", "Reading")));
    chooseMaterial(picture);
    picture.remarks = checkShaft(picture.shaft);
    const Notes left_out = cad::cadNotes(picture.shaft);
    picture.remarks.insert(picture.remarks.end(), left_out.begin(), left_out.end());
    std::erase_if(picture.notes, [&](const Note& note) {  // of the file: said again
        return std::any_of(picture.remarks.begin(), picture.remarks.end(),
                           [&](const Note& remark) { return remark.code.key == note.code.key; });
    });
    picture.notes.insert(picture.notes.end(), picture.remarks.begin(), picture.remarks.end());
    picture.mass_kg = drawing::massInKilograms(picture.shaft);
    return picture;
}

drawing::Drawing drawingOf(const DrawingPicture& picture, const Language& language)
{
    const DrawingQuestion& question = picture.question;
    drawing::DrawingOptions options;
    options.sheet = sheetOf(question.sheet);
    options.material = question.material_name;
    options.date = question.date.empty() ? today() : question.date;
    options.decimal_separator = decimalSeparator(language);
    options.measured = question.measured;
    options.translate = [&language](Text english) { return text(english, language); };
    return drawing::drawShaft(picture.shaft, options);
}

report::Answer answerOf(const DrawingPicture& picture)
{
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Length");
    answer.value = picture.shaft.length_mm();
    answer.unit = millimetre;
    const bool plain = picture.remarks.empty();
    answer.verdict_words = plain ? LT_TEXT("Engine", "no remarks") : LT_TEXT("Engine", "with remarks");
    answer.sentence = picture.mass_kg
                          ? LT_TEXT("Engine", "Mass {mass_kg:3} kg · largest diameter {diameter_mm:3} mm · {rows} rows")
                          : LT_TEXT("Engine",
                                    "Mass not known without a material · largest diameter {diameter_mm:3} mm · {rows} "
                                    "rows");
    answer.values = {{"mass_kg", picture.mass_kg ? Value(*picture.mass_kg) : Value()},
                     {"diameter_mm", largestDiameter_mm(picture.shaft)},
                     {"rows", static_cast<std::int64_t>(picture.shaft.segments.size())}};
    return answer;
}

report::Table rowsTable(const DrawingPicture& picture, const Language& language)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Rows from the free end");
    table.columns = {LT_TEXT("Engine", "Row"),
                     LT_TEXT("Engine", "Kind"),
                     report::Labelled{LT_TEXT("Engine", "z from"), millimetre},
                     report::Labelled{LT_TEXT("Engine", "z to"), millimetre},
                     report::Labelled{LT_TEXT("Engine", "Start ⌀"), millimetre},
                     report::Labelled{LT_TEXT("Engine", "End ⌀"), millimetre},
                     report::Labelled{LT_TEXT("Engine", "Arc radius"), millimetre},
                     LT_TEXT("Engine", "Role")};
    table.decimals = {0, 0, 3, 3, 3, 3, 3, 0};
    const auto add = [&](std::string number, double from_mm, double to_mm, const auto& row) {
        const Text kind = row.arc_radius_mm                              ? LT_TEXT("Engine", "arc")
                          : row.start_diameter_mm == row.end_diameter_mm ? LT_TEXT("Engine", "cylinder")
                                                                         : LT_TEXT("Engine", "cone");
        table.rows.push_back({std::move(number), text(kind, language), from_mm, to_mm, row.start_diameter_mm,
                              row.end_diameter_mm, row.arc_radius_mm ? Value(*row.arc_radius_mm) : Value(), row.role});
    };
    double z_mm = 0;
    int number = 0;
    for (const ShaftSegment& row : picture.shaft.segments) {
        add(std::to_string(++number), z_mm, z_mm + row.length_mm, row);
        z_mm += row.length_mm;
    }
    int bores = 0;
    for (const ShaftBore& bore : picture.shaft.bores) {
        const double sense = bore.from == ShaftEnd::Free ? 1 : -1;
        double at_mm = sense > 0 ? 0 : z_mm;
        ++bores;
        for (std::size_t i = 0; i < bore.segments.size(); ++i) {
            const double end_mm = at_mm + sense * bore.segments[i].length_mm;
            add(fmt::format("B{}.{}", bores, i + 1), at_mm, end_mm, bore.segments[i]);
            at_mm = end_mm;
        }
    }
    return table;
}

report::Table remarksTable(const DrawingPicture& picture, const Language& language)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Remarks");
    table.columns = {LT_TEXT("Engine", "Remark")};
    for (const Note& remark : picture.remarks) table.rows.push_back({text(remark, language)});
    if (table.rows.empty())
        table.rows.push_back({text(LT_TEXT("Engine", "There is nothing to remark on this shaft."), language)});
    return table;
}

report::Document reportOf(const DrawingPicture& picture, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Shaft for drawing and CAD");
    document.inputs = picture.inputs;
    document.synthetic = picture.synthetic;
    report::Section section{LT_TEXT("Engine", "Result"), {answerOf(picture), rowsTable(picture, language)}};
    if (!picture.notes.empty()) section.blocks.push_back(picture.notes);
    document.sections = {std::move(section)};
    Json json = {{"shaft", toJson(toValues(picture.shaft))},
                 {"length_mm", picture.shaft.length_mm()},
                 {"volume_mm3", volume_mm3(picture.shaft)},
                 {"mass_kg", picture.mass_kg ? Json(*picture.mass_kg) : Json(nullptr)}};
    document.results = {
        report::toText(report::wholeResult("draw", picture.inputs, toValues(picture.question), json, picture.notes))};
    return document;
}

}  // namespace lathelier::drawing_panel
