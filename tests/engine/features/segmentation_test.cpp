// The exact segmentation against all segmentations, the likelihood on discrete rows, junctions and ties of the model.
#include "engine/features/walls/segmentation.h"
#include "engine/features/walls/wall_limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "engine/core/random.h"
#include "engine/features/model/model_fit.h"
#include "engine/features/model/selection.h"
#include "engine/features/outline/edges.h"

namespace lathelier::features {
namespace {

Wall wallAt(double z, double r, std::uint64_t place)
{
    Wall wall;
    wall.z_mm = z;
    wall.points = 200;
    wall.sigma_mm = 0.05;
    wall.width_mm = 0.1;
    wall.r_mm = r + 0.0035 * 1.7 * (2 * randomUniform(11, 0, place) - 1);
    return wall;
}

/// The least cost of all cuttings into lines and arcs, tried one by one.
double bestOfAll(const std::vector<Wall>& walls)
{
    const std::size_t n = walls.size();
    std::vector<double> known(n + 1, -1);
    const std::function<double(std::size_t)> upTo = [&](std::size_t j) -> double {
        if (j == 0) return 0;
        if (known[j] >= 0) return known[j];
        double best = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i + segmentationLimits.least_line_walls <= j; ++i) {
            const double before = upTo(i);
            if (before == std::numeric_limits<double>::infinity()) continue;
            const std::span<const Wall> piece(walls.data() + i, j - i);
            best = std::min(best, before + lineCost(piece) + linePrice(n));
            if (piece.size() >= segmentationLimits.least_arc_walls)
                best = std::min(best, before + arcCost(piece) + arcPrice(n));
        }
        return known[j] = best;
    };
    return upTo(n);
}

TEST(Segmentation, IsTheBestOfAllCuttings)
{
    std::vector<Wall> walls;
    for (int i = 0; i < 40; ++i) {
        const double z = 180 + 0.1 * i, x = 0.1 * i;
        const double r = x < 1.2   ? 15
                         : x < 2.4 ? 15 - 0.6 * (x - 1.2)
                                   : 14.28 - 1 + std::sqrt(std::max(0.0, 4 - std::pow(x - 2.4, 2))) - 1;
        walls.push_back(wallAt(z, r, static_cast<std::uint64_t>(i)));
    }
    const std::vector<Piece> pieces = cutIntoPieces(walls);
    double cost = 0;
    std::size_t at = 0;
    for (const Piece& piece : pieces) {
        EXPECT_EQ(piece.begin, at);
        at = piece.end;
        const std::span<const Wall> own(walls.data() + piece.begin, piece.end - piece.begin);
        cost += piece.arc ? arcCost(own) + arcPrice(walls.size()) : lineCost(own) + linePrice(walls.size());
    }
    EXPECT_EQ(at, walls.size());
    EXPECT_NEAR(cost, bestOfAll(walls), 1e-6 * cost);
    EXPECT_EQ(pieces.size(), 3U);
    EXPECT_TRUE(pieces.back().arc);
}

TEST(Edges, LikelihoodOnDiscreteRows)
{
    // Rows 0.1 mm apart that the tilt moves by -0.1…0.1 mm over the turn; the spot blurs the edge by 0.15 mm.
    registration::EdgeRays edge;
    edge.edge.sign = -1;
    const double place = -98.0137;  // height: z = 98.0137
    std::uint64_t k = 0;
    for (int row = -12; row <= 12; ++row)
        for (int ray = 0; ray < 400; ++ray, ++k) {
            const double height = -98 + 0.1 * row + 0.1 * std::sin(2 * M_PI * ray / 400);
            const double strikes = height + 0.15 * (randomUniform(5, 0, k) - 0.5);
            edge.rays.push_back({height, strikes > place});
        }
    std::sort(edge.rays.begin(), edge.rays.end(), [](const auto& a, const auto& b) { return a.height < b.height; });
    const auto found = placeOf(edge);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->z_mm, 98.0137, 4 * found->sigma_mm);
    EXPECT_LT(found->sigma_mm, 0.004);
    EXPECT_NEAR(found->spot_mm, 0.15, 0.031);
    edge.rays.resize(5);
    EXPECT_FALSE(placeOf(edge));
}

/// One run between two planes.
Model modelOf(std::vector<Element> elements, double from, double to)
{
    Model model;
    model.planes.resize(2);
    model.planes[0].z_mm = model.planes[0].seen_mm = from;
    model.planes[1].z_mm = model.planes[1].seen_mm = to;
    Run run;
    run.right = 1;
    run.elements = std::move(elements);
    run.nodes_mm.assign(run.elements.size() + 1, 0);
    for (std::size_t i = 0; i < run.nodes_mm.size(); ++i)
        run.nodes_mm[i] = from + (to - from) * static_cast<double>(i) / static_cast<double>(run.elements.size());
    model.runs.push_back(run);
    resolve(model, model.runs[0]);
    return model;
}

