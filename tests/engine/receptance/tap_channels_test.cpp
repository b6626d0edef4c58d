// Channels of hammer and sensor, and what their values are in N and mm/s².
#include <gtest/gtest.h>

#include "engine/core/core_codes.h"
#include "engine/core/texts.h"
#include "engine/io/time_record/time_record_reader.h"
#include "engine/receptance/tap/tap_channels.h"
#include "engine/receptance/tap/tap_codes.h"

namespace lathelier::receptance {
namespace {

io::TimeRecord recordOf(const std::string& text)
{
    return io::readTimeRecord("r.csv", text).record;
}

constexpr char rows[] = "0,1,10\n0.001,2,20\n0.002,-4,30\n";

TapMeasured taken(const std::string& heading, const TapChannels& channels, Notes& notes)
{
    return takeSignals(recordOf(heading + "\n" + rows), "r.csv", channels, notes);
}

TapMeasured taken(const std::string& heading, const TapChannels& channels = {})
{
    Notes notes;
    return taken(heading, channels, notes);
}

std::string codeOf(const std::string& heading, const TapChannels& channels = {})
{
    try {
        taken(heading, channels);
    } catch (const Error& error) {
        EXPECT_TRUE(find(error.values(), "path"));
        EXPECT_EQ(text(error).find('{'), std::string::npos) << text(error);
        return error.code().key;
    }
    return {};
}

TEST(TapChannels, StatedUnitsAreEnough)
{
    const TapMeasured si = taken("time_s,force_N,acc_m_s2");
    EXPECT_DOUBLE_EQ(si.both.rate_hz, 1000);
    EXPECT_DOUBLE_EQ(si.both.force_N[2], -4);
    EXPECT_DOUBLE_EQ(si.both.motion[1], 20e3);
    EXPECT_EQ(si.quantity, FrfQuantity::Accelerance);
    const TapMeasured other = taken("t (ms),F [kN],a (g)");
    EXPECT_DOUBLE_EQ(other.both.rate_hz, 1e6);
    EXPECT_DOUBLE_EQ(other.both.force_N[0], 1000);
    EXPECT_DOUBLE_EQ(other.both.motion[0], 98066.5);
    EXPECT_EQ(taken("time_s,force_lbf,v (mm/s)").quantity, FrfQuantity::Mobility);
    EXPECT_DOUBLE_EQ(taken("time_s,force_lbf,v (mm/s)").both.force_N[0], 4.4482216152605);
    const TapMeasured displacement = taken("time_s,force_N,x_um");
    EXPECT_EQ(displacement.quantity, FrfQuantity::Receptance);
    EXPECT_DOUBLE_EQ(displacement.both.motion[2], 0.03);
}

TEST(TapChannels, SensitivitiesConvertVolts)
{
    TapChannels channels;
    channels.hammer_sensitivity = "2 mV/N";
    channels.response_sensitivity = "100 mV/g";
    const TapMeasured volts = taken("time_s,hammer_V,acc_mV", channels);
    EXPECT_DOUBLE_EQ(volts.both.force_N[0], 500);
    EXPECT_NEAR(volts.both.motion[0], 0.1 * 9806.65, 1e-9);
    channels.response_sensitivity = "10 mV/(m/s^2)";
    EXPECT_NEAR(taken("time_s,hammer_V,acc_mV", channels).both.motion[0], 1000, 1e-9);
    channels.hammer_sensitivity = "-500 N/V";
    EXPECT_DOUBLE_EQ(taken("time_s,hammer_V,acc_mV", channels).both.force_N[0], -500);
    channels.hammer_sensitivity = "3 N";  // of one unit of a record that states none
    EXPECT_DOUBLE_EQ(taken("time_s,hammer,acc_mV", channels).both.force_N[1], 6);
    EXPECT_EQ(codeOf("time_s,hammer_V,acc_mV", channels), "tap_unit_missing");  // volts are no parts of 3 N
}

TEST(TapChannels, AStatedUnitRules)
{
    TapChannels channels;
    channels.hammer_sensitivity = "2 mV/N";
    Notes notes;
    EXPECT_DOUBLE_EQ(taken("time_s,force_N,acc_m_s2", channels, notes).both.force_N[0], 1);
    EXPECT_TRUE(contains(notes, notes::tapSensitivityNotUsed));
    channels = {};
    channels.rate_hz = 500;
    EXPECT_DOUBLE_EQ(taken("time_s,force_N,acc_m_s2", channels, notes).both.rate_hz, 1000);
    EXPECT_TRUE(contains(notes, notes::tapRateNotUsed));
}

TEST(TapChannels, WhatIsMissingIsAskedFor)
{
    EXPECT_EQ(codeOf("time_s,hammer,acc_m_s2"), "tap_unit_missing");
    EXPECT_EQ(codeOf("time_s,hammer_V,acc_m_s2"), "tap_unit_missing");
    EXPECT_EQ(codeOf("time_s,force (furlong),acc_m_s2"), "tap_unit_missing");
    EXPECT_EQ(codeOf("time_s,one,two"), "tap_channel_unclear");
    EXPECT_EQ(codeOf("time_s,force_N,other_N"), "tap_channel_unclear");
    EXPECT_EQ(codeOf("nr_of_row,force_N,acc_m_s2"), "tap_rate_missing");
    TapChannels channels;
    channels.hammer = "nine";
    EXPECT_EQ(codeOf("time_s,force_N,acc_m_s2", channels), "value_not_understood");
    channels.hammer = "3";
    EXPECT_EQ(codeOf("time_s,force_N,acc_m_s2", channels), "value_not_understood");  // the same as the sensor
    channels = {};
    for (const char* word : {"2.25", "mV/N", "2.25 mV", "0 mV/N", "2,25 mV/N", "100 mV/g"}) {
        channels.hammer_sensitivity = word;
        EXPECT_EQ(codeOf("time_s,hammer_V,acc_m_s2", channels), "value_not_understood") << word;
    }
}

TEST(TapChannels, ChannelsByNameAndNumber)
{
    TapChannels channels;
    channels.hammer = "2";
    channels.response = "TWO";
    channels.hammer_sensitivity = "1 N";
    channels.response_sensitivity = "1 m/s^2";
    const TapMeasured measured = taken("time_s,one,two", channels);
    EXPECT_DOUBLE_EQ(measured.both.force_N[1], 2);
    EXPECT_DOUBLE_EQ(measured.both.motion[1], 20e3);
}

TEST(TapChannels, AMissingSampleHasItsLine)
{
    try {
        takeSignals(recordOf("time_s,force_N,acc_m_s2\n0,1,2\n1,,3\n2,3,4\n"), "r.csv", {}, *std::make_unique<Notes>());
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.code().key, "tap_sample_missing");
        EXPECT_EQ(std::get<std::int64_t>(*find(error.values(), "line")), 3);
        EXPECT_EQ(std::get<std::int64_t>(*find(error.values(), "column")), 2);
    }
}

TEST(TapChannels, FullScaleNeedsItsVoltage)
{
    io::TimeRecord record;
    for (int c = 0; c < 2; ++c) {
        io::TimeChannel& channel = record.channels.emplace_back();
        channel.number = c + 1;
        channel.is_of_full_scale = true;
        channel.rate_hz = 48000;
        channel.values = {0.5, -0.25};
    }
    record.channels[1].at_limit = {1};
    TapChannels channels;
    channels.hammer = "1";
    channels.response = "2";
    channels.hammer_sensitivity = "10 mV/N";
    channels.response_sensitivity = "50 g";
    Notes notes;
    EXPECT_THROW(takeSignals(record, "r.wav", channels, notes), Error);
    channels.full_scale_V = 10;
    const TapMeasured measured = takeSignals(record, "r.wav", channels, notes);
    EXPECT_NEAR(measured.both.force_N[0], 500, 1e-9);
    EXPECT_NEAR(measured.both.motion[1], -0.25 * 50 * 9806.65, 1e-6);
    EXPECT_EQ(measured.both.at_limit, (std::vector<char>{0, 2}));
}

}  // namespace
}  // namespace lathelier::receptance
