// The same cloud in many encodings: a cylinder through it has the certified diameter (NIST, cylinder 1).
#include <filesystem>

#include "engine/io/io_codes.h"
#include "tests/engine/io/cylinder_fit.h"
#include "tests/engine/io/reading.h"

namespace lathelier {
namespace {

namespace fs = std::filesystem;
using testing::cylinderDiameter;

const fs::path encodingsFolder = fs::path(LATHELIER_SOURCE_DIR) / "tests/data";
constexpr double certifiedDiameter_mm = 57.28923;

TEST(OddEncodings, eachReadableDisguiseHasTheCertifiedDiameter)
{
    int read = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(encodingsFolder / "odd_encodings")) {
        const std::string name = entry.path().filename().string();
        if (name >= "90") continue;
        SCOPED_TRACE(name);
        const io::ScanFile file = io::readScan(entry.path().string());
        EXPECT_EQ(file.scan.points_mm.size(), 500u);
        const bool single = name.find("float") != std::string::npos || name.ends_with(".pcd");
        EXPECT_NEAR(cylinderDiameter(file.scan.points_mm), certifiedDiameter_mm, single ? 5e-4 : 1e-4);
        ++read;
    }
    EXPECT_GE(read, 8);
}

TEST(OddEncodings, anEmptyFileIsRefused)
{
    try {
        io::readScan((encodingsFolder / "odd_encodings/90_zero_bytes.xyz").string());
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::fileEmpty);
    }
}

TEST(OddEncodings, ambiguousNumbersAreAskedAbout)
{
    const std::string path = (encodingsFolder / "odd_encodings/94_ambiguous_thousands_or_decimals.csv").string();
    try {
        io::readScan(path);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::numberAmbiguous);
        EXPECT_EQ(testing::integerOf(error, "line"), 1);
        EXPECT_EQ(testing::integerOf(error, "column"), 1);
    }
    EXPECT_EQ(io::readScan(path, {io::Decimal::Comma}).scan.points_mm.front(), Eigen::Vector3d(1.234, 5.678, 9.012));
    EXPECT_EQ(io::readScan(path, {io::Decimal::Point}).scan.points_mm.front(), Eigen::Vector3d(1234, 5678, 9012));
}

}  // namespace
}  // namespace lathelier
