// ISO 286-1: limits from the tables of the standard, and the classes that contain a measured size.
#include "engine/features/nominal/iso286.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lathelier::features {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Iso286, KnownLimits)
{
    const auto of = [](const char* name, double size) { return limitsOf(name, size).value(); };
    EXPECT_EQ(of("h6", 50), (Limits{-16, 0}));
    EXPECT_EQ(of("f7", 50), (Limits{-50, -25}));
    EXPECT_EQ(of("k6", 30), (Limits{2, 15}));
    EXPECT_EQ(of("p6", 80), (Limits{32, 51}));
    EXPECT_EQ(of("g6", 25), (Limits{-20, -7}));
    EXPECT_EQ(of("e8", 40), (Limits{-89, -50}));
    EXPECT_EQ(of("d9", 100), (Limits{-207, -120}));
    EXPECT_EQ(of("m6", 60), (Limits{11, 30}));
    EXPECT_EQ(of("n6", 20), (Limits{15, 28}));
    EXPECT_EQ(of("js6", 20), (Limits{-6.5, 6.5}));
    EXPECT_EQ(of("h11", 500), (Limits{-400, 0}));
    EXPECT_EQ(of("k8", 30), (Limits{0, 33}));
    EXPECT_EQ(of("H7", 25), (Limits{0, 21}));
    EXPECT_EQ(of("F8", 25), (Limits{20, 53}));
}

TEST(Iso286, RangesIncludeTheirUpperLimit)
{
    EXPECT_EQ(standardTolerance_um(7, 30), 21);
    EXPECT_EQ(standardTolerance_um(7, 30.001), 25);
    EXPECT_EQ(standardTolerance_um(13, 500), 970);
    EXPECT_FALSE(standardTolerance_um(7, 500.1));
    EXPECT_FALSE(standardTolerance_um(7, 0));
    EXPECT_FALSE(standardTolerance_um(4, 30));
    EXPECT_FALSE(limitsOf("h6", 0));
}

TEST(Iso286, ClassesAreParsed)
{
    EXPECT_EQ(parseIsoClass("h6"), (IsoClass{"h", 6}));
    EXPECT_EQ(parseIsoClass("js11"), (IsoClass{"js", 11}));
    EXPECT_EQ(parseIsoClass("H7"), (IsoClass{"H", 7}));
    for (const char* wrong : {"", "h", "6", "h06", "h4", "h14", "z6", "h6x", "K7", "h-6", "Js6", " h6"})
        EXPECT_FALSE(parseIsoClass(wrong)) << wrong;
}

TEST(Iso286, ClassesThatContainASize)
{
    EXPECT_THAT(fitsOf(49.973, 0.002, 50, Surface::Outer), ElementsAre("f5", "f6", "f7"));
    EXPECT_THAT(fitsOf(20, 0.0005, 20, Surface::Outer), ElementsAre("js5", "js6", "js7"));
    EXPECT_THAT(fitsOf(40, 0, 40, Surface::Outer), ElementsAre("h5", "js5", "h6"));
    EXPECT_THAT(fitsOf(25.005, 0.004, 25, Surface::Bore), ElementsAre("H5", "H6", "H7"));
    EXPECT_THAT(fitsOf(50.4, 0.002, 50, Surface::Outer), IsEmpty());
    EXPECT_THAT(fitsOf(600, 0.002, 600, Surface::Outer), IsEmpty());
}

}  // namespace
}  // namespace lathelier::features
