// Structure that is no body of revolution: never invented, never silent; and what correlated noise does to U.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "engine/core/random.h"
#include "engine/features/features_codes.h"
#include "engine/features/structure/map_cells.h"
#include "engine/features/structure/map_regions.h"
#include "engine/features/structure/mark_proof.h"
#include "engine/features/structure/residual_map.h"
#include "engine/features/walls/walls.h"
#include "shaped_scan.h"

namespace lathelier::features {
namespace {

constexpr double pi = std::numbers::pi;

Recognition recognized(const Shape& shape, std::uint64_t seed = 1)
{
    return recognize(shapedScan(collarPart(), coarser(seed), shape), {});
}

/// The row at z; error of its diameter over its U.
double errorOverU(const Recognition& result, double z_mm, double diameter_mm)
{
    for (const RecognizedRow& row : result.segments)
        if (row.z_start_mm < z_mm && row.z_end_mm > z_mm)
            return std::abs(row.start_diameter_mm - diameter_mm) / (1e-3 * *row.uncertainty.start_diameter_um);
    return HUGE_VAL;
}

const UnexplainedStructure* structureAt(const Recognition& result, double z_mm)
{
    for (const UnexplainedStructure& one : result.unexplained)
        if (one.z_start_mm < z_mm && one.z_end_mm > z_mm) return &one;
    return nullptr;
}

void expectNothingInvented(const Recognition& result)
{
    EXPECT_TRUE(result.bores.empty());
    EXPECT_TRUE(result.marks.empty());
    EXPECT_LE(result.segments.size(), 5U);
}

TEST(Structure, ACleanShaftHasNone)
{
    const Recognition result = recognized([](const AroundPoint& p) { return p.r_mm; });
    EXPECT_TRUE(result.unexplained.empty());
    EXPECT_EQ(result.variance_ratio, 1);
    EXPECT_EQ(result.passes_differ_um, 0);
    for (const RecognizedRow& row : result.segments) EXPECT_FALSE(row.lobes.lobes);
}

const ShaftMark* onlyMarkOf(const Recognition& result, MarkKind kind)
{
    return result.marks.size() == 1 && result.marks.front().kind == kind ? &result.marks.front() : nullptr;
}

class Splines : public testing::TestWithParam<int> {};

TEST_P(Splines, AreNoHollowShaft)
{
    for (const double share : {0.4, 0.5, 0.6}) {
        const Recognition result = recognized([&](const AroundPoint& p) {
            const double turn = GetParam() * p.angle_rad / (2 * pi);
            return p.z_mm < 30 && turn - std::floor(turn) > share ? p.r_mm - 1.2 : p.r_mm;
        });
        EXPECT_TRUE(result.bores.empty()) << share;
        EXPECT_TRUE(result.unexplained.empty()) << share;
        const ShaftMark* const mark = onlyMarkOf(result, MarkKind::Spline);
        EXPECT_NEAR(result.length_mm.value(), 97, result.length_uncertainty_mm) << share;
        ASSERT_TRUE(mark) << share;
        EXPECT_EQ(*mark->teeth, GetParam()) << share;
        EXPECT_NEAR(*mark->major_mm, 25, std::max(0.01, *mark->uncertainty_mm)) << share;
        EXPECT_NEAR(*mark->minor_mm, 22.6, 0.02) << share;
        EXPECT_NEAR(*mark->z_end_mm, 30, 0.3) << share;
        EXPECT_LE(result.segments.size(), 5U) << share;
        EXPECT_LT(errorOverU(result, 15, 25), 2) << share;
        EXPECT_LT(errorOverU(result, 48, 40), 2) << share;
        EXPECT_LT(errorOverU(result, 75, 25), 2) << share;
    }
}

INSTANTIATE_TEST_SUITE_P(Teeth, Splines, testing::Values(6, 8, 10, 24));

double eccentricRadius_mm(double radius_mm, double offset_mm, double angle_rad)
{
    const double side = offset_mm * std::sin(angle_rad);
    return offset_mm * std::cos(angle_rad) + std::sqrt(radius_mm * radius_mm - side * side);
}

TEST(Structure, AnEccentricCollarIsNamedAndMovesNoShoulder)
{
    for (const double offset_mm : {0.05, 0.2, 0.4, 1.0}) {
        const Recognition result = recognized([&](const AroundPoint& p) {
            return p.z_mm > 41 && p.z_mm < 56 ? eccentricRadius_mm(p.r_mm, offset_mm, p.angle_rad - 0.5) : p.r_mm;
        });
        EXPECT_TRUE(result.bores.empty());
        if (offset_mm > 0.1) {
            const ShaftMark* const mark = onlyMarkOf(result, MarkKind::Eccentric);
            ASSERT_TRUE(mark) << offset_mm;
            EXPECT_NEAR(*mark->offset_mm, offset_mm, *mark->uncertainty_mm) << offset_mm;
            EXPECT_NEAR(*mark->diameter_mm, 40, 0.01) << offset_mm;
            EXPECT_TRUE(result.unexplained.empty()) << offset_mm;
        } else {
            // An error of form, too small for an eccentric that somebody meant.
            expectNothingInvented(result);
            const UnexplainedStructure* const found = structureAt(result, 48);
            ASSERT_TRUE(found) << offset_mm;
            EXPECT_EQ(found->kind, StructureKind::Eccentric) << offset_mm;
            EXPECT_NEAR(*found->height_mm, offset_mm, 0.01) << offset_mm;
            EXPECT_TRUE(contains(result.notes, notes::segmentNotCoaxial)) << offset_mm;
        }
        ASSERT_EQ(result.segments.size(), 5U) << offset_mm;
        for (const auto& [row, z_mm] : {std::pair<std::size_t, double>{1, 41}, {2, 56}})
            EXPECT_LT(std::abs(result.segments[row].z_end_mm - z_mm), 2e-3 * *result.segments[row].uncertainty.z_end_um)
                << offset_mm;
    }
}

/// Less noise than the offset makes a rough zone of the collar: a thread of one start to a careless search.
TEST(Structure, AnEccentricIsNoThread)
{
    for (const double offset_mm : {0.3, 1.2, 3.0}) {
        sample::ScannerModel scanner = coarser(11);
        scanner.sigma_mm = 0.02;
        scanner.row_pitch_mm = 0.25;
        const Scan scan = shapedScan(collarPart(), scanner, [&](const AroundPoint& p) {
            if (p.z_mm < 41 || p.z_mm > 56) return p.r_mm;
            return eccentricRadius_mm(p.r_mm, offset_mm, p.angle_rad);
        });
        const Recognition result = recognize(scan, {});
        EXPECT_TRUE(result.bores.empty()) << offset_mm;
        const ShaftMark* const mark = onlyMarkOf(result, MarkKind::Eccentric);
        ASSERT_TRUE(mark) << offset_mm;
        EXPECT_NEAR(*mark->offset_mm, offset_mm, *mark->uncertainty_mm) << offset_mm;
        EXPECT_NEAR(result.segments[2].start_diameter_mm, 40, 0.01) << offset_mm;
        EXPECT_LT(errorOverU(result, 20, 25), 2) << offset_mm;
    }
}

TEST(Structure, AFlatOverACollarMovesNoShoulder)
{
    for (const double distance_mm : {14.0, 16.0, 18.0}) {
        const Recognition result = recognized([&](const AroundPoint& p) {
            const double across = p.r_mm * std::cos(p.angle_rad - 0.8);
            return p.z_mm > 41 && p.z_mm < 56 && across > distance_mm ? distance_mm / std::cos(p.angle_rad - 0.8)
                                                                      : p.r_mm;
        });
        ASSERT_EQ(result.segments.size(), 5U) << distance_mm;
        EXPECT_TRUE(result.bores.empty());
        EXPECT_TRUE(!result.marks.empty() || structureAt(result, 48)) << distance_mm;
        for (const ShaftMark& mark : result.marks) EXPECT_EQ(mark.kind, MarkKind::Flat) << distance_mm;
        for (const auto& [row, z_mm] : {std::pair<std::size_t, double>{1, 41}, {2, 56}})
            EXPECT_NEAR(result.segments[row].z_end_mm, z_mm, 0.02) << distance_mm;
        EXPECT_NEAR(result.spot_mm, recognized([](const AroundPoint& p) { return p.r_mm; }).spot_mm, 0.05);
    }
}

/// Cells of parts longer than 5 m are longer than 1 mm.
TEST(Structure, RowsOfTheMapFollowItsCells)
{
    ResidualMap map;
    map.first_mm = -10;
    map.cell_mm = 2;
    EXPECT_EQ(map.rowOf(-9), 0U);
    EXPECT_EQ(map.rowOf(9), 9U);
}

/// On a slope of 45° the spot moves points by up to half its width along z, and so along the radius.
TEST(Structure, TheSpotIsNoiseOnSlopes)
{
    const auto offOf = [](double mean_mm, float sine2, double spot_mm) {
        ResidualMap map;
        map.rows = 1;
        map.sigma_mm = 0.005;
        map.spot_mm = spot_mm;
        map.cells.assign(mapSectors, {.on = 16, .sine2 = 16 * sine2});
        map.cells[30].sum_mm = static_cast<float>(16 * mean_mm);
        const std::vector<std::uint8_t> off = offCells(map, 0.02);
        return std::count(off.begin(), off.end(), 1);
    };
    // Standard deviations of the mean: 1.25 µm on a cylinder, √(0.005² + 0.15²/24)/4 = 7.8 µm on the slope.
    EXPECT_EQ(offOf(0.03, 0, 0.15), 1);
    EXPECT_EQ(offOf(0.03, 0.5F, 0), 1);
    EXPECT_EQ(offOf(0.03, 0.5F, 0.15), 0);
    EXPECT_EQ(offOf(0.05, 0.5F, 0.15), 1);
}

TEST(Structure, ChamfersOfAQuietScanHaveNone)
{
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        sample::ScannerModel scanner = coarser(seed);
        scanner.sigma_mm = 0.005;
        const Recognition result =
            recognize(shapedScan(collarPart(), scanner, [](const AroundPoint& p) { return p.r_mm; }), {});
        EXPECT_TRUE(result.unexplained.empty()) << seed;
    }
}

TEST(Structure, PatchesWithoutPointsAreNoHoles)
{
    sample::ScannerModel scanner = coarser(3);
    scanner.dropout_share = 0.25;
    EXPECT_TRUE(recognize(scanShaft(collarPart(), scanner), {}).unexplained.empty());
}

TEST(Structure, PitsAreNoFlats)
{
    const Recognition result = recognized([](const AroundPoint& p) {
        double r = p.r_mm;
        for (int i = 0; i < 8; ++i) {
            const double dz = p.z_mm - (6 + 4 * i), along = p.r_mm * std::remainder(p.angle_rad - 1.3 * i, 2 * pi),
                         size = 1.2 + 0.15 * i;
            r -= (0.15 + 0.05 * i) * std::max(0.0, 1 - (dz * dz + along * along) / (size * size));
        }
        return r;
    });
    expectNothingInvented(result);
    ASSERT_FALSE(result.unexplained.empty());
    EXPECT_EQ(result.unexplained.front().kind, StructureKind::Sunken);
    EXPECT_LT(errorOverU(result, 75, 25), 2);
}

TEST(Structure, DamageIsWhatAPersonSays)
{
    RecognitionParameters parameters;
    parameters.unexplained = Unexplained::Damage;
    const Scan scan = shapedScan(collarPart(), coarser(4), [](const AroundPoint& p) {
        const double along = p.r_mm * p.angle_rad, dz = p.z_mm - 20;
        return p.r_mm - 0.5 * std::max(0.0, 1 - (dz * dz + along * along) / 9);
    });
    const Recognition refused = recognize(scan, {}), accepted = recognize(scan, parameters);
    EXPECT_TRUE(contains(refused.notes, notes::unexplainedStructure));
    EXPECT_FALSE(contains(accepted.notes, notes::unexplainedStructure));
    EXPECT_TRUE(contains(accepted.notes, notes::takenForDamage));
    EXPECT_EQ(accepted.unexplained.size(), refused.unexplained.size());
}

TEST(Structure, LobesAreOfTheRow)
{
    for (const int lobes : {2, 3, 5}) {
        const Recognition result = recognized([&](const AroundPoint& p) {
            return p.z_mm > 1 && p.z_mm < 41 ? p.r_mm + 0.015 * std::cos(lobes * p.angle_rad) : p.r_mm;
        });
        ASSERT_EQ(result.segments.size(), 5U);
        ASSERT_TRUE(result.segments[1].lobes.lobes) << lobes;
        EXPECT_EQ(*result.segments[1].lobes.lobes, lobes);
        EXPECT_NEAR(*result.segments[1].lobes.height_um, 30, 2);
        EXPECT_FALSE(result.segments[2].lobes.lobes) << lobes;
        EXPECT_TRUE(contains(result.notes, notes::rowsNotRound));
        EXPECT_TRUE(result.unexplained.empty()) << lobes;
    }
}

/// Lobes as large as the noise widen the scatter of a wall; its radius stays their mean.
TEST(Structure, LobesAreNoRoughZone)
{
    sample::ScannerModel scanner = coarser(13);
    scanner.sigma_mm = 0.015;
    const Scan scan = shapedScan(collarPart(), scanner, [&](const AroundPoint& p) {
        return p.z_mm > 1 && p.z_mm < 41 ? p.r_mm + 0.03 * std::cos(3 * p.angle_rad) : p.r_mm;
    });
    const Recognition result = recognize(scan, {});
    ASSERT_EQ(result.segments.size(), 5U);
    EXPECT_LT(errorOverU(result, 20, 25), 2);
    EXPECT_FALSE(contains(result.notes, notes::roughZone));
    ASSERT_TRUE(result.segments[1].lobes.lobes);
    EXPECT_NEAR(*result.segments[1].lobes.height_um, 60, 3);
}

/// Errors of diameters within U, over all rows of parts with this noise.
double shareWithinU(
    const std::function<double(std::size_t index, double z_mm, double angle_rad, std::uint64_t seed)>& noise, int parts)
{
    int all = 0, within = 0;
    for (int seed = 0; seed < parts; ++seed) {
        sample::ScannerModel scanner = coarser(static_cast<std::uint64_t>(seed) + 10);
        scanner.sigma_mm = 0.02;
        const Scan scan = shapedScan(collarPart(), scanner, [&](const AroundPoint& p) {
            return p.r_mm + noise(p.index, p.z_mm, p.angle_rad, static_cast<std::uint64_t>(seed));
        });
        const Recognition result = recognize(scan, {});
        EXPECT_EQ(result.segments.size(), 5U) << seed;
        for (const auto& [z, diameter] : {std::pair{20.0, 25.0}, {48.0, 40.0}, {75.0, 25.0}}) {
            ++all;
            within += errorOverU(result, z, diameter) <= 1 ? 1 : 0;
        }
    }
    return static_cast<double>(within) / all;
}

TEST(StatedUncertainty, HoldsWithWaves)
{
    // Waves of 7 mm as photogrammetry leaves them, 24 of random direction and phase.
    const double share = shareWithinU(
        [](std::size_t, double z, double angle, std::uint64_t seed) {
            double sum = 0;
            for (std::uint64_t w = 0; w < 24; ++w) {
                const double k = 2 * pi / 7, toward = 2 * pi * randomUniform(7, seed, 2 * w);
                sum += std::cos(k * (z * std::cos(toward) + 12.5 * std::cos(angle) * std::sin(toward)) +
                                2 * pi * randomUniform(7, seed, 2 * w + 1));
            }
            return 0.03 * sum / std::sqrt(12.0);
        },
        10);
    EXPECT_GE(share, 0.86);
}

TEST(StatedUncertainty, HoldsWithTwoPasses)
{
    // One pass behind the other in the file; the second reads 40 µm too much.
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        Scan scan = scanShaft(collarPart(), coarser(seed));
        const Scan second =
            shapedScan(collarPart(), coarser(seed + 10), [](const AroundPoint& p) { return p.r_mm + 0.04; });
        scan.points_mm.insert(scan.points_mm.end(), second.points_mm.begin(), second.points_mm.end());
        const Recognition result = recognize(scan, {});
        EXPECT_NEAR(result.passes_differ_um, 20, 4) << seed;
        EXPECT_EQ(result.segments.size(), 5U) << seed;
        EXPECT_TRUE(contains(result.notes, notes::passesDiffer)) << seed;
        for (const auto& [z, diameter] : {std::pair{20.0, 25.0}, {48.0, 40.0}, {75.0, 25.0}})
            EXPECT_LE(errorOverU(result, z, diameter), 1) << seed;
    }
}

