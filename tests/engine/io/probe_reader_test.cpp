// Probe records from tables: raw and averaged, as the practice data write them and as others may.
#include "engine/io/probe/probe_reader.h"
#include "engine/core/core_codes.h"
#include "engine/io/io_codes.h"
#include "engine/io/probe/probe_table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>

#include "engine/io/text/header_lines.h"
#include "tests/engine/io/reading.h"

namespace lathelier {
namespace {

const std::string practiceRecords = LATHELIER_SOURCE_DIR "/tests/data/lagrang/";

TEST(ProbeReader, practiceRecordAsTableAndAsPair)
{
    const io::ProbeFile table = io::readProbeRecord(practiceRecords + "section01_raw.csv");
    const io::ProbeFile pair = io::readProbeRecord(practiceRecords + "section01_lgraph1.dat");
    EXPECT_EQ(table.facts.format, "probe_csv_raw");
    EXPECT_EQ(pair.facts.format, "lgraph_1");
    const auto& a = std::get<io::ProbeRecord>(table.record);
    const auto& b = std::get<io::ProbeRecord>(pair.record);
    ASSERT_EQ(a.channels.size(), 5U);
    ASSERT_EQ(b.channels.size(), 5U);
    ASSERT_EQ(a.frames(), 16520U);
    ASSERT_EQ(b.frames(), 16520U);
    EXPECT_EQ(a.channels[0].name, "marker");
    EXPECT_EQ(a.channels[0].unit, io::ProbeChannel::Unit::Volt);
    EXPECT_EQ(a.channels[1].name, "X3");
    EXPECT_EQ(a.channels[1].unit, io::ProbeChannel::Unit::Micrometre);
    EXPECT_EQ(b.channels[1].name, "channel 2");
    EXPECT_EQ(b.channels[1].unit, io::ProbeChannel::Unit::Volt);
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
    EXPECT_EQ(testing::furtherNotes(table.notes), 0U);
}

TEST(ProbeReader, practiceAverages)
{
    const io::ProbeFile file = io::readProbeRecord(practiceRecords + "averaged_20x200.csv");
    const auto& record = std::get<io::AveragedRecord>(file.record);
    ASSERT_EQ(record.sections.size(), 20U);
    EXPECT_EQ(file.facts.format, "probe_csv_averaged");
    for (std::size_t s = 0; s < 20; ++s) {
        const io::AveragedSection& section = record.sections[s];
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

io::ProbeFile readRecord(const std::string& text, const io::ImportOptions& options = {})
{
    return io::readProbeTable("test", text, options);
}

io::ProbeRecord raw(const std::string& text, const io::ImportOptions& options = {})
{
    return std::get<io::ProbeRecord>(readRecord(text, options).record);
}

Error recordRefusal(const std::string& text, const io::ImportOptions& options = {})
{
    try {
        readRecord(text, options);
    } catch (const Error& error) {
        EXPECT_TRUE(find(error.values(), "path"));
        return error;
    }
    ADD_FAILURE() << "no error for " << text.substr(0, 200);
    return Error(errors::unknownOption, {});
}

TEST(ProbeReader, headingsInManyDisguises)
{
    const std::string point = "0,0.1,1.5,2.5\n0.5,0.2,1.6,2.6\n1.0,0.3,1.7,2.7\n";
    std::string comma;
    for (const char c : point) comma += c == ',' ? ';' : c == '.' ? ',' : c;
    for (const std::string& text :
         {"t_s,marker_V,X3_um,Y3_um\n" + point, "time [s],marker [V],X3 [µm],Y3 [um]\n" + point,
          "Time (s),marker (V),X3 (micron),Y3 (µm)\n" + point, "t;marker;X3;Y3\ns;V;µm;µm\n" + comma,
          "# unit_time=s; unit_disp=um\nt,marker_V,X3,Y3\n" + point, "# t_s,marker_V,X3_um,Y3_um\n" + point}) {
        const io::ProbeRecord record = raw(text);
        ASSERT_EQ(record.channels.size(), 3U) << text;
        EXPECT_EQ(record.channels[0].name, "marker") << text;
        EXPECT_EQ(record.channels[0].unit, io::ProbeChannel::Unit::Volt) << text;
        EXPECT_EQ(record.channels[1].name, "X3");
        EXPECT_EQ(record.channels[1].unit, io::ProbeChannel::Unit::Micrometre) << text;
        EXPECT_EQ(record.channels[2].values[1], 2.6);
        EXPECT_DOUBLE_EQ(record.rate_hz, 2);
    }
}

TEST(ProbeReader, unitsOfChannels)
{
    const io::ProbeRecord record = raw(
        "t_ms,marker_mV,X3 (mm),Y3_inch,angle_deg,phi_rad,X4_nm,other\n0,500,0.5,1,90,1,500,7\n1,0,0.25,0,91,2,0,8\n"
        "2,0,0.25,0,92,3,0,9\n");
    const auto& c = record.channels;
    ASSERT_EQ(c.size(), 7U);
    EXPECT_DOUBLE_EQ(c[0].values[0], 0.5);
    EXPECT_EQ(c[1].unit, io::ProbeChannel::Unit::Millimetre);
    EXPECT_EQ(c[1].values[0], 0.5);
    EXPECT_DOUBLE_EQ(c[2].values[0], 25400);
    EXPECT_EQ(c[3].unit, io::ProbeChannel::Unit::Degree);
    EXPECT_EQ(c[3].values[0], 90);
    EXPECT_NEAR(c[4].values[0], 180 / 3.14159265358979, 1e-9);
    EXPECT_DOUBLE_EQ(c[5].values[0], 0.5);
    EXPECT_EQ(c[6].unit, io::ProbeChannel::Unit::Unknown);
    EXPECT_NEAR(record.rate_hz, 1000, 1e-9);
    io::ImportOptions mm;
    mm.unit = io::LengthUnit::Millimetre;
    EXPECT_EQ(raw("t_s,X3,Y3\n0,1,2\n1,2,3\n", mm).channels[0].unit, io::ProbeChannel::Unit::Millimetre);
    EXPECT_TRUE(contains(readRecord("t_s,X3,Y3\n0,1,2\n1,2,3\n").notes, notes::channelUnitUnknown));
}

TEST(ProbeReader, whatTheHeaderSays)
{
    const io::ProbeRecord record =
        raw("# lagrang-raw v1; rpm=975; D_mm=50,5\n# tool=CNMG 120408, feed_mm_rev=0.1\n# channel_skew_s=3.07e-05 "
            "(channel k "
            "at t+k*skew, k=0..4); note=a (b; c=d)\nt_s,X3_um,Y3_um\n0,1,2\n1,2,3\n2,3,4\n");
    const auto word = [&record](const char* key) { return std::get<std::string>(*find(record.header, key)); };
    EXPECT_EQ(word("rpm"), "975");
    EXPECT_EQ(word("D_mm"), "50,5");
    EXPECT_EQ(io::headerNumber(record.header, "d_MM"), 50.5);
    EXPECT_EQ(word("tool"), "CNMG 120408");
    EXPECT_EQ(word("feed_mm_rev"), "0.1");
    EXPECT_EQ(word("note"), "a (b; c=d)");
    EXPECT_EQ(record.channel_skew_s, 3.07e-05);
    EXPECT_FALSE(io::headerNumber(record.header, "tool"));
    EXPECT_FALSE(io::headerNumber({{"a", std::string("1,234")}}, "a"));
}

std::string timed(int rows, const std::function<double(int)>& time, int decimals)
{
    std::string text = "t_s,X3_um,Y3_um\n";
    for (int i = 0; i < rows; ++i) text += fmt::format("{:.{}f},1,2\n", time(i), decimals);
    return text;
}

TEST(ProbeReader, times)
{
    const auto even = [](int i) { return i / 6500.0; };
    io::ProbeFile file = readRecord(timed(2000, even, 7));
    EXPECT_EQ(testing::furtherNotes(file.notes), 0U);
    EXPECT_NEAR(std::get<io::ProbeRecord>(file.record).rate_hz, 6500, 1e-2);
    EXPECT_EQ(std::get<io::ProbeRecord>(file.record).time_s.size(), 2000U);
    // Rounded to 0.1 ms, the single times say less than all of them together.
    file = readRecord(timed(2000, even, 4));
    EXPECT_TRUE(contains(file.notes, notes::timeCoarse));
    EXPECT_NEAR(std::get<io::ProbeRecord>(file.record).rate_hz, 6500, 2);
    EXPECT_TRUE(std::get<io::ProbeRecord>(file.record).time_s.empty());
    // A gap.
    file = readRecord(timed(
        2000, [&](int i) { return even(i < 1000 ? i : i + 5); }, 7));
    ASSERT_TRUE(contains(file.notes, notes::timeIrregular));
    EXPECT_EQ(std::get<std::int64_t>(*find(file.notes[0].values, "count")), 1);
    EXPECT_EQ(std::get<std::int64_t>(*find(file.notes[0].values, "line")), 1002);
    EXPECT_NEAR(std::get<io::ProbeRecord>(file.record).rate_hz, 6500, 5);
    // Times that go back, or stand still.
    const Error back = recordRefusal(timed(
        2000, [&](int i) { return even(i < 1000 ? i : i - 100); }, 7));
    EXPECT_EQ(back.code(), errors::malformed);
    EXPECT_EQ(testing::integerOf(back, "line"), 1002);
    EXPECT_EQ(recordRefusal(timed(
                                2000, [&](int i) { return even(i == 1000 ? 999 : i); }, 7))
                  .code(),
              errors::malformed);
    EXPECT_TRUE(contains(readRecord("time,X3_um,Y3_um\n0,1,2\n1,1,2\n2,1,2\n").notes, notes::timeUnitAssumed));
    EXPECT_TRUE(contains(readRecord("X3_um,Y3_um\n0.5,1\n1,1\n2,1\n").notes, notes::rateUnknown));
    EXPECT_EQ(raw("# rate_kHz=6.5\nX3_um,Y3_um\n0.5,1\n1,1\n2,1\n").rate_hz, 6500);
}

TEST(ProbeReader, lostSamplesStayAsHoles)
{
    const io::ProbeFile file = readRecord("t_s,X3_um,Y3_um\n0,1,2\n1,nan,3\n2,3,\n3,4,5\n");
    const auto& record = std::get<io::ProbeRecord>(file.record);
    ASSERT_EQ(record.frames(), 4U);
    EXPECT_TRUE(std::isnan(record.channels[0].values[1]));
    EXPECT_TRUE(std::isnan(record.channels[1].values[2]));
    EXPECT_TRUE(contains(file.notes, notes::samplesMissing));
    // A frame without its time has no place.
    std::string rows = "t_s,X3_um,Y3_um\n0,1,2\nnan,2,3\n";
    for (int i = 2; i < 20; ++i) rows += fmt::format("{},1,2\n", i);
    const io::ProbeFile timeless = readRecord(rows);
    EXPECT_EQ(std::get<io::ProbeRecord>(timeless.record).frames(), 19U);
    EXPECT_EQ(std::get<io::ProbeRecord>(timeless.record).rate_hz, 1);
    EXPECT_TRUE(contains(timeless.notes, notes::timeIrregular));
}

TEST(ProbeReader, averages)
{
    const std::string head = "section,z_mm,i,angle_deg,X3_um,Y3_um,Xp_um,Yp_um\n";
    const io::ProbeFile file = readRecord(head + "2,10,0,0,1,2,3,4\n2,10,1,180,5,6,7,8\n1,5,0,0,9,8,7,6\n");
    const auto& record = std::get<io::AveragedRecord>(file.record);
    ASSERT_EQ(record.sections.size(), 2U);
    EXPECT_EQ(record.sections[0].section, 2);
    EXPECT_EQ(record.sections[0].Yp_um, (std::vector<double>{4, 8}));
    EXPECT_EQ(record.sections[1].z_mm, 5);
    EXPECT_TRUE(record.sections[0].sX3_um.empty());
    EXPECT_EQ(recordRefusal(head + "1,5,0,0,1,2,3,4\n1,6,1,180,5,6,7,8\n").code(), errors::malformed);
    EXPECT_EQ(recordRefusal(head + "1.5,5,0,0,1,2,3,4\n2,6,1,180,5,6,7,8\n").code(), errors::malformed);
    EXPECT_EQ(recordRefusal("section,angle_deg,X3_um,Y3_um\n1,0,1,2\n1,1,5,6\n").code(), errors::columnsUnknown);
    EXPECT_EQ(recordRefusal("section,angle_deg,X3,Y3,Xp,Yp\n1,0,1,2,3,4\n1,1,5,6,7,8\n").code(), errors::unitUnknown);
    const auto mm = std::get<io::AveragedRecord>(
        readRecord("section,angle_rad,X3_mm,Y3_mm,Xp_mm,Yp_mm\n1,0,1,2,3,4\n1,1,5,6,7,8\n").record);
    EXPECT_DOUBLE_EQ(mm.sections[0].X3_um[1], 5000);
    EXPECT_NEAR(mm.sections[0].angle_deg[1], 57.29577951, 1e-8);
    EXPECT_TRUE(std::isnan(mm.sections[0].z_mm));
}

TEST(ProbeReader, whatIsNoRecord)
{
    EXPECT_EQ(recordRefusal("").code(), errors::fileEmpty);
    EXPECT_EQ(recordRefusal("x,y,z\n1,2,3\n4,5,6\n").code(), errors::formatUnknown);
    EXPECT_EQ(recordRefusal("angle_deg,r\n1,2\n4,5\n").code(), errors::formatUnknown);
    EXPECT_EQ(recordRefusal("t_s,n\n0,1\n1,2\n").code(), errors::columnsUnknown);
    const Error broken = recordRefusal("t_s,X3_um\n0,1\n1,two\n2,3\n");
    EXPECT_EQ(broken.code(), errors::malformed);
    EXPECT_EQ(testing::integerOf(broken, "line"), 3);
    EXPECT_FALSE(io::isProbeTable("x,y,z\n1,2,3\n4,5,6\n"));
    EXPECT_FALSE(io::isProbeTable("t,x,y,z\n1,2,3,4\n4,5,6,7\n"));
    EXPECT_TRUE(io::isProbeTable("t,marker,x,y\n1,2,3,4\n4,5,6,7\n"));
}

}  // namespace
}  // namespace lathelier
