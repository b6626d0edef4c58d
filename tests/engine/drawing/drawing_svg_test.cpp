// A drawing as SVG: the size of the sheet, well-formed, the same bytes twice.
#include "engine/drawing/drawing_svg.h"

#include <gtest/gtest.h>

#include <regex>

#include "engine/drawing/shaft_drawing.h"
#include "six_parts.h"

namespace lathelier::drawing {
namespace {

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
    return found;
}

/// Every tag closes, in order; attributes in quotes; no stray brackets or ampersands.
bool isWellFormed(const std::string& svg)
{
    static const std::regex tag(R"re(<(/?)(\w+)((?: [\w:-]+="[^"<>]*")*)(/?)>)re");
    std::vector<std::string> open;
    std::string rest;
    std::size_t at = 0;
    for (std::sregex_iterator match(svg.begin(), svg.end(), tag), end; match != end; ++match) {
        rest += svg.substr(at, static_cast<std::size_t>(match->position()) - at);
        at = static_cast<std::size_t>(match->position() + match->length());
        if ((*match)[1].length() > 0) {
            if (open.empty() || open.back() != (*match)[2]) return false;
            open.pop_back();
        } else if ((*match)[4].length() == 0) {
            open.push_back((*match)[2]);
        }
    }
    rest += svg.substr(at);
    return open.empty() && rest.find_first_of("<>") == std::string::npos &&
           count(rest, "&") == count(rest, "&amp;") + count(rest, "&lt;") + count(rest, "&gt;") +
                                   count(rest, "&quot;") + count(rest, "&#39;");
}

TEST(DrawingSvg, IsWellFormedAndTheSameTwice)
{
    for (auto [name, shaft] : allParts()) {
        SCOPED_TRACE(name);
        shaft.name = "<" + name + "> & \"co\"";
        const Drawing drawing = drawShaft(shaft, {});
        const std::string svg = toSvg(drawing);
        EXPECT_TRUE(isWellFormed(svg));
        EXPECT_EQ(svg, toSvg(drawShaft(shaft, {})));
        EXPECT_EQ(count(svg, "<text "), drawing.labels.size());
        EXPECT_EQ(count(svg, "<line "), drawing.lines.size());
        EXPECT_EQ(count(svg, "<path ") + count(svg, "<circle "), drawing.arcs.size() + drawing.arrows.size());
        EXPECT_EQ(count(svg, "nan"), 0U);
        EXPECT_EQ(count(svg, "⌀"), 0U);  // set as Ø
    }
}

TEST(DrawingSvg, HasTheSizeOfTheSheetInMillimetres)
{
    DrawingOptions options;
    options.sheet = Sheet::A3Landscape;
    const std::string svg = toSvg(drawShaft(table1Part(), options));
    EXPECT_NE(svg.find("width=\"420mm\" height=\"297mm\" viewBox=\"0 0 420 297\""), std::string::npos);
}

TEST(DrawingSvg, PaperHasItsOriginBelow)
{
    Drawing drawing;
    drawing.lines.push_back({{0, 0}, {297, 210}});
    drawing.arcs.push_back({{100, 100}, 10, 0, 90});
    const std::string svg = toSvg(drawing);
    EXPECT_NE(svg.find("x1=\"0\" y1=\"210\" x2=\"297\" y2=\"0\""), std::string::npos);
    EXPECT_NE(svg.find("M110 110 A10 10 0 0 0 100 100"), std::string::npos);
}

}  // namespace
}  // namespace lathelier::drawing
