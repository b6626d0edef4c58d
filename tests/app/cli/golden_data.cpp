#include "tests/app/cli/golden_data.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>

#include "engine/sample/sample.h"
#include "engine/sample/sample_files.h"
#include "tests/app/cli/golden_frf.h"
#include "tests/app/cli/golden_spindle.h"
#include "tests/app/cli/golden_tap.h"
#include "tests/app/cli/golden_wrong_kind.h"
#include "tests/engine/io/lgraph_files.h"

namespace lathelier::golden {
namespace {

std::string rows(int count, const std::function<Eigen::Vector3d(int)>& point)
{
    std::string text;
    for (int i = 0; i < count; ++i) {
        const Eigen::Vector3d p = point(i);
        text += fmt::format("{} {} {}\n", p.x(), p.y(), p.z());
    }
    return text;
}

/// A shaft Ø50 × 850 of 36 sides in metres, of 41 rings: bottom, wall and top as three solids of one file.
std::string facets()
{
    constexpr int sides = 36, rings = 41;
    const auto at = [](int side, int ring) {
        const double angle = 2 * std::numbers::pi * side / sides;
        return Eigen::Vector3d(0.025 * std::cos(angle), 0.025 * std::sin(angle), 0.85 * ring / (rings - 1));
    };
    const auto facet = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
        std::string text = "facet normal 0 0 0\n outer loop\n";
        for (const Eigen::Vector3d& p : {a, b, c})
            text += fmt::format("  vertex {:.9g} {:.9g} {:.9g}\n", p.x(), p.y(), p.z());
        return text + " endloop\nendfacet\n";
    };
    std::string bottom = "solid bottom\n", wall = "solid wall\n", top = "solid top\n";
    for (int i = 0; i < sides; ++i) {
        bottom += facet({0, 0, 0}, at(i + 1, 0), at(i, 0));
        top += facet({0, 0, 0.85}, at(i, rings - 1), at(i + 1, rings - 1));
        for (int ring = 0; ring + 1 < rings; ++ring) {
            wall += facet(at(i, ring), at(i + 1, ring), at(i + 1, ring + 1));
            wall += facet(at(i, ring), at(i + 1, ring + 1), at(i, ring + 1));
        }
    }
    return bottom + "endsolid bottom\n" + wall + "endsolid wall\n" + top + "endsolid top\n";
}

std::string binaryStl(const Scan& mesh)
{
    std::string bytes(80, ' ');
    const auto put = [&bytes](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
    put(static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles) {
        for (int i = 0; i < 3; ++i) put(0.0F);  // the normal, which readers compute
        for (const auto corner : triangle)
            for (int a = 0; a < 3; ++a) put(static_cast<float>(mesh.points_mm[static_cast<std::size_t>(corner)][a]));
        put(std::uint16_t{0});
    }
    return bytes;
}

std::string rows(const Scan& scan)
{
    return rows(static_cast<int>(scan.points_mm.size()),
                [&](int i) { return scan.points_mm[static_cast<std::size_t>(i)]; });
}

/// A scan as the practice data, tilted and shifted, of which about one point in eight is kept: 92 000.
Scan thinScan(const sample::ShaftModel& shaft, std::uint64_t seed, double tilt_deg)
{
    sample::ScannerModel scanner;
    scanner.seed = seed;
    const Eigen::AngleAxisd tilt(tilt_deg * std::numbers::pi / 180, Eigen::Vector3d(1, 2, 0).normalized());
    scanner.frame_T_scan = Eigen::Translation3d(tilt_deg, 0, -tilt_deg) * tilt;
    Scan scan = sample::scanShaft(shaft, scanner);
    std::vector<Eigen::Vector3d> kept;
    for (std::uint32_t i = 0; i < scan.points_mm.size(); ++i)
        if ((i * 2654435761U) >> 29 == 0) kept.push_back(scan.points_mm[i]);  // Knuth's multiplicative hash
    scan.points_mm = std::move(kept);
    return scan;
}

/// Profiles and probe records, whole and broken.
void makeRecords(const std::function<void(const std::string& name, const std::string& content)>& write)
{
    std::string xy = "# unit=mm\nx,y\n";
    std::string polar = "angle_deg;r_mm\n";
    std::string trace = "Units: um\nFilter: 1-50 UPR\n";
    for (int i = 0; i < 36; ++i) {
        const double angle = i * std::numbers::pi / 18;
        const double deviation_um = 3 * std::cos(3 * angle);
        const double r = 25 + deviation_um / 1000;
        xy += fmt::format("{:.9f},{:.9f}\n", r * std::cos(angle), r * std::sin(angle));
        std::string row = fmt::format("{};{:.6f}\n", i * 10, r);
        for (char& c : row) c = c == '.' ? ',' : c;
        polar += row;
        trace += fmt::format("{:.6f}\n", deviation_um);
    }
    write("profile_xy.csv", xy);
    write("profile_polar.csv", polar);
    write("trace.txt", trace);
    write("record.csv", "# rpm=975; D_mm=50\nt_s,marker_V,X3_um,Y3_um\n0,0.1,1,2\n0.5,0.2,2,3\n1,0.3,3,4\n");
    write("averaged.csv",
          "section,z_mm,i,angle_deg,X3_um,Y3_um,Xp_um,Yp_um\n1,5,0,0,1,2,3,4\n1,5,1,180,1,2,3,4\n"
          "2,10,0,0,1,2,3,4\n2,10,1,180,1,2,3,4\n");
    testing::LGraphSetup setup;
    write("pair.par", testing::makePar(setup));
    write("pair.dat", testing::makeDat(setup.frames, setup.active.size()));
    write("cut.par", testing::makePar(setup));
    write("cut.dat", testing::makeDat(setup.frames / 2, setup.active.size()));
    write("alone.dat", testing::makeDat(setup.frames, setup.active.size()));
    setup.version = testing::Made::After2008;
    std::string par = testing::makePar(setup);
    write("late.PAR", par);
    write("late.DAT", testing::makeDat(setup.frames, setup.active.size()));
    testing::put<double>(par, 109, 11);  // another rate per channel
    write("rate.par", par);
    write("rate.dat", testing::makeDat(setup.frames, setup.active.size()));
}

/// A section of radius 25 mm about (1, 2), as x,y: r contains `lobes` · cos(kθ - 30°). From a turn of `points`, those
/// from `gap_from` to `gap_to` are left out; lengths are multiplied by `unit`.
std::string section(int points, int k, double lobe_mm, double unit = 1, int gap_from = 0, int gap_to = 0)
{
    std::string text = "x,y\n";
    for (int i = 0; i < points; ++i) {
        if (i >= gap_from && i < gap_to) continue;
        const double angle = 2 * std::numbers::pi * i / points;
        const double r = 25 + lobe_mm * std::cos(k * angle - std::numbers::pi / 6);
        text += fmt::format("{:.9f},{:.9f}\n", unit * (1 + r * std::cos(angle)), unit * (2 + r * std::sin(angle)));
    }
    return text;
}

/// The same as angle and deviation in µm from the nominal radius.
std::string deviations(int points, int k, double lobe_um)
{
    std::string text = "angle_deg,deviation_um\n";
    for (int i = 0; i < points; ++i)
        text += fmt::format("{:.6f},{:.6f}\n", 360.0 * i / points,
                            lobe_um * std::cos(k * 2 * std::numbers::pi * i / points));
    return text;
}

}  // namespace

void makeData(const std::string& folder)
{
    const auto write = [&folder](const std::string& name, const std::string& content) {
        std::ofstream(folder + "/" + name, std::ios::binary) << content;
    };
    write("empty.xyz", "");
    write("four.xyz", "0 0 0\n10 0 0\n0 10 0\n0 0 10\n");
    write("equal.xyz", rows(1000, [](int) { return Eigen::Vector3d(1, 2, 3); }));
    write("line.xyz", rows(1000, [](int i) { return Eigen::Vector3d(i * 0.1, i * 0.2, i * 0.05); }));
    write("plane.xyz", rows(2500, [](int i) { return Eigen::Vector3d(i % 50, i / 50, 7); }));
    write("nan.xyz", "nan nan nan\nNaN 1 2\n1 inf 2\n");
    write("huge.xyz", "1e30 0 0\n0 1e30 0\n0 0 1e30\n-1e30 5 5\n");
    write("words.xyz", "1 2 3\n4 five 6\n7 8 9\n");
    write("small.xyz", "0.01 0.02 0.03\n0.1 0.2 0.3\n0.2 0.2 0.1\n0.3 0.1 0.2\n");
    write("promise.ply",
          "ply\nformat binary_little_endian 1.0\nelement vertex 1000000000000\nproperty float x\nproperty float y\n"
          "property float z\nend_header\nshort");
    write("comma.csv", "x;y;z\n1,5;2,5;3,5\n10,25;20;30\n2,5;3,5;4,5\n");
    write("photo.jpg", std::string("\xFF\xD8\xFF\xE0\0\x10JFIF\0", 11) + std::string(500, '\x81'));
    write("name with spaces, ą & <b>.xyz", "0 0 0\n10 0 0\n0 10 0\n0 0 10\n");
    write("unreadable.xyz", "1 2 3\n");
    ::chmod((folder + "/unreadable.xyz").c_str(), 0);
    std::filesystem::create_directory(folder + "/folder");
    ::mkfifo((folder + "/silent.pipe").c_str(), 0666);
    ::mkfifo((folder + "/fed.pipe").c_str(), 0666);

    makeRecords(write);
    write("no_feed.nc", "G0 X10. Z0.\nG1 Z-5.\n");
    write("unknown_word.nc", "G0 X10. Z2.\nG1 Z1. G321 F0.1\n");
    write("endless.nc", "#1=0\nWHILE[1 EQ 1]DO1\n#1=#1+1\nEND1\nM30\n");
    write("okuma.min", "$SHAFT.MIN%\nG50 S2000\nNAT01\nG85 NLAP1 D4 F0.3\nG00 X50 Z2\n");
    makeSpindleRecords(write);
    makeTapRecords(write);
    makeWrongKinds(folder);
    makeFrfs(folder);

    write("lobes.csv", section(360, 3, 0.005));
    write("lobes_um.csv", section(360, 3, 0.005, 1000));
    write("oval.csv", section(400, 2, 0.002));
    write("keyway.csv", section(720, 2, 0.005, 1, 100, 116));
    write("deviations.csv", deviations(360, 4, 3));
    write("three_points.csv", "x,y\n1,0\n0,1\n-1,0\n");
    write("straight.csv", "x,y\n1,2\n2,4\n3,6\n4,8\n5,10\n");

    write("shaft.xyz", rows(thinScan(sample::nominalShaft(), 1, 0.3)));
    write("copy.xyz", rows(thinScan(sample::copiedShaft(), 2, 4)));
    sample::ScannerModel coarse;
    coarse.row_pitch_mm = 0.5;
    coarse.angle_step_deg = 2;
    write("cylinder.xyz", rows(11 * 60, [](int i) {
              const double t = 2 * std::numbers::pi * (i % 60) / 60, r = 25 + 0.004 * std::cos(3 * t);
              return Eigen::Vector3d(3 + r * std::cos(t), r * std::sin(t), 8.0 * (i / 60));
          }));
    write("coarse.xyz", rows(sample::scanShaft(sample::nominalShaft(), coarse)));
    write("facets36.stl", facets());
    write("nominal.stl", binaryStl(sample::shaftMesh(sample::nominalShaft())));
    sample::writeSample(folder + "/sample");
    write("zones.json",
          R"([{"name": "collar", "z_start_mm": 98.7, "z_end_mm": 107.3, "lower_mm": -0.05, "upper_mm": 0.1},
 {"name": "grip", "z_start_mm": 0, "z_end_mm": 20, "lower_mm": null, "upper_mm": null}])");
    write("zones_reversed.json", R"([
 {"name": "collar", "z_start_mm": 107, "z_end_mm": 98, "lower_mm": -0.05, "upper_mm": 0.1}])");
    write("bracket.xyz", rows(sample::scanBracket(20000, 0.02, Eigen::Isometry3d::Identity(), 3)));
}

}  // namespace lathelier::golden
