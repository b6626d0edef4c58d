#include "engine/report/polar_svg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/report/html.h"
#include "engine/report/ring_labels.h"
#include "engine/report/svg.h"
#include "tests/occurrences.h"

namespace lathelier {
namespace {

report::PolarPlot plotWith(double amplitude_um, double radius_mm = 25, std::size_t points = 720)
{
    report::PolarPlot plot;
    plot.title = std::string("Section <1>");
    plot.base_radius_mm = radius_mm;
    report::PolarPlot::Trace trace;
    trace.name = std::string("profile");
    for (std::size_t i = 0; i <= points; ++i) {
        const double angle = 360.0 * static_cast<double>(i) / static_cast<double>(points);
        trace.angle_deg.push_back(angle);
        trace.deviation_um.push_back(amplitude_um * std::cos(3 * angle * M_PI / 180));
    }
    plot.traces = {trace};
    plot.circles = {{std::string("MZCI"), amplitude_um / 10, 0, amplitude_um, 1, false},
                    {std::string("MICI"), 0, 0, 0, 4, true}};
    plot.contacts = {{0, amplitude_um, true}, {60, -amplitude_um, false}};
    return plot;
}

TEST(PolarSvg, TheMagnificationIsRoundAndFits)
{
    for (const double amplitude : {.05, .7, 3.0, 11.0, 480.0, 12000.0})
        for (const double radius : {.5, 25.0, 800.0}) {
            const report::PolarPlot plot = plotWith(amplitude, radius);
            const double times = report::fittingMagnification(plot);
            const double leading = times / std::pow(10, std::floor(std::log10(times) + 1e-9));
            EXPECT_TRUE(std::abs(leading - 1) < 1e-6 || std::abs(leading - 2) < 1e-6 || std::abs(leading - 5) < 1e-6)
                << times;
            // The largest deviation takes between an eighth and two fifths of the base circle's radius.
            const double drawn = times * amplitude / (1000 * radius);
            EXPECT_LT(drawn, .42);
            EXPECT_GT(drawn, .13);
        }
    EXPECT_EQ(report::fittingMagnification({}), 1);
}

TEST(PolarSvg, StatesWhatIsDrawn)
{
    const std::string svg = report::toSvg(plotWith(3));
    EXPECT_NE(svg.find("Section &lt;1&gt;"), std::string::npos);
    EXPECT_NE(svg.find("Deviations magnified 2000 times"), std::string::npos);
    EXPECT_NE(svg.find("1 division = 2 µm"), std::string::npos);
    EXPECT_NE(svg.find("radius 25.0000 mm"), std::string::npos);
    EXPECT_NE(svg.find("MZCI"), std::string::npos);
    EXPECT_NE(svg.find("outer circle"), std::string::npos);
    EXPECT_NE(svg.find("inner circle"), std::string::npos);
    EXPECT_NE(svg.find(">330°<"), std::string::npos);
    EXPECT_GE(occurrences(svg, "stroke-dasharray"), 2u);  // the dashed circle and its legend
    report::PolarPlot plot = plotWith(3);
    plot.magnification = 500;
    EXPECT_NE(report::toSvg(plot).find("magnified 500 times"), std::string::npos);
}

TEST(PolarSvg, LongTracesAreThinnedAndGapsStayOpen)
{
    EXPECT_LT(report::toSvg(plotWith(3, 25, 1000000)).size(), 200000u);
    report::PolarPlot plot = plotWith(3);
    const std::string whole = report::toSvg(plot);
    for (std::size_t i = 100; i < 120; ++i) plot.traces[0].deviation_um[i] = std::numeric_limits<double>::quiet_NaN();
    const std::string broken = report::toSvg(plot);
    EXPECT_EQ(occurrences(broken, "nan"), 0u);
    EXPECT_NE(whole, broken);
    EXPECT_NO_THROW(report::toSvg(report::PolarPlot{}));
}

TEST(PolarSvg, NumbersOfTheScaleLieBeneathTheData)
{
    const std::string svg = report::toSvg(plotWith(3));
    const std::size_t number = svg.find(">+2<"), plate = svg.rfind("#ffffff");
    const std::size_t profile = svg.find("stroke=\"" + report::hex(report::colourOf(0)));
    ASSERT_NE(number, std::string::npos);
    ASSERT_NE(profile, std::string::npos);
    EXPECT_LT(number, profile);
    EXPECT_LT(plate, profile);
}

TEST(PolarSvg, NumbersOfTheScaleStandWhereNothingIsDrawn)
{
    // All is drawn in the upper half, and a curve runs along the lower ring.
    std::vector<report::PolarPlace> drawn;
    for (double x = -100; x <= 100; x += 2)
        for (double y = 0; y <= 100; y += 2) drawn.push_back({x, y});
    for (int angle = 180; angle < 360; ++angle)
        drawn.push_back({60 * std::cos(angle * M_PI / 180), 60 * std::sin(angle * M_PI / 180)});
    std::vector<report::RingLabel> labels{{60, 24, 14}, {92, 24, 14}};
    report::placeRingLabels(labels, drawn, 100);
    for (const report::RingLabel& label : labels) {
        ASSERT_TRUE(label.place);
        EXPECT_LT(label.place->y_px, 0);
        for (const report::PolarPlace& place : drawn)
            EXPECT_FALSE(std::abs(place.x_px - label.place->x_px) < 12 && std::abs(place.y_px - label.place->y_px) < 7);
    }
    EXPECT_NEAR(std::hypot(labels[1].place->x_px, labels[1].place->y_px), 92, 1e-9);  // free: on its ring
    std::vector<report::RingLabel> crowded{{60, 24, 14}, {61, 24, 14}, {62, 24, 14},
                                           {63, 24, 14}, {64, 24, 14}, {65, 24, 14}};
    report::placeRingLabels(crowded, {}, 100);
    for (const report::RingLabel& a : crowded)
        for (const report::RingLabel& b : crowded) {
            if (&a == &b || !a.place || !b.place) continue;
            EXPECT_GE(std::hypot(a.place->x_px - b.place->x_px, a.place->y_px - b.place->y_px), 14);
        }
    EXPECT_TRUE(crowded[0].place);
    EXPECT_FALSE(crowded[5].place);
}

TEST(PolarSvg, DeviationsThatGoOneWayGetTheRoomOfTheOther)
{
    for (const double sign : {1.0, -1.0}) {
        report::PolarPlot plot = plotWith(3);
        for (double& value : plot.traces[0].deviation_um) value = sign * std::abs(value);
        plot.circles.clear();
        plot.contacts.clear();
        EXPECT_GE(report::fittingMagnification(plot), report::fittingMagnification(plotWith(3)));
    }
}

TEST(PolarSvg, StandsInReports)
{
    report::Document document;
    document.sections = {{std::string("s"), {plotWith(3)}}};
    EXPECT_NE(report::toHtml(document).find("magnified 2000 times"), std::string::npos);
}

}  // namespace
}  // namespace lathelier
