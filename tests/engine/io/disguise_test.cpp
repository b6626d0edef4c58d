// Text clouds in many notations: the values read equal those written.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>

#include "engine/io/io_codes.h"
#include "tests/engine/io/reading.h"

namespace lathelier {
namespace {

using testing::readText;
using Points = std::vector<Eigen::Vector3d>;

const Points base = {{26.74906, 6.90735, -16.07329},
                     {27.2174, 6.73386, -15.57244},
                     {27.70329, 6.56756, -15.03421},
                     {0.25, -1e-3, 1234.5},
                     {-0.5, 12.125, 7},
                     {29.53672, 62.93389, -3.23828}};

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

/// One line for each point; `write` gets its number from 1 and its coordinates.
std::string lines(const std::function<std::string(int, double, double, double)>& write, const std::string& end = "\n")
{
    std::string text;
    int i = 0;
    for (const Eigen::Vector3d& p : base) text += write(++i, p.x(), p.y(), p.z()) + end;
    return text;
}

std::string plain(const std::string& delimiter, const std::string& end = "\n")
{
    return lines(
        [&](int, double x, double y, double z) { return fmt::format("{}{}{}{}{}", x, delimiter, y, delimiter, z); },
        end);
}

std::string fixed(const char* pattern, const std::string& end = "\n")
{
    return lines([&](int, double x, double y, double z) { return fmt::format(fmt::runtime(pattern), x, y, z); }, end);
}

std::string utf16(const std::string& ascii, bool bigEndian, bool mark)
{
    std::string result = !mark ? "" : bigEndian ? "\xFE\xFF" : "\xFF\xFE";
    for (const char c : ascii) result += bigEndian ? std::string{'\0', c} : std::string{c, '\0'};
    return result;
}

void expectBase(const std::string& text, const io::ImportOptions& options = {}, double tolerance = 0)
{
    SCOPED_TRACE(text.substr(0, 300));
    try {
        const io::ScanFile file = readText(text, options);
        ASSERT_EQ(file.scan.points_mm.size(), base.size());
        for (std::size_t i = 0; i < base.size(); ++i)
            EXPECT_LE((file.scan.points_mm[i] - base[i]).cwiseAbs().maxCoeff(), tolerance) << i;
    } catch (const Error& error) {
        ADD_FAILURE() << error.what();
    }
}

TEST(Disguise, separators)
{
    for (const char* delimiter : {" ", ",", ";", "\t", "|", ", ", "; ", "    ", " \t ", " ; ", "\t\t", " , ", " | "})
        expectBase(plain(delimiter));
    expectBase(fixed("{:12.5f}{:14.5f}{:16.5f}"));
    expectBase(fixed("  {} {}\t{}  "));
    expectBase(fixed("{};{};{};"));
    expectBase(fixed("{},{},{},"));
    expectBase(fixed("{}\t{}\t{}\t"));
    expectBase(fixed("| {} | {} | {} |"));
    expectBase("| X | Y | Z |\n|---|---|---|\n" + fixed("| {} | {} | {} |"));
    expectBase("sep=;\n" + plain(";"));
    expectBase("\"sep=,\"\r\nX,Y,Z\r\n" + plain(",", "\r\n"));
    expectBase(fixed("({}, {}, {})"));
    expectBase(fixed("[{}, {}, {}],"));
    expectBase(fixed("{{{}; {}; {}}}"));
}

TEST(Disguise, lineEnds)
{
    for (const char* end : {"\n", "\r\n", "\r"}) {
        expectBase(plain(" ", end));
        expectBase("X;Y;Z" + std::string(end) + plain(";", end));
        std::string withoutLast = plain(",", end);
        withoutLast.resize(withoutLast.size() - std::string_view(end).size());
        expectBase(withoutLast);
        expectBase(plain(",", end) + end + end);
    }
    expectBase(fixed("{} {} {}\n"));  // every other line is blank
}

TEST(Disguise, encodings)
{
    for (const std::string& text :
         {plain(" "), "X,Y,Z\n" + plain(","), replaced(plain(";"), ".", ","), plain("\t", "\r\n")}) {
        expectBase("\xEF\xBB\xBF" + text);
        for (const bool bigEndian : {false, true})
            for (const bool mark : {false, true}) expectBase(utf16(text, bigEndian, mark));
        expectBase(text + std::string(200, '\0'));
        expectBase(text + "\x1a");
        expectBase(utf16(text, false, true) + "\n");
    }
    expectBase(
        "# Gr\xF6\xDF"
        "e in \xB5m?\n" +
        plain(" "));  // Latin-1
    expectBase(
        "# Gr\xC3\xB6\xC3\x9F"
        "e\n" +
        plain(" "));                                        // UTF-8
    expectBase(replaced(plain(" "), "-", "\xE2\x88\x92"));  // U+2212 MINUS SIGN
    expectBase(replaced(plain(" "), "-", "\xE2\x88\x92") + "# \xC2\xB0\n");
    EXPECT_EQ(readText("# Gr\xF6\xDF"
                       "e\n" +
                       plain(" "))
                  .facts.encoding,
              "latin-1");
    EXPECT_EQ(readText(utf16(plain(" "), true, true)).facts.encoding, "utf-16be");
}

TEST(Disguise, decimalCommas)
{
    for (const char* delimiter : {" ", ";", "\t", "|", "; ", "   "}) expectBase(replaced(plain(delimiter), ".", ","));
    expectBase(replaced(fixed("\"{}\",\"{}\",\"{}\""), ".", ","));
    expectBase("X,Y,Z\n" + replaced(fixed("\"{}\",\"{}\",\"{}\""), ".", ","));
    expectBase(replaced(fixed("{}mm;{}mm;{}mm"), ".", ","));
    // A comma for everything: the zeros in front of fractions, or the names, tell.
    expectBase(replaced(fixed("{:.5f},{:.5f},{:.5f}"), ".", ","));
    expectBase("X,Y,Z\n" + replaced(fixed("{:.5f},{:.5f},{:.5f}"), ".", ","));
}

TEST(Disguise, waysToWriteNumbers)
{
    for (const char* pattern : {"{:.9e} {:.9e} {:.9e}", "{:.9E};{:.9E};{:.9E}", "{:+.5f},{:+.5f},{:+.5f}",
                                "{:012.5f} {:012.5f} {:012.5f}", "\"{}\" \"{}\" \"{}\"", "'{}';'{}';'{}'",
                                "\"{}\",\"{}\",\"{}\"", "{}mm {}mm {}mm", "{} mm;{} mm;{} mm", "{} mm {} mm {} mm"})
        expectBase(fixed(pattern));
    expectBase(replaced(fixed("{:.9e} {:.9e} {:.9e}"), "e", "D"));
    expectBase(replaced(fixed("{:.9e} {:.9e} {:.9e}"), "e", "d"));
    expectBase(replaced(fixed("{:10.5f}{:11.5f}{:12.5f}"), " -", "-"));  // touching fields
    expectBase(replaced(plain(" "), "0.", "."));
    expectBase(replaced(plain(";"), "1234.5", "1,234.5"));
    expectBase(replaced(plain(";"), "1234.5", "1'234.5"));
    expectBase(replaced(plain(";"), "1234.5", "1 234.5"));
    expectBase(replaced(replaced(plain("\t"), ".", ","), "1234,5", "1.234,5"));
    expectBase(replaced(replaced(plain(";"), ".", ","), "1234,5",
                        "1\xC2\xA0"
                        "234,5"));
}

TEST(Disguise, remarksHeadingsAndFooters)
{
    for (const char* mark : {"# ", "// ", "; ", "% ", "! ", "#", "//", "* "}) {
        expectBase(mark + std::string("made by a scanner, 12.5 degrees\n") + plain(" ") + mark + "end\n");
        expectBase(plain(",") + mark + "end");
        expectBase(mark + std::string("X Y Z\n") + plain(" "));
    }
    expectBase(fixed("{} {} {} # remark"));
    expectBase(fixed("{},{},{} // remark"));
    expectBase(fixed("{}\t{}\t{} ; remark"));
    expectBase("Scanner ABC\nDate: 2024-01-05 12:30\nOperator: N. N.\n\nX Y Z\n" + plain(" "));
    expectBase("X;Y;Z\nmm;mm;mm\n" + plain(";"));
    expectBase("X,Y,Z\n[mm],[mm],[mm]\n" + plain(","));
    expectBase(plain(" ") + "END\n");
    expectBase(plain(",") + "Total: 6 points\n\n");
    expectBase("X,Y,Z\n" + plain(",") + "X,Y,Z\n");
    expectBase("6\n" + plain(" "));
    expectBase("6\nname of the part\n" + plain(" "));
    expectBase("6 3\n" + plain(" "));
    expectBase("\n\n" + plain(" ") + "\n\n");
    expectBase(plain(",") + ",,\n,,\n");
}

TEST(Disguise, columnsBesideTheCoordinates)
{
    const auto row = [](const char* pattern) {
        return lines([pattern](int i, double x, double y, double z) {
            return fmt::format(fmt::runtime(pattern), fmt::arg("i", i), fmt::arg("x", x), fmt::arg("y", y),
                               fmt::arg("z", z));
        });
    };
    expectBase(row("{x} {y} {z} 128"));
    expectBase(row("{x} {y} {z} -845 255 128 {i}"));
    expectBase(row("{x:.5f} {y:.5f} {z:.5f} 0 0 1"));
    expectBase(row("{i} {x} {y} {z}"));
    expectBase(row("{i};{x};{y};{z};12"));
    expectBase(row("P{i},{x},{y},{z}"));
    expectBase("Point;X;Y;Z\n" + row("P{i};{x};{y};{z}"));
    expectBase("Point;X;Y;Z;Remark\n" + row("P{i};{x};{y};{z};ok"));
    expectBase("z,y,x\n" + row("{z},{y},{x}"));
    expectBase("Intensity,X,Y,Z\n" + row("0.5,{x},{y},{z}"));
    expectBase("\"X\";\"Y\";\"Z\"\n" + row("{x};{y};{z}"));
    expectBase(",x,y,z\n" + row("{i},{x},{y},{z}"));                 // pandas
    expectBase("\"x\" \"y\" \"z\"\n" + row("\"{i}\" {x} {y} {z}"));  // R
    expectBase("//X Y Z R G B\n" + row("{x} {y} {z} 1 2 3"));        // CloudCompare
    expectBase("\"Normals:0\",\"Normals:1\",\"Normals:2\",\"Points:0\",\"Points:1\",\"Points:2\"\n" +
               row("0,0,1,{x},{y},{z}"));  // ParaView
    expectBase("Pos_X [mm]\tPos_Y [mm]\tPos_Z [mm]\n" + row("{x}\t{y}\t{z}"));
    expectBase("X (mm) Y (mm) Z (mm)\n" + row("{x} {y} {z}"));
    expectBase("nx ny nz x y z\n" + row("1 0 0 {x} {y} {z}"));
    expectBase("6\nmolecule\n" + row("C {x} {y} {z}"));  // the chemists' XYZ
}

TEST(Disguise, normalsAreFoundByNameOrByTheirLength)
{
    const std::string row = "1 2 3 0 0.6 0.8\n4 5 6 0 0 1\n7 8 9 1 0 0\n";
    const io::ScanFile nameless = readText(row);
    ASSERT_TRUE(nameless.scan.hasNormals());
    EXPECT_NEAR(nameless.scan.normals[0].y(), 0.6, 1e-7);
    EXPECT_TRUE(readText("x y z nx ny nz\n1 2 3 0 3 4\n4 5 6 0 0 2\n").scan.hasNormals());
    EXPECT_FALSE(readText("1 2 3 255 128 0\n4 5 6 0 0 1\n7 8 9 1 0 0\n").scan.hasNormals());
    const io::ScanFile unusable = readText("x y z nx ny nz\n1 2 3 0 0 0\n4 5 6 0 0 2\n");
    EXPECT_FALSE(unusable.scan.hasNormals());
    EXPECT_TRUE(contains(unusable.notes, notes::normalsUnusable));
}

TEST(Disguise, rowsWithoutFiniteCoordinatesAreCounted)
{
    for (const char* word :
         {"nan", "NaN", "-nan", "inf", "-Infinity", "1.#QNAN", "-1.#IND", "N/A", "#N/A", "null", "nan(ind)"}) {
        SCOPED_TRACE(word);
        const io::ScanFile file = readText("1 2 3\n4 5 " + std::string(word) + "\n7 8 9\n");
        EXPECT_EQ(file.scan.points_mm.size(), 2u);
        ASSERT_TRUE(contains(file.notes, notes::pointsNotFinite));
        ASSERT_EQ(file.facts.skipped.size(), 1u);
        EXPECT_EQ(file.facts.skipped[0].line, 2);
    }
}

struct Disguise {
    std::string delimiter;
    char decimal;
    std::string end;
    int encoding;
    bool mark;
    bool names;
    bool count;
    bool index;
    bool label;
    int extra;
    bool quoted;
    bool trailing;
};

std::string dress(const Points& points, const Disguise& d)
{
    std::string text;
    const bool trailing = d.trailing && d.delimiter.find_first_not_of(' ') != std::string::npos;
    const auto add = [&](const std::vector<std::string>& cells) {
        for (std::size_t k = 0; k < cells.size(); ++k) text += (k > 0 ? d.delimiter : "") + cells[k];
        text += (trailing ? d.delimiter : "") + d.end;
    };
    const bool quoted = d.quoted || (d.decimal == ',' && d.delimiter == ",");
    const auto number = [&](double value) {
        const std::string cell = replaced(fmt::format("{:.17e}", value), ".", std::string(1, d.decimal));
        return quoted ? '"' + cell + '"' : cell;
    };
    if (d.count) text += std::to_string(points.size()) + d.end;
    std::vector<std::string> names = {"X", "Y", "Z"};
    if (d.label) names.insert(names.begin(), "Name");
    if (d.index) names.insert(names.begin(), "Id");
    for (int k = 0; k < d.extra; ++k) names.push_back("Scalar" + std::to_string(k));
    if (d.names) add(names);
    int i = 0;
    for (const Eigen::Vector3d& p : points) {
        std::vector<std::string> cells;
        ++i;
        if (d.index) cells.push_back(std::to_string(i));
        if (d.label) cells.push_back("P" + std::to_string(i * 7));
        for (int k = 0; k < 3; ++k) cells.push_back(number(p[k]));
        for (int k = 0; k < d.extra; ++k) cells.push_back(number(i * 0.375 + k));
        add(cells);
    }
    if (d.encoding == 0) return d.mark ? "\xEF\xBB\xBF" + text : text;
    return utf16(text, d.encoding == 2, d.mark);
}

RC_GTEST_PROP(Disguise, whatWasWrittenIsReadBackBitForBit, ())
{
    const auto coordinate =
        rc::gen::map(rc::gen::pair(rc::gen::inRange(-4000000, 4000000), rc::gen::inRange(1, 10000)),
                     [](const std::pair<int, int>& p) { return p.first / static_cast<double>(p.second); });
    const auto coordinates = *rc::gen::nonEmpty(rc::gen::container<std::vector<double>>(coordinate));
    Points points;
    for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
        points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    RC_PRE(points.size() >= 3);
    const Disguise disguise = {*rc::gen::element<std::string>(" ", ",", ";", "\t", "|", "  ", "; "),
                               *rc::gen::element('.', ','),
                               *rc::gen::element<std::string>("\n", "\r\n", "\r"),
                               *rc::gen::inRange(0, 3),
                               *rc::gen::arbitrary<bool>(),
                               *rc::gen::arbitrary<bool>(),
                               *rc::gen::arbitrary<bool>(),
                               *rc::gen::arbitrary<bool>(),
                               *rc::gen::arbitrary<bool>(),
                               *rc::gen::inRange(0, 3),
                               *rc::gen::arbitrary<bool>(),
                               *rc::gen::arbitrary<bool>()};
    const std::string text = dress(points, disguise);
    RC_LOG() << text.substr(0, 500);
    const io::ScanFile file = readText(text);
    RC_ASSERT(file.scan.points_mm.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i) RC_ASSERT(file.scan.points_mm[i] == points[i]);
    RC_ASSERT(file.facts.decimal == (disguise.decimal == ',' ? "comma" : "point"));
}

}  // namespace
}  // namespace lathelier
