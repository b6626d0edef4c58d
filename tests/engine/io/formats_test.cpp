// PLY, PCD, STL and OBJ: what was written is read back, in every variant of the format.
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

#include "engine/io/facts_json.h"
#include "engine/io/io_codes.h"
#include "tests/engine/io/reading.h"

namespace lathelier {
namespace {

using testing::appendBytes;
using testing::errorOf;
using testing::integerOf;
using testing::readText;

const std::vector<Eigen::Vector3d> plyCorners = {{0.1, 0, 0}, {10.1, 0, 0}, {0.1, 10, 0}, {0.1, 0, 10}};

std::string plyHeader(const std::string& format, const std::string& vertex, const std::string& rest = "")
{
    return "ply\nformat " + format + " 1.0\ncomment unit mm\nelement vertex 4\n" + vertex + rest + "end_header\n";
}

const std::string plyDoubles = "property double x\nproperty double y\nproperty double z\n";
const std::string plyFaces = "element face 2\nproperty list uchar int vertex_indices\n";

void expectCorners(const io::ScanFile& file, double tolerance = 0)
{
    ASSERT_EQ(file.scan.points_mm.size(), plyCorners.size());
    for (std::size_t i = 0; i < plyCorners.size(); ++i)
        EXPECT_LE((file.scan.points_mm[i] - plyCorners[i]).cwiseAbs().maxCoeff(), tolerance);
}

TEST(Ply, binaryInBothByteOrdersKeepsDoubles)
{
    for (const bool big : {false, true}) {
        std::string text = plyHeader(
            big ? "binary_big_endian" : "binary_little_endian",
            "property uchar flag\n" + plyDoubles + "property float nx\nproperty float ny\nproperty float nz\n",
            plyFaces);
        for (const Eigen::Vector3d& p : plyCorners) {
            appendBytes<std::uint8_t>(text, 7);
            for (int k = 0; k < 3; ++k) appendBytes(text, p[k], big);
            for (const float n : {0.F, 0.F, 2.F}) appendBytes(text, n, big);
        }
        text += '\3';
        for (const int i : {0, 1, 2}) appendBytes(text, i, big);
        text += '\4';
        for (const int i : {0, 1, 2, 3}) appendBytes(text, i, big);
        const io::ScanFile file = readText(text);
        expectCorners(file);
        EXPECT_EQ(file.scan.normals.at(3), Eigen::Vector3f(0, 0, 1));
        ASSERT_EQ(file.scan.triangles.size(), 3u);
        EXPECT_EQ(file.scan.triangles[2], (std::array<std::uint32_t, 3>{0, 2, 3}));
        EXPECT_EQ(file.facts.unit_source, "stated");
        EXPECT_EQ(file.facts.format, big ? "ply_binary_big_endian" : "ply_binary_little_endian");
        for (std::size_t cut = text.size() - 1; cut > text.find("end_header") + 11; cut -= 5)
            EXPECT_EQ(errorOf(text.substr(0, cut)).code(), errors::truncated) << cut;
    }
}

TEST(Ply, asciiWithAnyLineEndAndOrderOfProperties)
{
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        std::string text =
            plyHeader("ascii", "property float z\nproperty uchar red\nproperty float x\nproperty float y\n", plyFaces);
        text += "0 255 0.1 0\n0 255 10.1 0\n0 255 0.1 1.0e1\n10 255 0.1 0\n3 0 1 2\n4 0 1 2 3\n";
        for (std::size_t at = 0; end != "\n" && (at = text.find('\n', at)) != std::string::npos; at += end.size())
            text.replace(at, 1, end);
        const io::ScanFile file = readText(text);
        expectCorners(file);
        EXPECT_EQ(file.scan.triangles.size(), 3u);
    }
}

TEST(Ply, binaryBehindAHeaderWithOtherLineEnds)
{
    for (const std::string end : {"\r\n", "\r"}) {
        std::string text;
        for (const char c : plyHeader("binary_little_endian", plyDoubles)) c == '\n' ? text += end : text += c;
        std::vector<Eigen::Vector3d> points = plyCorners;
        // The first byte of the data looks like a line feed.
        points[0].x() = std::bit_cast<double>((std::bit_cast<std::uint64_t>(10.1) & ~std::uint64_t{0xFF}) | 0x0A);
        for (const Eigen::Vector3d& p : points)
            for (int k = 0; k < 3; ++k) appendBytes(text, p[k]);
        EXPECT_EQ(readText(text).scan.points_mm, points);
    }
}

TEST(Ply, listsBeforeAndWithinTheVertices)
{
    std::string text =
        "ply\nformat binary_little_endian 1.0\nelement camera 1\nproperty list uchar float view\nelement vertex "
        "4\nproperty list uchar short tags\n" +
        plyDoubles + "end_header\n";
    text += '\2';
    appendBytes(text, 1.F);
    appendBytes(text, 2.F);
    for (std::size_t i = 0; i < plyCorners.size(); ++i) {
        text += static_cast<char>(i);
        for (std::size_t k = 0; k < i; ++k) appendBytes<std::int16_t>(text, 5);
        for (int k = 0; k < 3; ++k) appendBytes(text, plyCorners[i][k]);
    }
    expectCorners(readText(text));
}

TEST(Ply, brokenHeadersAndBodiesAreLocated)
{
    const Error type = errorOf("ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\nend_header\n");
    EXPECT_EQ(type.code(), errors::malformed);
    EXPECT_EQ(integerOf(type, "line"), 4);
    EXPECT_EQ(integerOf(type, "column"), 10);
    const Error body = errorOf(plyHeader("ascii", plyDoubles) + "0 0 0\n1 1\n2 2 2\n3 3 3\n");
    EXPECT_EQ(integerOf(body, "line"), 10);
    EXPECT_EQ(errorOf("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n").code(), errors::malformed);
    EXPECT_EQ(errorOf(plyHeader("ascii", "property float x\nproperty float y\n") + "1 2\n").code(), errors::malformed);
    const Error index =
        errorOf(plyHeader("ascii", plyDoubles, plyFaces) + "0 0 0\n1 1 1\n2 2 2\n3 3 3\n3 0 1 2\n3 0 1 4\n");
    EXPECT_EQ(index.code(), errors::malformed);
    EXPECT_EQ(integerOf(index, "line"), 16);
}

TEST(Ply, pointsThatAreNotFiniteAreLeftOutWithTheirFaces)
{
    std::string text =
        plyHeader("ascii", plyDoubles, plyFaces) + "0.1 0 0\nnan 0 0\n0.1 10 0\n0.1 0 10\n3 0 1 2\n3 0 2 3\n";
    const io::ScanFile file = readText(text);
    EXPECT_EQ(file.scan.points_mm.size(), 3u);
    ASSERT_EQ(file.scan.triangles.size(), 1u);
    EXPECT_EQ(file.scan.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
    ASSERT_EQ(file.facts.skipped.size(), 1u);
    EXPECT_EQ(file.facts.skipped[0].line, 12);
    EXPECT_TRUE(contains(file.notes, notes::pointsNotFinite));
}

std::string pcdHeader(const std::string& data, const std::string& size = "8", const std::string& type = "F")
{
    const std::string s = size + " " + size + " " + size;
    const std::string t = type + " " + type + " " + type;
    return "# .PCD v0.7 - unit mm\nVERSION 0.7\nFIELDS rgb x y z\nSIZE 4 " + s + "\nTYPE U " + t +
           "\nCOUNT 2 1 1 1\nWIDTH 2\nHEIGHT 2\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA " + data + "\n";
}

TEST(Pcd, asciiBinaryAndCompressed)
{
    expectCorners(readText(pcdHeader("ascii") + "1 2 0.1 0 0\n1 2 10.1 0 0\n1 2 0.1 10 0\n1 2 0.1 0 10\n"));
    std::string binary = pcdHeader("binary");
    for (const Eigen::Vector3d& p : plyCorners) {
        appendBytes<std::uint64_t>(binary, 0);
        for (int k = 0; k < 3; ++k) appendBytes(binary, p[k]);
    }
    expectCorners(readText(binary));
    EXPECT_EQ(errorOf(binary.substr(0, binary.size() - 1)).code(), errors::truncated);

    std::string columns(32, '\0');  // all rgb, then all x, all y, all z
    for (int k = 0; k < 3; ++k)
        for (const Eigen::Vector3d& p : plyCorners) appendBytes(columns, p[k]);
    // The zeros in front as one literal byte and a copy that overlaps itself; the rest literally.
    std::string packed("\0\0\xE0\x16\0", 5);
    ASSERT_EQ(1 + 7 + 0x16 + 2, 32);
    for (std::size_t at = 32; at < columns.size(); at += 32) packed += '\x1F' + columns.substr(at, 32);
    std::string compressed = pcdHeader("binary_compressed");
    appendBytes(compressed, static_cast<std::uint32_t>(packed.size()));
    appendBytes(compressed, static_cast<std::uint32_t>(columns.size()));
    const io::ScanFile file = readText(compressed + packed);
    expectCorners(file);
    EXPECT_EQ(file.facts.format, "pcd_binary_compressed");
    packed[3] = '\x15';
    EXPECT_EQ(errorOf(compressed + packed).code(), errors::malformed);
}

std::string asciiStl(const std::string& name)
{
    const auto facet = [](const char* a, const char* b, const char* c) {
        return std::string("  FACET normal 0 0 1\n    outer loop\n") + "      vertex " + a + "\n      vertex " + b +
               "\n      vertex " + c + "\n    endloop\n  endfacet\n";
    };
    return "solid " + name + "\n" + facet("0.1 0 0", "10.1 0 0", "0.1 10 0") +
           facet("1.0e-1 -0 0", "0.1 10 0", "0.1 0 10") + "endsolid " + name + "\n";
}

TEST(Stl, asciiSolidsShareEqualCorners)
{
    const io::ScanFile file = readText(asciiStl("first") + "\n" + asciiStl("second part, unit mm"));
    expectCorners(file);
    EXPECT_EQ(file.scan.triangles.size(), 4u);
    EXPECT_EQ(file.scan.triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
    EXPECT_EQ(file.facts.unit_source, "stated");
    EXPECT_EQ(std::get<std::int64_t>(*find(file.facts.details, "solids")), 2);
    const std::string text = asciiStl("a");
    for (std::size_t cut = text.size() - 12; cut > 60; cut -= 7)
        EXPECT_EQ(errorOf(text.substr(0, cut)).code(), errors::malformed) << cut;
}

TEST(Stl, facetsThatBoundNothingAreCountedInANote)
{
    const std::string flat =
        "facet normal 0 0 0\nouter loop\nvertex 1 2 3\nvertex 1 2 3\nvertex 4 5 6\nendloop\nendfacet\n";
    std::string text = asciiStl("a");
    const std::size_t end = text.rfind("endsolid");
    const std::size_t sound = readText(text).scan.triangles.size();
    text.insert(end, flat + flat);
    const io::ScanFile file = readText(text);
    EXPECT_EQ(file.scan.triangles.size(), sound);
    ASSERT_TRUE(contains(file.notes, notes::facetsDegenerate));
    for (const Note& note : file.notes)
        if (note.code == notes::facetsDegenerate) {
            EXPECT_EQ(std::get<std::int64_t>(*find(note.values, "count")), 2);
            EXPECT_NE(find(note.values, "path"), nullptr);
        }
    EXPECT_FALSE(contains(readText(asciiStl("a")).notes, notes::facetsDegenerate));
}

TEST(Stl, binaryAlsoWhenItsHeaderSaysSolid)
{
    for (const std::string start : {"solid facet endsolid", "exported", "UNITS=mm"}) {
        std::string text = start + std::string(80 - start.size(), ' ');
        appendBytes<std::uint32_t>(text, 2);
        for (const std::array<std::size_t, 3> t : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}}) {
            for (const float n : {0.F, 0.F, 1.F}) appendBytes(text, n);
            for (const std::size_t i : t)
                for (int k = 0; k < 3; ++k) appendBytes(text, static_cast<float>(plyCorners[i][k]));
            appendBytes<std::uint16_t>(text, 0);
        }
        const io::ScanFile file = readText(text);
        expectCorners(file, 1e-6);
        EXPECT_EQ(file.scan.triangles.size(), 2u);
        EXPECT_EQ(file.facts.format, "stl_binary");
        EXPECT_EQ(errorOf(text.substr(0, text.size() - 1)).code(), errors::truncated);
        EXPECT_EQ(readText(text + "more").scan.triangles.size(), 2u);
    }
}

TEST(Obj, polygonsNormalsAndIndicesFromBothEnds)
{
    const io::ScanFile file = readText(
        "# Units: mm\nmtllib part.mtl\no part\nv 0.1 0 0\nv 10.1 0 0 1.0\nv 0.1 10 0 0.5 0.5 0.5\nv 0.1 0 10\nvt 0 0\n"
        "vn 0 0 1\nvn 0 0 1\nvn 1 0 0\nvn 0 2 0\ng side\nusemtl steel\ns off\nf 1//1 2//2 3//3\nf -4/1/1 -2/1/3 \\\n "
        "-1/1/4\n");
    expectCorners(file);
    ASSERT_EQ(file.scan.triangles.size(), 2u);
    EXPECT_EQ(file.scan.triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
    EXPECT_EQ(file.scan.normals.at(3), Eigen::Vector3f(0, 1, 0));
    EXPECT_EQ(file.facts.unit_source, "stated");
    const Error error = errorOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n");
    EXPECT_EQ(integerOf(error, "line"), 4);
    EXPECT_EQ(integerOf(error, "column"), 7);
    EXPECT_EQ(errorOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n").code(), errors::malformed);
    EXPECT_EQ(errorOf("v 0 0 0\nv 1 0\nv 0 1 0\n").code(), errors::malformed);
}

TEST(Formats, decimalCommasOfCarelessPrograms)
{
    expectCorners(readText("v 0,1 0 0\nv 10,1 0 0\nv 0,1 10 0\nv 0,1 0 10\n"));
    expectCorners(readText(plyHeader("ascii", plyDoubles) + "0,1 0 0\n10,1 0 0\n0,1 10 0\n0,1 0 10\n"));
    EXPECT_EQ(errorOf("v 1,234 0 0\nv 5,678 0 0\n").code(), errors::numberAmbiguous);
}

TEST(Facts, haveTheKeysOfTheCommandLine)
{
    const Json text = toJson(io::readScan("a.csv", "X;Y;Z\n1,5;2,5;3,5\n4,5;5,5;6,5\n", {}).facts);
    std::vector<std::string> keys;
    for (const auto& [key, value] : text.items()) keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"path", "format", "encoding", "delimiter", "decimal", "unit",
                                              "unit_source", "rows", "columns", "skipped", "details"}));
    EXPECT_EQ(text["format"], "xyz_text");
    EXPECT_EQ(text["decimal"], "comma");
    EXPECT_EQ(text["delimiter"], "semicolon");
    EXPECT_EQ(text["rows"], 2);
    EXPECT_EQ(text["skipped"][0]["line"], 1);
    EXPECT_EQ(text["skipped"][0]["reason"], "column names");
    EXPECT_EQ(text["details"]["points"], 2);
    EXPECT_EQ(text["details"]["min_mm"], (std::vector<double>{1.5, 2.5, 3.5}));
    EXPECT_EQ(text["details"]["max_mm"], (std::vector<double>{4.5, 5.5, 6.5}));
    const Json stl = toJson(readText(asciiStl("a")).facts);
    EXPECT_TRUE(stl["columns"].is_null());
    EXPECT_EQ(stl["details"]["triangles"], 2);
}

TEST(Options, speakTheKeysOfTheCommandLine)
{
    const auto options = fromValues<io::ImportOptions>({{"decimal", std::string("comma")},
                                                        {"delimiter", std::string("pipe")},
                                                        {"encoding", std::string("latin-1")},
                                                        {"unit", std::string("um")}});
    EXPECT_EQ(options.decimal, io::Decimal::Comma);
    EXPECT_EQ(options.delimiter, io::Delimiter::Pipe);
    EXPECT_EQ(options.encoding, io::Encoding::Latin1);
    EXPECT_EQ(options.unit, io::LengthUnit::Micrometre);
}

TEST(TextTables, ARemarkThatHoldsANameIsNoHeading)
{
    const io::ScanFile file =
        io::readScan("a.xyz", "# scanner X\n! more\n1.5 2.5 3.5\n40.5 5.5 6.5\n7.5 8.5 9.5\n", {});
    ASSERT_EQ(file.scan.points_mm.size(), 3u);
    EXPECT_EQ(file.scan.points_mm[1].x(), 40.5);
    EXPECT_EQ(file.scan.points_mm[1].z(), 6.5);
}

}  // namespace
}  // namespace lathelier