TEST(StatedUncertainty, SharedErrorsOfAWall)
{
    Walls walls;
    walls.chains.resize(1);
    walls.chains[0].walls.resize(1);
    walls.chains[0].walls[0].sigma_mm = 0.03;
    walls.chains[0].walls[0].points = 25;
    // σ of the mean 6 µm; five times its variance, and 16 µm besides: √(4·36 + 256) µm are shared.
    EXPECT_NEAR(withSharedErrors(walls, 5, 0.016).chains[0].walls[0].shared_mm, 0.02, 1e-12);
    EXPECT_EQ(withSharedErrors(walls, 1, 0).chains[0].walls[0].shared_mm, 0);
}

TEST(MapRegions, CloseAroundTheAxis)
{
    // Two rows of six columns: a region over the seam, one cell apart from it.
    const std::vector<std::uint8_t> taken{1, 0, 0, 1, 0, 1, /**/ 0, 0, 0, 0, 0, 1};
    const auto closed = connectedRegions(taken, 6, true), open = connectedRegions(taken, 6, false);
    ASSERT_EQ(closed.size(), 2U);
    EXPECT_EQ(closed[0], (std::vector<std::size_t>{0, 5, 11}));
    EXPECT_EQ(open.size(), 3U);
    const RegionBox box = boxOf(closed[0], 6, true);
    EXPECT_EQ(box.first_column, 5U);
    EXPECT_EQ(box.columns(), 2U);
    EXPECT_EQ(box.rows(), 2U);
    std::vector<std::size_t> ring(6);
    for (std::size_t i = 0; i < 6; ++i) ring[i] = i;
    EXPECT_EQ(boxOf(ring, 6, true).columns(), 6U);
}

