#include "engine/trajectory/revolutions.h"
#include "engine/core/core_codes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/sample/sample_record.h"
#include "engine/trajectory/record_plan.h"
#include "engine/trajectory/section_signals.h"
#include "engine/trajectory/trajectory_codes.h"

namespace lathelier::trajectory {
namespace {

using std::numbers::pi;

sample::SpindleModel oneSectionModel()
{
    sample::SpindleModel model = sample::quietSpindle();
    model.sections = 1;
    model.revolutions = 20;
    model.taper_diameter_um = 0;
    model.barrel_um = 0;
    model.rate_hz = 6500;
    model.channel_skew_s = 1 / (5 * 6500.0);
    return model;
}

PreparedRecord prepared(const io::ProbeRecord& record, TrajectoryParameters parameters = {})
{
    Notes notes;
    return prepare(record, "record.csv", parameters, notes);
}

ErrorCode codeOfRecord(const io::ProbeRecord& record, TrajectoryParameters parameters = {})
{
    try {
        prepared(record, parameters);
    } catch (const Error& error) {
        EXPECT_TRUE(find(error.values(), "path"));
        EXPECT_EQ(std::string(error.what()).find('{'), std::string::npos) << error.what();
        return error.code();
    }
    ADD_FAILURE() << "no error";
    return errors::internal;
}

/// The angle of the spindle (in degrees) as an encoder has it.
io::ProbeRecord withEncoder(io::ProbeRecord record, const sample::SpindleModel& model, bool falling)
{
    io::ProbeChannel& angle = record.channels[0];
    angle.name = "angle";
    angle.unit = io::ProbeChannel::Unit::Degree;
    for (std::size_t i = 0; i < angle.values.size(); ++i) {
        const double turn = model.speed_rpm / 60 * record.time_s[i] - model.lead_turns;
        angle.values[i] = 360 * (falling ? std::ceil(turn) - turn : turn - std::floor(turn));
    }
    return record;
}

TEST(Revolutions, MarksOfAQuietRecordAreExact)
{
    const sample::SpindleModel model = oneSectionModel();
    const io::ProbeRecord record = sample::makeProbeRecord(model);
    const PreparedRecord ready = prepared(record);
    ASSERT_EQ(ready.revolutions.all.size(), 20u);
    EXPECT_EQ(ready.revolutions.irregular, 0);
    for (const Revolution& r : ready.revolutions.all)
        EXPECT_NEAR(r.start_s, (static_cast<double>(r.number) + model.lead_turns) * 60 / model.speed_rpm, 1e-9);
    EXPECT_NEAR(ready.revolutions.threshold, 1.775, 1e-9);
}

TEST(Revolutions, TheMarkerMayLieOnAnyChannel)
{
    sample::SpindleModel model = oneSectionModel();
    io::ProbeRecord record = sample::makeProbeRecord(model);
    std::rotate(record.channels.begin(), record.channels.begin() + 1, record.channels.end());
    for (io::ProbeChannel& channel : record.channels) channel.name = "ai";  // names without a meaning
    TrajectoryParameters parameters;
    parameters.channels = "X3=0, Y3=1, Xp=2, Yp=3, marker=4";
    const PreparedRecord ready = prepared(record, parameters);
    // Sampled four steps later than channel 0, whose place it has left: the generator knew it as channel 0.
    EXPECT_NEAR(ready.revolutions.all[3].start_s,
                (3 + model.lead_turns) * 60 / model.speed_rpm + 4 * model.channel_skew_s, 1e-9);
}

TEST(Revolutions, AnIrregularPeriodIsCountedAndTheTurnsGoOn)
{
    const sample::SpindleModel model = oneSectionModel();
    io::ProbeRecord record = sample::makeProbeRecord(model);
    // The mark between turns 4 and 5 is lost; in turn 9 there is one too many.
    for (std::size_t i = 0; i < record.frames(); ++i) {
        const double turn = model.speed_rpm / 60 * record.time_s[i] - model.lead_turns;
        if (turn > 4.9 && turn < 5.2) record.channels[0].values[i] = 0.05;
        if (turn > 9.4 && turn < 9.43) record.channels[0].values[i] = 3.5;
    }
    const PreparedRecord ready = prepared(record);
    EXPECT_EQ(ready.revolutions.irregular, 3);
    ASSERT_EQ(ready.revolutions.all.size(), 20u);
    EXPECT_EQ(ready.revolutions.all[4].number, 4);
    EXPECT_FALSE(ready.revolutions.all[4].regular);
    EXPECT_EQ(ready.revolutions.all[5].number, 6);
    EXPECT_TRUE(ready.revolutions.all[5].regular);
    EXPECT_EQ(ready.revolutions.all.back().number, 19);
}

TEST(Revolutions, AnEncoderGivesTheSameSamplesWhicheverWayItCounts)
{
    const sample::SpindleModel model = oneSectionModel();
    const io::ProbeRecord marker = sample::makeProbeRecord(model);
    const PreparedRecord by_marker = prepared(marker);
    const auto sampled = [](const PreparedRecord& ready) {
        return resample(*ready.record, ready.clock, ready.map, ready.revolutions, ready.revolutions.all, 200,
                        ready.channel_skew_s);
    };
    const SectionSignals expected = sampled(by_marker);
    for (const bool falling : {false, true}) {
        const io::ProbeRecord record = withEncoder(marker, model, falling);
        const PreparedRecord by_angle = prepared(record);
        ASSERT_EQ(by_angle.revolutions.all.size(), 20u);
        const SectionSignals found = sampled(by_angle);
        for (std::size_t probe = 0; probe < 4; ++probe)
            for (std::size_t i = 0; i < 200; ++i)
                EXPECT_NEAR(found.at(probe, 7, i), expected.at(probe, 7, falling ? (200 - i) % 200 : i), 1e-4)
                    << probe << " " << i << " " << falling;
    }
}

TEST(Revolutions, ChannelsAreSampledLaterOneAfterTheOther)
{
    sample::SpindleModel model = oneSectionModel();
    const io::ProbeRecord record = sample::makeProbeRecord(model);
    const auto worst = [&](double skew_s) {
        TrajectoryParameters parameters;
        parameters.channel_skew_s = skew_s;
        const PreparedRecord ready = prepared(record, parameters);
        const SectionSignals signals = resample(record, ready.clock, ready.map, ready.revolutions,
                                                ready.revolutions.all, 200, ready.channel_skew_s);
        double largest = 0;
        for (std::size_t i = 0; i < 200; ++i) {
            double yp = 0;
            for (const sample::MotionWave& wave : model.tool)
                yp += wave.y_um * std::cos(wave.upr * 2 * pi * static_cast<double>(i) / 200 - wave.y_phase_rad);
            largest = std::max(largest, std::abs(signals.at(3, 11, i) - yp));
        }
        return largest;
    };
    EXPECT_LT(worst(model.channel_skew_s), 1e-4);
    EXPECT_GT(worst(0), 0.02);
}

TEST(Revolutions, BadRecordsAreRefusedAndSayWhere)
{
    const sample::SpindleModel model = oneSectionModel();
    const io::ProbeRecord good = sample::makeProbeRecord(model);
    io::ProbeRecord record = good;
    std::fill(record.channels[0].values.begin(), record.channels[0].values.end(), 0.05);
    EXPECT_EQ(codeOfRecord(record), errors::markerNotFound);

    TrajectoryParameters parameters;
    parameters.channels = "marker=1,X3=0,Y3=2,Xp=3,Yp=4";  // marker and X3 exchanged
    record = good;
    record.channels[0].unit = io::ProbeChannel::Unit::Volt;
    EXPECT_EQ(codeOfRecord(record, parameters), errors::markerElsewhere);

    record = good;  // one revolution only
    for (io::ProbeChannel& channel : record.channels) channel.values.resize(700);
    record.time_s.resize(700);
    EXPECT_EQ(codeOfRecord(record), errors::tooFewRevolutions);

    record = good;  // less than one
    for (io::ProbeChannel& channel : record.channels) channel.values.resize(60);
    record.time_s.resize(60);
    EXPECT_EQ(codeOfRecord(record), errors::markerNotFound);

    record = good;
    record.channels.resize(2);
    EXPECT_EQ(codeOfRecord(record), errors::channelsUnknown);

    record = good;
    for (io::ProbeChannel& channel : record.channels) channel.unit = io::ProbeChannel::Unit::Unknown;
    EXPECT_EQ(codeOfRecord(record), errors::channelUnitMissing);

    record = withEncoder(good, model, false);
    for (double& angle : record.channels[0].values) angle = 90;
    EXPECT_EQ(codeOfRecord(record), errors::angleNotTurning);
}

}  // namespace
}  // namespace lathelier::trajectory
