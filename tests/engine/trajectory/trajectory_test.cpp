#include "engine/trajectory/trajectory.h"
#include "engine/core/core_codes.h"
#include "engine/trajectory/trajectory_codes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/sample/sample_record.h"
#include "engine/trajectory/surface_image.h"
#include "tests/engine/trajectory/truth.h"

namespace lathelier::trajectory {
namespace {

using std::numbers::pi;

ErrorCode codeOfRecords(const std::vector<io::ProbeFile>& records, const TrajectoryParameters& parameters = {})
{
    try {
        trajectory(records, parameters);
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('{'), std::string::npos) << error.what();
        return error.code();
    }
    ADD_FAILURE() << "no error";
    return errors::internal;
}

TEST(Trajectory, WithoutNoiseTheTruthComesBack)
{
    const sample::SpindleModel model = fineModel();
    TrajectoryParameters parameters;
    parameters.revolutions = model.revolutions;
    const TrajectoryResult result = trajectory({fileOf(sample::makeProbeRecord(model))}, parameters);
    ASSERT_EQ(result.sections.size(), 5u);
    for (int s = 0; s < model.sections; ++s) {
        const TrajectorySection& section = result.sections[static_cast<std::size_t>(s)];
        EXPECT_EQ(section.revolutions_used, 8);
        EXPECT_NEAR(section.z_mm, sample::sectionMiddle_mm(model, s), 1e-9);
        EXPECT_NEAR(section.speed_rpm, 975, 1e-3);
        EXPECT_LE(worstDifference_um(section, model, s), 0.01);
        EXPECT_NEAR(section.spindle.asynchronous_um, 0, 0.01);
    }
    ASSERT_TRUE(result.longitudinal);
    EXPECT_NEAR(result.longitudinal->taper_diameter_um, model.taper_diameter_um, 0.01);
    EXPECT_NEAR(result.longitudinal->barrel_um, model.barrel_um, 0.01);
    EXPECT_NEAR(result.longitudinal->axis_straightness_um, 0, 0.01);
    EXPECT_NEAR(result.longitudinal->half_diameter_range_um, result.longitudinal->diameter_range_um / 2, 1e-12);
    EXPECT_TRUE(contains(result.notes, notes::valueAssumed));  // feed and sections from the record
}

TEST(Trajectory, AHundredFramesARevolutionAreEnough)
{
    sample::SpindleModel model = sample::quietSpindle();
    ASSERT_EQ(model.rate_hz, 1625);
    model.sections = 4;
    const TrajectoryResult result = trajectory({fileOf(sample::makeProbeRecord(model))});
    for (int s = 0; s < model.sections; ++s)
        EXPECT_LE(worstDifference_um(result.sections[static_cast<std::size_t>(s)], model, s), 0.05);
}

TEST(Trajectory, NoiseIsAveragedDownToTheLimits)
{
    sample::SpindleModel model = sample::sampleSpindle();
    const TrajectoryResult result = trajectory({fileOf(sample::makeProbeRecord(model))});
    ASSERT_EQ(result.sections.size(), 20u);
    for (int s = 0; s < model.sections; ++s) {
        const TrajectorySection& section = result.sections[static_cast<std::size_t>(s)];
        EXPECT_EQ(section.revolutions_used, 40);
        const form::ReferenceCircles truth = form::fitCircles(sample::trueImage_mm(model, s));
        const form::ReferenceCircles& found = section.roundness.circles;
        EXPECT_NEAR(found.LSCI.RONt_um, truth.LSCI.RONt_um, 0.3) << s;
        EXPECT_NEAR(found.MZCI.RONt_um, truth.MZCI.RONt_um, 0.3) << s;
        EXPECT_LT((found.LSCI.centre_mm - truth.LSCI.centre_mm).norm() * 1e3, 0.2) << s;
        // Noise of 0.4 µm over forty values and a whirl of 0.8 µm both ways.
        EXPECT_NEAR(section.spindle.asynchronous_um, 2 * 0.8 + 4.5 * 0.4, 1.0);
        EXPECT_GT(section.spindle.total_um, section.spindle.synchronous_um);
    }
    EXPECT_NEAR(result.longitudinal->taper_diameter_um, 16, 0.1);
    EXPECT_NEAR(result.longitudinal->barrel_um, 5, 0.1);
}

TEST(Trajectory, AveragesAnswerLikeTheRecordItself)
{
    const sample::SpindleModel model = sample::quietSpindle();
    const TrajectoryResult result = trajectory({fileOf(sample::makeAveragedRecord(model))});
    ASSERT_EQ(result.sections.size(), 20u);
    for (int s = 0; s < model.sections; ++s)
        EXPECT_LE(worstDifference_um(result.sections[static_cast<std::size_t>(s)], model, s), 1e-6);
    // The samples of a revolution lie half a sample before its middle, on average.
    EXPECT_NEAR(result.longitudinal->taper_diameter_um, 16, 5e-4);
    EXPECT_NEAR(result.longitudinal->barrel_um, 5, 5e-4);
    EXPECT_TRUE(contains(result.notes, notes::averagesOnly));
    EXPECT_TRUE(std::isnan(result.sections[0].spindle.asynchronous_um));
    EXPECT_EQ(result.sections[0].revolutions_used, 40);
}

TEST(Trajectory, UnevenRepeatedAndUnorderedAnglesOfAveragesAreHandled)
{
    sample::SpindleModel model = sample::quietSpindle();
    model.sections = 1;
    io::AveragedRecord record = sample::makeAveragedRecord(model, 360);
    io::AveragedSection& section = record.sections[0];
    const auto eachColumn = [&](auto change) {
        for (auto* column : {&section.angle_deg, &section.X3_um, &section.Y3_um, &section.Xp_um, &section.Yp_um})
            change(*column);
    };
    eachColumn([](std::vector<double>& c) {
        c.push_back(c[40]);                               // doubled
        c.erase(c.begin() + 100);                         // missing
        std::rotate(c.begin(), c.begin() + 77, c.end());  // starts elsewhere
        std::swap(c[3], c[200]);                          // out of order
    });
    const TrajectoryResult result = trajectory({fileOf(record)});
    const form::ReferenceCircles truth = form::fitCircles(sample::trueImage_mm(model, 0, 360));
    EXPECT_NEAR(result.sections[0].roundness.circles.LSCI.RONt_um, truth.LSCI.RONt_um, 0.03);
    EXPECT_LT((result.sections[0].roundness.circles.LSCI.centre_mm - truth.LSCI.centre_mm).norm() * 1e3, 0.01);
}

TEST(Trajectory, DriftIsKeptUnlessAskedAndTheSizeStays)
{
    sample::SpindleModel model = fineModel();
    model.revolutions = 40;
    model.drift_um_per_rev = 0.02;
    const std::vector<io::ProbeFile> records{fileOf(sample::makeProbeRecord(model))};
    TrajectoryParameters parameters;
    const TrajectoryResult kept = trajectory(records, parameters);
    parameters.drift = Drift::Section;
    const TrajectoryResult removed = trajectory(records, parameters);
    EXPECT_NEAR(kept.sections[0].drift_um_per_rev[0], 0.02, 1e-3);
    EXPECT_GT(kept.sections[0].spindle.asynchronous_um, 0.7);
    EXPECT_LT(removed.sections[0].spindle.asynchronous_um, 0.05);
    for (std::size_t s = 0; s < 5; ++s)
        EXPECT_NEAR(removed.sections[s].roundness.circles.LSCI.radius_mm,
                    kept.sections[s].roundness.circles.LSCI.radius_mm, 1e-5);
    // Slow drift looks like size: 0.02 µm a revolution over 160 of them.
    EXPECT_NEAR(removed.longitudinal->taper_diameter_um, 16 - 2 * 0.02 * 160, 0.05);
}

TEST(Trajectory, OutliersAreLeftOutWhenAskedAndCounted)
{
    sample::SpindleModel model = sample::sampleSpindle();
    model.sections = 3;
    io::ProbeRecord record = sample::makeProbeRecord(model);
    for (std::size_t i = 500; i < record.frames(); i += 1000) record.channels[3].values[i] += 40;
    TrajectoryParameters parameters;
    parameters.outliers = form::OutlierRule::Hampel;
    const TrajectoryResult cleaned = trajectory({fileOf(record)}, parameters);
    const TrajectoryResult kept = trajectory({fileOf(record)});
    EXPECT_TRUE(contains(cleaned.notes, notes::motionOutliers));
    for (std::size_t s = 0; s < 3; ++s) {
        const double truth_um = form::fitCircles(sample::trueImage_mm(model, static_cast<int>(s))).LSCI.RONt_um;
        EXPECT_NEAR(cleaned.sections[s].roundness.circles.LSCI.RONt_um, truth_um, 0.6);
        EXPECT_GT(kept.sections[s].roundness.circles.LSCI.RONt_um, truth_um + 0.6);
    }
}

TEST(Trajectory, TheSameBitsForAnyNumberOfThreads)
{
    const std::vector<io::ProbeFile> records{fileOf(sample::makeProbeRecord(sample::sampleSpindle()))};
    const auto bits = [&](int threads) {
        const ThreadLimit limit(threads);
        EXPECT_TRUE(threads == 0 || threadsAllowed() == static_cast<std::size_t>(threads));
        const TrajectoryResult result = trajectory(records);
        std::vector<double> numbers{result.longitudinal->taper_diameter_um, result.longitudinal->CYLt_MZCY_um};
        for (const TrajectorySection& s : result.sections) {
            numbers.push_back(s.roundness.circles.MZCI.RONt_um);
            numbers.push_back(s.roundness.RONt_expanded_uncertainty_um);
            numbers.push_back(s.spindle.total_um);
            numbers.insert(numbers.end(), s.radius_mm.begin(), s.radius_mm.end());
        }
        return numbers;
    };
    EXPECT_EQ(bits(1), bits(0));
}

TEST(Trajectory, SeveralRecordsTakeTheirPlacesFromTheList)
{
    sample::SpindleModel model = fineModel();
    std::vector<io::ProbeFile> records;
    for (int i = 0; i < 3; ++i) {
        io::ProbeRecord record = sample::makeProbeRecord(model);
        std::erase_if(record.header, [](const auto& entry) { return entry.first == "sections"; });
        records.push_back(fileOf(record));
    }
    TrajectoryParameters parameters;
    parameters.revolutions = 8;
    EXPECT_TRUE(contains(trajectory(records, parameters).notes, notes::zUnknown));
    EXPECT_FALSE(trajectory(records, parameters).longitudinal);
    parameters.z_mm = "5, 10,15.5";
    const TrajectoryResult result = trajectory(records, parameters);
    ASSERT_TRUE(result.longitudinal);
    EXPECT_EQ(result.longitudinal->z_mm, (std::vector<double>{5, 10, 15.5}));
    EXPECT_NEAR(result.longitudinal->taper_diameter_um, 0, 1e-6);
    parameters.z_mm = "5,5; 10; 15,25";  // between semicolons a comma is a decimal mark
    EXPECT_EQ(trajectory(records, parameters).longitudinal->z_mm, (std::vector<double>{5.5, 10, 15.25}));
    parameters.z_mm = "5,10";
    EXPECT_EQ(codeOfRecords(records, parameters), errors::valueNotUnderstood);
    parameters.z_mm = "5,10,x";
    EXPECT_EQ(codeOfRecords(records, parameters), errors::valueNotUnderstood);
    parameters.z_mm = "";
    parameters.feed_mm_rev = 0.1;
    EXPECT_EQ(codeOfRecords(records, parameters), errors::valueNotUnderstood);
}

TEST(Trajectory, ATruncatedRecordingIsSaidToBeShort)
{
    const sample::SpindleModel model = fineModel();  // 40 revolutions
    io::ProbeRecord record = sample::makeProbeRecord(model);
    const auto cut = [&](std::size_t frames) {
        for (io::ProbeChannel& channel : record.channels) channel.values.resize(frames);
        record.time_s.resize(frames);
    };
    cut(record.frames() / 2);
    TrajectoryParameters parameters;
    parameters.revolutions = 8;
    const TrajectoryResult result = trajectory({fileOf(record)}, parameters);
    EXPECT_TRUE(contains(result.notes, notes::fewerRevolutions));
    EXPECT_NEAR(result.sections.back().z_mm, model.feed_mm_rev * 17.5, 0.5);  // where the data are, not where asked
    cut(2500);
    EXPECT_EQ(codeOfRecords({fileOf(record)}, parameters), errors::recordTooShort);
}

TEST(Trajectory, WhatIsMissingIsRefused)
{
    const sample::SpindleModel model = fineModel();
    io::ProbeRecord record = sample::makeProbeRecord(model);
    std::erase_if(record.header, [](const auto& entry) { return entry.first == "D_mm"; });
    EXPECT_EQ(codeOfRecords({fileOf(record)}), errors::diameterMissing);
    TrajectoryParameters parameters;
    parameters.workpiece_diameter_mm = 50;
    EXPECT_EQ(trajectory({fileOf(record)}, parameters).workpiece_diameter_mm, 50);
    parameters.channels = "marker=2,X3=1,Y3=0,Xp=3,Yp=4";
    EXPECT_EQ(codeOfRecords({fileOf(record)}, parameters), errors::markerElsewhere);
    EXPECT_TRUE(trajectory(std::vector<io::ProbeFile>{}).sections.empty());
}

TEST(Trajectory, ADiscHasNoCylindricityButAllElse)
{
    sample::SpindleModel model = fineModel();
    model.workpiece_diameter_mm = 110;
    model.feed_mm_rev = 1e-4;  // five sections within 4 µm
    TrajectoryParameters parameters;
    parameters.revolutions = model.revolutions;
    const TrajectoryResult result = trajectory({fileOf(sample::makeProbeRecord(model))}, parameters);
    ASSERT_TRUE(result.longitudinal);
    EXPECT_NEAR(result.longitudinal->taper_diameter_um, model.taper_diameter_um, 0.01);
    EXPECT_TRUE(std::isnan(result.longitudinal->CYLt_LSCY_um));
    EXPECT_TRUE(contains(result.notes, notes::noCylindricity));
}

TEST(Trajectory, RevolutionsThatWereNotUsedAreSaid)
{
    const std::vector<io::ProbeFile> records{fileOf(sample::makeProbeRecord(fineModel()))};  // 5 sections of 8 turns
    TrajectoryParameters parameters;
    parameters.revolutions = 8;
    EXPECT_FALSE(contains(trajectory(records, parameters).notes, notes::revolutionsUnused));
    parameters.revolutions = 5;
    const Notes notes = trajectory(records, parameters).notes;
    const auto unused = std::find_if(notes.begin(), notes.end(),
                                     [](const Note& note) { return note.code == notes::revolutionsUnused; });
    ASSERT_NE(unused, notes.end());
    EXPECT_EQ(*find(unused->values, "used"), Value(std::int64_t{25}));
    EXPECT_EQ(*find(unused->values, "found"), Value(std::int64_t{40}));
}

TEST(Trajectory, ASuspiciousSpeedIsNoted)
{
    io::ProbeRecord record = sample::makeProbeRecord(fineModel());
    for (auto& [key, value] : record.header)
        if (key == "rpm_nominal") value = std::string("480");
    EXPECT_TRUE(contains(trajectory({fileOf(record)}).notes, notes::speedDiffers));
}

TEST(Trajectory, CancelStopsIt)
{
    std::stop_source source;
    source.request_stop();
    const io::ProbeFile file = fileOf(sample::makeProbeRecord(fineModel()));
    EXPECT_THROW(trajectory({file}, {}, Progress(source.get_token(), nullptr)), Cancelled);
}

TEST(TimeSignals, PeaksSurviveTheThinning)
{
    const sample::SpindleModel model = fineModel();
    io::ProbeRecord record = sample::makeProbeRecord(model);
    record.channels[2].values[7777] = 99;
    const std::vector<TimeSignal> signals = timeSignals(record, {}, 500);
    ASSERT_EQ(signals.size(), 5u);
    EXPECT_LE(signals[2].value.size(), 500u);
    EXPECT_EQ(*std::max_element(signals[2].value.begin(), signals[2].value.end()), 99);
    EXPECT_TRUE(std::is_sorted(signals[2].time_s.begin(), signals[2].time_s.end()));
    EXPECT_EQ(signals[0].signal, "marker");
    EXPECT_EQ(signals[3].signal, "Xp");
    EXPECT_EQ(signals[1].revolution_starts_s.size(), 40u);
    TrajectoryParameters wrong;
    wrong.channels = "nonsense";
    EXPECT_EQ(timeSignals(record, wrong, 500)[0].signal, "");
}

/// A record with a good marker whose probes see `signal(time, sample, channel)` and no part.
io::ProbeRecord signalRecord(const std::function<double(double, std::size_t, std::size_t)>& signal_um)
{
    sample::SpindleModel model = sample::sampleSpindle();
    model.sections = 1;
    io::ProbeRecord record = sample::makeProbeRecord(model);
    record.header.erase(std::remove_if(record.header.begin(), record.header.end(),
                                       [](const auto& entry) { return entry.first == "feed_mm_rev"; }),
                        record.header.end());
    for (std::size_t c = 1; c < record.channels.size(); ++c) {
        record.channels[c].unit = io::ProbeChannel::Unit::Micrometre;
        for (std::size_t i = 0; i < record.frames(); ++i)
            record.channels[c].values[i] = signal_um(static_cast<double>(i) / model.rate_hz, i, c);
    }
    return record;
}

TEST(Trajectory, NoiseDriftAndHumAreNotJudgedAsForm)
{
    TrajectoryParameters parameters;
    parameters.form.tolerance_um = 50;
    const auto verdict = [&](const auto& signal) {
        const TrajectoryResult result = trajectory({fileOf(signalRecord(signal))}, parameters);
        EXPECT_EQ(contains(result.notes, notes::formNotMeasured), !result.sections.front().form_measured);
        return result.verdict;
    };
    EXPECT_EQ(verdict([](double, std::size_t i, std::size_t c) { return 3 * randomNormal(3, c, i); }),
              Verdict::Undecided);
    EXPECT_EQ(verdict([](double t, std::size_t, std::size_t) { return 20 * t; }), Verdict::Undecided);
    EXPECT_EQ(verdict([](double t, std::size_t, std::size_t) { return 10 * std::sin(2 * pi * 50 * t); }),
              Verdict::Undecided);
    // The same noise under a form of 20 µm is judged.
    EXPECT_EQ(verdict([](double t, std::size_t i, std::size_t c) {
                  return randomNormal(3, c, i) + (c == 1 ? 10 * std::cos(2 * 2 * pi * 975 / 60 * t) : 0);
              }),
              Verdict::Pass);
    parameters.form.tolerance_um = .5;  // and noise is not "out of tolerance" either
    EXPECT_EQ(verdict([](double, std::size_t i, std::size_t c) { return 3 * randomNormal(3, c, i); }),
              Verdict::Undecided);
}

}  // namespace
}  // namespace lathelier::trajectory
