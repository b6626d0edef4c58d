#include "widgets/core/report/report_pieces.h"

#include <QStringList>

#include "engine/core/texts.h"
#include "engine/core/version.h"
#include "engine/core/visible.h"
#include "engine/report/answer_ruler.h"
#include "engine/report/cells.h"
#include "engine/report/plot_svg.h"
#include "engine/report/polar_svg.h"

namespace lathelier {
namespace {

// Sizes in px of 1/96 inch, so that they do not depend on the screen's resolution.
constexpr const char* cellLine = "border-bottom: 1px solid #d8dde3;";

QString escaped(const std::string& text)
{
    return QString::fromStdString(visible(text, true)).toHtmlEscaped();
}

QString cellHtml(const Value& value, Text unit, int decimals, const Language& language, const char* tag = "td")
{
    return QString("<%1 align='%2' style='%3'>%4</%1>")
        .arg(tag, report::isNumeric(value) ? "right" : "left", cellLine,
             escaped(report::cellText(value, unit, decimals, language)));
}

QString heading(const QString& text, int size_px)
{
    return QString("<p style='font-size:%1px; font-weight:600; margin-top:0; margin-bottom:0;'>%2</p>")
        .arg(size_px)
        .arg(text);
}

class Maker {
public:
    explicit Maker(const Language& language) : language_(language) {}

