// Errors of the source paper, as regression tests.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/trajectory/surface_image.h"
#include "engine/trajectory/trajectory_codes.h"
#include "tests/engine/trajectory/truth.h"

namespace lathelier::trajectory {
namespace {

using std::numbers::pi;

// The paper's eq. (1) takes the spindle's angle for that of the point on the part.
TEST(PaperTraps, ThePolarAngleIsCorrected)
{
    // A tool that stands 5 mm high shows the whole image turned by 11.5°: with the paper's angle it would not be.
    const std::vector<double> angle_deg{0, 90, 180, 270};
    const std::vector<double> zero(4, 0.0), high(4, 5000.0);
    const SurfaceImage image = imageOf({zero, zero, zero, high}, angle_deg, 50, Rotation::Same);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(image.radius_mm[i], std::hypot(25, 5), 1e-12);
        EXPECT_NEAR(std::remainder(image.body_angle_deg[i] - (angle_deg[i] + std::atan2(-5, 25) * 180 / pi), 360), 0,
                    1e-9);
    }
    // A perfect shaft that runs out by e: its circle comes back at the part's own radius with the corrected angle only.
    std::vector<double> x, y, even;
    constexpr int n = 360;
    constexpr double e_um = 2000, r_mm = 25;
    for (int i = 0; i < n; ++i) {
        const double t = 2 * pi * i / n;
        even.push_back(360.0 * i / n);
        // The axis goes round the spindle's; the tool is drawn along the ray on which the surface stays a circle of
        // radius r about the spindle axis: P = (r, 0).
        x.push_back(e_um * std::cos(t));
        y.push_back(e_um * std::sin(t));
    }
    const std::vector<double> still(n, 0.0);
    const SurfaceImage round = imageOf({x, y, still, still}, even, 2 * r_mm, Rotation::Same);
    const std::vector<Eigen::Vector2d> points = round.points_mm();
    const form::FittedCircle circle = form::fitLeastSquaresCircle(points);
    EXPECT_NEAR(circle.RONt_um, 0, 1e-6);
    EXPECT_NEAR(circle.radius_mm, r_mm, 1e-9);
    EXPECT_NEAR(circle.centre_mm.norm(), 1e-3 * e_um, 1e-9);
    // With the paper's angle the same radii are no circle.
    std::vector<Eigen::Vector2d> papers;
    for (int i = 0; i < n; ++i)
        papers.push_back(round.radius_mm[static_cast<std::size_t>(i)] *
                         Eigen::Vector2d(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n)));
    EXPECT_GT(form::fitLeastSquaresCircle(papers).RONt_um, 50);
}

// Two probes cannot separate the mandrel's form from its motion (trap 5): it appears in full as form of the part.
TEST(PaperTraps, TheMandrelsFormIsAFloorThatIsStated)
{
    sample::SpindleModel model = fineModel();
    model.axis = {{1, 10, 0, 10, pi / 2}};
    model.tool = {};
    model.taper_diameter_um = 0;
    model.barrel_um = 0;
    io::ProbeRecord record = sample::makeProbeRecord(model);
    for (std::size_t i = 0; i < record.frames(); ++i) {  // a mandrel with three lobes of 0.1 µm, seen by the X probe
        const double turn = model.speed_rpm / 60 * (record.time_s[i] + model.channel_skew_s) - model.lead_turns;
        record.channels[1].values[i] += 0.1 * std::cos(3 * 2 * pi * turn);
    }
    const TrajectoryResult result = trajectory({fileOf(record)});
    EXPECT_NEAR(result.sections[2].roundness.circles.LSCI.RONt_um, 0.2, 0.01);
    EXPECT_EQ(result.mandrel_form_um, 0.2);
    EXPECT_TRUE(contains(result.notes, notes::mandrelFloor));
}

// Seen from the part the angle runs the other way (trap 6): the same form, a mirrored centre.
TEST(PaperTraps, TheMirroredImageHasTheSameFormAndAnotherCentre)
{
    const sample::SpindleModel model = fineModel();
    TrajectoryParameters parameters;
    const std::vector<io::ProbeFile> records{fileOf(sample::makeProbeRecord(model))};
    const form::FittedCircle same = trajectory(records, parameters).sections[0].roundness.circles.LSCI;
    parameters.rotation = Rotation::Opposite;
    const form::FittedCircle mirrored = trajectory(records, parameters).sections[0].roundness.circles.LSCI;
    EXPECT_NEAR(mirrored.RONt_um, same.RONt_um, 1e-6);
    EXPECT_NEAR(mirrored.centre_mm.x(), same.centre_mm.x(), 1e-9);
    EXPECT_NEAR(mirrored.centre_mm.y(), -same.centre_mm.y(), 1e-9);
    EXPECT_GT(std::abs(same.centre_mm.y()) * 1e3, 1);
}

// Run-out is not roundness (trap 1); single revolutions show what their mean hides (trap 5).
TEST(PaperTraps, RunOutAndSingleRevolutionsAreShownBesideRoundness)
{
    sample::SpindleModel model = fineModel();
    model.whirl_um = 2;
    const TrajectorySection section = trajectory({fileOf(sample::makeProbeRecord(model))}).sections[0];
    EXPECT_GT(section.run_out_um, 20);
    EXPECT_LT(section.roundness.circles.LSCI.RONt_um, 12);
    ASSERT_EQ(section.revolution_RONt_um.size(), 8u);
    ASSERT_EQ(section.envelope_min_mm.size(), 200u);
    for (std::size_t i = 0; i < 200; ++i) {
        EXPECT_LE(section.envelope_min_mm[i], section.radius_mm[i]);
        EXPECT_GE(section.envelope_max_mm[i], section.radius_mm[i]);
    }
    EXPECT_NEAR(section.spindle.asynchronous_um, 4, 0.6);
}

}  // namespace
}  // namespace lathelier::trajectory