TEST(MarkProof, FloorsAndChords)
{
    // A flat 11 mm from the axis of Ø25 has the chord 11.87 mm; a keyway of 8 mm at 8.5 mm has walls.
    EXPECT_EQ(floorShape(12.5, 11, 2 * std::sqrt(12.25 * 12.25 - 121), 0.25), FloorShape::Flat);
    EXPECT_EQ(floorShape(12.5, 8.5, 8, 0.25), FloorShape::Keyway);
    EXPECT_EQ(floorShape(12.5, 8.5, 14, 0.25), FloorShape::Neither);
    std::vector<FloorPoint> plane, bowl;
    for (int i = 0; i < 400; ++i) {
        const double z = 0.25 * (i % 20), across = 0.25 * i / 20,
                     noise = 0.03 * randomNormal(1, 2, static_cast<std::uint64_t>(i));
        plane.push_back({z, across, noise});
        bowl.push_back({z, across, noise + 0.02 * (z - 2.5) * (z - 2.5)});
    }
    EXPECT_TRUE(isPlane(plane, 0.03));
    EXPECT_FALSE(isPlane(bowl, 0.03));
    // What is left of a bowl where only points near its plane are used still bends.
    std::erase_if(bowl, [](const FloorPoint& point) { return std::abs(point.off_mm - 0.04) > 0.06; });
    EXPECT_FALSE(isPlane(bowl, 0.03));
}

}  // namespace
}  // namespace lathelier::features