Element line(double level, double slope, double at)
{
    Element e;
    e.level_mm = level;
    e.slope = slope;
    e.at_mm = at;
    e.cylinder = slope == 0;
    return e;
}

TEST(Model, TiesGiveTheCentre)
{
    // A fillet R 2 between Ø20 and a face at z 10.
    Element fillet = arcOverChord(8, 10, 10, 12, 2, false);
    fillet.start = Tie::Tangent;
    fillet.end = Tie::Plane;
    const Model foot = modelOf({line(10, 0, 0), fillet}, 0, 10);
    EXPECT_NEAR(foot.runs[0].elements[1].centre_z_mm, 8, 1e-12);
    EXPECT_NEAR(foot.runs[0].elements[1].centre_r_mm, 12, 1e-12);
    EXPECT_NEAR(foot.runs[0].nodes_mm[1], 8, 1e-12);
    EXPECT_EQ(foot.runs[0].violation, 0);

    // A round R 3 at the free end, tangent to the cylinder after it.
    Element round = arcOverChord(0, 7, 3, 10, 3, true);
    round.start = Tie::Plane;
    round.end = Tie::Tangent;
    const Model end = modelOf({round, line(10, 0, 5)}, 0, 10);
    EXPECT_NEAR(end.runs[0].elements[0].centre_z_mm, 3, 1e-12);
    EXPECT_NEAR(end.runs[0].elements[0].centre_r_mm, 7, 1e-12);
    EXPECT_NEAR(startRadius_mm(end.runs[0]), 7, 1e-9);

    // A hollow arc R 5 tangent to a cylinder and a cone of 45°: feet at tan(22.5°)·R from the corner.
    Element hollow = arcOverChord(8, 10, 12, 12, 5, false);
    hollow.start = hollow.end = Tie::Tangent;
    const Model corner = modelOf({line(10, 0, 0), hollow, line(10, 1, 10)}, 0, 20);
    const double t = 5 * std::tan(M_PI / 8);
    EXPECT_NEAR(corner.runs[0].nodes_mm[1], 10 - t, 1e-9);
    EXPECT_NEAR(corner.runs[0].nodes_mm[2], 10 + t / std::sqrt(2), 1e-9);

    // A free arc meets the lines where they cross it.
    const Model free = modelOf({line(10, 0, 0), arcOverChord(8, 10, 12, 10, 5, true), line(10, 0, 20)}, 0, 20);
    EXPECT_NEAR(free.runs[0].nodes_mm[1], 8, 1e-9);
    EXPECT_NEAR(free.runs[0].nodes_mm[2], 12, 1e-9);
}

TEST(Model, PredictionIsTheMeanOverSpotAndBin)
{
    Model model = modelOf({line(10, 0, 0), line(10, -1, 5)}, 0, 10);
    model.spot_mm = 0.2;
    Wall wall;
    wall.z_mm = 5;
    wall.width_mm = 0.1;
    // Mean of max(0, x) over the sum of two even spreads of widths a, b: (a² + b²/3 …) by numeric integration.
    double mean = 0;
    constexpr int n = 400;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double x = 0.2 * ((i + 0.5) / n - 0.5) + 0.1 * ((j + 0.5) / n - 0.5);
            mean += std::max(0.0, x) / n / n;
        }
    EXPECT_NEAR(predicted_mm(model, model.runs[0], wall), 10 - mean, 4e-3);
    wall.z_mm = 4;
    EXPECT_NEAR(predicted_mm(model, model.runs[0], wall), 10, 1e-12);
}

TEST(Model, FitFindsAChamfer)
{
    Model model = modelOf({line(10.01, 0, 0), line(9.5, -0.9, 8.6)}, 0, 9);
    std::uint64_t k = 0;
    for (double z = 0.05; z < 9; z += 0.05) model.runs[0].walls.push_back(wallAt(z, z < 8 ? 10 : 18 - z, 100 + k++));
    for (Wall& wall : model.runs[0].walls) wall.width_mm = 0;
    const JointFit fit = fitAll(model, 30);
    EXPECT_TRUE(fit.converged);
    EXPECT_NEAR(model.runs[0].elements[0].level_mm, 10, 1e-3);
    EXPECT_NEAR(model.runs[0].elements[1].slope, -1, 0.02);
    EXPECT_NEAR(model.runs[0].nodes_mm[1], 8, 0.02);
    EXPECT_EQ(fit.covariance.rows(), static_cast<Eigen::Index>(fit.slots.size()));
}

}  // namespace
}  // namespace lathelier::features
