#include "engine/trajectory/channel_map.h"
#include "engine/core/core_codes.h"
#include "engine/trajectory/trajectory_codes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/core/code_of_error.h"

namespace lathelier::trajectory {
namespace {

using Unit = io::ProbeChannel::Unit;

io::ProbeRecord recordWith(std::vector<Unit> units)
{
    io::ProbeRecord record;
    for (const Unit unit : units) record.channels.push_back({"ai", unit, 1, {1, 2, 3, 4}});
    return record;
}

TrajectoryParameters asking(const std::string& channels)
{
    TrajectoryParameters parameters;
    parameters.channels = channels;
    return parameters;
}

const io::ProbeRecord volts = recordWith({Unit::Volt, Unit::Volt, Unit::Volt, Unit::Volt, Unit::Volt});

TEST(ChannelMap, SensitivityBelongsToVoltsOnly)
{
    const io::ProbeRecord record = recordWith({Unit::Volt, Unit::Volt, Unit::Micrometre, Unit::Millimetre, Unit::Volt});
    TrajectoryParameters parameters = asking("marker=0,-X3=1,Y3=2,Xp=3, - Yp = 4 ");
    parameters.sensitivity_um_per_V = 80;
    Notes notes;
    const ChannelMap map = mapChannels(record, parameters, notes);
    EXPECT_EQ(map.probes[0].um_per_value, -80);
    EXPECT_EQ(map.probes[1].um_per_value, 1);
    EXPECT_EQ(map.probes[2].um_per_value, 1000);
    EXPECT_EQ(map.probes[3].um_per_value, -80);
    EXPECT_FALSE(map.is_angle);
}

TEST(ChannelMap, ASensitivityNobodyGaveIsAssumedAndSaidSo)
{
    Notes notes;
    EXPECT_EQ(mapChannels(volts, asking("marker=0,X3=1,Y3=2,Xp=3,Yp=4"), notes).probes[0].um_per_value, 50);
    EXPECT_TRUE(contains(notes, notes::sensitivityAssumed));
    notes.clear();
    TrajectoryParameters given = asking("marker=0,X3=1,Y3=2,Xp=3,Yp=4");
    given.sensitivity_um_per_V = 50;
    mapChannels(volts, given, notes);
    EXPECT_FALSE(contains(notes, notes::sensitivityAssumed));
    const Unit um = Unit::Micrometre;
    mapChannels(recordWith({Unit::Volt, um, um, um, um}), asking("marker=0,X3=1,Y3=2,Xp=3,Yp=4"), notes);
    EXPECT_FALSE(contains(notes, notes::sensitivityAssumed));
}

TEST(ChannelMap, AProbeHasTheSensitivityOfItsCertificate)
{
    Notes notes;
    TrajectoryParameters asked = asking("marker=0,-X3=1,Y3=2,Xp=3,Yp=4");
    asked.probes = {{Probe::X3, 49.8, "2026-01-31"}, {Probe::Yp, 51, {}}};
    ChannelMap map = mapChannels(volts, asked, notes);
    EXPECT_EQ(map.probes[0].um_per_value, -49.8);
    EXPECT_EQ(map.probes[1].um_per_value, assumedSensitivity_um_per_V);
    EXPECT_EQ(map.probes[3].um_per_value, 51);
    EXPECT_TRUE(contains(notes, notes::sensitivityAssumed));  // of the other two
    ASSERT_EQ(map.used.size(), 1u);
    EXPECT_EQ(map.used[0].key, "sensitivity_um_per_V");
    EXPECT_EQ(map.used[0].origin, ValueOrigin::Assumed);

    notes.clear();
    asked.probes.push_back({Probe::Y3, 50, {}});
    asked.probes.push_back({Probe::Xp, 50, {}});
    map = mapChannels(volts, asked, notes);
    EXPECT_FALSE(contains(notes, notes::sensitivityAssumed));  // every probe has its own
    EXPECT_TRUE(map.used.empty());

    asked.probes.push_back({Probe::X3, 50, {}});
    EXPECT_EQ(codeOfError([&] { mapChannels(volts, asked, notes); }), errors::valueNotUnderstood);
}

TEST(ChannelMap, CalibrationsAreTypedAsRows)
{
    const auto infos = lathelier::infos<TrajectoryParameters>();
    const auto probes = std::find_if(infos.begin(), infos.end(), [](const auto& info) { return info.key == "probes"; });
    ASSERT_NE(probes, infos.end());
    const auto read = fromValues<TrajectoryParameters>({{"probes", parse(*probes, "X3,49.8,2026-01-31;Yp,51")}});
    ASSERT_EQ(read.probes.size(), 2u);
    EXPECT_EQ(read.probes[0].calibrated, "2026-01-31");
    EXPECT_EQ(read.probes[1].probe, Probe::Yp);
    EXPECT_EQ(read.probes[1].sensitivity_um_per_V, 51);
}

TEST(ChannelMap, ChannelsGoByPlaceOrName)
{
    io::ProbeRecord record = volts;
    const char* names[] = {"Tip", "west", "south", "trigger", "north"};
    for (std::size_t i = 0; i < 5; ++i) record.channels[i].name = names[i];
    Notes notes;
    const ChannelMap map = mapChannels(record, asking("Marker=Trigger,X3=0,Y3=WEST,Xp=2,Yp=north"), notes);
    EXPECT_EQ(map.reference, 3u);
    EXPECT_EQ(map.probes[1].channel, 1u);
    EXPECT_EQ(map.probes[3].channel, 4u);
}

TEST(ChannelMap, HeadingsRuleUnlessAMapIsGiven)
{
    io::ProbeRecord record =
        recordWith({Unit::Micrometre, Unit::Micrometre, Unit::Micrometre, Unit::Micrometre, Unit::Degree});
    const char* names[] = {"Yp", "xp", "Y3", "X3", "angle"};
    for (std::size_t i = 0; i < 5; ++i) record.channels[i].name = names[i];
    Notes notes;
    const ChannelMap map = mapChannels(record, {}, notes);
    EXPECT_TRUE(map.is_angle);
    EXPECT_EQ(map.reference, 4u);
    EXPECT_EQ(map.probes[0].channel, 3u);
    EXPECT_EQ(mapChannels(record, asking("angle=4,X3=0,Y3=1,Xp=2,Yp=3"), notes).probes[0].channel, 0u);
}

TEST(ChannelMap, AnAngleInTheMarkersPlaceIsAnEncoder)
{
    Notes notes;
    const io::ProbeRecord record = recordWith({Unit::Degree, Unit::Volt, Unit::Volt, Unit::Volt, Unit::Volt});
    EXPECT_TRUE(mapChannels(record, {}, notes).is_angle);
}

TEST(ChannelMap, MistakesAreLocated)
{
    const struct {
        const char* map;
        std::int64_t column;
    } cases[] = {{"marker=0,X3=1,Y3=2,Xp=3", 1},
                 {"marker=0,X3=1,Y3=2,Xp=3,Yp", 25},
                 {"marker=0,X3=1,Y3=2,Xp=3,Zp=4", 25},
                 {"marker=0,X3=1,X3=2,Xp=3,Yp=4", 15},
                 {"marker=0,X3=1,Y3=1,Xp=3,Yp=4", 15},
                 {"marker=0,X3=0,Y3=2,Xp=3,Yp=4", 10},
                 {"marker=0,X3=,Y3=2,Xp=3,Yp=4", 10},
                 {"X3=1,Y3=2,Xp=3,Yp=4", 1},
                 {"marker=0,angle=0,X3=1,Y3=2,Xp=3,Yp=4", 1},
                 {"", 1}};
    for (const auto& [map, column] : cases) {
        Notes notes;
        try {
            mapChannels(volts, asking(map), notes);
            ADD_FAILURE() << map;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::valueNotUnderstood) << map;
            EXPECT_EQ(std::get<std::int64_t>(*find(error.values(), "column")), column) << map;
        }
    }
    for (const char* map : {"marker=0,X3=1,Y3=2,Xp=3,Yp=5", "marker=0,X3=-1,Y3=2,Xp=3,Yp=4",
                            "marker=0,X3=1,Y3=2,Xp=3,Yp=west", "angle=0,X3=1,Y3=2,Xp=3,Yp=4"}) {
        Notes notes;
        try {
            mapChannels(volts, asking(map), notes);
            ADD_FAILURE() << map;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::channelsUnknown) << map;
        }
    }
}

TEST(ChannelMap, ADeadOrSaturatedProbeIsNoted)
{
    io::ProbeRecord record = volts;
    record.channels[2].values = {3, 3, 3, 3};
    record.channels[4].values.clear();
    for (int i = 0; i < 100; ++i) record.channels[4].values.push_back(std::min(i % 50, 30));
    for (io::ProbeChannel& channel : record.channels) channel.values.resize(100, channel.values.back());
    for (int i = 0; i < 100; ++i) record.channels[1].values[static_cast<std::size_t>(i)] = i;
    for (int i = 0; i < 100; ++i) record.channels[3].values[static_cast<std::size_t>(i)] = -i;
    Notes notes;
    mapChannels(record, {}, notes);
    ASSERT_EQ(notes.size(), 3u);
    EXPECT_EQ(notes[0].code, notes::channelStandsStill);
    EXPECT_EQ(notes[1].code, notes::channelCutOff);
}

}  // namespace
}  // namespace lathelier::trajectory
