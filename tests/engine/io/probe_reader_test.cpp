// Probe records from tables: raw and averaged, as the practice data write them and as others may.
#include "engine/io/probe_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "tests/engine/io/reading.h"

namespace lathelier {
namespace {

const std::string practice = LATHELIER_SOURCE_DIR "/../shared/data/lagrang/";

TEST(ProbeReader, practiceRecordAsTableAndAsPair)
{
    if (!std::filesystem::exists(practice)) GTEST_SKIP() << "no shared data";
    const ProbeFile table = readProbeRecord(practice + "section01_raw.csv");
    const ProbeFile pair = readProbeRecord(practice + "section01_lgraph1.dat");
    EXPECT_EQ(table.facts.format, "probe_csv_raw");
    EXPECT_EQ(pair.facts.format, "lgraph_1");
    const auto& a = std::get<ProbeRecord>(table.record);
    const auto& b = std::get<ProbeRecord>(pair.record);
    ASSERT_EQ(a.channels.size(), 5U);
    ASSERT_EQ(b.channels.size(), 5U);
    ASSERT_EQ(a.frames(), 16520U);
    ASSERT_EQ(b.frames(), 16520U);
    EXPECT_EQ(a.channels[0].name, "marker");
    EXPECT_EQ(a.channels[0].unit, ProbeChannel::Unit::Volt);
    EXPECT_EQ(a.channels[1].name, "X3");
    EXPECT_EQ(a.channels[1].unit, ProbeChannel::Unit::Micrometre);
    EXPECT_EQ(b.channels[1].name, "channel 2");
    EXPECT_EQ(b.channels[1].unit, ProbeChannel::Unit::Volt);
    EXPECT_NEAR(a.rate_hz, 6500, 1e-3);
    EXPECT_NEAR(b.rate_hz, 6500, 1e-9);
    EXPECT_EQ(a.time_s.size(), 16520U);
    EXPECT_TRUE(b.time_s.empty());
    EXPECT_DOUBLE_EQ(*a.channel_skew_s, 3.07692308e-05);
    EXPECT_NEAR(*b.channel_skew_s, 3.07692308e-05, 1e-12);
    EXPECT_EQ(b.device, "L761");
    EXPECT_EQ(b.recorded, "Tue Apr 21 12:00:00 2015");
    EXPECT_EQ(std::get<std::string>(*find(a.header, "rpm_nominal")), "975");
    EXPECT_EQ(std::get<std::string>(*find(a.header, "channel_skew_s")),
              "3.07692308e-05 (channel k sampled at t+k*skew, k=0..4)");
    // The pair holds the same signals, rounded to codes of 5 V / 8000, at 50 µm/V; the table to 1 nm and 1 mV.
    for (std::size_t k = 0; k < 5; ++k)
        for (std::size_t i = 0; i < a.frames(); ++i) {
            const double um_or_V = k == 0 ? b.channels[k].values[i] : b.channels[k].values[i] * 50;
            const double half = (k == 0 ? 1 : 50) * 5.0 / 8000 / 2;
            ASSERT_NEAR(um_or_V, a.channels[k].values[i], half + 0.00051) << k << " " << i;
        }
    EXPECT_TRUE(table.notes.empty());
}

TEST(ProbeReader, practiceAverages)
{
    if (!std::filesystem::exists(practice)) GTEST_SKIP() << "no shared data";
    const ProbeFile file = readProbeRecord(practice + "averaged_20x200.csv");
    const auto& record = std::get<AveragedRecord>(file.record);
    ASSERT_EQ(record.sections.size(), 20U);
    EXPECT_EQ(file.facts.format, "probe_csv_averaged");
    for (std::size_t s = 0; s < 20; ++s) {
        const AveragedSection& section = record.sections[s];
        EXPECT_EQ(section.section, static_cast<int>(s) + 1);
        EXPECT_NEAR(section.z_mm, 5 * (static_cast<double>(s) + 1), 1e-12);
        EXPECT_EQ(section.angle_deg.size(), 200U);
        EXPECT_EQ(section.sYp_um.size(), 200U);
    }
    EXPECT_DOUBLE_EQ(record.sections[0].X3_um[1], 15.3783);
    EXPECT_DOUBLE_EQ(record.sections[0].sYp_um[2], 0.6510);
    EXPECT_DOUBLE_EQ(record.sections[0].angle_deg[2], 3.6);
    EXPECT_EQ(std::get<std::string>(*find(record.header, "D_mm")), "50");
}

}  // namespace
}  // namespace lathelier
