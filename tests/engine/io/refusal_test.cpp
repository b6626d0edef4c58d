// Files that have to be refused: with the right code, at the right place, whatever their headers promise.
#include <fstream>

#include "engine/core/core_codes.h"
#include "engine/io/io_codes.h"
#include "tests/engine/io/reading.h"

namespace lathelier {
namespace {

using testing::errorOf;
using testing::integerOf;
using testing::readText;
using testing::wordOf;

const std::string good = "26.74906 6.90735 -16.07329\n27.2174 6.73386 -15.57244\n";

void expectAt(const Error& error, const ErrorCode& code, std::int64_t line, std::int64_t column)
{
    SCOPED_TRACE(error.what());
    EXPECT_EQ(error.code(), code);
    EXPECT_EQ(integerOf(error, "line"), line);
    EXPECT_EQ(integerOf(error, "column"), column);
}

TEST(Refusal, brokenRowsAreNamedWithLineAndColumn)
{
    expectAt(errorOf(good + "1 2.5.1 3\n" + good), errors::malformed, 3, 3);
    expectAt(errorOf(good + "1 2\n" + good), errors::malformed, 3, 4);
    expectAt(errorOf(good + "1 2 3 4\n" + good), errors::malformed, 3, 7);
    expectAt(errorOf(good + "broken off here\n" + good), errors::malformed, 3, 1);
    expectAt(errorOf(good + "1 2"), errors::malformed, 3, 4);
    expectAt(errorOf("1 abc 3\n" + good), errors::malformed, 1, 3);
    expectAt(errorOf("X,Y,Z\n1,2,3\n4,O5,6\n7,8,9\n"), errors::malformed, 3, 3);
    expectAt(errorOf("1,2,3\n4,,6\n7,8,9\n"), errors::malformed, 2, 3);
    const Error error = errorOf(good + "1 2 x3\n" + good);
    EXPECT_EQ(wordOf(error, "found"), "x3");
    EXPECT_EQ(wordOf(error, "expected"), "a number");
}

TEST(Refusal, theFirstBrokenRowIsNamedInALongFile)
{
    std::string text;
    for (int i = 0; i < 200000; ++i) text += "1.25 2.5 " + std::to_string(i) + ".5\n";
    for (const std::size_t line : {150001U, 90001U, 90000U}) {
        std::size_t at = 0;
        for (std::size_t i = 1; i < line; ++i) at = text.find('\n', at) + 1;
        text[at] = 'q';
        expectAt(errorOf(text), errors::malformed, static_cast<std::int64_t>(line), 1);
    }
}

TEST(Refusal, promisesOfAHeaderAreNotBelieved)
{
    const std::string ply =
        "ply\nformat FORMAT 1.0\nelement vertex 1000000000000\nproperty float x\nproperty float y\nproperty float "
        "z\nend_header\n";
    for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        std::string text = ply;
        text.replace(text.find("FORMAT"), 6, format);
        EXPECT_EQ(errorOf(text + "1 2 3\n").code(), errors::truncated) << format;
    }
    const std::string pcd =
        "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1000000000000\nHEIGHT 1\nPOINTS "
        "1000000000000\nDATA ";
    for (const std::string data : {"ascii\n1 2 3\n", "binary\n123456789012",
                                   "binary_compressed\n\x08\0\0\0\xFF\xFF\xFF\xFF"
                                   "12345678"})
        EXPECT_EQ(errorOf(pcd + data).code(), errors::truncated) << data;
    EXPECT_EQ(errorOf("1000000000000\n" + good).code(), errors::truncated);
    EXPECT_EQ(errorOf(std::string(80, ' ') + "\xFF\xFF\xFF\xFF" + std::string(500, '\0')).code(), errors::truncated);
    const Error faces = errorOf(
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement face "
        "4000000000\n"
        "property list uchar int vertex_indices\nend_header\n1 2 3\n3 0 0 0\n");
    EXPECT_EQ(faces.code(), errors::truncated);
    EXPECT_EQ(wordOf(faces, "items"), "faces");
}

TEST(Refusal, otherKindsOfFilesAreNamed)
{
    EXPECT_EQ(errorOf("").code(), errors::fileEmpty);
    EXPECT_EQ(errorOf("\xEF\xBB\xBF").code(), errors::fileEmpty);
    EXPECT_EQ(errorOf("# only remarks\n\n").code(), errors::formatUnknown);
    EXPECT_EQ(errorOf("X,Y,Z\n").code(), errors::formatUnknown);
    EXPECT_EQ(errorOf("some words\nand more words\n").code(), errors::formatUnknown);
    EXPECT_EQ(wordOf(errorOf("\x89PNG\r\n\x1a\n"), "found"), "a PNG picture");
    EXPECT_EQ(wordOf(errorOf(std::string("\x01\x02\x00\x03", 4)), "found"), "binary data");
    EXPECT_EQ(wordOf(errorOf("  <!DOCTYPE html><p>1 2 3</p>"), "found"), "an HTML document");
    EXPECT_EQ(errorOf("1 2\n3 4\n5 6\n").code(), errors::malformed);
    EXPECT_EQ(errorOf("nan nan nan\nnan nan nan\n").code(), errors::noPoints);
    EXPECT_EQ(errorOf(std::string(3 << 20, '7')).code(), errors::formatUnknown);  // one endless line
}

TEST(Refusal, linesOfMoreThanAMebibyte)
{
    std::string line;
    while (line.size() <= (1u << 20)) line += "1.5 ";
    expectAt(errorOf(good + line + "\n" + good), errors::malformed, 3, 1);
}

TEST(Refusal, hostileTextsAreJudgedInLinearTime)  // a quadratic step would take minutes here
{
    const auto repeated = [](const std::string& piece, std::size_t bytes) {
        std::string text;
        while (text.size() < bytes) text += piece;
        return text;
    };
    const std::size_t size = 1000000;
    for (const char* piece : {"1-", "1.5-", "1,", "\"", "(", "[1,", "1 \"", "=\"", "#", "a ", "1.#"})
        errorOf(repeated(piece, size));
    readText(good + repeated("\n", 20 * size));
    errorOf(repeated("x y z\n", size / 2) + good + repeated("footer\n", size) + "1 2\n");
    errorOf("v 1 2 3\nv 4 5 6\nf" + repeated(" 1 \\\n", size) + "x\n");
}

TEST(Refusal, namesThatAreNoCartesianCoordinates)
{
    EXPECT_EQ(errorOf("angle;radius;z\n1.5;2.5;3.5\n4.5;5.5;6.5\n").code(), errors::malformed);
    EXPECT_EQ(errorOf("x;y;intensity\n1.5;2.5;3.5\n4.5;5.5;6.5\n").code(), errors::malformed);
    EXPECT_EQ(errorOf("X [mm];Y [mm];Z [inch]\n1.5;2.5;3.5\n4.5;5.5;6.5\n").code(), errors::malformed);
}

TEST(Refusal, ambiguousNumbers)
{
    const Error error = errorOf("1,234;5,678;9,012\n2,345;6,789;1,023\n");
    expectAt(error, errors::numberAmbiguous, 1, 1);
    EXPECT_EQ(wordOf(error, "first"), "1.234");
    EXPECT_EQ(wordOf(error, "second"), "1234");
    EXPECT_EQ(errorOf("1,234 5,678 9,012\n2,345 6,789 1,023\n").code(), errors::numberAmbiguous);
    EXPECT_EQ(errorOf("\"1,234\",\"5,678\",\"9,012\"\n").code(), errors::numberAmbiguous);
    EXPECT_EQ(errorOf("12,45,67,25,18,7\n13,46,68,26,19,8\n").code(), errors::numberAmbiguous);
    expectAt(errorOf("1.5;2.5;3.5\n4.5;1,234;6.5\n7.5;8.5;9.5\n"), errors::numberAmbiguous, 2, 5);
    // One value far down settles all.
    std::string text;
    for (int i = 0; i < 2000; ++i) text += "1,234;5,678;9,012\n";
    EXPECT_EQ(errorOf(text).code(), errors::numberAmbiguous);
    EXPECT_EQ(readText(text + "0,5;1,25;2,125\n").scan.points_mm.front(), Eigen::Vector3d(1.234, 5.678, 9.012));
    // A given decimal mark that does not fit is refused, not bent.
    EXPECT_EQ(errorOf("26.74906;6.90735;-16.07329\n", {io::Decimal::Comma}).code(), errors::malformed);
}

TEST(Refusal, coordinatesOutOfReach)
{
    expectAt(errorOf(good + "1 1e30 3\n"), errors::coordinateTooLarge, 3, 3);
    expectAt(errorOf(good + "1 1e999 3\n"), errors::coordinateTooLarge, 3, 3);
    expectAt(errorOf("v 1 2 3\nv 1e30 2 3\n"), errors::coordinateTooLarge, 2, 3);
    EXPECT_EQ(errorOf("ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\nproperty double "
                      "z\nend_header\n1 2 -1e30\n")
                  .code(),
              errors::coordinateTooLarge);
}

TEST(Units, aStatedOneRulesThenTheGivenOneThenTheExtent)
{
    io::ImportOptions metre;
    metre.unit = io::LengthUnit::Metre;
    const io::ScanFile stated = io::readScan("t", "X (in),Y (in),Z (in)\n1,2,3\n4,5,6\n", metre);
    EXPECT_EQ(stated.scan.points_mm[0], Eigen::Vector3d(25.4, 50.8, 76.19999999999999));
    EXPECT_EQ(stated.facts.unit_source, "stated");
    EXPECT_TRUE(contains(stated.notes, notes::unitNotUsed));
    EXPECT_EQ(io::readScan("t", "0.5 0.25 0\n1 1 1\n", metre).scan.points_mm[0], Eigen::Vector3d(500, 250, 0));
    const io::ScanFile guessed = io::readScan("t", "0 0 0\n1 10 2\n", {});
    EXPECT_EQ(guessed.facts.unit_source, "guessed");
    EXPECT_TRUE(contains(guessed.notes, notes::unitGuessed));
    EXPECT_EQ(errorOf("0 0 0\n0.5 0.9 0.2\n").code(), errors::unitUnknown);
    EXPECT_EQ(errorOf("0 0 0\n10001 0 0\n").code(), errors::unitUnknown);
    EXPECT_EQ(io::readScan("t", "0 0 0\n10000 0 0\n", {}).facts.unit, "mm");
}

TEST(Units, manyWaysToStateThem)
{
    const auto unitOf = [](const std::string& heading) {
        return io::readScan("t", heading + "\n0.5;0.25;0.125\n1.5;2.5;3.5\n", {}).facts;
    };
    for (const char* heading :
         {"X (in);Y (in);Z (in)", "x_in;y_in;z_in", "X [inch];Y [inch];Z [inch]", "X/in;Y/in;Z/in",
          "X in inch;Y in inch;Z in inch", "# unit: inch", "# Units = Inches", "Unit;inch", "x;y;z\nin;in;in",
          "# all coordinates in inch", "\"X (in)\";\"Y (in)\";\"Z (in)\""}) {
        SCOPED_TRACE(heading);
        EXPECT_EQ(unitOf(heading).unit, "inch");
        EXPECT_EQ(unitOf(heading).unit_source, "stated");
    }
    EXPECT_EQ(unitOf("X [\xC2\xB5m];Y [\xC2\xB5m];Z [\xC2\xB5m]").unit, "um");
    EXPECT_EQ(unitOf("X [\xB5m];Y [\xB5m];Z [\xB5m]").unit, "um");
    EXPECT_EQ(unitOf("# the unit was cleaned in the morning").unit_source, "guessed");
}

}  // namespace
}  // namespace lathelier
