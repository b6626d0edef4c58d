#include "tests/app/cli/golden_wrong_kind.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>

namespace lathelier::golden {
namespace {

using Write = std::function<void(const std::string& name, const std::string& content)>;

/// A heading and 360 rows.
std::string table(const std::string& heading, const std::function<std::string(int)>& row, int rows = 360)
{
    std::string text = heading;
    for (int i = 0; i < rows; ++i) text += row(i);
    return text;
}

/// Three lobes of 5 µm on 25 mm.
double radius(int degree)
{
    return 25 + 0.005 * std::cos(3 * degree * std::numbers::pi / 180);
}

void makeTables(const Write& write)
{
    write("two_angles.csv", table("angle_deg,distance_mm,angle2_deg,distance2_mm\n", [](int i) {
              return fmt::format("{},{:.6f},{},{:.6f}\n", i, radius(i), i + 0.5, 30 + 0.001 * (i % 7));
          }));
    write("two_radii.csv", table("angle_deg,distance_mm,reading_mm\n", [](int i) {
              return fmt::format("{},{:.6f},{:.6f}\n", i, radius(i), radius(i + 90));
          }));
    write("angle_and_unknown.csv", table("angle_deg,left_mm,right_mm\n", [](int i) {
              return fmt::format("{},{:.6f},{:.6f}\n", i, radius(i), radius(i + 90));
          }));
    write("two_clouds.csv", table("x,y,z,x,y,z\n", [](int i) {
              return fmt::format("{0}.5,{1}.5,3.5,{1}.5,{0}.5,4.5\n", i % 20, i / 20);
          }));
    const auto three = [](int i) {
        return fmt::format("{:.3f},{:.6f},{:.6f}\n", 50.0 + i, std::sin(0.1 * i), std::cos(0.1 * i));
    };
    write("receptance.csv", table("frequency_hz,real_mm_N,imag_mm_N\n", three));
    write("forces.csv", table("time_s,force_N,temp_C\n", three));
    std::string blanks = table("time_s,force_N,temp_C\n", three);
    for (char& c : blanks) c = c == ',' ? ' ' : c;
    write("forces.txt", blanks);
    write("two_forces.csv", table("force_N,temp_C\n", [](int i) {
              return fmt::format("{:.6f},{:.6f}\n", 5 * std::sin(0.1 * i), 5 * std::cos(0.1 * i));
          }));
    const auto grid = [](int i) { return fmt::format("{} {} 1.5\n", i % 8, i / 8); };
    write("titled.xyz", table("Scan of shaft\n", grid, 40));
    write("unnamed.csv",
          table(
              "col 1;col 2;col 3\n", [](int i) { return fmt::format("{};{};1.5\n", i % 8, i / 8); }, 40));
    write("far.xyz", "1 2 3\n4 5 6\n7 2e7 9\n" + table("", grid, 60));
}

void makeTexts(const Write& write)
{
    const auto literal = [](int i) { return fmt::format("    {:.6f},\n", radius(i)); };
    const std::string program = table("const double radii[] = {\n", literal, 359) + "};\n";
    write("literals.txt", program);
    write("literals.cpp", table("", literal, 359));
    write("script.txt", table("import numpy as np\n", literal, 359));
    write("literals3.txt",
          table("points = [\n", [](int i) { return fmt::format("    {}, {}, 1.5,\n", i % 8, i / 8); }) + "]\n");
    write("kept.json", "{\n\"kept\": true\n}\n");
}

void makeMeshes(const Write& write)
{
    const std::string obj =
        "Exported from CAD\nv 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n";
    write("titled.obj", obj);
    write("titled_obj.txt", obj);
    for (const char* name : {"table.stl", "table.ply", "table.pcd", "table.dfq"})
        write(name, "1.5 2.5 3.5\n4.5 5.5 6.5\n7.5 8.5 9.5\n");
    write("colours.off", "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0 1 0 255 0 0 255\n3 0 1 2\n");
    write("commented.txt", "# made by hand\n\nOFF # a triangle\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    write("far.obj", "# remark\nv 1 2 3\n\nvn 0 0 1\nv 1 2e8 3\nv 4 5 6\n");
    write("far.stl",
          "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 3e8\nvertex 0 1 0\nendloop\nendfacet\n"
          "endsolid a\n");
    std::string ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float "
        "z\nend_header\n";
    const float corners[] = {0, 0, 0, 10, 20, 30};
    std::string body(sizeof corners, '\0');
    std::memcpy(body.data(), corners, sizeof corners);
    ply += body;
    write("line_end.ply", ply + "\r\n");
    write("filled.ply", ply + std::string(100000, '\0'));
    write("filled_ascii.ply",
          "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
          "0 0 0\n10 20 30\n" +
              std::string(100000, '\0'));
}

void makeQdas(const Write& write)
{
    const std::string fields =
        "K0100 2\r\nK1001/1 shaft 7\r\nK1001/2 shaft 8\r\nK2001/1 1\r\nK2001/2 2\r\nK0001/1 5.25\r\n"
        "K0004/1 21.04.2015/12:00:00\r\nK0001/2 6\r\nK0001/1 5.5\r\n";
    write("measured.dfq", fields);
    write("qdas.txt", fields);
    write("short_values.dfq",
          "K0100 2\r\nK1001 shaft\r\nK2001/1 a\r\nK2001/2 b\r\n"
          "5.25\x14"
          "0\x14"
          "21.04.2015/12:00:00\x0F"
          "6.5\r\n5.5\x0F"
          "6.75\r\n");
}

}  // namespace

void makeWrongKinds(const std::string& folder)
{
    namespace fs = std::filesystem;
    const Write write = [&folder](const std::string& name, const std::string& content) {
        std::ofstream(folder + "/" + name, std::ios::binary) << content;
    };
    makeTables(write);
    makeTexts(write);
    makeMeshes(write);
    makeQdas(write);
    fs::create_symlink("four.xyz", folder + "/symbolic.xyz");
    fs::create_hard_link(folder + "/four.xyz", folder + "/hard.xyz");
    fs::create_directory(folder + "/reference");
    write("reference/b.ds", "4\n1 0 0\n0 1 5\n-1 0 10\n0 -1 2\n");  // a cylinder
    write("reference/b.fit", "0 0 0 0 0 1 2\n");
    fs::create_directory(folder + "/wrong_reference");
    write("wrong_reference/a.ds", "3\n1 0 0\n0 1 0\n-1 0 0\n");
    write("wrong_reference/a.fit", "0 0 0 0 0 1 2.0001\n");
}

}  // namespace lathelier::golden
