#include "engine/cad/shaft_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "engine/cad/csv_columns.h"
#include "engine/cad/csv_marks.h"
#include "engine/cad/steps_view.h"
#include "engine/core/units.h"
#include "engine/core/visible.h"
#include "engine/io/io_codes.h"
#include "engine/io/table/table_cell.h"
#include "engine/io/table/table_layout.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/number.h"
#include "engine/io/text/text_lines.h"
#include "engine/shaft/shaft_codes.h"

namespace lathelier::cad {
namespace {

constexpr const char* outsideContour = "outside";
constexpr const char* boreFree = "bore_free";
constexpr const char* boreChuck = "bore_chuck";
constexpr std::array stepColumns = {
    "no", "x_mm", "y_mm", "radius_mm", "z_start_mm", "z_end_mm", "chamfer_start_mm", "chamfer_end_mm"};
constexpr std::size_t mostRows = 100000;

/// "=", "+", "-" and "@" begin a formula in a spreadsheet.
bool startsFormula(std::string_view text)
{
    return !text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos;
}

/// The text of a cell that foreign() wrote.
std::string_view withoutApostrophe(std::string_view cell)
{
    return cell.starts_with('\'') && startsFormula(cell.substr(1)) ? cell.substr(1) : cell;
}

class CsvWriter {
public:
    explicit CsvWriter(const CsvStyle& style) : style_(style) {}

    void cell(std::string_view text)
    {
        if (!first_) text_ += style_.delimiter;
        first_ = false;
        // A cell that begins with an apostrophe is taken for a quoted one by readers that know both marks.
        const bool isPlain = text.find_first_of(std::string("\"\r\n") + style_.delimiter) == std::string_view::npos;
        if (isPlain && !text.starts_with('\'')) {
            text_ += text;
            return;
        }
        text_ += '"';
        for (const char c : text) text_ += c == '"' ? '\'' : c == '\r' || c == '\n' ? ' ' : c;
        text_ += '"';
    }

    /// A text of unknown origin: hidden characters shown, and an apostrophe before what a spreadsheet would compute.
    void foreign(std::string_view text)
    {
        const std::string shown = visible(text);
        cell(std::string_view(startsFormula(shown) ? "'" + shown : shown));
    }

    void cell(double value)
    {
        std::string digits = fmt::format("{}", value == 0 ? 0.0 : value);
        std::replace(digits.begin(), digits.end(), '.', style_.decimal);
        cell(std::string_view(digits));
    }

    void cell(std::optional<double> value) { value ? cell(*value) : cell(std::string_view()); }

    void end()
    {
        text_ += '\n';
        first_ = true;
    }

    void remark(const std::string& content) { text_ += "# " + content + "\n"; }

    std::string take() { return std::move(text_); }

private:
    CsvStyle style_;
    std::string text_;
    bool first_ = true;
};

/// A bore row as an outside row, as both have the same columns.
ShaftSegment asSegment(const BoreSegment& row)
{
    return {row.length_mm, row.start_diameter_mm, row.end_diameter_mm, 0, row.arc_radius_mm,
            row.role,      row.tolerance,         row.measured};
}

void writeRow(CsvWriter& out, const char* contour, std::size_t number, double z_start_mm, double z_end_mm,
              const ShaftSegment& row)
{
    out.cell(std::string_view(contour));
    out.cell(static_cast<double>(number));
    out.cell(z_start_mm);
    out.cell(z_end_mm);
    for (const CsvColumn& column : csvColumns()) out.cell(column.get(row));
    out.foreign(row.role);
    out.foreign(row.tolerance ? std::string_view(row.tolerance->iso_class) : std::string_view());
    out.end();
}

char delimiterOf(std::string_view heading)
{
    for (const char c : {';', '\t'})
        if (heading.find(c) != std::string_view::npos) return c;
    return ',';
}

struct Line {
    std::int64_t number = 0;
    std::string_view text;
    std::vector<io::Cell> cells;
};

/// The table of a text: heading and rows, without blank lines and remarks.
class CsvTable {
public:
    CsvTable(std::string_view text, const Progress& progress)
    {
        for (io::Lines lines(text); lines.next();) {
            if (lines.number() % 1024 == 0) progress.check();
            const std::string_view content = io::trimmed(lines.line());
            if (content.empty() || content.front() == '#') continue;
            if (lines_.empty()) delimiter_ = delimiterOf(content);
            Line line{lines.number(), lines.line(), {}};
            io::splitFields(lines.line(), delimiter_, line.cells);
            if (!lines_.empty()) {
                io::dropEmptyEnd(line.cells, lines_[0].cells.size());
                if (line.cells.size() > lines_[0].cells.size())
                    throw io::columnsDiffer(line.number, line.text, line.cells, lines_[0].cells.size());
            }
            lines_.push_back(std::move(line));
            if (lines_.size() > mostRows) throw io::malformed(lines.number(), lines.line(), lines.line(), fewer);
        }
        if (lines_.empty()) throw Error(errors::fileEmpty, {});
        for (std::size_t i = 0; i < lines_[0].cells.size(); ++i) columns_.emplace(std::string(lines_[0].cells[i]), i);
    }

