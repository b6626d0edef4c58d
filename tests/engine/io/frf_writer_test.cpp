// Frequency responses written and read again, and turned into receptances.
#include "engine/io/frf/frf_writer.h"

#include <gtest/gtest.h>

#include <clocale>
#include <filesystem>

#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "tests/engine/io/frf_files.h"
#include "tests/scratch_folder.h"

namespace lathelier {
namespace {

using testing::modeFrf;

constexpr FrfQuantity quantities[] = {FrfQuantity::Receptance, FrfQuantity::Mobility, FrfQuantity::Accelerance};

void expectSameFrf(const Frf& found, const Frf& expected, double relative)
{
    EXPECT_EQ(found.quantity, expected.quantity);
    ASSERT_EQ(found.value.size(), expected.value.size());
    for (std::size_t i = 0; i < expected.value.size(); ++i) {
        EXPECT_NEAR(found.frequency_hz[i], expected.frequency_hz[i], 1e-9 * expected.frequency_hz[i]);
        EXPECT_LE(std::abs(found.value[i] - expected.value[i]), relative * std::abs(expected.value[i]));
    }
    ASSERT_EQ(found.coherence.size(), expected.coherence.size());
    for (std::size_t i = 0; i < expected.coherence.size(); ++i)
        EXPECT_NEAR(found.coherence[i], expected.coherence[i], 1e-12);
}

TEST(FrfWriter, universalFilesComeBack)
{
    for (const FrfQuantity quantity : quantities)
        for (const bool even : {true, false})
            for (const int lines : {1, 2, 5, 101}) {
                io::MeasuredFrf written = modeFrf(quantity, lines, 50.123, 0.1);
                if (!even && lines > 2) written.frf.frequency_hz[1] += 0.01234567;
                if (lines == 101) written.frf.coherence.assign(written.frf.value.size(), 0.875);
                const std::vector<io::MeasuredFrf> both{written, modeFrf(quantity)};
                const io::FrfFile file = io::readFrf("test.uff", io::toUff(both), {}, {});
                ASSERT_EQ(file.frfs.size(), 2U);
                expectSameFrf(file.frfs[0].frf, written.frf, 1e-11);
                EXPECT_EQ(file.frfs[0].response_node, 7);
                EXPECT_EQ(file.frfs[0].reference_direction, 3);
                EXPECT_EQ(file.frfs[0].frf.name, "mode");
                EXPECT_TRUE(file.notes.empty());
            }
}

TEST(FrfWriter, universalFilesKeepTheirColumns)
{
    const std::string text = io::toUff(std::vector{modeFrf(FrfQuantity::Receptance, 3)});
    EXPECT_TRUE(text.starts_with("    -1\n    58\nmode\n"));
    EXPECT_NE(text.find("\n         6         3         1"), std::string::npos);
    EXPECT_NE(text.find("\n         8    0    0    0 Displacement         mm                  \n"), std::string::npos);
    EXPECT_NE(text.find("\n        13    0    0    0 Excitation force     N                   \n"), std::string::npos);
}

TEST(FrfWriter, tablesComeBackWithAllDigits)
{
    for (const FrfQuantity quantity : quantities) {
        io::MeasuredFrf written = modeFrf(quantity, 11, 50, 1.0 / 3);
        written.frf.coherence.assign(11, 0.1);
        const std::string text = io::toFrfCsv(written.frf);
        const Frf read = io::readFrf("test.csv", text, {}, {}).frfs.at(0).frf;
        expectSameFrf(read, written.frf, 0);
        EXPECT_EQ(read.frequency_hz, written.frf.frequency_hz);
    }
    EXPECT_TRUE(io::toFrfCsv(modeFrf(FrfQuantity::Receptance).frf).starts_with("frequency_hz,real_mm_N,imag_mm_N\n"));
}

TEST(FrfWriter, localeChangesNothing)
{
    const io::MeasuredFrf written = modeFrf(FrfQuantity::Receptance);
    const std::string uff = io::toUff(std::vector{written}), csv = io::toFrfCsv(written.frf);
    const bool isThere = std::setlocale(LC_ALL, "pl_PL.UTF-8") != nullptr;
    EXPECT_EQ(io::toUff(std::vector{written}), uff);
    EXPECT_EQ(io::toFrfCsv(written.frf), csv);
    if (isThere) std::setlocale(LC_ALL, "C");
}

TEST(FrfWriter, filesAreWhole)
{
    const ScratchFolder folder;
    const std::string path = (folder / "mode.uff").string();
    const io::MeasuredFrf written = modeFrf(FrfQuantity::Mobility);
    io::writeUff(path, std::vector{written});
    expectSameFrf(io::readFrf(path).frfs.at(0).frf, written.frf, 1e-11);
    io::writeFrfCsv((folder / "mode.csv").string(), written.frf);
    expectSameFrf(io::readFrf((folder / "mode.csv").string()).frfs.at(0).frf, written.frf, 0);
    EXPECT_THROW(io::writeUff((folder / "no/mode.uff").string(), std::vector{written}), Error);
}

TEST(MeasuredFrf, becomesReceptance)
{
    const Frf receptance = modeFrf(FrfQuantity::Receptance).frf;
    for (const FrfQuantity quantity : quantities) {
        const Frf found = io::toReceptance(modeFrf(quantity).frf);
        EXPECT_EQ(found.quantity, FrfQuantity::Receptance);
        for (std::size_t i = 0; i < receptance.value.size(); ++i)
            EXPECT_LE(std::abs(found.value[i] - receptance.value[i]), 1e-14);
        EXPECT_EQ(io::activeLines_percent(modeFrf(quantity).frf), 0);
    }
    const Frf fromZero = io::toReceptance(modeFrf(FrfQuantity::Accelerance, 3, 0).frf);
    EXPECT_EQ(fromZero.frequency_hz, (std::vector<double>{2, 4}));
    EXPECT_EQ(io::toReceptance(modeFrf(FrfQuantity::Receptance, 3, 0).frf).value.size(), 3U);
}

}  // namespace
}  // namespace lathelier
