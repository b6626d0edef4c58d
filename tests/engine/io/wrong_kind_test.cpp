// Tables and texts that hold numbers, but not those that were asked for: what a name or a content says, it is read as,
// or refused.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/io/io_codes.h"
#include "engine/io/profile/profile_reader.h"
#include "tests/engine/io/reading.h"

namespace lathelier {
namespace {

using testing::errorOf;
using testing::integerOf;
using testing::readText;
using testing::wordOf;

constexpr const char* rows3 = "1.5,2.5,3.5\n2.5,3.5,1.5\n3.5,1.5,2.5\n4.5,3.5,2.5\n";

io::ImportOptions millimetres()
{
    io::ImportOptions options;
    options.unit = io::LengthUnit::Millimetre;
    return options;
}

std::string profileError(const std::string& name, const std::string& content,
                         io::ProfileColumns columns = io::ProfileColumns::Auto)
{
    io::ProfileOptions options;
    options.columns = columns;
    options.nominal_radius_mm = 25;
    try {
        io::readProfile(name, content, millimetres(), options);
    } catch (const Error& error) {
        return error.code().key;
    }
    return {};
}

std::string namesRead(const std::string& content, io::ProfileColumns columns = io::ProfileColumns::Auto)
{
    io::ProfileOptions options;
    options.columns = columns;
    const io::ProfileFile file = io::readProfile("test", content, millimetres(), options);
    for (const Note& note : file.notes)
        if (note.code == notes::columnsRead) return text(*find(note.values, "columns"));
    return {};
}

std::string repeated(const std::string& heading, const std::string& row, int count = 12)
{
    std::string result = heading + "\n";
    for (int i = 0; i < count; ++i) result += std::to_string(30 * i) + row + "\n";
    return result;
}

TEST(WrongKind, columnsOfAProfileAreNamed)
{
    EXPECT_EQ(namesRead(repeated("angle,distance,angle2,distance2", ",25.5,7.5,8.5")), "angle, distance");
    EXPECT_EQ(namesRead(repeated("angle,distance,angle2", ",25.5,7.5"), io::ProfileColumns::AngleRadius),
              "angle, distance");
    EXPECT_EQ(namesRead(repeated("no,phi_deg,reading_mm", ",7.5,25.5")), "phi_deg, reading_mm");
    EXPECT_EQ(namesRead(repeated("angle1,radius1", ",25.5")), "angle1, radius1");
    EXPECT_EQ(namesRead("1.5,2.5\n2.5,3.5\n3.5,1.5\n4.5,3.5\n", io::ProfileColumns::Xy), "1, 2");
}

TEST(WrongKind, columnsThatCouldAllBeMeantAreRefused)
{
    EXPECT_EQ(profileError("t", repeated("angle,radius,distance", ",25.5,24.5")), "columns_ambiguous");
    EXPECT_EQ(profileError("t", repeated("angle,r,r", ",25.5,24.5")), "columns_ambiguous");
    EXPECT_EQ(profileError("t", repeated("angle1,radius1,angle2,radius2", ",25.5,7.5,24.5")), "columns_ambiguous");
    EXPECT_EQ(profileError("t", repeated("x,y,x,y", ",25.5,7.5,24.5")), "columns_ambiguous");
    EXPECT_EQ(profileError("t", repeated("angle,foo,bar", ",25.5,24.5"), io::ProfileColumns::AngleRadius),
              "columns_ambiguous");
    EXPECT_EQ(profileError("t", repeated("foo,bar,baz", ",25.5,24.5"), io::ProfileColumns::AngleRadius),
              "columns_ambiguous");
    EXPECT_EQ(profileError("t", repeated("x,foo,bar", ",25.5,24.5"), io::ProfileColumns::Xy), "columns_unknown");
    EXPECT_EQ(profileError("t", repeated("x,y,foo", ",25.5,24.5"), io::ProfileColumns::AngleRadius), "columns_unknown");
    EXPECT_EQ(errorOf("x,y,z,x,y,z\n1.5,2.5,3.5,4.5,5.5,6.5\n2.5,3.5,1.5,4.5,5.5,6.5\n").code(),
              errors::columnsAmbiguous);
    // A plain letter comes before a further coordinate, and deviations do not stand beside radii.
    EXPECT_EQ(readText("x,y,z,x position,y position,z position\n1.5,2.5,3.5,4.5,5.5,6.5\n2.5,3.5,1.5,4.5,5.5,6.5\n")
                  .scan.points_mm[0],
              Eigen::Vector3d(1.5, 2.5, 3.5));
    EXPECT_EQ(namesRead(repeated("angle,radius,deviation", ",25.5,0.5")), "angle, radius");
}

TEST(WrongKind, otherQuantitiesAreNoCoordinates)
{
    for (const char* heading :
         {"frequency_hz,real_mm_N,imag_mm_N", "time_s,force_N,temp_C", "t_s,marker_V,X3_um", "Fx,Fy,Fz",
          "force,torque,power", "alpha,beta,gamma", "ch1,ch2,ch3", "# time,force,temp"}) {
        SCOPED_TRACE(heading);
        EXPECT_EQ(errorOf(std::string(heading) + "\n" + rows3).code(), errors::malformed);
    }
    for (const char* heading : {"# time force temp", "time_s force_N temp_C", "t_s force noise"})
        EXPECT_EQ(errorOf(std::string(heading) + "\n1.5 2.5 3.5\n2.5 3.5 1.5\n3.5 1.5 2.5\n").code(), errors::malformed)
            << heading;
    EXPECT_EQ(readText("# scan time: 12\n1.5 2.5 3.5\n2.5 3.5 1.5\n3.5 1.5 2.5\n").scan.points_mm.size(), 3U);
    for (const char* heading :
         {"col1,col2,col3", "Easting,Northing,Height", "scan of part_7", "section of shaft", "V1,V2,V3", ",,"}) {
        SCOPED_TRACE(heading);
        EXPECT_EQ(readText(std::string(heading) + "\n" + rows3).scan.points_mm.size(), 4U);
    }
    // A remark with a known word in it ("rho") does not hide the names below.
    EXPECT_EQ(errorOf("# tip of a shaft, rho 7850, E 210e9 x\nfrequency_hz,real_mm_N,imag_mm_N\n" + std::string(rows3))
                  .code(),
              errors::malformed);
    EXPECT_EQ(
        readText("# made on r 15, x of rho 3 at z\nx,y,z,r\n1.5,2.5,3.5,9.5\n2.5,3.5,1.5,9.5\n").scan.points_mm[0],
        Eigen::Vector3d(1.5, 2.5, 3.5));
    EXPECT_EQ(profileError("t", "force_N,temp_C\n1.5,2.5\n2.5,3.5\n3.5,1.5\n4.5,3.5\n"), "columns_unknown");
    EXPECT_EQ(profileError("t", "angle_deg,temp_C\n0,2.5\n90,3.5\n180,1.5\n270,3.5\n"), "columns_unknown");
    EXPECT_EQ(profileError("t", "force\n1.5\n2.5\n3.5\n1.5\n"), "columns_unknown");
    EXPECT_EQ(profileError("t", "Part_7\n1.5\n2.5\n3.5\n1.5\n"), "");  // a title
}

TEST(WrongKind, programsAreNoTables)
{
    const std::string numbers = "25.001,\n25.002,\n25.003,\n25.002,\n25.001,\n";
    for (const char* start : {"static const double r[] = {", "r = [", "import numpy as np", "from math import pi",
                              "#include <vector>", "#pragma once", "def radii():", "{", "\"radii\": ["}) {
        SCOPED_TRACE(start);
        EXPECT_EQ(profileError("t", std::string(start) + "\n" + numbers), "format_unknown");
        EXPECT_EQ(errorOf(std::string(start) + "\n" + rows3).code(), errors::formatUnknown);
    }
    EXPECT_EQ(profileError("t", numbers + "};\n"), "format_unknown");
    EXPECT_EQ(profileError("r.cpp", numbers), "format_unknown");
    EXPECT_EQ(profileError("r.py", numbers), "format_unknown");
    EXPECT_EQ(profileError("r.txt", numbers), "");
    // Remarks of measuring programs are no programs.
    EXPECT_EQ(profileError("r.txt", "# imported from the gauge; rpm=975\nclass A, form 5\n" + numbers), "");
}

TEST(WrongKind, aMeshIsReadAsOneByItsNameOrItsContent)
{
    const std::string obj = "Exported from CAD\nv 0 0 0\nv 10 0 0\nv 0 10 0\nf 1 2 3\n";
    EXPECT_EQ(integerOf(errorOf(obj), "line"), 1);
    EXPECT_EQ(wordOf(errorOf(obj), "expected"), "an OBJ keyword such as v or f");
    for (const char* name : {"a.obj", "a.OBJ", "a.stl", "a.ply", "a.pcd"}) {
        SCOPED_TRACE(name);
        EXPECT_THROW(io::readScan(name, rows3, millimetres()), Error);
    }
    for (const char* name : {"a.xyz", "a.csv", "obj", "a.obj.txt"})
        EXPECT_EQ(io::readScan(name, rows3, millimetres()).scan.points_mm.size(), 4U) << name;
    EXPECT_EQ(profileError("a.obj", "1.5,2.5\n2.5,3.5\n3.5,1.5\n4.5,3.5\n"), "format_unknown");
    for (const char* off : {"OFF\n", "COFF\n", "NOFF BINARY\n", "STCN4OFF\n", "# remark\n\nOFF\n", "OFF # remark\r\n"})
        EXPECT_EQ(wordOf(errorOf(std::string(off) + "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "found"), "an OFF mesh");
}

/// What the refusal of a file says that it found.
std::string foundKind(const std::string& content)
{
    const Error error = errorOf(content);
    EXPECT_EQ(error.code(), errors::formatUnknown) << content.substr(0, 40);
    return wordOf(error, "found");
}

TEST(WrongKind, recordersAndGridsAreNamed)
{
    using namespace std::string_literals;
    const std::string binary = std::string(200, '\x01') + std::string(8, '\0');
    const std::string labview =
        "LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\n***End_of_Header***\t\n"s + rows3;
    EXPECT_EQ(foundKind(labview), "a LabVIEW measurement (LVM)");
    EXPECT_EQ(foundKind("\xEF\xBB\xBF\n" + labview), "a LabVIEW measurement (LVM)");
    EXPECT_EQ(foundKind("\"LabVIEW Measurement\"\n" + std::string(rows3)), "a LabVIEW measurement (LVM)");
    EXPECT_EQ(profileError("hammer.lvm", labview), "format_unknown");
    EXPECT_EQ(foundKind("TDSm" + binary), "a TDMS measurement of LabVIEW");
    EXPECT_EQ(foundKind("RIFF\x24\x08\0\0WAVEfmt "s + binary), "a WAV recording");
    EXPECT_EQ(foundKind("\x93NUMPY" + binary), "a NumPy array (NPY)");
    EXPECT_EQ(foundKind("\x89HDF\r\n\x1A\n" + binary), "an HDF5 file");
    EXPECT_EQ(foundKind("aBCR-1.0\nManufacID = x\n" + std::string(rows3)), "a surface height map (SDF, BCR)");
    const std::string ptx =
        "2\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"
        "1.5 2.5 3.5 0.5\n1.5 2.5 3.25 0.5\n1.5 2.25 3.5 0.5\n1.25 2.5 3.5 0.5\n";
    EXPECT_EQ(foundKind(ptx), "a PTX scan");
    // A count of points and points are no PTX.
    EXPECT_EQ(readText("4\n1.5 2.5 3.5\n2.5 3.5 1.5\n3.5 1.5 2.5\n4.5 3.5 2.5\n").scan.points_mm.size(), 4U);
}

/// Radius read at the second point of three lobes over one turn of `turn` in the unit of `heading`.
io::ProfileFile lobesIn(const std::string& heading, double turn, int count = 72)
{
    std::string content = heading + ",radius [mm]\n";
    for (int i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / count;
        content += std::to_string(turn * share) + "," +
                   std::to_string(25 + 0.003 * std::cos(18.849555921538759 * share)) + "\n";
    }
    return io::readProfile("test", content, io::ImportOptions{}, io::ProfileOptions{});
}

TEST(WrongKind, unitsOfAnglesAreConvertedOrNamed)
{
    const double pi = 3.14159265358979;
    for (const auto& [heading, turn] :
         std::initializer_list<std::pair<const char*, double>>{{"Winkel [gon]", 400},
                                                               {"angle_gon", 400},
                                                               {"angle [rev]", 1},
                                                               {"angle (turns)", 1},
                                                               {"phi [mrad]", 2000 * pi},
                                                               {"angle [rad]", 2 * pi},
                                                               {"angle [arcmin]", 21600},
                                                               {"angle [arcsec]", 1296000},
                                                               {"angle [deg]", 360},
                                                               {"angle", 360},
                                                               {"Winkel [Grad]", 360},
                                                               {"angle [grad]", 400},
                                                               {"angle [grad]", 360},
                                                               {"angle [ticks]", 360}}) {
        const io::ProfileFile file = lobesIn(heading, turn);
        ASSERT_EQ(file.profile.points_mm.size(), 72U) << heading;
        EXPECT_NEAR(std::atan2(file.profile.points_mm[18].y(), file.profile.points_mm[18].x()), pi / 2, 1e-4)
            << heading << " " << turn;
    }
    EXPECT_TRUE(contains(lobesIn("angle [ticks]", 360).notes, notes::angleUnitFromExtent));
    EXPECT_FALSE(contains(lobesIn("angle [gon]", 400).notes, notes::angleUnitFromExtent));
    for (const auto& [heading, turn] : std::initializer_list<std::pair<const char*, double>>{
             {"angle [ticks]", 4096}, {"angle [grad]", 200}, {"angle [foo]", 1}}) {
        try {
            lobesIn(heading, turn);
            ADD_FAILURE() << heading;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::angleUnitUnknown) << heading;
            EXPECT_EQ(integerOf(error, "column"), 1);
        }
    }
}

TEST(WrongKind, rowAndColumnNumbersOfAScannerAreNoCoordinates)
{
    std::string rowMajor, columnMajor, serpentine, heights, normals;
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 9; ++j) {
            const std::string xyz = std::to_string(10 + 0.25 * j) + " " + std::to_string(5 - 0.5 * i) + " " +
                                    std::to_string(1.5 + 0.125 * i * j) + "\n";
            const std::string a = std::to_string(i), b = std::to_string(j);
            rowMajor += a + " " + b + " " + xyz;
            columnMajor += b + " " + a + " " + xyz;
            serpentine += a + " " + std::to_string(i % 2 ? 8 - j : j) + " " + xyz;
            heights += a + " " + b + " " + std::to_string(1.5 + 0.125 * i * j) + "\n";
            normals += a + " " + b + " " + std::to_string(1.5) + " 0.6 0.0 0.8\n";
        }
    for (const std::string& content : {rowMajor, columnMajor, serpentine}) {
        const io::ScanFile file = readText(content);
        ASSERT_EQ(file.scan.points_mm.size(), 108U);
        EXPECT_DOUBLE_EQ(file.scan.points_mm[1].x(), 10.25);
        EXPECT_TRUE(contains(file.notes, notes::columnsGuessed));
    }
    EXPECT_DOUBLE_EQ(readText(heights).scan.points_mm[1].y(), 1);
    const io::ScanFile withNormals = readText(normals);
    EXPECT_DOUBLE_EQ(withNormals.scan.points_mm[1].y(), 1);
    EXPECT_TRUE(withNormals.scan.hasNormals());
}

TEST(WrongKind, theEndOfTheDataIsTheEndOfTheFile)
{
    const std::string ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
        "z\nend_header\n" +
        std::string(12, '\0');
    EXPECT_EQ(readText(ply).scan.points_mm.size(), 1U);
    EXPECT_EQ(readText(ply + "\n").scan.points_mm.size(), 1U);
    EXPECT_EQ(readText(ply + std::string(4096, '\0')).scan.points_mm.size(), 1U);  // a disk's cluster
    EXPECT_EQ(errorOf(ply + std::string(100000, '\0')).code(), errors::malformed);
    EXPECT_EQ(integerOf(errorOf(ply + "\n\nmore"), "byte"), static_cast<std::int64_t>(ply.size()) + 2);
    const std::string pcd =
        "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA binary\n" +
        std::string(12, '\0');
    EXPECT_EQ(readText(pcd + std::string(4000, '\0')).scan.points_mm.size(), 1U);
    EXPECT_EQ(errorOf(pcd + std::string(100000, '\0')).code(), errors::malformed);
    EXPECT_EQ(errorOf(rows3 + std::string(100000, '\0')).code(), errors::formatUnknown);
    EXPECT_EQ(readText(rows3 + std::string(4000, '\0')).scan.points_mm.size(), 4U);
}

TEST(WrongKind, coordinatesOutOfReachArePlaced)
{
    const Error stl = errorOf(
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 0\nvertex 1 2e8 0\nendloop\nendfacet\n"
        "endsolid a\n");
    EXPECT_EQ(stl.code(), errors::coordinateTooLarge);
    EXPECT_EQ(integerOf(stl, "line"), 6);
    EXPECT_EQ(integerOf(stl, "column"), 10);
    const Error obj = errorOf("v 1 2 3\n# remark\nvn 0 0 1\nv 1 2 -3e7\n");
    EXPECT_EQ(integerOf(obj, "line"), 4);
    EXPECT_EQ(integerOf(obj, "column"), 7);
    // As far as the registration reaches: it knows no lines.
    const Error table = errorOf("1 2 3\n4 5 6\n7 1.1e7 9\n");
    EXPECT_EQ(table.code(), errors::coordinateTooLarge);
    EXPECT_EQ(integerOf(table, "line"), 3);
}

}  // namespace
}  // namespace lathelier