    const Line& heading() const { return lines_[0]; }
    std::size_t rows() const { return lines_.size() - 1; }
    bool has(const std::string& name) const { return columns_.count(name) > 0; }
    const Line& row(std::size_t i) const { return lines_[i + 1]; }

    std::string_view cell(std::size_t i, const std::string& name) const
    {
        const auto column = columns_.find(name);
        const Line& line = row(i);
        return column == columns_.end() || column->second >= line.cells.size() ? std::string_view()
                                                                               : line.cells[column->second];
    }

    /// A comma within one of these cells is a decimal mark, as there are no digit groups.
    void findDecimal(const std::vector<std::string>& numbers)
    {
        for (std::size_t i = 0; i < rows(); ++i)
            for (const std::string& name : numbers)
                if (cell(i, name).find(',') != std::string_view::npos) decimal_ = ',';
    }

    std::optional<double> number(std::size_t i, const std::string& name) const
    {
        const std::string_view content = cell(i, name);
        if (content.empty()) return {};
        const auto value = io::wholeNumber(content, decimal_);
        if (!value || !std::isfinite(*value)) refuse(i, name, LT_TEXT("Engine", "a finite number"));
        return value;
    }

    double required(std::size_t i, const std::string& name) const
    {
        const auto value = number(i, name);
        if (!value) refuse(i, name, LT_TEXT("Engine", "a number in each row"));
        return *value;
    }

    [[noreturn]] void refuse(std::size_t i, const std::string& name, Text expected) const
    {
        const std::string_view content = cell(i, name);
        const Line& line = row(i);
        throw io::malformed(line.number, line.text, content.empty() ? line.text.substr(line.text.size()) : content,
                            expected);
    }

private:
    static constexpr Text fewer = LT_TEXT("Engine", "at most 100000 rows");

    std::vector<Line> lines_;
    std::map<std::string, std::size_t> columns_;
    char delimiter_ = ',';
    char decimal_ = '.';
};

void remarkUnknown(const CsvTable& table, const std::vector<std::string>& known, Notes& notes)
{
    for (const io::Cell& cell : table.heading().cells) {
        if (cell.empty() || std::find(known.begin(), known.end(), cell) != known.end()) continue;
        const std::size_t offset = static_cast<std::size_t>(cell.data() - table.heading().text.data());
        notes.push_back({notes::unknownKey,
                         {{"line", table.heading().number},
                          {"column", io::columnAt(table.heading().text, offset)},
                          {"key", io::excerpt(cell)}}});
    }
}

Shaft readFull(CsvTable& table, Notes& notes)
{
    std::vector<std::string> numbers, known{"contour", "no", "z_start_mm", "z_end_mm", "role", "tolerance_class"};
    for (const CsvColumn& column : csvColumns()) numbers.emplace_back(column.name);
    known.insert(known.end(), numbers.begin(), numbers.end());
    remarkUnknown(table, known, notes);
    table.findDecimal(numbers);
    Shaft shaft;
    const auto boreFrom = [&](ShaftEnd end) -> ShaftBore& {
        for (ShaftBore& bore : shaft.bores)
            if (bore.from == end) return bore;
        return shaft.bores.emplace_back(ShaftBore{end, {}});
    };
    for (std::size_t i = 0; i < table.rows(); ++i) {
        ShaftSegment row;
        for (const CsvColumn& column : csvColumns())
            if (const auto value = column.required ? table.required(i, column.name) : table.number(i, column.name))
                column.set(row, *value);
        row.role = withoutApostrophe(table.cell(i, "role"));
        if (const std::string_view iso = withoutApostrophe(table.cell(i, "tolerance_class")); !iso.empty()) {
            if (!row.tolerance) row.tolerance.emplace();
            row.tolerance->iso_class = iso;
        }
        const std::string_view contour = table.cell(i, "contour");
        if (contour.empty() || contour == outsideContour)
            shaft.segments.push_back(std::move(row));
        else if (contour == boreFree || contour == boreChuck)
            boreFrom(contour == boreFree ? ShaftEnd::Free : ShaftEnd::Chuck)
                .segments.push_back({row.length_mm, row.start_diameter_mm, row.end_diameter_mm, row.arc_radius_mm,
                                     row.role, row.tolerance, row.measured});
        else
            table.refuse(i, "contour", LT_TEXT("Engine", "outside, bore_free or bore_chuck"));
    }
    return shaft;
}

Shaft withMarks(Shaft shaft, std::string_view text, Notes& notes)
{
    shaft.marks = readMarkRemarks(text, notes);
    for (const ShaftMark& mark : shaft.marks)
        if (mark.kind == MarkKind::Unexplained)
            notes.push_back({notes::shaftUnexplained,
                             {{"z_start_mm", mark.z_start_mm.value_or(0)}, {"z_end_mm", mark.z_end_mm.value_or(0)}}});
    return shaft;
}

Shaft readSteps(CsvTable& table, Notes& notes)
{
    const std::vector<std::string> known(stepColumns.begin(), stepColumns.end());
    remarkUnknown(table, known, notes);
    table.findDecimal(known);
    Shaft shaft;
    double z = 0;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const double diameter = 2 * table.required(i, "radius_mm");
        const double begin = table.required(i, "z_start_mm"), end = table.required(i, "z_end_mm");
        const double before = table.number(i, "chamfer_start_mm").value_or(0);
        const double after = table.number(i, "chamfer_end_mm").value_or(0);
        if (i > 0 && std::abs(begin - z) > same_mm)
            table.refuse(i, "z_start_mm", LT_TEXT("Engine", "the end of the step before"));
        if (before < 0 || after < 0 || !(before + after < end - begin))
            table.refuse(i, "z_end_mm", LT_TEXT("Engine", "a step longer than its chamfers"));
        const auto chamfer = [](double length, double from, double to) {
            return ShaftSegment{length, from, to, 0, {}, "chamfer"};
        };
        if (before > 0) shaft.segments.push_back(chamfer(before, diameter - 2 * before, diameter));
        shaft.segments.push_back({end - begin - before - after, diameter, diameter, 0, {}, ""});
        if (after > 0) shaft.segments.push_back(chamfer(after, diameter, diameter - 2 * after));
        z = end;
    }
    return shaft;
}

}  // namespace

