// Places of small steps, walls beside shoulders, worn seats beside undercuts.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/features/model/model.h"
#include "engine/features/recognition.h"
#include "made_scan.h"

namespace lathelier::features {
namespace {

TEST(Planes, AStepOfTheNoiseIsPlacedAsWellAsItIsSaid)
{
    const sample::ShaftModel shaft{piece(0, 20, 20, 20), piece(20, 40, 20.2, 20.2), piece(40, 60, 20.3, 20.3),
                                   piece(60, 80, 26, 26)};
    double squares = 0;
    int count = 0;
    for (std::uint64_t seed = 31; seed < 36; ++seed) {
        const Recognition r = recognize(scanShaft(shaft, askew(seed)), {});
        ASSERT_EQ(r.segments.size(), 4U) << seed;
        const double shift = r.segments[2].z_end_mm - 60;  // of the free end, which is less certain
        for (const std::size_t i : {0U, 1U}) {
            const double off = 1e3 * (r.segments[i].z_end_mm - shift - (i == 0 ? 20 : 40));
            EXPECT_NEAR(off, 0, 12) << seed << " step " << i;
            EXPECT_LT(r.segments[i].uncertainty.z_end_um.value_or(99), 16) << seed;
            squares += std::pow(2 * off / std::hypot(r.segments[i].uncertainty.z_end_um.value_or(0), 5.0), 2);
            ++count;
        }
    }
    EXPECT_LT(std::sqrt(squares / count), 1.5);
}

/// Mean over rays that hit the wall before an edge, read anywhere within their spot that lies before it.
double meanBeside(double edge_mm, double z_mm, double width_mm, double spot_mm, double (*radius)(double))
{
    double sum = 0, n = 0;
    for (int i = 0; i < 400; ++i)
        for (int k = 0; k < 400; ++k) {
            const double ray = z_mm + width_mm * ((i + 0.5) / 400 - 0.5), at = ray + spot_mm * ((k + 0.5) / 400 - 0.5);
            if (at > edge_mm) continue;
            sum += radius(at);
            n += 1;
        }
    return sum / n;
}

TEST(Planes, BesideAClearShoulderTheSpotEndsAtIt)
{
    Model model;
    model.spot_mm = 0.15;
    model.sigma_mm = 0.05;
    model.planes.resize(2);
    model.planes[1].z_mm = 10;
    model.planes[1].sigma_mm = 0.002;
    model.planes[1].is_clear = true;
    model.planes[1].low_side = -1;
    features::Run run;
    run.left = 0;
    run.right = 1;
    Element cone;
    cone.at_mm = 10;
    cone.level_mm = 12;
    cone.slope = 1;
    run.elements.push_back(cone);
    model.runs.push_back(run);
    resolve(model, model.runs[0]);
    for (const double z : {9.8, 9.92, 9.96}) {
        Wall wall;
        wall.z_mm = z;
        wall.width_mm = 0.05;
        EXPECT_TRUE(counts(model, model.runs[0], wall)) << z;
        const double mean = meanBeside(10, z, 0.05, 0.15, [](double at) { return 12 + (at - 10); });
        EXPECT_NEAR(predicted_mm(model, model.runs[0], wall), mean, 1.5e-3) << z;
    }
    Wall beyond;
    beyond.z_mm = 9.99;
    beyond.width_mm = 0.05;
    EXPECT_FALSE(counts(model, model.runs[0], beyond));
    model.planes[1].is_clear = false;
    Wall blurred;
    blurred.z_mm = 9.92;
    blurred.width_mm = 0.05;
    EXPECT_FALSE(counts(model, model.runs[0], blurred));
}

TEST(Planes, NoiseAlongTheNormalMovesTheMeanOverAnArc)
{
    constexpr double sigma = 0.1, rho = 3;
    std::mt19937_64 random(9);
    std::normal_distribution<double> noise(0, sigma);
    std::uniform_real_distribution<double> turn(0.02, M_PI / 2 - 0.02);
    Model model;
    model.sigma_mm = sigma;
    model.corner_mm = 0.16;  // a surface scan
    model.planes.resize(2);
    model.planes[1].z_mm = rho;
    features::Run run;
    run.right = 1;
    Element hollow;  // r = 20 + ρ - √(ρ² - z²)
    hollow.arc = true;
    hollow.centre_r_mm = 20 + rho;
    hollow.log_radius = std::log(rho);
    run.elements.push_back(hollow);
    model.runs.push_back(run);
    resolve(model, model.runs[0]);
    for (const double z : {0.8, 1.5, 2.0}) {
        constexpr double width = 0.05;
        double sum = 0, n = 0;
        for (int i = 0; i < 2000000; ++i) {
            const double angle = turn(random), off = rho - noise(random), at = off * std::sin(angle);
            if (std::abs(at - z) > width / 2) continue;
            sum += 20 + rho - off * std::cos(angle);
            n += 1;
        }
        Wall wall;
        wall.z_mm = z;
        wall.width_mm = width;
        EXPECT_NEAR(predicted_mm(model, model.runs[0], wall), sum / n, 3e-3) << z;
    }
}

TEST(Planes, WearDoesNotBendTheUndercutBesideIt)
{
    const double run_out = 0.2 / std::tan(15 * M_PI / 180);
    sample::ShaftModel shaft{piece(0, 1, 18, 20), piece(1, 23, 20, 20), piece(23, 23 + run_out, 20, 19.6),
                             piece(23 + run_out, 24.4, 19.6, 19.6)};
    shaft[1].barrel_um = 12;
    shaft[1].taper_start_um = 10;
    shaft[1].taper_end_um = -10;
    addArc(shaft, 24.4, 25, 24.4, 10.4, 0.6, false);
    shaft.push_back(piece(25, 60, 28, 28));
    for (std::uint64_t seed = 41; seed < 43; ++seed) {
        const Recognition r = recognize(scanShaft(shaft, askew(seed)), {});
        ASSERT_EQ(r.segments.size(), 6U) << seed;
        EXPECT_EQ(r.segments[1].kind, RowKind::Cylinder);
        EXPECT_EQ(r.segments[2].kind, RowKind::Cone) << seed;
        EXPECT_NEAR(r.segments[2].half_angle_deg, -15, 2) << seed;
        EXPECT_NEAR(r.segments[3].start_diameter_mm, 19.6, 6e-3) << seed;
        EXPECT_NEAR(r.segments[1].start_diameter_mm, 20 + 4 * 0.012 / 3, 2e-3) << seed;
        EXPECT_GT(r.segments[1].form_pv_um, 9) << seed;  // the wear is reported although it was subtracted
    }
}

}  // namespace
}  // namespace lathelier::features
