// Time records: tables, universal files with functions of time, WAV.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "engine/core/random.h"
#include "engine/io/probe/probe_reader.h"
#include "engine/io/time_record/even_times.h"
#include "engine/io/time_record/time_record_reader.h"
#include "tests/engine/io/frf_files.h"
#include "tests/engine/io/reading.h"

namespace lathelier::io {
namespace {

using lathelier::testing::integerOf;

/// 200 rows, 5 ms apart, but for `time`.
std::string timeTable(const std::string& heading, const std::function<double(int)>& time, int digits = 6)
{
    std::string text = heading + "\n";
    for (int i = 0; i < 200; ++i) text += fmt::format("{:.{}f},{},{:.3f}\n", time(i), digits, i % 7, 0.5 * i);
    return text;
}

Error timeErrorOf(const std::string& bytes, const std::string& name = "r.csv")
{
    try {
        readTimeRecord(name, bytes);
    } catch (const Error& error) {
        EXPECT_TRUE(find(error.values(), "path"));
        return error;
    }
    ADD_FAILURE() << "no error";
    return Error(errors::fileEmpty, {});
}

TEST(TimeRecord, TablesStateTheirUnits)
{
    const TimeRecordFile file =
        readTimeRecord("r.csv", timeTable("t_ms,force_N,acc_m_s2", [](int i) { return 5.0 * i; }));
    ASSERT_EQ(file.record.channels.size(), 2u);
    const TimeChannel& force = file.record.channels[0];
    EXPECT_EQ(force.number, 2);
    EXPECT_EQ(force.role, TimeChannel::Role::Force);
    EXPECT_NEAR(*force.rate_hz, 200, 1e-9);
    EXPECT_EQ(force.values.size(), 200u);
    ASSERT_TRUE(file.record.channels[1].unit);
    EXPECT_EQ(file.record.channels[1].unit->kind, SignalUnit::Kind::Acceleration);
    EXPECT_DOUBLE_EQ(file.record.channels[1].unit->scale, 1000);
    EXPECT_EQ(file.facts.format, "time_csv");
}

TEST(TimeRecord, ARowOfUnitsAndACommaAsDecimalMark)
{
    const TimeRecordFile file =
        readTimeRecord("r.csv", "time;hammer;acc\ns;N;g\n0,000;1,5;2,25\n0,001;1,5;2,5\n0,002;1,5;2,75\n");
    ASSERT_EQ(file.record.channels.size(), 2u);
    EXPECT_DOUBLE_EQ(file.record.channels[0].values[0], 1.5);
    ASSERT_TRUE(file.record.channels[0].unit && file.record.channels[1].unit);
    EXPECT_DOUBLE_EQ(file.record.channels[1].unit->scale, 9806.65);
    EXPECT_NEAR(*file.record.channels[0].rate_hz, 1000, 1e-9);
}

TEST(TimeRecord, ARateMayStandAboveTheTable)
{
    const TimeRecordFile file = readTimeRecord("r.csv", "# rate_hz=25600\nforce_N,acc_m_s2\n1,2\n3,4\n5,6\n");
    ASSERT_EQ(file.record.channels.size(), 2u);
    EXPECT_DOUBLE_EQ(*file.record.channels[0].rate_hz, 25600);
    EXPECT_FALSE(readTimeRecord("r.csv", "force_N,acc_m_s2\n1,2\n3,4\n5,6\n").record.channels[0].rate_hz);
}

TEST(TimeRecord, UnevenTimesAreRefusedWithTheirLine)
{
    const auto jitter = [](double share) {
        return timeTable(
            "t_s,force_N,acc_m_s2", [share](int i) { return 0.005 * (i + (i == 77 ? share : 0)); }, 9);
    };
    const Error error = timeErrorOf(jitter(0.02));
    EXPECT_STREQ(error.code().key, "time_uneven");
    EXPECT_EQ(integerOf(error, "line"), 79);
    EXPECT_NEAR(std::get<double>(*find(error.values(), "expected_s")), 0.005, 1e-9);
    EXPECT_NO_THROW(readTimeRecord("r.csv", jitter(0.005)));
    const Error gap =
        timeErrorOf(timeTable("t_s,force_N,acc_m_s2", [](int i) { return 0.005 * (i + (i >= 100 ? 1 : 0)); }));
    EXPECT_STREQ(gap.code().key, "time_uneven");
    EXPECT_EQ(integerOf(gap, "line"), 102);
    const Error back =
        timeErrorOf(timeTable("t_s,force_N,acc_m_s2", [](int i) { return 0.005 * (i >= 100 ? i - 100 : i); }));
    EXPECT_EQ(integerOf(back, "line"), 102);
}

// 25600 Hz: 39.0625 µs, written to a µs, to ten µs and in single precision.
TEST(TimeRecord, RoundedTimesAreEven)
{
    const auto written = [](int digits) {
        return timeTable(
            "t_s,force_N,acc_m_s2", [](int i) { return i / 25600.0; }, digits);
    };
    for (const int digits : {10, 7, 6, 5}) {
        SCOPED_TRACE(digits);
        EXPECT_NEAR(*readTimeRecord("r.csv", written(digits)).record.channels[0].rate_hz, 25600, 60);
    }
    std::vector<double> single;
    for (int i = 0; i < 100000; ++i) single.push_back(static_cast<double>(static_cast<float>(i / 25600.0)));
    EXPECT_FALSE(judgeTimes(single, {}).uneven);
    std::vector<double> random;
    for (int i = 0; i < 1000; ++i)
        random.push_back((i + 0.03 * randomNormal(1, 1, static_cast<std::uint64_t>(i))) / 25600.0);
    EXPECT_TRUE(judgeTimes(random, {}).uneven);
}

std::string timeSet(int response_direction, int ordinate, const std::string& unit, const std::string& values)
{
    testing::UffText set;
    set.function = 1;
    set.data_type = 4;
    set.points = 4;
    set.start = 0.5;
    set.step = 1e-3;
    set.response_node = 12;
    set.response_direction = response_direction;
    set.ordinate = ordinate;
    set.label = ordinate == 13 ? "Force" : "Acceleration";
    set.unit = unit;
    set.denominator = 0;
    set.per = "NONE";
    set.frequency_unit = "s";
    return testing::uffSet(set, values);
}

const std::string fourValues = fmt::format("{:20.12E}{:20.12E}{:20.12E}{:20.12E}\n", 1.0, -2.0, 3.0, 4.0);

TEST(TimeRecord, UniversalFiles)
{
    const std::string bytes = timeSet(3, 13, "N", fourValues) + timeSet(-3, 12, "g", fourValues);
    const TimeRecordFile file = readTimeRecord("r.uff", bytes);
    ASSERT_EQ(file.record.channels.size(), 2u);
    const TimeChannel& force = file.record.channels[0];
    const TimeChannel& acceleration = file.record.channels[1];
    EXPECT_EQ(force.role, TimeChannel::Role::Force);
    EXPECT_NEAR(*force.rate_hz, 1000, 1e-9);
    EXPECT_DOUBLE_EQ(force.start_s, 0.5);
    EXPECT_DOUBLE_EQ(acceleration.values[1], 2);  // its direction is -z
    EXPECT_EQ(acceleration.node, 12);
    EXPECT_EQ(acceleration.direction, 3);
    EXPECT_EQ(file.facts.format, "UFF");
    EXPECT_TRUE(find(file.facts.details, "datasets"));
}

TEST(TimeRecord, UniversalFilesTakeUnitsOfSet164)
{
    const std::string units =
        "    -1\n   164\n         5mm (milli-newton)             2\n"
        "  1.0000000000000000E+03  1.0000000000000000E+03  1.0000000000000000E+00\n    -1\n";
    const TimeRecordFile file = readTimeRecord("r.uff", units + timeSet(1, 13, "NONE", fourValues));
    ASSERT_TRUE(file.record.channels[0].unit);
    EXPECT_DOUBLE_EQ(file.record.channels[0].unit->scale, 1e-3);
    EXPECT_FALSE(readTimeRecord("r.uff", timeSet(1, 13, "NONE", fourValues)).record.channels[0].unit);
    EXPECT_EQ(readTimeRecord("r.uff", timeSet(1, 13, "V", fourValues)).record.channels[0].unit->kind,
              SignalUnit::Kind::Voltage);
}

TEST(TimeRecord, AUniversalFileOfResponsesIsNone)
{
    testing::UffText set;
    set.points = 1;
    const std::string bytes = testing::uffSet(set, fmt::format("{:20.12E}{:20.12E}\n", 1.0, 1.0));
    EXPECT_STREQ(timeErrorOf(bytes, "r.uff").code().key, "time_record_none");
}

struct Wav {
    int format = 1, bits = 16, channels = 2;
    std::uint32_t rate = 48000;
    bool extensible = false;
    std::string before;  ///< chunks in front of "fmt "
    long stated = -1;    ///< size of "data"; -1: as it is

