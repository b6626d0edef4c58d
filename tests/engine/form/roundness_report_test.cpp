#include "engine/form/roundness/roundness_report.h"
#include "engine/form/roundness/roundness_plots.h"
#include "engine/form/roundness/superimpose_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/report/html.h"
#include "engine/report/plain_text.h"
#include "engine/report/polar_svg.h"
#include "tests/engine/form/made_profile.h"

namespace lathelier::form {
namespace {

RoundnessResult made(RoundnessParameters parameters = {})
{
    Profile profile = lobedProfile(evenAngles(720), {{2, .004, 1}, {3, .002, 0}}, {.02, .01}, .0003);
    profile.name = "section 1 <left>";
    return roundness(profile, parameters);
}

TEST(RoundnessReport, TheAnswerNamesCircleFilterLimitAndVerdict)
{
    RoundnessParameters parameters;
    EXPECT_EQ(report::valueLine(answer(made())).find("RONt(MZCI) "), 0u);
    EXPECT_NE(report::sentenceText(answer(made())).find("no filter"), std::string::npos);
    EXPECT_FALSE(answer(made()).verdict);
    parameters.cutoff_upr = 50;
    parameters.tolerance_um = 20;
    const report::Answer pass = answer(made(parameters));
    EXPECT_NE(report::sentenceText(pass).find("G 1-50\u00A0UPR"), std::string::npos) << report::sentenceText(pass);
    EXPECT_EQ(report::limitText(pass), "limit 20\u00A0µm");
    EXPECT_EQ(pass.verdict, Verdict::Pass);
    EXPECT_EQ(pass.expanded_uncertainty, made(parameters).RONt_expanded_uncertainty_um);
    parameters.tolerance_um = 2;
    parameters.circle = ReferenceCircle::LSCI;
    const report::Answer fail = answer(made(parameters));
    EXPECT_EQ(report::valueLine(fail).find("RONt(LSCI) "), 0u);
    EXPECT_EQ(report::limitText(fail), "limit 2\u00A0µm");
    EXPECT_EQ(fail.verdict, Verdict::Fail);
    const double value = headlineDeviation_um(made(parameters));
    parameters.tolerance_um = value;
    parameters.decision = DecisionRule::Guarded;
    const report::Answer open = answer(made(parameters));
    EXPECT_EQ(open.verdict, Verdict::Undecided);
    EXPECT_NE(report::sentenceText(open).find("within the uncertainty"), std::string::npos);
    EXPECT_EQ(filterName({15, 500}), "G 15-500 UPR");
}

TEST(RoundnessReport, TheAnswerSaysWhatOtherMethodsWouldSay)
{
    RoundnessParameters parameters;
    parameters.tolerance_um = 1000;
    EXPECT_NE(report::sentenceText(answer(made(parameters))).find("within by all "), std::string::npos);
    parameters.tolerance_um = 1e-4;
    EXPECT_NE(report::sentenceText(answer(made(parameters))).find("above by all "), std::string::npos);
    const RoundnessResult result = made();
    double least_um = HUGE_VAL, most_um = 0;
    for (const MethodRow& row : result.methods)
        for (const double value_um : row.RONt_um)
            if (!row.undersampled && std::isfinite(value_um)) {
                least_um = std::min(least_um, value_um);
                most_um = std::max(most_um, value_um);
            }
    parameters.tolerance_um = (least_um + most_um) / 2;
    const std::string between = report::sentenceText(answer(made(parameters)));
    EXPECT_NE(between.find("methods: look at the filter"), std::string::npos) << between;
}

TEST(RoundnessReport, HoldsEverythingOnce)
{
    RoundnessParameters parameters;
    parameters.tolerance_um = 20;
    const std::string html = report::toHtml(roundnessReport({made(parameters)}, {}));
    for (const std::string wanted : {"minimum zone (MZCI)", "maximum inscribed (MICI)", "Sizes across the section",
                                     "Deviations magnified", "Undulations per revolution", "how much of the value",
                                     "As in the source paper", "Expanded uncertainty", "within tolerance", "ISO 12181"})
        EXPECT_NE(html.find(wanted), std::string::npos) << wanted;
    EXPECT_EQ(html.find("<left>"), std::string::npos);
    EXPECT_EQ(html.find("nan"), std::string::npos);
    const std::string several = report::toHtml(roundnessReport({made(parameters), made()}, {}));
    EXPECT_NE(several.find("All profiles"), std::string::npos);
    EXPECT_NE(several.find("section 1 &lt;left&gt;"), std::string::npos);
    EXPECT_NE(report::toPlainText(roundnessSummary(made(parameters))).find("✓ within tolerance"), std::string::npos);
}

TEST(RoundnessReport, ThePolarPlotShowsTheContactsOfTheChosenCircle)
{
    const RoundnessResult result = made();
    const report::PolarPlot plot = roundnessPolarPlot(result);
    EXPECT_EQ(plot.contacts.size(), result.circles.MZCI.contacts.size());
    EXPECT_EQ(plot.circles.size(), 5u);
    ASSERT_EQ(plot.traces.size(), 1u);
    EXPECT_EQ(plot.traces[0].angle_deg.size(), 721u);
    // A contact lies on its reference line, and on the profile.
    for (const report::PolarPlot::Mark& mark : plot.contacts) {
        const report::PolarPlot::ReferenceLine& line = plot.circles[mark.outer ? 1 : 2];
        const double angle = mark.angle_deg * std::numbers::pi / 180;
        const double on = line.deviation_um + line.x_um * std::cos(angle) + line.y_um * std::sin(angle);
        EXPECT_NEAR(on, mark.deviation_um, 1e-3);
    }
    const report::Plot spectrum = spectrumPlot(result);
    EXPECT_EQ(spectrum.curves[0].y.size() + 1, spectrum.curves[0].x.size());
    EXPECT_NEAR(spectrum.curves[0].y[0], 4, .1);
}

/// The others wait to be asked for; the zone is as wide as the value says.
TEST(RoundnessReport, ThePolarPlotShowsTheChosenCircleAndItsZone)
{
    for (const ReferenceCircle which : circlesOfTable) {
        RoundnessParameters parameters;
        parameters.circle = which;
        const RoundnessResult result = made(parameters);
        const report::PolarPlot plot = roundnessPolarPlot(result);
        std::size_t others = 0;
        for (const report::PolarPlot::ReferenceLine& line : plot.circles) {
            if (line.asked.empty()) continue;
            ++others;
            EXPECT_NE(line.asked, name(which));
        }
        EXPECT_EQ(others, which == ReferenceCircle::MZCI ? 3U : 4U);
        ASSERT_EQ(plot.rings.size(), 1U);
        EXPECT_NEAR(plot.rings[0].outer_um - plot.rings[0].inner_um, result.circles.of(which).RONt_um, 1e-6);
        const std::string svg = report::toSvg(plot);
        for (const ReferenceCircle other : circlesOfTable)
            EXPECT_EQ(svg.find(std::string(name(other)) + "  RONt") != std::string::npos, other == which);
    }
}

TEST(RoundnessReport, TheToleranceIsDrawnUnlessItDwarfsTheForm)
{
    const auto limits = [](double tolerance_um) {
        RoundnessParameters parameters;
        parameters.tolerance_um = tolerance_um;
        std::vector<double> found;
        for (const report::PolarPlot::ReferenceLine& line : roundnessPolarPlot(made(parameters)).circles)
            if (line.colour.role == report::ColourRole::Limit) found.push_back(line.deviation_um);
        return found;
    };
    ASSERT_EQ(limits(12).size(), 2U);
    EXPECT_NEAR(limits(12)[0] - limits(12)[1], 12, 1e-9);
    EXPECT_TRUE(limits(1000).empty());
}

TEST(RoundnessReport, AFilterIsOfferedWhereNoneWasChosen)
{
    const auto offered = [](const report::Answer& answer) -> const report::Finding* {
        for (const report::Finding& finding : answer.findings)
            if (find(finding.offer, "cutoff_upr")) return &finding;
        return nullptr;
    };
    const report::Answer plain = answer(made());
    const report::Finding* finding = offered(plain);
    ASSERT_TRUE(finding);
    RoundnessParameters parameters;
    parameters.cutoff_upr = std::get<double>(*find(finding->offer, "cutoff_upr"));
    const RoundnessResult filtered = made(parameters);
    EXPECT_NE(report::findingText(*finding).find(fixed(filtered.circles.MZCI.RONt_um, plain.decimals, {})),
              std::string::npos)
        << report::findingText(*finding) << " but " << filtered.circles.MZCI.RONt_um;
    EXPECT_FALSE(offered(answer(filtered)));
}

TEST(RoundnessReport, TheStrongestWavesAreNamed)
{
    const report::Plot spectrum = spectrumPlot(made());
    ASSERT_FALSE(spectrum.marks.empty());
    EXPECT_LE(spectrum.marks.size(), 3U);
    EXPECT_EQ(spectrum.marks[0].x, 2);
    EXPECT_EQ(report::captionText(spectrum.marks[0].name), "2 oval");
}

TEST(RoundnessReport, DeviationsCountFromTheChosenCircleAndSaySo)
{
    for (const ReferenceCircle which : circlesOfTable) {
        RoundnessParameters parameters;
        parameters.circle = which;
        const RoundnessResult result = made(parameters);
        const FittedCircle& circle = result.circles.of(which);
        const report::PolarPlot plot = roundnessPolarPlot(result);
        EXPECT_EQ(plot.base_radius_mm, circle.radius_mm);
        EXPECT_NE(report::captionText(plot.traces[0].name).find(name(which)), std::string::npos);
        const auto [low, high] =
            std::minmax_element(plot.traces[0].deviation_um.begin(), plot.traces[0].deviation_um.end());
        EXPECT_NEAR(*low, 1000 * (circle.inner_radius_mm - circle.radius_mm), 1e-6) << name(which);
        EXPECT_NEAR(*high, 1000 * (circle.outer_radius_mm - circle.radius_mm), 1e-6) << name(which);
        for (const report::PolarPlot::Mark& mark : plot.contacts)
            EXPECT_NEAR(mark.deviation_um, mark.outer ? *high : *low, 1e-3) << name(which);
    }
}

TEST(RoundnessReport, TheLegendOfTheCirclesDoesNotDependOnTheChosenOne)
{
    std::vector<std::string> first;
    for (const ReferenceCircle which : {ReferenceCircle::LSCI, ReferenceCircle::MZCI, ReferenceCircle::MCCI}) {
        RoundnessParameters parameters;
        parameters.circle = which;
        RoundnessResult result = made(parameters);
        result.RONt_expanded_uncertainty_um = which == ReferenceCircle::LSCI ? 0.5 : 0.005;
        std::vector<std::string> names;
        for (const report::PolarPlot::ReferenceLine& line : roundnessPolarPlot(result).circles)
            if (std::string words = report::captionText(line.name); !words.empty()) names.push_back(std::move(words));
        if (first.empty()) first = names;
        EXPECT_EQ(names, first);
    }
}

TEST(RoundnessReport, SuperimposedProfiles)
{
    const Profile a = lobedProfile(evenAngles(360), {{2, .004, 1}, {3, .002, 0}});
    const report::Section section = superimposeSection(superimpose(a, a));
    EXPECT_NE(report::toPlainText(section).find("Largest difference of the profiles 0.00\u00A0µm"), std::string::npos);
}

}  // namespace
}  // namespace lathelier::form