    Piece operator()(const report::Answer& answer) const
    {
        const auto back = [&]() -> QString {
            if (!answer.verdict) return "#f0f4f8";
            switch (*answer.verdict) {
                case Verdict::Pass: return "#e6f6ef";
                case Verdict::Fail: return "#fdecea";
                case Verdict::Undecided: return "#fff8e6";
            }
            return {};
        };
        std::string quantity = report::captionText(answer.quantity, language_);
        if (!answer.subject.empty()) quantity += ", " + answer.subject;
        QString lines = QString(
                            "<table cellspacing='0' cellpadding='6'><tr><td valign='middle' bgcolor='%1'><span "
                            "style='font-size:17px; "
                            "font-weight:600; color:#ffffff;'>%2</span></td><td>&nbsp;</td><td>%3<br><span "
                            "style='font-size:24px; font-weight:600;'>%4</span></td></tr></table>")
                            .arg(badge(answer.verdict), escaped(report::verdictText(answer, language_)),
                                 escaped(quantity), escaped(report::valueText(answer, language_)));
        if (answer.verdict)
            lines += "<p style='margin:4px 0 0 0;'>" + escaped(report::limitText(answer, language_)) + "</p>";
        if (const std::string sentence = report::sentenceText(answer, language_); !sentence.empty())
            lines += "<p style='margin:4px 0 0 0;'>" + escaped(sentence) + "</p>";
        for (const report::Finding& finding : answer.findings) {
            std::string findingLine = report::findingText(finding, language_);
            if (finding.verdict) findingLine += "  " + lathelier::text(shortName(*finding.verdict), language_);
            lines += "<p style='margin:2px 0 0 0;'>– " + escaped(findingLine) + "</p>";
        }
        if (const std::string assumed = report::assumedText(answer, language_); !assumed.empty())
            lines += "<p style='margin:4px 0 0 0; font-style:italic;'>" + escaped(assumed) + "</p>";
        return text(QString("<table width='100%' cellpadding='10' bgcolor='%1'><tr><td>%2</td></tr></table>")
                        .arg(back(), lines));
    }
    static const char* badge(const std::optional<Verdict>& verdict)
    {
        if (!verdict) return "#52606d";
        switch (*verdict) {
            case Verdict::Pass: return "#177a53";
            case Verdict::Fail: return "#b3261e";
            case Verdict::Undecided: return "#8a5a00";
        }
        return "";
    }
    Piece operator()(const report::Paragraph& paragraph) const
    {
        return text("<p>" + escaped(fill(lathelier::text(paragraph.pattern, language_), paragraph.values, language_)) +
                    "</p>");
    }
    Piece operator()(const report::QuantityTable& table) const
    {
        QString rows;
        for (const report::Quantity& row : table.rows)
            rows += QString(
                        "<tr><td style='%1'>%2</td><td align='right' style='%1'><b>%3</b></td><td style='%1 "
                        "color:#52606d;'>"
                        "%4</td></tr>")
                        .arg(cellLine, caption(row.name),
                             escaped(report::cellText(row.value, row.unit, row.decimals, language_)),
                             escaped(lathelier::text(shownUnit(row.unit, language_).unit, language_)));
        Piece piece = text(heading(caption(table.title), 13) + "<table width='100%' cellspacing='0' cellpadding='3'>" +
                           rows + tableEnd);
        piece.narrow = true;
        return piece;
    }
    Piece operator()(const report::Table& table) const
    {
        Piece piece;
        piece.kind = Piece::Kind::Rows;
        piece.html = heading(caption(table.title), 13) + "<table width='100%' cellspacing='0' cellpadding='3'><tr>";
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            const bool numeric =
                !table.rows.empty() && i < table.rows.front().size() && report::isNumeric(table.rows.front()[i]);
            piece.html +=
                QString("<td align='%1' style='border-bottom: 1px solid #7b8794; color:#52606d;'><b>%2</b></td>")
                    .arg(numeric ? "right" : "left", caption(table.columns[i]));
        }
        piece.html += "</tr>";
        for (const auto& row : table.rows) {
            QString cells;
            for (std::size_t i = 0; i < row.size(); ++i)
                cells += cellHtml(row[i], table.unitOf(i), table.decimalsOf(i), language_);
            piece.rows.push_back("<tr>" + cells + "</tr>");
        }
        return piece;
    }
    Piece operator()(const report::Plot& plot) const { return drawing(report::toSvg(plot, language_)); }
    Piece operator()(const report::PolarPlot& plot) const { return drawing(report::toSvg(plot, language_)); }
    Piece operator()(const report::ColourMap& map) const { return drawing(report::toSvg(map, language_)); }
    Piece operator()(const report::Picture& picture) const
    {
        Piece piece;
        piece.kind = picture.isSvg() ? Piece::Kind::Svg : Piece::Kind::Png;
        piece.data = picture.png;
        piece.narrow = picture.isHalf();
        if (!picture.isSvg() || piece.narrow)
            piece.html = "<p style='color:#52606d;'>" + caption(picture.title) + "</p>";
        return piece;
    }
    Piece operator()(const Notes& notes) const
    {
        QString lines;
        for (const Note& note : notes)
            lines += (note.code.severity == Severity::Warning ? "<b>⚠</b> " : "– ") +
                     escaped(lathelier::text(note, language_)) + "<br>";
        return text("<p>" + lines + "</p>");
    }

    QString caption(const report::Caption& words) const { return escaped(report::captionText(words, language_)); }
    QString phrase(Text words) const { return escaped(lathelier::text(words, language_)); }

    static Piece text(const QString& html)
    {
        Piece piece;
        piece.html = html;
        return piece;
    }
    /// Under its answer. `figure`: as rulerSvg() gives it, an SVG in an element of HTML.
    static Piece ruler(const std::string& figure)
    {
        const std::size_t from = figure.find("<svg"), to = figure.rfind("</figure>");
        Piece piece = drawing(figure.substr(from, to - from));
        piece.share = 0.75;
        return piece;
    }
    static Piece title(const QString& words)
    {
        Piece piece = text(heading(words, 17) + "<hr>");
        piece.keep_with_next = true;
        return piece;
    }

private:
    static Piece drawing(std::string svg)
    {
        Piece piece;
        piece.kind = Piece::Kind::Svg;
        piece.data = std::move(svg);
        return piece;
    }

