#include "engine/report/html.h"

#include <algorithm>

#include "engine/core/version.h"
#include "engine/report/abbreviations.h"
#include "engine/report/answer_ruler.h"
#include "engine/report/cells.h"
#include "engine/report/html_style.h"
#include "engine/report/plot_svg.h"
#include "engine/report/png.h"
#include "engine/report/polar_svg.h"
#include "engine/report/svg.h"

namespace lathelier::report {
namespace {

constexpr std::size_t longTable = 24;  ///< rows; longer tables of few columns are set in several columns
constexpr std::size_t narrowTable = 5;

std::string element(const std::string& tag, const std::string& content)
{
    return "<" + tag + ">" + content + "</" + tag + ">\n";
}

/// The blocks of one document, one call for each kind.
class Writer {
public:
    explicit Writer(const Language& language) : language_(language) {}

    std::string operator()(const Answer& answer) const
    {
        const std::string line = valueLine(answer, language_);
        const std::string words = expansion(line, language_);
        std::string head = "<span class=\"verdict\">" + escaped(verdictText(answer, language_)) + "</span>";
        head += " <span class=\"value\"" + (words.empty() ? "" : " title=\"" + escaped(words) + "\"") + ">" +
                escaped(line) + "</span>";
        if (answer.verdict) head += " <span class=\"limit\">" + escaped(limitText(answer, language_)) + "</span>";
        std::string body = rulerSvg(answer, language_);
        if (const std::string sentence = sentenceText(answer, language_); !sentence.empty())
            body += element("p", escaped(sentence));
        std::string findings;
        for (const Finding& finding : answer.findings) {
            std::string findingHtml = escaped(findingText(finding, language_));
            if (finding.verdict) findingHtml += " <b>" + escaped(text(shortName(*finding.verdict), language_)) + "</b>";
            findings += element("li", findingHtml);
        }
        if (!findings.empty()) body += element("ul", findings);
        if (const std::string assumed = assumedText(answer, language_); !assumed.empty())
            body += "<p class=\"assumed\">" + escaped(assumed) + "</p>\n";
        const std::string kind = answer.verdict ? std::string(key(*answer.verdict)) : "open";
        return "<div class=\"answer " + kind + "\"><p class=\"head\">" + head + "</p>\n" + body + "</div>\n";
    }

    std::string operator()(const Paragraph& paragraph) const
    {
        return element("p", escaped(fill(text(paragraph.pattern, language_), paragraph.values, language_)));
    }

    std::string operator()(const QuantityTable& table) const
    {
        std::string rows;
        for (const Quantity& row : table.rows)
            rows += "<tr><th scope=\"row\">" + caption(row.name) + "</th><td class=\"number\">" +
                    cell(row.value, row.unit, row.decimals) + "</td><td class=\"unit\">" +
                    escaped(text(shownUnit(row.unit, language_).unit, language_)) + "</td></tr>\n";
        return "<table class=\"quantities\"><caption>" + caption(table.title) + "</caption>\n" + rows + "</table>\n";
    }

    std::string operator()(const Table& table) const
    {
        std::string head;
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            const bool number = !table.rows.empty() && i < table.rows[0].size() && isNumeric(table.rows[0][i]);
            head += std::string("<th scope=\"col\"") + (number ? " class=\"number\">" : ">") +
                    caption(table.columns[i]) + "</th>";
        }
        head = "<thead><tr>" + head + "</tr></thead>\n";
        const bool split = table.rows.size() > longTable && table.columns.size() <= narrowTable;
        const bool wide = !split && table.columns.size() >= narrowTable;  // spans the full width of the page
        const std::size_t parts = split ? 2 : 1;
        std::string pieces;
        for (std::size_t part = 0; part < parts; ++part) {
            const std::size_t begin = part * table.rows.size() / parts;
            const std::size_t end = (part + 1) * table.rows.size() / parts;
            std::string rows;
            for (std::size_t i = begin; i < end; ++i) rows += row(table, table.rows[i]);
            pieces.append("<table class=\"rows\">")
                .append(head)
                .append("<tbody>\n")
                .append(rows)
                .append("</tbody></table>\n");
        }
        return "<div class=\"table\">" + element("h3", caption(table.title)) +
               (wide ? pieces : "<div class=\"grid\">" + pieces + "</div>") + "</div>\n";
    }

    std::string operator()(const Plot& plot) const { return element("figure", toSvg(plot, language_)); }
    std::string operator()(const PolarPlot& plot) const { return element("figure", toSvg(plot, language_)); }
    std::string operator()(const ColourMap& map) const { return element("figure", toSvg(map, language_)); }

    std::string operator()(const Picture& picture) const
    {
        const std::string title = caption(picture.title);
        if (picture.isSvg()) return element("figure", picture.png + "<figcaption>" + title + "</figcaption>");
        return element("figure", "<img alt=\"" + title + "\" src=\"data:image/png;base64," + base64(picture.png) +
                                     "\"><figcaption>" + title + "</figcaption>");
    }

