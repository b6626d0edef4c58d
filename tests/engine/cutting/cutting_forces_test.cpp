// Cutting forces: the force table of the DRITTO setup, the geometry of the chip against integration, guards.
#include "engine/cutting/cutting_forces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../core/code_of_error.h"
#include "engine/core/units.h"
#include "engine/cutting/cutting_codes.h"

namespace lathelier::cutting {
namespace {

constexpr CuttingCoefficients steel{1748.5, 99.2, 703, 92.5};
Tool insertAt(double entering_deg, double radius_mm = 0.8)
{
    return {.corner_radius_mm = radius_mm, .entering_angle_deg = entering_deg};
}

const Tool tool = insertAt(95);

TEST(CuttingForces, TableAtTheEnteringAngleOf95)
{
    const CuttingEdge edge(tool, 0.2, ContactLength::Arc);
    const Chip deep = edge.chipAt(3);
    EXPECT_NEAR(deep.flowAngle() * deg_per_rad, 13.352, 5e-4);
    EXPECT_NEAR(deep.contact_mm, 3.565, 5e-4);
    const CuttingForces at_3 = forcesOf(steel, deep);
    EXPECT_NEAR(at_3.F_t_N, 1402.0, 0.05);
    EXPECT_NEAR(at_3.F_f_N, 731.0, 0.05);
    EXPECT_NEAR(at_3.F_ap_N, 173.5, 0.05);
    EXPECT_NEAR(edge.chipAt(1).flowAngle() * deg_per_rad, 41.706, 5e-4);
    const CuttingForces at_1 = cuttingForces(steel, tool, 0.2, 1);
    EXPECT_NEAR(at_1.F_t_N, 503.5, 0.05);
    EXPECT_NEAR(at_1.F_f_N, 212.3, 0.05);
    EXPECT_NEAR(at_1.F_ap_N, 189.2, 0.05);
}

TEST(CuttingForces, ChipAreaIsThatBetweenTwoRevolutions)
{
    const Tool leading = insertAt(70);
    for (const double feed : {0.05, 0.2, 0.6})
        for (const double depth : {0.2, 0.5, 1.5}) {
            const CuttingEdge edge(leading, feed, ContactLength::Arc);
            double area = 0;
            // By slices along h: each is as wide as the feed above the scallop, as the corner below it.
            const double r = *leading.corner_radius_mm;
            const int slices = 200000;
            for (int i = 0; i < slices; ++i) {
                const double h = depth * (i + 0.5) / slices;
                const double width = h > edge.scallop_mm() ? feed : 2 * std::sqrt(r * r - (r - h) * (r - h));
                area += width * depth / slices;
            }
            EXPECT_NEAR(edge.chipAt(depth).area_mm2, area, 1e-6) << feed << ' ' << depth;
        }
}

TEST(CuttingForces, ContactIsContinuousWhereTheCornerEnds)
{
    for (const double entering_deg : {95.0, 90.0, 60.0})
        for (const ContactLength contact : {ContactLength::Arc, ContactLength::Chord, ContactLength::Straight}) {
            const Tool one = insertAt(entering_deg);
            const CuttingEdge edge(one, 0.2, contact);
            const double corner = 0.8 * (1 - std::cos(entering_deg / deg_per_rad));
            const Chip below = edge.chipAt(corner - 1e-9), above = edge.chipAt(corner + 1e-9);
            EXPECT_NEAR(below.contact_mm, above.contact_mm, 1e-7);
            EXPECT_NEAR(below.across_feed, above.across_feed, 1e-7);
            EXPECT_NEAR(below.area_mm2, above.area_mm2, 1e-7);
        }
}

TEST(CuttingForces, ContactLengths)
{
    const Chip chord = CuttingEdge(tool, 0.2, ContactLength::Chord).chipAt(3);
    EXPECT_NEAR(
        chord.contact_mm,
        std::hypot(chord.contact_mm * chord.across_feed, 3 - CuttingEdge(tool, 0.2, ContactLength::Arc).scallop_mm()),
        1e-12);
    const Chip straight = CuttingEdge(tool, 0.2, ContactLength::Straight).chipAt(3);
    EXPECT_NEAR(straight.contact_mm, 3 / std::sin(95 / deg_per_rad), 1e-12);
    EXPECT_NEAR(straight.area_mm2 / straight.contact_mm, 0.2 * std::sin(95 / deg_per_rad), 1e-12);
    EXPECT_LT(chord.contact_mm, CuttingEdge(tool, 0.2, ContactLength::Arc).chipAt(3).contact_mm);
}

TEST(CuttingForces, NoForceUpToTheScallop)
{
    const CuttingEdge edge(tool, 0.2, ContactLength::Arc);
    EXPECT_NEAR(edge.scallop_mm(), 0.00627, 1e-5);
    for (const double depth : {-1.0, 0.0, 0.006, edge.scallop_mm()}) {
        const CuttingForces forces = forcesOf(steel, edge.chipAt(depth));
        EXPECT_EQ(forces.F_t_N, 0);
        EXPECT_EQ(forces.F_f_N, 0);
        EXPECT_EQ(forces.F_ap_N, 0);
    }
    EXPECT_TRUE(edge.chipAt(0.0064).is_cut);
}

TEST(CuttingForces, TheRadialForceIsNotMonotoneInTheDepth)
{
    const double at_1 = cuttingForces(steel, tool, 0.2, 1).F_ap_N;
    EXPECT_GT(at_1, cuttingForces(steel, tool, 0.2, 0.3).F_ap_N);
    EXPECT_GT(at_1, cuttingForces(steel, tool, 0.2, 3).F_ap_N);
}

TEST(CuttingForces, LengthsAndForcesScale)
{
    for (const double lengths : {0.5, 3.0})
        for (const ContactLength contact : {ContactLength::Arc, ContactLength::Chord, ContactLength::Straight}) {
            const double forces = 7;
            const CuttingCoefficients scaled{
                steel.K_tc_N_mm2 * forces / (lengths * lengths), steel.K_te_N_mm * forces / lengths,
                steel.K_rfc_N_mm2 * forces / (lengths * lengths), steel.K_rfe_N_mm * forces / lengths};
            for (const double depth : {0.3, 2.0}) {
                const CuttingForces one = cuttingForces(steel, tool, 0.2, depth, contact);
                const CuttingForces other =
                    cuttingForces(scaled, insertAt(95, 0.8 * lengths), 0.2 * lengths, depth * lengths, contact);
                EXPECT_NEAR(other.F_t_N, forces * one.F_t_N, 1e-9 * one.F_t_N * forces);
                EXPECT_NEAR(other.F_f_N, forces * one.F_f_N, 1e-9 * one.F_t_N * forces);
                EXPECT_NEAR(other.F_ap_N, forces * one.F_ap_N, 1e-9 * one.F_t_N * forces);
            }
        }
}

TEST(CuttingForces, Refusals)
{
    EXPECT_EQ(codeOfError([] { CuttingEdge(tool, 0, ContactLength::Arc); }), errors::feedMissing);
    EXPECT_EQ(codeOfError([] { CuttingEdge(tool, std::nan(""), ContactLength::Arc); }), errors::feedMissing);
    EXPECT_EQ(codeOfError([] { CuttingEdge(tool, 1.6, ContactLength::Arc); }), errors::feedBeyondCorner);
    EXPECT_EQ(codeOfError([] { CuttingEdge(tool, 0.2, ContactLength::Arc, 1.65); }), errors::edgeCannotEnter);
}

TEST(CuttingForces, ATurnedFeedOpensTheEntering)
{
    const Chip turned = CuttingEdge(tool, 0.2, ContactLength::Arc, 10 / deg_per_rad).chipAt(2);
    const Chip other = CuttingEdge(insertAt(85), 0.2, ContactLength::Arc).chipAt(2);
    EXPECT_NEAR(turned.contact_mm, other.contact_mm, 1e-12);
    EXPECT_NEAR(turned.across_feed, other.across_feed, 1e-12);
}

}  // namespace
}  // namespace lathelier::cutting
