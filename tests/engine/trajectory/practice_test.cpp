// Practice data against their truth (limits 0.3, 0.3, 0.2, 0.1 µm).
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/io/probe/probe_reader.h"
#include "engine/trajectory/trajectory.h"
#include "engine/trajectory/trajectory_codes.h"
#include "tests/engine/io/lgraph_files.h"
#include "tests/scratch_folder.h"

namespace lathelier::trajectory {
namespace {

const std::string lagrangFolder = LATHELIER_SOURCE_DIR "/tests/data/lagrang/";

class Practice : public ::testing::Test {
protected:
    void SetUp() override { truth = nlohmann::json::parse(std::ifstream(lagrangFolder + "truth.json")); }

    void expectSection(const TrajectorySection& section, const nlohmann::json& expected) const
    {
        const form::ReferenceCircles& found = section.roundness.circles;
        EXPECT_NEAR(found.LSCI.RONt_um, 1e3 * expected["LSCI"]["RONt"].get<double>(), 0.3) << section.section;
        EXPECT_NEAR(found.MZCI.RONt_um, 1e3 * expected["MZCI"]["RONt"].get<double>(), 0.3) << section.section;
        const Eigen::Vector2d centre_mm(expected["LSCI"]["cx"].get<double>(), expected["LSCI"]["cy"].get<double>());
        EXPECT_LT((found.LSCI.centre_mm - centre_mm).norm() * 1e3, 0.2) << section.section;
        EXPECT_NEAR(found.LSCI.radius_mm, expected["LSCI"]["R"].get<double>(), 5e-4) << section.section;
    }

    nlohmann::json truth;
};

TEST_F(Practice, AveragedSectionsAndTheLongitudinalSection)
{
    const TrajectoryResult result = trajectory({io::readProbeRecord(lagrangFolder + "averaged_20x200.csv")});
    ASSERT_EQ(result.sections.size(), 20u);
    for (std::size_t s = 0; s < truth["sections"].size(); ++s)
        expectSection(result.sections[s], truth["sections"][s]["truth"]);
    ASSERT_TRUE(result.longitudinal);
    const nlohmann::json& along = truth["longitudinal_truth"];
    EXPECT_NEAR(result.longitudinal->taper_diameter_um, 2 * along["taper_radius_um"].get<double>(), 0.1);
    EXPECT_NEAR(result.longitudinal->barrel_um, along["barrel_parabola_um"].get<double>(), 0.1);
    EXPECT_NEAR(result.longitudinal->diameter_range_um, along["dia_range_um"].get<double>(), 0.3);
    EXPECT_NEAR(result.longitudinal->profile_straightness_um, along["straightness_res_pv_um"].get<double>(), 0.3);
    EXPECT_LT(result.longitudinal->axis_straightness_um, 0.3);
}

TEST_F(Practice, TheRawSectionAsTableAndAsLGraph)
{
    const TrajectoryResult table = trajectory({io::readProbeRecord(lagrangFolder + "section01_raw.csv")});
    TrajectoryParameters parameters;
    parameters.workpiece_diameter_mm = 50;
    const TrajectoryResult recorder =
        trajectory({io::readProbeRecord(lagrangFolder + "section01_lgraph1.par")}, parameters);
    const nlohmann::json& expected = truth["sections"][0];
    for (const TrajectoryResult* result : {&table, &recorder}) {
        ASSERT_EQ(result->sections.size(), 1u);
        const TrajectorySection& section = result->sections[0];
        EXPECT_EQ(section.revolutions_used, 40);
        EXPECT_NEAR(section.speed_rpm, 975, 0.5);
        expectSection(section, expected["truth"]);
        EXPECT_FALSE(result->longitudinal);
        EXPECT_TRUE(contains(result->notes, notes::zUnknown));
        for (std::size_t probe = 0; probe < 4; ++probe) {
            const char* names[] = {"X3", "Y3", "Xp", "Yp"};
            EXPECT_NEAR(section.error_motion[probe].asynchronous_um,
                        expected["asynchronous_um"][names[probe]].get<double>(), 0.4);
        }
    }
}

TEST_F(Practice, ARecordingOfSomethingElseIsRefused)
{
    TrajectoryParameters parameters;
    parameters.workpiece_diameter_mm = 50;
    lathelier::testing::LGraphSetup two;
    two.version = lathelier::testing::Made::Two;
    two.active = {4, 6};
    const ScratchFolder made;
    const std::string name = (made / "two_channels").string();
    std::ofstream(name + ".par", std::ios::binary) << lathelier::testing::makePar(two);
    std::ofstream(name + ".dat", std::ios::binary) << lathelier::testing::makeDat(two.frames, two.active.size());
    const std::vector<io::ProbeFile> records{io::readProbeRecord(name + ".dat")};
    try {
        trajectory(records, parameters);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::channelsUnknown);
        EXPECT_TRUE(find(error.values(), "path"));
    }
    parameters.channels = "marker=0,X3=1,Y3=1,Xp=1,Yp=1";
    EXPECT_THROW(trajectory(records, parameters), Error);
}

}  // namespace
}  // namespace lathelier::trajectory