    std::string operator()(const Notes& notes) const
    {
        std::string items;
        for (const Note& note : notes)
            items += note.code.severity == Severity::Warning
                         ? "<li class=\"warning\"><b>!</b> " + escaped(text(note, language_)) + "</li>\n"
                         : "<li>" + escaped(text(note, language_)) + "</li>\n";
        return items.empty() ? items : "<ul class=\"notes\">\n" + items + "</ul>\n";
    }

    /// The blocks in order; consecutive tables of quantities are set side by side.
    std::string blocks(const std::vector<Block>& all) const
    {
        std::string result;
        bool grid = false;
        for (const Block& block : all) {
            const auto* const picture = std::get_if<Picture>(&block);
            const bool narrow = std::holds_alternative<QuantityTable>(block) || (picture && picture->isHalf());
            if (narrow != grid) result += narrow ? "<div class=\"grid\">\n" : "</div>\n";
            grid = narrow;
            result += std::visit(*this, block);
        }
        return grid ? result + "</div>\n" : result;
    }

    std::string section(const Section& section) const
    {
        return "<section>\n" + element("h2", caption(section.title)) + blocks(section.blocks) + "</section>\n";
    }

    std::string inputs(const std::vector<InputFile>& files) const
    {
        if (files.empty()) return {};
        std::string rows;
        for (const InputFile& file : files)
            rows += "<tr><td class=\"path\">" + escaped(file.path) + "</td><td class=\"number\">" +
                    cell(file.bytes, {}, 0) + "</td><td class=\"digest\">" + escaped(file.sha256) + "</td></tr>\n";
        return "<section>\n" + element("h2", phrase(LT_TEXT("Engine", "Input files"))) +
               "<table class=\"rows inputs\"><thead><tr><th>" + phrase(LT_TEXT("Engine", "File")) +
               "</th><th class=\"number\">" + phrase(LT_TEXT("Engine", "Bytes")) +
               "</th><th>SHA-256</th></tr></thead><tbody>\n" + rows + "</tbody></table>\n</section>\n";
    }

    /// Title block: names, values and a signature field.
    std::string titleBlock(const std::vector<Quantity>& rows) const
    {
        if (rows.empty()) return {};
        std::string result;
        for (const Quantity& row : rows)
            result += "<div><dt>" + caption(row.name) + "</dt><dd>" + cell(row.value, row.unit, row.decimals) +
                      "</dd></div>\n";
        result += "<div class=\"signature\"><dt>" + phrase(LT_TEXT("Engine", "Date, signature")) +
                  "</dt><dd>&nbsp;</dd></div>\n";
        return "<dl class=\"title-block\">\n" + result + "</dl>\n";
    }

    std::string phrase(Text words) const { return escaped(text(words, language_)); }
    std::string caption(const Caption& words) const { return escaped(captionText(words, language_)); }

private:
    std::string cell(const Value& value, Text unit, int decimals) const
    {
        return escaped(cellText(value, unit, decimals, language_));
    }

    std::string row(const Table& table, const std::vector<Value>& values) const
    {
        std::string result;
        for (std::size_t i = 0; i < values.size(); ++i)
            result += (isNumeric(values[i]) ? "<td class=\"number\">" : "<td>") +
                      cell(values[i], table.unitOf(i), table.decimalsOf(i)) + "</td>";
        return "<tr>" + result + "</tr>\n";
    }

    const Language& language_;
};

/// "2026-11-21T03:05:09+0000" in readable form: date and time to the minute.
std::string readable(const std::string& created)
{
    if (created.size() < 16 || created[10] != 'T') return created;
    return created.substr(0, 10) + " " + created.substr(11, 5);
}

}  // namespace

std::string toHtml(const Document& document, const Language& language)
{
    const Writer writer(language);
    const std::string title = writer.caption(document.title);
    std::string result = "<!DOCTYPE html>\n<html lang=\"" + writer.phrase(LT_TEXT("Engine", "en")) +
                         "\">\n<head>\n<meta charset=\"utf-8\">\n"
                         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                         "<meta name=\"generator\" content=\"Lathelier " +
                         std::string(programVersion) + "\">\n" + element("title", title) + "<style>\n" +
                         std::string(reportStyle) + "</style>\n</head>\n<body>\n";
    result += "<header>";
    if (!document.logo_png_base64.empty())
        result +=
            "<img class=\"logo\" alt=\"\" src=\"data:image/png;base64," + escaped(document.logo_png_base64) + "\">";
    result += "<div>" + element("h1", title);
    if (document.synthetic)
        result += "<p class=\"synthetic\">" +
                  writer.phrase(LT_TEXT("Engine", "Synthetic data: made by a program, not measured")) + "</p>\n";
    result += "</div><p class=\"origin\"><b>Lathelier</b> " + std::string(programVersion);
    if (!document.created.empty())
        result += "<br><time datetime=\"" + escaped(document.created) + "\">" + escaped(readable(document.created)) +
                  "</time>";
    result += "</p></header>\n" + writer.titleBlock(document.title_block);
    for (const Section& section : document.sections) result += writer.section(section);
    return result + writer.inputs(document.inputs) + "</body>\n</html>\n";
}

}  // namespace lathelier::report
