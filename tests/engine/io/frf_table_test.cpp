// Frequency responses in tables: columns, units, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "engine/core/core_codes.h"
#include "engine/io/file_kind.h"
#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/frf_reader.h"
#include "engine/io/io_codes.h"
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
}

TEST(FrfTable, levelsInDecibel)
{
    const std::string rows = "10,-120,-90\n20,-140,180\n";
    // 20 lg(1e-6) is -120.
    for (const char* heading :
         {"f,mag (dB re 1 m/N),phase_deg", "f,dB re 1 m/N,phase_deg", "f,magnitude_dB_re_1_m_N,phase_deg",
          "f;dB re 1000 mm/N;phase (deg)", "f,dB,phase\nHz,dB re 1 m/N,deg"}) {
        std::string text = table(heading, rows);
        if (text.find(';') != std::string::npos) std::replace(text.begin(), text.end(), ',', ';');
        const Frf frf = readTable(text).frfs.at(0).frf;
        EXPECT_NEAR(std::abs(frf.value[0] - std::complex<double>(0, -1e-3)), 0, 1e-15) << heading;
        EXPECT_NEAR(std::abs(frf.value[1] - std::complex<double>(-1e-4, 0)), 0, 1e-15) << heading;
    }
    for (const char* heading : {"f,mag_db,phase_deg", "f,magnitude_dB,phase_deg", "f,dB,phase_deg"}) {
        EXPECT_EQ(tableRefusal(table(heading, rows)).code(), errors::frfUnitMissing) << heading;
        const Frf given = readTable(table(heading, rows), {io::FrfUnitChoice::MmPerN, {}}).frfs.at(0).frf;
        EXPECT_NEAR(std::abs(given.value[0] - std::complex<double>(0, -1e-6)), 0, 1e-18) << heading;
    }
}

TEST(FrfTable, complexNumbersInOneColumn)
{
    const std::vector<std::complex<double>> expected{{1e-5, -2e-6}, {-3.5e-5, 4e-6}};
    const char* const tables[] = {"frequency_hz,H (mm/N)\n10,1e-5-2e-6j\n20,-3.5e-5+4e-6j\n",
                                  "frequency_hz,H_mm_N\n10,(1e-5-2e-6j)\n20,(-3.5e-5+4e-6j)\n",
                                  "f;H [mm/N]\n10;(1e-5,-2e-6)\n20;(-3.5e-5,4e-6)\n",
                                  "f,H [mm/N]\n10,(1e-5,-2e-6)\n20,(-3.5e-5,4e-6)\n",
                                  "f,H [mm/N]\n10,\"1e-5 - 2e-6i\"\n20,\"-3.5e-5 + 4e-6i\"\n",
                                  "f\tH\nHz\tmm/N\n10\t1e-5 - 2e-6*i\n20\t-3.5e-5 + 4e-6*i\n",
                                  "f H[mm/N]\n10 1e-5+-2e-6j\n20 -3.5e-5+4e-6j\n",
                                  "f;H (mm/N)\n10,0;0,00001-0,000002i\n20,0;-0,000035+0,000004i\n",
                                  "f;H (mm/N)\r\n10;1E-5-j2E-6\r\n20;-3.5E-5+j*4E-6\r\n",
                                  "H (mm/N);f\n1E-5-2E-6I;10\n-3.5E-5+4E-6I;20\n",
                                  "f,coherence,H_mm_N\n10,0.9,1e-5-2e-6j\n20,0.8,-3.5e-5+4e-6j\n"};
    for (const char* text : tables) {
        const io::FrfFile file = readTable(text);
        EXPECT_EQ(file.frfs.at(0).frf.value, expected) << text;
        EXPECT_EQ(file.frfs[0].frf.frequency_hz, (std::vector<double>{10, 20})) << text;
        EXPECT_TRUE(io::likeFrf("a.csv", text, {}) == io::Likeness::Certain) << text;
    }
    const Frf imaginary = readTable("f,H (mm/N)\n10,-2e-6j\n20,1+0j\n").frfs.at(0).frf;
    EXPECT_EQ(imaginary.value, (std::vector<std::complex<double>>{{0, -2e-6}, {1, 0}}));
    EXPECT_EQ(tableRefusal("f,H\n10,1e-5-2e-6j\n20,1e-5-2e-6j\n").code(), errors::frfUnitMissing);
    EXPECT_EQ(tableRefusal("10,1e-5-2e-6j\n20,1e-5-2e-6j\n").code(), errors::columnsUnknown);
    // A row that is not like the others is named with its line.
    EXPECT_EQ(integerOf(tableRefusal("f,H (mm/N)\n10,1-2j\n20,1-2j\n30,7\n40,1-2j\n"), "line"), 4);
}

