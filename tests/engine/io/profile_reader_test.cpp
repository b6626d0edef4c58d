// Measured profiles: what the columns mean, in which unit, and what is refused.
#include "engine/io/profile_reader.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/engine/io/reading.h"

namespace lathelier {
namespace {

const std::string practice = LATHELIER_SOURCE_DIR "/../shared/data/form/";

TEST(ProfileReader, practiceProfiles)
{
    if (!std::filesystem::exists(practice)) GTEST_SKIP() << "no shared data";
    int read = 0;
    for (const auto& entry : std::filesystem::directory_iterator(practice)) {
        if (entry.path().extension() != ".csv") continue;
        const ProfileFile file = readProfile(entry.path().string());
        EXPECT_EQ(file.facts.format, "profile_xy");
        EXPECT_EQ(file.facts.unit_source, "stated");
        EXPECT_TRUE(file.notes.empty());
        for (const Eigen::Vector2d& point : file.profile.points_mm) ASSERT_NEAR(point.norm(), 25, 25);
        ++read;
    }
    EXPECT_EQ(read, 6);
}

TEST(ProfileReader, circlesInCoordinatePlanes)
{
    if (!std::filesystem::exists(practice)) GTEST_SKIP() << "no shared data";
    const ProfileFile yz = readProfile(practice + "nist_circles/cir2d1.ds");
    ASSERT_EQ(yz.profile.points_mm.size(), 38U);
    EXPECT_EQ(yz.profile.points_mm[0], Eigen::Vector2d(-555.1677, 21.97622));
    EXPECT_TRUE(contains(yz.notes, NoteCode::ProfilePlane));
    const ProfileFile zx = readProfile(practice + "nist_circles/cir2d2.ds");
    EXPECT_EQ(zx.profile.points_mm[0], Eigen::Vector2d(423.62282, -823.57962));
    const ProfileFile xy = readProfile(practice + "nist_circles/cir2d9.ds");
    EXPECT_EQ(xy.profile.points_mm[0], Eigen::Vector2d(114.49663, 95.6036));
}

}  // namespace
}  // namespace lathelier
