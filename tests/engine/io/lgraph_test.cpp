// L-Graph pairs: all versions, volts by device, and every contradiction named.
#include "engine/core/core_codes.h"
#include "engine/io/io_codes.h"
#include "tests/engine/io/lgraph_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "engine/io/file_kind.h"
#include "engine/io/probe/lgraph.h"
#include "engine/io/probe/lgraph_header.h"
#include "engine/io/probe/probe_reader.h"
#include "tests/engine/io/reading.h"
#include "tests/scratch_folder.h"

namespace lathelier {
namespace {

using testing::LGraphSetup;
using testing::Made;
using testing::makeDat;
using testing::makePar;
using testing::put;

io::ProbeFile readMade(const LGraphSetup& setup, const io::RecorderOptions& options = {})
{
    return io::readLGraph("made.par", makePar(setup), makeDat(setup.frames, setup.active.size()), options);
}

const io::ProbeRecord& record(const io::ProbeFile& file)
{
    return std::get<io::ProbeRecord>(file.record);
}

Error lgraphRefusal(const std::string& par, const std::string& dat)
{
    try {
        io::readLGraph("made.par", par, dat, {}, {}, "made.dat");
    } catch (const Error& error) {
        EXPECT_TRUE(find(error.values(), "path"));
        EXPECT_TRUE(find(error.values(), "byte"));
        EXPECT_FALSE(text(error).empty());
        return error;
    }
    ADD_FAILURE() << "no error";
    return Error(errors::unknownOption, {});
}

/// The check that an Error recordContradicts names.
std::string failedCheck(const std::string& par, const std::string& dat)
{
    const Error error = lgraphRefusal(par, dat);
    EXPECT_EQ(error.code(), errors::recordContradicts);
    return testing::wordOf(error, "check");
}

class LGraphVersions : public ::testing::TestWithParam<Made> {};
INSTANTIATE_TEST_SUITE_P(LGraph, LGraphVersions, ::testing::Values(Made::One, Made::After2008, Made::Two));

TEST_P(LGraphVersions, everySampleIsWhereItBelongs)
{
    LGraphSetup setup;
    setup.version = GetParam();
    setup.gain_codes[2] = 2;  // channel 3, × 4
    setup.gain_codes[3] = 3;  // channel 4, × 8
    const io::ProbeFile file = readMade(setup);
    const io::ProbeRecord& made = record(file);
    ASSERT_EQ(made.channels.size(), 3U);
    EXPECT_EQ(made.channels[0].name, "channel 1");
    EXPECT_EQ(made.channels[1].name, "channel 3");
    EXPECT_EQ(made.channels[2].name, "channel 4");
    EXPECT_EQ(made.channels[1].gain, 4);
    ASSERT_EQ(made.frames(), 100U);
    const int gains[] = {1, 4, 8};
    for (std::size_t f = 0; f < 100; ++f)
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_DOUBLE_EQ(made.channels[c].values[f],
                             (100.0 * static_cast<double>(f) - static_cast<double>(c)) * 5 / 2000 / gains[c]);
    EXPECT_EQ(made.rate_hz, 10000);
    EXPECT_NEAR(*made.channel_skew_s, 1 / 30000.0, 1e-9);
    EXPECT_EQ(made.device, "L783");
    EXPECT_EQ(made.recorded, "Tue Apr 21 12:00:00 2015");
    EXPECT_TRUE(file.notes.empty());
    const char* const formats[] = {"lgraph_1", "lgraph_2008", "lgraph_2"};
    EXPECT_EQ(file.facts.format, formats[static_cast<int>(GetParam())]);
    EXPECT_NEAR(std::get<double>(*find(file.facts.details, "duration_s")), 0.01, 1e-12);
}

TEST_P(LGraphVersions, contradictionsAreNamed)
{
    LGraphSetup setup;
    setup.version = GetParam();
    const bool wide = GetParam() == Made::After2008;
    const std::string par = makePar(setup);
    const std::string dat = makeDat(100, 3);
    const auto changed = [&par](auto change) {
        std::string bytes = par;
        change(bytes);
        return bytes;
    };
    EXPECT_EQ(failedCheck(changed([](auto& p) { put<std::int16_t>(p, 65, 33); }), dat), "number of channels");
    EXPECT_EQ(failedCheck(changed([](auto& p) { put<std::int16_t>(p, 65, 0); }), dat), "number of channels");
    EXPECT_EQ(failedCheck(changed([](auto& p) { put<std::int16_t>(p, 65, 2); }), dat), "active channels");
    EXPECT_EQ(failedCheck(changed([&](auto& p) { put<std::uint8_t>(p, wide ? 277 : 159, 4); }), dat), "gain code");
    EXPECT_EQ(failedCheck(
                  changed([&](auto& p) { wide ? put<std::int64_t>(p, 75, 301) : put<std::int32_t>(p, 71, 301); }), dat),
              "samples = frames × channels");
    EXPECT_EQ(failedCheck(changed([](auto& p) { put<std::int32_t>(p, 67, 0); }), dat), "frames");
    EXPECT_EQ(failedCheck(changed([&](auto& p) { wide ? put<double>(p, 109, 11) : put<float>(p, 91, 11); }), dat),
              "total time = frames / rate");
    EXPECT_EQ(
        failedCheck(changed([&](auto& p) { wide ? put<double>(p, 109, std::nan("")) : put<float>(p, 91, -1); }), dat),
        "rate per channel");
    EXPECT_EQ(failedCheck(par, dat + "more"), "size of the .dat file");
    EXPECT_EQ(failedCheck(par, dat + "m"), "size of the .dat file");
    const Error cut = lgraphRefusal(par, dat.substr(0, 301));
    EXPECT_EQ(cut.code(), errors::truncated);
    EXPECT_EQ(testing::wordOf(cut, "path"), "made.dat");
    EXPECT_EQ(testing::integerOf(cut, "found"), 50);
    EXPECT_EQ(testing::integerOf(cut, "expected"), 100);
    EXPECT_EQ(lgraphRefusal(par, "").code(), errors::truncated);
    EXPECT_EQ(lgraphRefusal(par.substr(0, 200), dat).code(), errors::truncated);
    EXPECT_EQ(lgraphRefusal(changed([](auto& p) { p[0] = '9'; }), dat).code(), errors::formatUnknown);
    if (GetParam() == Made::Two) {
        EXPECT_EQ(failedCheck(changed([](auto& p) { put<std::int64_t>(p, 227, 99); }), dat), "frames, stated twice");
    } else {
        EXPECT_EQ(failedCheck(par + "x", dat), "size of the .par file");
        EXPECT_EQ(failedCheck(changed([&](auto& p) { wide ? put<double>(p, 93, 20) : put<float>(p, 83, 20); }), dat),
                  "converter rate ≥ rate × channels");
    }
}

TEST(LGraph, hostileCountsCostNothing)
{
    LGraphSetup setup;
    setup.version = Made::After2008;
    std::string par = makePar(setup);
    const std::string dat = makeDat(100, 3);
    put<std::int64_t>(par, 67, std::int64_t{1} << 61);  // frames × channels does not fit into 64 bits
    put<std::int64_t>(par, 75, 100);
    EXPECT_EQ(failedCheck(par, dat), "samples = frames × channels");
    put<std::int64_t>(par, 67, std::int64_t{1} << 60);  // three channels of 2^60 frames: nothing is allocated
    put<std::int64_t>(par, 75, 3 * (std::int64_t{1} << 60));
    testing::putExtended(par, 83, static_cast<long double>(std::int64_t{1} << 60) / 10000);
    EXPECT_EQ(lgraphRefusal(par, dat).code(), errors::truncated);
    put<std::int64_t>(par, 67, -100);
    EXPECT_EQ(failedCheck(par, dat), "frames");
}

TEST(LGraph, fullScaleByDeviceAndByOption)
{
    LGraphSetup setup;
    setup.device = "L-761";
    io::ProbeFile file = readMade(setup);
    EXPECT_DOUBLE_EQ(record(file).channels[0].values[2], 200.0 * 5 / 8000);
    EXPECT_TRUE(contains(file.notes, notes::fullScaleAssumed));
    file = readMade(setup, {4000, 10});
    EXPECT_DOUBLE_EQ(record(file).channels[0].values[2], 200.0 * 10 / 4000);
    EXPECT_TRUE(file.notes.empty());
    setup.device = "E440";
    file = readMade(setup);
    EXPECT_EQ(record(file).channels[0].unit, io::ProbeChannel::Unit::Unknown);
    EXPECT_EQ(record(file).channels[0].values[2], 200);
    EXPECT_TRUE(contains(file.notes, notes::fullScaleUnknown));
    file = readMade(setup, {8000, 10});
    EXPECT_EQ(record(file).channels[0].unit, io::ProbeChannel::Unit::Volt);
    EXPECT_DOUBLE_EQ(record(file).channels[0].values[2], 200.0 * 10 / 8000);
}

TEST(LGraph, aFasterConverterPausesBetweenFrames)
{
    LGraphSetup setup;
    setup.converter_kHz = 300;
    setup.delay_ms = 0.1 - 2.0 / 300;  // the rest of the frame
    io::ProbeFile file = readMade(setup);
    EXPECT_NEAR(*record(file).channel_skew_s, 1 / 300e3, 1e-10);
    EXPECT_TRUE(file.notes.empty());
    setup.delay_ms = 0.02;
    EXPECT_TRUE(contains(readMade(setup).notes, notes::converterDelayDiffers));
    setup.version = Made::Two;
    file = readMade(setup);
    EXPECT_NEAR(*record(file).channel_skew_s, 1 / 30e3, 1e-9);
    EXPECT_TRUE(contains(file.notes, notes::converterRateWrong));
}

TEST(LGraph, severalSegmentsAreNoted)
{
    LGraphSetup setup;
    setup.version = Made::Two;
    std::string par = makePar(setup);
    put<std::int32_t>(par, 17131, 3);
    EXPECT_TRUE(contains(io::readLGraph("made.par", par, makeDat(100, 3)).notes, notes::recordInSegments));
}

class LGraphFiles : public ::testing::Test {
protected:
    std::string write(const std::string& name, const std::string& content) const
    {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return (folder_ / name).string();
    }
    ScratchFolder folder_;
};

TEST_F(LGraphFiles, eitherOfThePairInAnyCase)
{
    const LGraphSetup setup;
    const std::string dat = write("run1.DAT", makeDat(100, 3));
    const std::string par = write("run1.PAR", makePar(setup));
    for (const std::string& path : {dat, par}) {
        EXPECT_EQ(io::findKind({&io::probeRecordFiles()}, path).likeness, io::Likeness::Certain);
        EXPECT_EQ(record(io::readProbeRecord(path)).frames(), 100U);
    }
    write("run1.par", makePar({}).replace(0, 1, "9"));  // the partner in the same case comes first
    EXPECT_EQ(record(io::readProbeRecord(dat)).frames(), 100U);
    const std::string mixed = write("Run2.dat", makeDat(100, 3));
    write("RUN2.PAR", makePar(setup));
    EXPECT_EQ(record(io::readProbeRecord(mixed)).frames(), 100U);
}

TEST_F(LGraphFiles, aMissingPartnerIsNamed)
{
    const std::string dat = write("a.dat", makeDat(100, 3));
    const std::string par = write("b.par", makePar({}));
    for (const std::string& path : {dat, par}) {
        EXPECT_EQ(io::findKind({&io::probeRecordFiles()}, path).kind, &io::probeRecordFiles());
        try {
            io::readProbeRecord(path);
            ADD_FAILURE();
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::partnerMissing);
            EXPECT_EQ(testing::wordOf(error, "path"), path);
            EXPECT_EQ(testing::wordOf(error, "partner"), path == dat ? "a.par" : "b.dat");
        }
    }
}

TEST_F(LGraphFiles, aTextNamedDatIsATable)
{
    const std::string dat = write("table.dat", "t_s,X3_um,Y3_um\n0,1,2\n0.1,2,3\n0.2,3,4\n");
    EXPECT_EQ(record(io::readProbeRecord(dat)).channels.size(), 2U);
    const std::string cloud = write("cloud.dat", "1 2 3\n4 5 6\n7 8 9\n");
    EXPECT_EQ(io::findKind({&io::probeRecordFiles()}, cloud).kind, nullptr);
}

}  // namespace
}  // namespace lathelier