    std::string with(const std::string& data) const
    {
        using testing::rawBytes;
        const auto bytes = static_cast<std::uint32_t>(bits / 8);
        std::string header;
        header += rawBytes(static_cast<std::uint16_t>(extensible ? 0xFFFE : format));
        header += rawBytes(static_cast<std::uint16_t>(channels)) + rawBytes(rate);
        header += rawBytes(static_cast<std::uint32_t>(rate * bytes * static_cast<std::uint32_t>(channels)));
        header += rawBytes(static_cast<std::uint16_t>(bytes * static_cast<std::uint32_t>(channels)));
        header += rawBytes(static_cast<std::uint16_t>(bits));
        if (extensible) {
            header +=
                rawBytes(std::uint16_t{22}) + rawBytes(static_cast<std::uint16_t>(bits)) + rawBytes(std::uint32_t{3});
            header += rawBytes(static_cast<std::uint16_t>(format)) + std::string(14, '\x01');
        }
        const auto size = stated < 0 ? static_cast<std::uint32_t>(data.size()) : static_cast<std::uint32_t>(stated);
        const std::string body = "WAVE" + before + "fmt " + rawBytes(static_cast<std::uint32_t>(header.size())) +
                                 header + "data" + rawBytes(size) + data;
        return "RIFF" + rawBytes(static_cast<std::uint32_t>(body.size())) + body;
    }
};

template <class... T>
std::string joined(T... values)
{
    return (testing::rawBytes(values) + ...);
}

TEST(TimeRecord, WavOf16Bits)
{
    Wav wav;
    wav.before = "LIST" + testing::rawBytes(std::uint32_t{3}) + "abc" + std::string(1, '\0');  // padded to even
    const TimeRecordFile file = readTimeRecord(
        "r.wav", wav.with(joined(std::int16_t{16384}, std::int16_t{-8192}, std::int16_t{32767}, std::int16_t{-32768})));
    ASSERT_EQ(file.record.channels.size(), 2u);
    const TimeChannel& left = file.record.channels[0];
    EXPECT_TRUE(left.is_of_full_scale);
    EXPECT_DOUBLE_EQ(*left.rate_hz, 48000);
    EXPECT_DOUBLE_EQ(left.values[0], 0.5);
    EXPECT_DOUBLE_EQ(file.record.channels[1].values[0], -0.25);
    EXPECT_EQ(left.at_limit, std::vector<std::size_t>{1});
    EXPECT_EQ(file.record.channels[1].at_limit, std::vector<std::size_t>{1});
    EXPECT_EQ(file.facts.format, "WAV");
}

TEST(TimeRecord, WavOfOtherWidths)
{
    Wav wav;
    wav.channels = 1;
    wav.bits = 24;
    EXPECT_DOUBLE_EQ(
        readTimeRecord("r.wav", wav.with(std::string("\x00\x00\xC0\x00\x00\x20", 6))).record.channels[0].values[0],
        -0.5);
    wav.bits = 32;
    wav.extensible = true;
    EXPECT_DOUBLE_EQ(readTimeRecord("r.wav", wav.with(joined(std::int32_t{1} << 29))).record.channels[0].values[0],
                     0.25);
    wav.format = 3;
    EXPECT_DOUBLE_EQ(readTimeRecord("r.wav", wav.with(joined(1.5F))).record.channels[0].values[0], 1.5);
    wav.stated = 0;  // a recorder that was stopped
    EXPECT_EQ(readTimeRecord("r.wav", wav.with(joined(1.5F, 2.5F))).record.channels[0].values.size(), 2u);
}

TEST(TimeRecord, BrokenWavs)
{
    Wav wav;
    wav.stated = 400;
    const Error cut = timeErrorOf(wav.with("abcd"), "r.wav");
    EXPECT_STREQ(cut.code().key, "truncated");
    EXPECT_GE(integerOf(cut, "byte"), 44);
    wav.stated = -1;
    wav.bits = 8;
    EXPECT_STREQ(timeErrorOf(wav.with("abcd"), "r.wav").code().key, "malformed");
    wav.bits = 32;
    wav.format = 3;
    EXPECT_STREQ(timeErrorOf(wav.with(joined(std::nanf(""), 1.0F)), "r.wav").code().key, "malformed");
    wav.channels = 0;
    EXPECT_STREQ(timeErrorOf(wav.with("abcd"), "r.wav").code().key, "malformed");
    EXPECT_STREQ(timeErrorOf("RIFF....WAVE", "r.wav").code().key, "malformed");
}

TEST(TimeRecord, KindsAreToldApart)
{
    const FileKinds kinds{&timeRecordFiles(), &scanFiles(), &profileFiles(), &probeRecordFiles(), &frfFiles()};
    const auto keyOf = [&](const std::string& name, const std::string& bytes) -> std::string {
        const KindFound found = likeliestKind(kinds, name, bytes, {});
        return found.kind ? found.kind->key : "";
    };
    const auto even = [](int i) { return 0.001 * i; };
    EXPECT_EQ(keyOf("r.csv", timeTable("t_s,force_N,acc_m_s2", even)), "time_record");
    EXPECT_EQ(keyOf("r.csv", timeTable("time,hammer_V,acc_V", even)), "time_record");
    EXPECT_EQ(keyOf("r.csv", timeTable("t_s,marker_V,X3_um", even)), "probe_record");
    EXPECT_EQ(keyOf("r.csv", timeTable("frequency_hz,real_mm_N,imag_mm_N", even)), "frf");
    EXPECT_EQ(keyOf("r.csv", timeTable("x,y,z", even)), "scan");
    EXPECT_EQ(keyOf("r.uff", timeSet(1, 13, "N", fourValues)), "time_record");
    testing::UffText set;
    set.points = 1;
    EXPECT_EQ(keyOf("r.uff", testing::uffSet(set, fmt::format("{:20.12E}{:20.12E}\n", 1.0, 1.0))), "frf");
    EXPECT_EQ(keyOf("noise", Wav().with("abcd")), "time_record");
}

TEST(TimeRecord, SensitivitiesAndUnits)
{
    EXPECT_DOUBLE_EQ(sensitivityOf("2.25 mV/N")->per_unit.scale, 1 / 2.25e-3);
    EXPECT_DOUBLE_EQ(sensitivityOf("10.2mV/(m/s^2)")->per_unit.scale, 1000 / 10.2e-3);
    EXPECT_DOUBLE_EQ(sensitivityOf("10.2 mV/(m/s²)")->per_unit.scale, 1000 / 10.2e-3);
    EXPECT_DOUBLE_EQ(sensitivityOf("4 um/V")->per_unit.scale, 4e-3);
    EXPECT_EQ(sensitivityOf("4 mm/s")->per_unit.kind, SignalUnit::Kind::Velocity);
    EXPECT_FALSE(sensitivityOf("4 mm/s")->of_volts);
    EXPECT_FALSE(sensitivityOf("N"));
    EXPECT_FALSE(sensitivityOf("3 furlong/V"));
    EXPECT_EQ(parseSignalHeading("acc_m_s2").name, "acc");
    EXPECT_EQ(parseSignalHeading("F_hammer_kN").unit->scale, 1000);
    EXPECT_FALSE(parseSignalHeading("channel_1").unit);
    EXPECT_EQ(parseSignalHeading("Force (ticks)").unit_text, "ticks");
}

}  // namespace
}  // namespace lathelier::io