    const Language& language_;
};

/// Two columns of names and values, and a place to sign.
Piece titleBlock(const std::vector<report::Quantity>& rows, const Maker& maker, const Language& language)
{
    QStringList cells;
    for (const report::Quantity& row : rows)
        cells << QString("<td width='17%' style='%1 color:#52606d;'>%2</td><td width='33%' style='%1'><b>%3</b></td>")
                     .arg(cellLine, maker.caption(row.name),
                          escaped(report::cellText(row.value, row.unit, row.decimals, language)));
    cells << QString("<td style='%1 color:#52606d;'>%2<br>&nbsp;</td><td style='%1'></td>")
                 .arg(cellLine, maker.phrase(LT_TEXT("Engine", "Date, signature")));
    QString html = "<table width='100%' cellspacing='0' cellpadding='4' bgcolor='#f7f9fb'>";
    for (int i = 0; i < cells.size(); i += 2)
        html += "<tr>" + cells[i] + (i + 1 < cells.size() ? cells[i + 1] : QString("<td></td><td></td>")) + "</tr>";
    return Maker::text(html + tableEnd);
}

Piece inputsTable(const std::vector<InputFile>& inputs, const Maker& maker, const Language& language)
{
    Piece piece;
    piece.kind = Piece::Kind::Rows;
    piece.html =
        QString(
            "<table width='100%' cellspacing='0' cellpadding='3'><tr><td><b>%1</b></td><td align='right'><b>%2</b>"
            "</td><td><b>SHA-256</b></td></tr>")
            .arg(maker.phrase(LT_TEXT("Engine", "File")), maker.phrase(LT_TEXT("Engine", "Bytes")));
    for (const InputFile& input : inputs)
        piece.rows.push_back("<tr>" + cellHtml(input.path, {}, 0, language) + cellHtml(input.bytes, {}, 0, language) +
                             QString("<td style='%1 font-family:monospace; font-size:9px;'>%2</td></tr>")
                                 .arg(cellLine, escaped(input.sha256)));
    return piece;
}

}  // namespace

std::vector<Piece> piecesOf(const report::Document& document, const Language& language)
{
    const Maker maker(language);
    std::vector<Piece> pieces;
    if (const QString logo = QString::fromStdString(document.logo_png_base64).toHtmlEscaped(); !logo.isEmpty())
        pieces.push_back(Maker::text("<img src='data:image/png;base64," + logo + "' height='56'>"));
    pieces.push_back(Maker::text(heading(maker.caption(document.title), 24)));
    QString origin = QStringLiteral("Lathelier ") + programVersion;
    if (!document.created.empty())
        origin += " · " + QString::fromStdString(document.created).left(16).replace('T', ' ').toHtmlEscaped();
    pieces.push_back(Maker::text("<p style='color:#52606d;'>" + origin + "</p>"));
    if (document.synthetic)
        pieces.push_back(
            Maker::text("<table cellpadding='4' bgcolor='#fff3d6'><tr><td><b>⚠ " +
                        maker.phrase(LT_TEXT("Engine", "Synthetic data: made by a program, not measured")) +
                        "</b></td></tr></table>"));
    if (!document.title_block.empty()) pieces.push_back(titleBlock(document.title_block, maker, language));
    for (const report::Section& section : document.sections) {
        pieces.push_back(Maker::title(maker.caption(section.title)));
        for (const report::Block& block : section.blocks) {
            pieces.push_back(std::visit(maker, block));
            if (const auto* const answer = std::get_if<report::Answer>(&block))
                if (const std::string ruler = report::rulerSvg(*answer, language); !ruler.empty())
                    pieces.push_back(Maker::ruler(ruler));
        }
    }
    if (!document.inputs.empty()) {
        pieces.push_back(Maker::title(maker.phrase(LT_TEXT("Engine", "Input files"))));
        pieces.push_back(inputsTable(document.inputs, maker, language));
    }
    return pieces;
}

}  // namespace lathelier
