// Frequency responses in tables: columns, units, and what is refused.
#include <gtest/gtest.h>

#include "engine/io/file_kind.h"
#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/frf_reader.h"
#include "tests/engine/io/reading.h"

namespace lathelier {
namespace {

using testing::integerOf;

io::FrfFile readTable(const std::string& text, const io::FrfOptions& options = {}, const io::ImportOptions& import = {})
{
    return io::readFrf("test.csv", text, import, options);
}

Error tableRefusal(const std::string& text, const io::FrfOptions& options = {})
{
    try {
        readTable(text, options);
    } catch (const Error& error) {
        EXPECT_TRUE(find(error.values(), "path"));
        return error;
    }
    ADD_FAILURE() << "no error for " << text;
    return Error(errors::unknownOption, {});
}

std::string table(const std::string& heading, const std::string& rows = "50,1.5,-2.5\n52,3.5,-4.5\n54,1,-2\n")
{
    return heading + "\n" + rows;
}

constexpr double frfTolerance = 1e-12;

TEST(FrfTable, readsRealAndImaginaryPart)
{
    const io::FrfFile file = readTable(table("frequency_hz,real_mm_N,imag_mm_N"));
    ASSERT_EQ(file.frfs.size(), 1U);
    const Frf& frf = file.frfs[0].frf;
    EXPECT_EQ(frf.quantity, FrfQuantity::Receptance);
    EXPECT_EQ(frf.frequency_hz, (std::vector<double>{50, 52, 54}));
    EXPECT_EQ(frf.value[1], std::complex<double>(3.5, -4.5));
    EXPECT_EQ(file.facts.format, "frf_csv");
    EXPECT_EQ(file.facts.unit, "mm/N");
    EXPECT_EQ(file.facts.unit_source, "stated");
}

TEST(FrfTable, unitsOfHeadings)
{
    struct Case {
        const char* heading;
        FrfQuantity quantity;
        double scale;
    };
    const Case cases[] = {{"frequency_hz,real_m_N,imag_m_N", FrfQuantity::Receptance, 1000},
                          {"f,real_mm_s_N,imag_mm_s_N", FrfQuantity::Mobility, 1},
                          {"freq,re_m_s2_N,im_m_s2_N", FrfQuantity::Accelerance, 1000},
                          {"Frequency (Hz),Real (m/s^2/N),Imag (m/s^2/N)", FrfQuantity::Accelerance, 1000},
                          {"Frequency [Hz],Re(H) [mm/N],Im(H) [mm/N]", FrfQuantity::Receptance, 1},
                          {"f_hz,real_g_N,imag_g_N", FrfQuantity::Accelerance, 9806.65},
                          {"f,real,imag\nHz,m/N,m/N", FrfQuantity::Receptance, 1000},
                          {"f_hz,real (m/s)/N,imag (m/s)/N", FrfQuantity::Mobility, 1000}};
    for (const Case& one : cases) {
        const Frf frf = readTable(table(one.heading)).frfs.at(0).frf;
        EXPECT_EQ(frf.quantity, one.quantity) << one.heading;
        EXPECT_NEAR(frf.value[0].real() / one.scale, 1.5, frfTolerance) << one.heading;
    }
}

TEST(FrfTable, magnitudeAndPhase)
{
    const Frf degrees =
        readTable(table("frequency_hz,magnitude_mm_N,phase_deg", "10,2,-90\n20,1,-180\n30,3,0\n")).frfs.at(0).frf;
    EXPECT_NEAR(std::abs(degrees.value[0] - std::complex<double>(0, -2)), 0, frfTolerance);
    EXPECT_NEAR(std::abs(degrees.value[1] - std::complex<double>(-1, 0)), 0, frfTolerance);
    const Frf radians = readTable(table("f,mag_m_N,phase_rad", "10,2,-1.5707963267948966\n20,1,0\n")).frfs.at(0).frf;
    EXPECT_NEAR(std::abs(radians.value[0] - std::complex<double>(0, -2000)), 0, 1e-9);
    EXPECT_EQ(tableRefusal(table("f,mag_m_N,phase")).code(), errors::frfUnitMissing);
    EXPECT_EQ(tableRefusal(table("f,mag_db,phase_deg"), {io::FrfUnitChoice::MPerN, {}}).code(), errors::frfUnitMissing);
}

TEST(FrfTable, withoutAUnitOneHasToBeGiven)
{
    const Error error = tableRefusal(table("frequency_hz,real,imag"));
    EXPECT_EQ(error.code(), errors::frfUnitMissing);
    EXPECT_EQ(error.code().kind, ErrorKind::InputRejected);
    EXPECT_EQ(integerOf(error, "line"), 1);
    EXPECT_EQ(integerOf(error, "column"), 2);
    const io::FrfFile given = readTable(table("frequency_hz,real,imag"), {io::FrfUnitChoice::MPerS2N, {}});
    EXPECT_EQ(given.frfs.at(0).frf.quantity, FrfQuantity::Accelerance);
    EXPECT_EQ(given.frfs.at(0).frf.value[0], std::complex<double>(1500, -2500));
    EXPECT_EQ(given.facts.unit_source, "given");
    const io::FrfFile stated = readTable(table("frequency_hz,real_mm_N,imag_mm_N"), {io::FrfUnitChoice::MPerN, {}});
    EXPECT_EQ(stated.frfs.at(0).frf.value[0].real(), 1.5);
    EXPECT_TRUE(contains(stated.notes, notes::frfUnitNotUsed));
    EXPECT_EQ(tableRefusal(table("frequency_hz,real_mm_N,imag_m_N")).code(), errors::frfUnitMissing);
    EXPECT_EQ(tableRefusal(table("frequency_hz,real_kg,imag_kg")).code(), errors::frfUnitMissing);
}

TEST(FrfTable, separatorsDecimalMarksAndRemarks)
{
    const Frf frf =
        readTable("# tip of a shaft\nfrequency_hz;real_mm_N;imag_mm_N\n50,5;1,5e-4;-2,5\n51,5;1;-2\n").frfs[0].frf;
    EXPECT_EQ(frf.frequency_hz[0], 50.5);
    EXPECT_EQ(frf.value[0], std::complex<double>(1.5e-4, -2.5));
}

TEST(FrfTable, coherenceIsKept)
{
    const Frf frf =
        readTable(table("frequency_hz,real_mm_N,imag_mm_N,coherence", "1,1,1,0.5\n2,1,1,nan\n")).frfs[0].frf;
    EXPECT_EQ(frf.coherence, (std::vector<double>{0.5, 0}));
}

TEST(FrfTable, frequenciesHaveToAscend)
{
    const Error error = tableRefusal(table("frequency_hz,real_mm_N,imag_mm_N", "50,1,2\n52,1,2\n52,1,2\n"));
    EXPECT_EQ(error.code(), errors::frfNotAscending);
    EXPECT_EQ(integerOf(error, "line"), 4);
}

TEST(FrfTable, otherTablesAreNone)
{
    EXPECT_EQ(tableRefusal(table("x,y,z")).code(), errors::columnsUnknown);
    EXPECT_EQ(tableRefusal(table("t_s,X3_um,Y3_um")).code(), errors::columnsUnknown);
}

TEST(FrfKind, isToldByContent)
{
    const io::FileKinds kinds{&io::scanFiles(), &io::profileFiles(), &io::probeRecordFiles(), &io::qdasFiles(),
                              &io::frfFiles()};
    const auto keyOf = [&kinds](const std::string& path, const std::string& head) {
        return io::likeliestKind(kinds, path, head, {}).kind->key;
    };
    EXPECT_EQ(keyOf("a.csv", table("frequency_hz,real_mm_N,imag_mm_N")), "frf");
    EXPECT_EQ(keyOf("a.csv", table("frequency_hz,real,imag")), "frf");
    EXPECT_EQ(keyOf("a.csv", table("frequency,magnitude,phase_deg")), "frf");
    EXPECT_EQ(keyOf("a.csv", table("x,y,z")), "scan");
    EXPECT_EQ(keyOf("a.csv", table("50,1,2")), "scan");
    EXPECT_EQ(keyOf("a.csv", table("t_s,X3_um,Y3_um")), "probe_record");
    EXPECT_EQ(keyOf("a.csv", table("angle_deg,r_mm", "0,25\n90,25.1\n180,25\n270,25.1\n")), "profile");
    EXPECT_EQ(keyOf("a.dat", "    -1\n    58\n"), "frf");
    EXPECT_EQ(keyOf("a.csv", "-1\n58\n3\n"), "profile");
    EXPECT_EQ(keyOf("a.uff", "nothing"), "frf");
}

}  // namespace
}  // namespace lathelier
