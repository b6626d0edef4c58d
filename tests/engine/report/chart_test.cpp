#include "engine/report/chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>

#include "engine/report/chart_csv.h"
#include "engine/report/plot_frame.h"
#include "engine/report/plot_svg.h"
#include "tests/occurrences.h"

namespace lathelier {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A lobe chart as the window and the report will have it: a limit curve with what is stable below.
report::Plot lobes()
{
    report::Plot plot;
    plot.title = std::string("Lobes");
    plot.remark = std::string("tool 1");
    plot.x = {std::string("Speed"), Text{"1/min"}, report::Axis::Scale::Logarithmic, Interval{100, 10000}};
    plot.y = {std::string("Depth"), Text{"mm"}, report::Axis::Scale::Logarithmic, Interval{0.1, 10}};
    report::Curve curve;
    curve.name = std::string("limit");
    for (int i = 0; i <= 100; ++i) {
        curve.x.push_back(100 * std::pow(100, i / 100.0));
        curve.y.push_back(1 + 0.5 * std::sin(i * 0.3));
    }
    plot.regions = {report::between(std::string("stable"), report::ColourRole::Stable, curve.x,
                                    std::vector<double>(curve.x.size(), -infinity), curve.y),
                    report::between(std::string("unstable"), report::ColourRole::Unstable, curve.x, curve.y,
                                    std::vector<double>(curve.x.size(), infinity))};
    plot.curves = {curve};
    plot.limits = {{report::Limit::Direction::Horizontal, 5, std::string("power")},
                   {report::Limit::Direction::Vertical, 3000, std::string("fastest")}};
    plot.marks = {{1000, 1, std::string("lobe")}};
    plot.handles = {
        {"point", report::Handle::Kind::Point, 1000, 0.5, std::string("operating point"), Interval{200, 5000}, {}}};
    return plot;
}

TEST(ChartSvg, EveryPartIsDrawnInItsColour)
{
    const std::string svg = report::toSvg(lobes());
    for (const report::ColourRole role : {report::ColourRole::Stable, report::ColourRole::Unstable,
                                          report::ColourRole::Limit, report::ColourRole::Mark})
        EXPECT_NE(svg.find(report::hex(report::colourOf(role))), std::string::npos) << static_cast<int>(role);
    for (const char* words : {"Speed (1/min)", "Depth (mm)", "tool 1", ">limit<", ">stable<", ">unstable<", ">power<",
                              ">fastest<", ">lobe<", ">operating point<", ">200<", ">0.5<"})
        EXPECT_NE(svg.find(words), std::string::npos) << words;
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(ChartSvg, ALogarithmicAxisHasEqualDecades)
{
    report::PlotFrame frame;
    frame.bottom = 278;
    frame.x = {100, 10000};
    frame.y = {0.1, 10};
    frame.x_scale = frame.y_scale = report::Axis::Scale::Logarithmic;
    EXPECT_NEAR(frame.toX(1000), (frame.left + frame.right) / 2, 1e-9);
    EXPECT_NEAR(frame.toY(1), (frame.top + frame.bottom) / 2, 1e-9);
    const std::string svg = report::toSvg(lobes());
    EXPECT_NE(svg.find("<text x=\"459\""), std::string::npos) << "1000 stands in the middle";
    EXPECT_NE(svg.find(">1000<"), std::string::npos);
}

TEST(ChartSvg, NothingLeavesTheFrame)
{
    report::Plot plot = lobes();
    plot.x.range = Interval{500, 800};
    plot.y.range = Interval{0.9, 1.1};
    report::Curve bars;
    bars.style = report::Curve::Style::Bars;
    for (int i = 1; i < 100; ++i) bars.x.push_back(100 * i);
    bars.y.assign(98, 1.05);
    report::Curve points = plot.curves[0];
    points.style = report::Curve::Style::Points;
    plot.curves.push_back(bars);
    plot.curves.push_back(points);
    const std::string svg = report::toSvg(plot);
    const std::regex place("[ML]([0-9.-]+) ([0-9.-]+)");
    const std::size_t legend = svg.find("</text>");  // titles and legends stand outside by purpose
    std::size_t seen = 0;
    for (std::sregex_iterator at(svg.begin() + static_cast<std::ptrdiff_t>(legend), svg.end(), place), end; at != end;
         ++at) {
        const double y = std::stod((*at)[2]);
        if (y < report::frameTop) continue;  // a sample in the legend
        ++seen;
        const double x = std::stod((*at)[1]);
        EXPECT_GE(x, report::frameLeft - 6);
        EXPECT_LE(x, report::frameRight + 6);
    }
    EXPECT_GT(seen, 20u);
}

TEST(ChartSvg, EqualScalesDrawACircleRound)
{
    report::Plot plot;
    plot.equal_scales = true;
    report::Curve circle;
    for (int i = 0; i <= 360; ++i) {
        circle.x.push_back(std::cos(i * 0.0174532925));
        circle.y.push_back(std::sin(i * 0.0174532925));
        circle.along.push_back(i);
    }
    plot.curves = {circle};
    const std::string svg = report::toSvg(plot);
    const std::string path = svg.substr(svg.find("<path d=\"M"));
    double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
    const std::string data = path.substr(0, path.find('"', 10));
    const std::regex place("[ML]([0-9.]+) ([0-9.]+)");
    for (std::sregex_iterator at(data.begin(), data.end(), place), end; at != end; ++at)
        for (int axis = 0; axis < 2; ++axis) {
            low[axis] = std::min(low[axis], std::stod((*at)[static_cast<std::size_t>(axis) + 1]));
            high[axis] = std::max(high[axis], std::stod((*at)[static_cast<std::size_t>(axis) + 1]));
        }
    EXPECT_NEAR(high[0] - low[0], high[1] - low[1], 1);
    EXPECT_GT(high[0] - low[0], 150);
}

TEST(Chart, WhatIsShownHoldsEverythingWithAir)
{
    report::Plot plot = lobes();
    plot.x.range.reset();
    plot.y.range.reset();
    EXPECT_LT(report::shownX(plot).from, 100);
    EXPECT_GT(report::shownX(plot).from, 80);
    EXPECT_GT(report::shownX(plot).to, 10000);
    EXPECT_LT(report::shownY(plot).from, 0.5);  // the handle
    EXPECT_GT(report::shownY(plot).to, 5);      // the limit
    plot.curves[0].y[3] = -1;                   // nowhere on this axis
    EXPECT_GT(report::shownY(plot).from, 0);
    EXPECT_EQ(report::shownX({}).to, 1);
    report::Plot bars;
    bars.curves = {{{}, {0.5, 1.5, 2.5}, {3, 4}, report::Curve::Style::Bars}};
    EXPECT_EQ(report::shownY(bars).from, 0);
}

TEST(Chart, AHandleKeepsToItsWay)
{
    report::Handle point = lobes().handles[0];
    report::moveHandle(point, 100, 7);
    EXPECT_EQ(point.x, 200);
    EXPECT_EQ(point.y, 7);
    report::moveHandle(point, NAN, infinity);
    EXPECT_EQ(point.x, 200);
    EXPECT_EQ(point.y, 7);
    report::Handle line{"limit", report::Handle::Kind::Vertical, 1, 0, {}, {}, {}};
    report::moveHandle(line, 3, 4);
    EXPECT_EQ(line.x, 3);
    EXPECT_EQ(line.y, 0);
}

TEST(Chart, TheMapSaysTheValueOfACell)
{
    report::ColourMap map;
    map.x_to = 40;
    map.y_to = 360;
    map.columns = 2;
    map.rows = 1;
    map.values = {0.5F, NAN};
    EXPECT_EQ(map.at(10, 100), 0.5);
    EXPECT_TRUE(std::isnan(map.at(30, 100)));
    EXPECT_TRUE(std::isnan(map.at(-1, 100)));
    EXPECT_TRUE(std::isnan(report::ColourMap{}.at(0.5, 0.5)));
}

TEST(ChartCsv, BarsStandAtTheirMiddlesAndNamesAreQuoted)
{
    report::Plot plot;
    plot.x = {std::string("z, along"), Text{"mm"}};
    plot.y = {std::string("amplitude"), Text{"µm"}};
    plot.curves = {{{}, {0.5, 1.5, 2.5}, {3, NAN}, report::Curve::Style::Bars}};
    EXPECT_EQ(toCsv(plot), "\"z, along (mm)\",amplitude (µm)\n1,3\n2,\n");
    plot.curves[0].readout_y = {0.125, 0.25};
    plot.curves[0].readout_unit = Text{"mm"};
    EXPECT_EQ(occurrences(toCsv(plot), "0.125"), 1u);
}

}  // namespace
}  // namespace lathelier
