// The pruned search equals the exhaustive search over all strokes and points; distances are those of finely cut
// strokes.
#include "engine/cam/check/surface_deviation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "cam_data.h"

namespace lathelier::cam {
namespace {

Shaft partOf(std::mt19937& random)
{
    std::uniform_real_distribution<double> length(1, 12), diameter(8, 40);
    Shaft part;
    const int count = 3 + static_cast<int>(random() % 8);
    for (int i = 0; i < count; ++i) {
        const double start = diameter(random), long_mm = length(random);
        part.segments.push_back({long_mm, start, random() % 2 ? start : diameter(random), 0, {}, ""});
    }
    return part;
}

std::vector<CutterStroke> strokesOf(std::mt19937& random, double length_mm)
{
    std::uniform_real_distribution<double> z(-2, length_mm + 2), x(3, 22), angle(-3, 3);
    std::vector<CutterStroke> strokes;
    for (int i = 0; i < 60; ++i) {
        CutterStroke stroke;
        stroke.line = i + 1;
        stroke.radius_mm = 0.4;
        stroke.from = {z(random), x(random)};
        stroke.to = {z(random), x(random)};
        if (i % 3 == 1) {
            stroke.is_arc = true;
            stroke.centre = {z(random), x(random)};
            stroke.begin = angle(random);
            stroke.sweep = angle(random);
            stroke.from_radius_mm = stroke.to_radius_mm = 2;
            stroke.from = stroke.centre + 2 * Corner{std::cos(stroke.begin), std::sin(stroke.begin)};
            const double end = stroke.begin + stroke.sweep;
            stroke.to = stroke.centre + 2 * Corner{std::cos(end), std::sin(end)};
        } else if (i % 3 == 2) {
            stroke.body = stock::hullOf({stroke.from, stroke.to, stroke.from + Corner{2, 0}, stroke.to + Corner{2, 0},
                                         stroke.from + Corner{0, 5}, stroke.to + Corner{2, 5}});
        }
        strokes.push_back(stroke);
    }
    return strokes;
}

TEST(SurfaceDeviation, PrunedSearchIsTheFullSearch)
{
    std::mt19937 random(7);
    for (int round = 0; round < 20; ++round) {
        const Shaft part = partOf(random);
        const DrawnContour drawing(part, {}, 0.2);
        AllStrokes all{strokesOf(random, part.length_mm()), 40};
        const BarLimits bar{22, -1};
        const SurfaceDeviation found = surfaceDeviation(drawing, all, bar, {}, 0.002, 0.003);
        double gouge = 0, left_max = 0;
        for (std::size_t i = 0; i < drawing.points().size(); ++i) {
            const Corner& at = drawing.points()[i].at;
            double left = std::min(bar.radius_mm - at.x_mm, at.z_mm - bar.end_z_mm), own = 1e9;
            for (std::size_t k = 0; k < all.strokes.size(); ++k) {
                const double clearance = all.strokes[k].clearance_mm(at);
                left = std::min(left, clearance);
                if (k < all.own) own = std::min(own, clearance);
            }
            ASSERT_EQ(found.clearances[i].left_mm, left);
            ASSERT_EQ(found.clearances[i].own_mm, own);
            gouge = std::max(gouge, -own);
            left_max = std::max(left_max, left);
        }
        EXPECT_GE(found.gouge_mm, gouge);
        EXPECT_LT(found.gouge_mm, gouge + drawing.spacing_mm());
        EXPECT_GE(found.left_max_mm, left_max);
        EXPECT_LT(found.left_max_mm, left_max + drawing.spacing_mm());
    }
}

TEST(SurfaceDeviation, ArcsAreAsFarAsTheirPoints)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> angle(-6, 6), place(-5, 5);
    for (int round = 0; round < 200; ++round) {
        CutterStroke arc;
        arc.is_arc = true;
        arc.begin = angle(random) / 2;
        arc.sweep = angle(random);
        arc.from_radius_mm = arc.to_radius_mm = 3;
        arc.from = 3 * Corner{std::cos(arc.begin), std::sin(arc.begin)};
        arc.to = 3 * Corner{std::cos(arc.begin + arc.sweep), std::sin(arc.begin + arc.sweep)};
        const Corner at{place(random), place(random)};
        double nearest = 1e9;
        for (int i = 0; i <= 20000; ++i) {
            const double t = arc.begin + arc.sweep * i / 20000;
            nearest = std::min(nearest, stock::length_mm(at - 3 * Corner{std::cos(t), std::sin(t)}));
        }
        EXPECT_NEAR(arc.clearance_mm(at), nearest, 1e-3);
        EXPECT_LE(arc.clearance_mm(at), nearest + 1e-12);
    }
}

TEST(SurfaceDeviation, DrawnPointsLieOnTheDrawing)
{
    const Shaft part = *jobOf("small").shaft;
    const DrawnContour drawing(part);
    double length = 0;
    for (const ContourPiece& piece : drawing.pieces()) length += piece.length_mm();
    EXPECT_NEAR(drawing.points().back().along_mm, length, 1e-4);
    EXPECT_EQ(drawing.points().front().at, (Corner{0, 0}));
    EXPECT_NEAR(drawing.points().back().at.z_mm, 28, 1e-12);
    for (const DrawnPoint& point : drawing.points()) {
        const Corner normal = drawing.normalAt(point.piece, point.t);
        EXPECT_NEAR(stock::length_mm(normal), 1, 1e-9);
        if (point.at.z_mm > 16.1 && point.at.z_mm < 17.9) {
            EXPECT_NEAR(stock::length_mm(point.at - Corner{16, 12}), 2, 1e-9);
            EXPECT_NEAR(normal.z_mm, (16 - point.at.z_mm) / 2, 1e-9);
        }
    }
}

}  // namespace
}  // namespace lathelier::cam
