#include "engine/series/control_chart.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/series/series_codes.h"

namespace lathelier::series {
namespace {

std::vector<archive::SeriesPoint> pointsOf(const std::vector<double>& values)
{
    std::vector<archive::SeriesPoint> points;
    points.reserve(values.size());
    for (const double value : values) {
        archive::SeriesPoint point;
        point.value = value;
        points.push_back(point);
    }
    return points;
}

void limit(std::vector<archive::SeriesPoint>& points, std::optional<double> lower, std::optional<double> upper)
{
    for (archive::SeriesPoint& point : points) {
        point.lower_limit = lower;
        point.upper_limit = upper;
    }
}

/// A scatter that neither runs nor drifts: ±a, in pairs that are turned about.
std::vector<double> alternating(std::size_t count, double size)
{
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = (i % 4 == 0 || i % 4 == 3) ? size : -size;
    return values;
}

TEST(ControlChart, has_the_limits_of_single_values)
{
    // Moving ranges 2, 1, 3; mean 2; limits 2.25 ± 2.66 · 2.
    Notes notes;
    const ControlChart chart = controlChart(pointsOf({1, 3, 4, 1}), notes);
    EXPECT_EQ(chart.count, 4);
    EXPECT_DOUBLE_EQ(chart.mean, 2.25);
    EXPECT_DOUBLE_EQ(*chart.standard_deviation, std::sqrt(6.75 / 3));
    EXPECT_DOUBLE_EQ(*chart.lower_control_limit, 2.25 - 5.32);
    EXPECT_DOUBLE_EQ(*chart.upper_control_limit, 2.25 + 5.32);
    EXPECT_EQ(chart.out_of_control, 0);
    EXPECT_TRUE(notes.empty());
}

TEST(ControlChart, finds_a_value_a_run_and_a_trend)
{
    Notes notes;
    std::vector<double> values = alternating(40, 1);
    EXPECT_TRUE(controlChart(pointsOf(values), notes).isInControl());
    values[20] = 12;
    EXPECT_EQ(controlChart(pointsOf(values), notes).out_of_control, 1);

    values = alternating(40, 1);
    for (std::size_t i = 10; i < 17; ++i) values[i] = i % 2 == 0 ? 1 : 0.8;
    const ControlChart run = controlChart(pointsOf(values), notes);
    EXPECT_GE(run.longest_run, 7);
    EXPECT_FALSE(run.isInControl());

    values = {0, 3, 1, -2, -1.5, -1, -0.5, 0, 0.5, 1, -1, 2};  // seven that rise, from -2 on
    const ControlChart trend = controlChart(pointsOf(values), notes);
    EXPECT_EQ(trend.longest_trend, 7);
    EXPECT_FALSE(trend.isInControl());
}

TEST(ControlChart, drift_is_the_slope_with_its_uncertainty)
{
    Notes notes;
    std::vector<double> values = alternating(400, 0.01);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += 0.002 * static_cast<double>(i);
    const ControlChart chart = controlChart(pointsOf(values), notes);
    EXPECT_NEAR(*chart.drift_per_100_parts, 0.2, 0.001);
    EXPECT_GT(*chart.drift_expanded_uncertainty_per_100_parts, 0);
    EXPECT_LE(std::abs(*chart.drift_per_100_parts - 0.2), *chart.drift_expanded_uncertainty_per_100_parts);

    const ControlChart exact = controlChart(pointsOf({1, 2, 3, 4, 5}), notes);
    EXPECT_DOUBLE_EQ(*exact.drift_per_100_parts, 100);
    EXPECT_NEAR(*exact.drift_expanded_uncertainty_per_100_parts, 0, 1e-9);
}

TEST(ControlChart, capability_is_that_of_the_nearer_limit)
{
    Notes notes;
    auto points = pointsOf(alternating(100, 1));  // s = sqrt(100 / 99), mean 0
    limit(points, -3, 6);
    const ControlChart chart = controlChart(points, notes);
    const double s = std::sqrt(100.0 / 99);
    EXPECT_NEAR(*chart.capability_pp, 9 / (6 * s), 1e-12);
    EXPECT_NEAR(*chart.capability_ppk, 3 / (3 * s), 1e-12);
    EXPECT_TRUE(notes.empty());
    limit(points, std::nullopt, 6);
    const ControlChart one_sided = controlChart(points, notes);
    EXPECT_FALSE(one_sided.capability_pp);
    EXPECT_NEAR(*one_sided.capability_ppk, 6 / (3 * s), 1e-12);
}

TEST(ControlChart, says_what_a_capability_is_worth)
{
    Notes notes;
    auto points = pointsOf({1, 2, 1, 2, 1});
    limit(points, 0, 3);
    controlChart(points, notes);
    EXPECT_TRUE(contains(notes, notes::capabilityFewValues));
    notes.clear();
    points = pointsOf({1, 2, 3, 4, 5, 6, 7, 8, 9});
    limit(points, 0, 10);
    controlChart(points, notes);
    EXPECT_TRUE(contains(notes, notes::capabilityOutOfControl));
    notes.clear();
    points.back().upper_limit = 11;
    const ControlChart chart = controlChart(points, notes);
    EXPECT_FALSE(chart.capability_ppk);
    EXPECT_TRUE(contains(notes, notes::limitsDiffer));
}

TEST(ControlChart, verdicts_are_counted_as_they_were_made)
{
    Notes notes;
    auto points = pointsOf({1, 2, 3, 4});
    points[0].verdict = Verdict::Fail;
    points[1].verdict = Verdict::Undecided;
    points[2].verdict = Verdict::Pass;
    const ControlChart chart = controlChart(points, notes);
    EXPECT_EQ(chart.judged, 3);
    EXPECT_EQ(chart.out_of_tolerance, 1);
    EXPECT_EQ(chart.undecided, 1);
}

TEST(ControlChart, one_value_has_no_scatter)
{
    Notes notes;
    auto points = pointsOf({4});
    limit(points, 0, 10);
    const ControlChart chart = controlChart(points, notes);
    EXPECT_EQ(chart.mean, 4);
    EXPECT_FALSE(chart.standard_deviation);
    EXPECT_FALSE(chart.upper_control_limit);
    EXPECT_FALSE(chart.drift_per_100_parts);
    EXPECT_FALSE(chart.capability_ppk);
}

TEST(ControlChart, scales_with_the_unit)
{
    Notes notes;
    const std::vector<double> values{1, 3, 2, 5, 4, 2, 3};
    std::vector<double> scaled;
    scaled.reserve(values.size());
    for (const double value : values) scaled.push_back(1000 * value);
    auto mm = pointsOf(values), um = pointsOf(scaled);
    limit(mm, 0, 6);
    limit(um, 0, 6000);
    const ControlChart a = controlChart(mm, notes), b = controlChart(um, notes);
    EXPECT_NEAR(b.mean, 1000 * a.mean, 1e-9);
    EXPECT_NEAR(*b.standard_deviation, 1000 * *a.standard_deviation, 1e-9);
    EXPECT_NEAR(*b.upper_control_limit, 1000 * *a.upper_control_limit, 1e-9);
    EXPECT_NEAR(*b.drift_per_100_parts, 1000 * *a.drift_per_100_parts, 1e-9);
    EXPECT_NEAR(*b.capability_ppk, *a.capability_ppk, 1e-12);
    EXPECT_EQ(b.longest_run, a.longest_run);
}

}  // namespace
}  // namespace lathelier::series