TEST(FrfTable, columnsWithoutHeadingsAreStated)
{
    const std::string rows = "10,1,-2\n20,3,-4\n";
    const auto read = [&rows](const std::string& columns, const std::string& text = {}) {
        io::FrfOptions options{io::FrfUnitChoice::MmPerN, {}};
        options.frf_columns = columns;
        return readTable(text.empty() ? rows : text, options).frfs.at(0).frf;
    };
    const Error error = tableRefusal(rows);
    EXPECT_EQ(error.code(), errors::columnsUnknown);
    EXPECT_NE(std::string(error.what()).find("--frf-columns"), std::string::npos);
    EXPECT_EQ(read("frequency,real,imag").value[1], std::complex<double>(3, -4));
    EXPECT_EQ(read("frequency, imag, real").value[1], std::complex<double>(-4, 3));
    EXPECT_NEAR(std::abs(read("frequency,magnitude,phase").value[0] - std::polar(1.0, -2 * std::numbers::pi / 180)), 0,
                frfTolerance);
    EXPECT_NEAR(std::abs(read("frequency,magnitude,phase_rad").value[0] - std::polar(1.0, -2.0)), 0, frfTolerance);
    EXPECT_NEAR(std::abs(read("frequency,magnitude_db,phase_rad").value[0] - std::polar(std::pow(10, 0.05), -2.0)), 0,
                frfTolerance);
    EXPECT_EQ(read("frequency,skip,real,imag", "10;7;1,5;-2,5\n20;7;3,5;-4,5\n").value[0],
              std::complex<double>(1.5, -2.5));
    EXPECT_EQ(read("frequency,complex", "10 1-2j\n20 3-4j\n").value[1], std::complex<double>(3, -4));
    EXPECT_EQ(read("frequency,real,imag,coherence", "10,1,-2,0.5\n20,3,-4,0.75\n").coherence[1], 0.75);
    io::FrfOptions options;
    options.frf_columns = "frequency,real,imag";
    EXPECT_EQ(tableRefusal(rows, options).code(), errors::frfUnitMissing);
    for (const char* wrong : {"frequency,real", "real,imag", "frequency,real,imag,magnitude", "a,b,c",
                              "frequency,frequency,real,imag", "frequency,magnitude,real", ","}) {
        options.frf_columns = wrong;
        EXPECT_EQ(tableRefusal(rows, options).code(), errors::valueNotUnderstood) << wrong;
    }
    options.frf_columns = "frequency,skip,skip,real,imag";
    EXPECT_EQ(tableRefusal(rows, options).code(), errors::columnsUnknown);
}

TEST(FrfTable, namesBehindTheFirstRow)
{
    for (const char* names :
         {"\tFreq\tHz\tReal\tm/N\tImag\tReal\t", "  Freq Hz Real m/N Imag m/N", " Freq Hz Real m/N Imag"}) {
        const std::string text = std::string("  0.0e+00\t1e-06\t-2e-06") + names + "\n  1.0e+01\t3e-06\t-4e-06\t\n";
        const io::FrfFile file = readTable(text);
        EXPECT_EQ(file.facts.format, "frf_cutpro");
        EXPECT_EQ(file.facts.unit, "m/N");
        EXPECT_EQ(file.frfs.at(0).frf.frequency_hz, (std::vector<double>{0, 10})) << names;
        EXPECT_NEAR(std::abs(file.frfs[0].frf.value[1] - std::complex<double>(3e-3, -4e-3)), 0, 1e-15) << names;
        EXPECT_TRUE(io::likeFrf("tap.dat", text, {}) == io::Likeness::Certain);
    }
    const Error error = tableRefusal("0 1 2 Freq Hz Real Imag\n1 2 3\n");
    EXPECT_EQ(error.code(), errors::frfUnitMissing);
    EXPECT_EQ(integerOf(error, "line"), 1);
    EXPECT_EQ(tableRefusal("0 1 2 Freq Hz Real m/N Imag mm/N\n1 2 3\n").code(), errors::frfUnitMissing);
}

TEST(FrfTable, angularFrequencies)
{
    constexpr double perRadian = 0.5 / std::numbers::pi;
    for (const char* heading : {"omega_rad_s,real_mm_N,imag_mm_N", "omega (rad/s),real_mm_N,imag_mm_N",
                                "w [rad/s],real_mm_N,imag_mm_N", "f (rad/s),real_mm_N,imag_mm_N"})
        EXPECT_EQ(readTable(table(heading)).frfs.at(0).frf.frequency_hz[0], 50 * perRadian) << heading;
    const Error error = tableRefusal(table("omega,real_mm_N,imag_mm_N"));
    EXPECT_EQ(error.code(), errors::frequencyUnitMissing);
    EXPECT_EQ(integerOf(error, "column"), 1);
    io::FrfOptions options;
    options.frequency_unit = io::FrequencyUnitChoice::RadPerSecond;
    EXPECT_EQ(readTable(table("omega,real_mm_N,imag_mm_N"), options).frfs.at(0).frf.frequency_hz[0], 50 * perRadian);
    EXPECT_EQ(readTable(table("f,real_mm_N,imag_mm_N"), options).frfs.at(0).frf.frequency_hz[0], 50 * perRadian);
    const io::FrfFile stated = readTable(table("f_hz,real_mm_N,imag_mm_N"), options);
    EXPECT_EQ(stated.frfs.at(0).frf.frequency_hz[0], 50);
    EXPECT_TRUE(contains(stated.notes, notes::frfUnitNotUsed));
    // Both may stand side by side.
    EXPECT_EQ(readTable("omega,f_hz,real_mm_N,imag_mm_N\n300,50,1,2\n400,60,1,2\n").frfs.at(0).frf.frequency_hz[0], 50);
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
