#include "engine/report/html.h"
#include "engine/project/project_codes.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/report/plain_text.h"
#include "engine/report/plot_svg.h"
#include "engine/report/svg.h"
#include "tests/occurrences.h"

namespace lathelier {
namespace {

const std::string nasty = "<script>alert(\"1\")</script> & 'wał' \xFF\xC0\x80 \x01";
const std::string tamed =
    "&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt; &amp; &#39;wał&#39; "
    "&lt;FF&gt;&lt;C0&gt;&lt;80&gt; &lt;U+0001&gt;";

report::Answer nastyAnswer()
{
    report::Answer answer;
    answer.quantity = nasty;
    answer.subject = nasty;
    answer.value = NAN;
    answer.upper_limit = 1;
    answer.verdict = Verdict::Fail;
    answer.sentence = LT_TEXT("Engine", "{x}");
    answer.values = {{"x", nasty}};
    answer.findings = {{LT_TEXT("Engine", "{x}"), {{"x", nasty}}, Verdict::Undecided, {}}};
    return answer;
}

report::Document fullDocument()
{
    report::Document document;
    document.title = nasty;
    document.synthetic = true;
    document.inputs = {{nasty, 1234567, "ab12"}};
    report::ColourMap map{nasty, {nasty}, {nasty}, {nasty}, 0, 10, 0, 360, 2, 2, {0.1F, NAN, -0.2F, 0.3F}, 0.2, 0.05};
    report::Plot plot;
    plot.title = nasty;
    plot.curves = {{nasty, {0, 1, 2}, {0, NAN, 2}, report::Curve::Style::Line, {}, -1},
                   {nasty, {0, 1, 2}, {1, 2, 3}, report::Curve::Style::Band, {0, 1, 2}, -1},
                   {nasty, {0, 1, 2}, {5, 6}, report::Curve::Style::Bars, {}, -1}};
    document.sections = {
        {nasty,
         {nastyAnswer(), report::Paragraph{LT_TEXT("Engine", "{x}"), {{"x", nasty}}},
          report::QuantityTable{nasty, {{nasty, nasty, {}}, {"n", NAN, {}}, {"m", 1.23456, unit::mm, 2}}},
          report::Table{nasty, {nasty, "b"}, {{nasty, std::int64_t{-1234567}}}, {}}, plot, map,
          report::Picture{nasty, "not really"}, Notes{{notes::sourceMissing, {{"path", nasty}}}}}}};
    return document;
}

TEST(Html, WhatComesFromFilesIsEscapedEverywhere)
{
    const std::string html = report::toHtml(fullDocument());
    EXPECT_EQ(html.find("<script"), std::string::npos);
    EXPECT_EQ(html.find("alert(\""), std::string::npos);
    EXPECT_EQ(html.find('\xFF'), std::string::npos);
    EXPECT_GE(occurrences(html, tamed), 15u);
}

TEST(Html, NothingIsFetchedFromOutside)
{
    const std::string html = report::toHtml(fullDocument());
    for (const char* attribute : {"src=\"", "href=\"", "url("})
        for (std::size_t at = html.find(attribute); at != std::string::npos; at = html.find(attribute, at + 1))
            EXPECT_EQ(html.compare(html.find('"', at) + 1, 5, "data:"), 0) << html.substr(at, 60);
    EXPECT_EQ(html.find("<link"), std::string::npos);
    EXPECT_EQ(html.find("@import"), std::string::npos);
}

TEST(Html, EveryElementIsClosed)
{
    const std::string html = report::toHtml(fullDocument());
    for (const char* tag :
         {"table", "tr", "td", "th", "div", "section", "figure", "svg", "text", "ul", "li", "p", "h1", "h2", "h3"}) {
        const std::string open = std::string("<") + tag;
        EXPECT_EQ(occurrences(html, open + ">") + occurrences(html, open + " "),
                  occurrences(html, std::string("</") + tag + ">"))
            << tag;
    }
}

TEST(Html, ValuesAreSetForPeople)
{
    const std::string html = report::toHtml(fullDocument());
    EXPECT_NE(html.find("<td class=\"number\">-1\u202F234\u202F567</td>"), std::string::npos);
    EXPECT_NE(html.find("<td class=\"number\">1.23</td><td class=\"unit\">mm</td>"), std::string::npos);
    EXPECT_NE(html.find("<td class=\"number\">–</td>"), std::string::npos);
    EXPECT_NE(html.find("✗ out of tolerance"), std::string::npos);
    EXPECT_NE(html.find("Synthetic data"), std::string::npos);
}

TEST(Html, SpeaksTheLanguageItIsGiven)
{
    Language polish;
    polish.translate = [](const char* english) {
        return std::string(english) == "✗ out of tolerance" ? "✗ poza tolerancją" : english;
    };
    polish.fixed = [](double, int) { return std::string("1,23"); };
    const std::string html = report::toHtml(fullDocument(), polish);
    EXPECT_NE(html.find("✗ poza tolerancją"), std::string::npos);
    EXPECT_NE(html.find("<td class=\"number\">1,23</td>"), std::string::npos);
}

TEST(Html, TheSameDocumentGivesTheSameBytes)
{
    report::Document document = fullDocument();
    EXPECT_EQ(report::toHtml(document), report::toHtml(document));
    document.created = "2026-11-21T03:05:09+0100";
    EXPECT_NE(report::toHtml(document).find(">2026-11-21 03:05</time>"), std::string::npos);
}

TEST(PlainText, ColumnsLineUp)
{
    report::Answer rms;
    rms.quantity = "RMS";
    rms.value = 1;
    rms.decimals = 2;
    rms.unit = unit::mm;
    rms.upper_limit = 2;
    rms.verdict = Verdict::Pass;
    const report::Section section{
        "x",
        {rms, report::QuantityTable{"T", {{"wał", 1.5, unit::mm}, {"longer", std::int64_t{12}, {}}}},
         report::Table{"Z", {"a", "bb"}, {{1.0, 22.25}}, {0, 2}}}};
    EXPECT_EQ(report::toPlainText(section),
              "RMS 1.00\u00A0mm · limit 2\u00A0mm  ✓ within tolerance\n\nT\n  wał     1.500 mm\n  longer     12\n\nZ\n "
              " a     bb\n  1  22.25\n");
}

TEST(Svg, AMillionPointsAreThinnedButExtremesStay)
{
    report::Plot plot;
    report::Curve curve;
    for (int i = 0; i < 1000000; ++i) {
        curve.x.push_back(i);
        curve.y.push_back(i == 123456 ? 10 : std::sin(i * 0.001));
    }
    plot.curves = {curve};
    const std::string svg = report::toSvg(plot);
    EXPECT_LT(svg.size(), 100000u);
    plot.curves[0].y[123456] = 0;
    EXPECT_NE(report::toSvg(plot), svg);
}

TEST(Svg, AnyNumbersGiveADrawing)
{
    rc::check([](const std::vector<double>& x, const std::vector<double>& y) {
        report::Plot plot;
        for (const auto style : {report::Curve::Style::Line, report::Curve::Style::Bars, report::Curve::Style::Band})
            plot.curves.push_back({"c", x, y, style, x, -1});
        plot.curves.push_back(
            {"inf", {INFINITY, NAN, 1e308, -1e308}, {NAN, 1, 1e308, -1e308}, report::Curve::Style::Line, {}, -1});
        const std::string svg = report::toSvg(plot);
        RC_ASSERT(svg.find("nan") == std::string::npos);
        RC_ASSERT(svg.find("inf\"") == std::string::npos);
    });
}

TEST(Svg, MapsOfImpossibleSizesAreLeftBlank)
{
    report::ColourMap map;
    map.columns = 10;
    map.rows = 10;
    map.values = {1, 2};
    EXPECT_EQ(report::toSvg(map).find("<image"), std::string::npos);
}

}  // namespace
}  // namespace lathelier