std::string stepsCsv(const Shaft& shaft, const CsvStyle& style)
{
    CsvWriter out(style);
    for (const char* column : stepColumns) out.cell(std::string_view(column));
    out.end();
    double number = 0;
    for (const ShaftStep& step : stepsOf(shaft)) {
        for (const double value : {++number, step.x_mm, step.y_mm, step.radius_mm, step.z_start_mm, step.z_end_mm,
                                   step.chamfer_start_mm, step.chamfer_end_mm})
            out.cell(value);
        out.end();
    }
    for (const std::size_t i : rowsBesideSteps(shaft)) {
        const ShaftSegment& row = shaft.segments[i];
        out.remark(fmt::format("row {}: length {} mm, diameters {} to {} mm{}", i + 1, row.length_mm,
                               row.start_diameter_mm, row.end_diameter_mm,
                               row.arc_radius_mm ? fmt::format(", arc radius {} mm", *row.arc_radius_mm) : ""));
    }
    return out.take();
}

std::string shaftCsv(const Shaft& shaft, const CsvStyle& style)
{
    CsvWriter out(style);
    for (const char* name : {"contour", "no", "z_start_mm", "z_end_mm"}) out.cell(std::string_view(name));
    for (const CsvColumn& column : csvColumns()) out.cell(std::string_view(column.name));
    for (const char* name : {"role", "tolerance_class"}) out.cell(std::string_view(name));
    out.end();
    double z = 0;
    for (std::size_t i = 0; i < shaft.segments.size(); ++i) {
        const ShaftSegment& row = shaft.segments[i];
        writeRow(out, outsideContour, i + 1, z, z + row.length_mm, row);
        z += row.length_mm;
    }
    for (const ShaftBore& bore : shaft.bores) {
        const bool free = bore.from == ShaftEnd::Free;
        z = free ? 0 : shaft.length_mm();
        for (std::size_t i = 0; i < bore.segments.size(); ++i) {
            const double end = z + (free ? 1 : -1) * bore.segments[i].length_mm;
            writeRow(out, free ? boreFree : boreChuck, i + 1, z, end, asSegment(bore.segments[i]));
            z = end;
        }
    }
    for (const std::string& mark : markRemarks(shaft)) out.remark(mark);
    return out.take();
}

Shaft readShaftCsv(std::string_view bytes, Notes& notes, const Progress& progress)
{
    const io::DecodedText text = io::decodeText(bytes, io::Encoding::Auto, progress);
    CsvTable table(text.view(), progress);
    if (table.has("length_mm") && table.has("start_diameter_mm") && table.has("end_diameter_mm"))
        return withMarks(readFull(table, notes), text.view(), notes);
    if (table.has("radius_mm") && table.has("z_start_mm") && table.has("z_end_mm")) return readSteps(table, notes);
    throw Error(errors::columnsUnknown,
                {{"line", table.heading().number},
                 {"found", io::excerpt(table.heading().text)},
                 {"expected", LT_TEXT("Engine",
                                      "the columns length_mm, start_diameter_mm and end_diameter_mm, or "
                                      "radius_mm, z_start_mm and z_end_mm")}});
}

}  // namespace lathelier::cad
