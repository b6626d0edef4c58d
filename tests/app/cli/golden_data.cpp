#include "tests/app/cli/golden_data.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>

#include "engine/project/sample.h"

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

std::string rows(const Scan& scan)
{
    return rows(static_cast<int>(scan.points_mm.size()),
                [&](int i) { return scan.points_mm[static_cast<std::size_t>(i)]; });
}

/// A scan as the practice data, tilted and shifted, of which about one point in eight is kept: 92 000.
Scan thinScan(const ShaftModel& shaft, std::uint64_t seed, double tilt_deg)
{
    ScannerModel scanner;
    scanner.seed = seed;
    const Eigen::AngleAxisd tilt(tilt_deg * std::numbers::pi / 180, Eigen::Vector3d(1, 2, 0).normalized());
    scanner.frame_T_scan = Eigen::Translation3d(tilt_deg, 0, -tilt_deg) * tilt;
    Scan scan = scanShaft(shaft, scanner);
    std::vector<Eigen::Vector3d> kept;
    for (std::uint32_t i = 0; i < scan.points_mm.size(); ++i)
        if ((i * 2654435761U) >> 29 == 0) kept.push_back(scan.points_mm[i]);  // Knuth's multiplicative hash
    scan.points_mm = std::move(kept);
    return scan;
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

    write("shaft.xyz", rows(thinScan(nominalShaft(), 1, 0.3)));
    write("copy.xyz", rows(thinScan(copiedShaft(), 2, 4)));
    ScannerModel coarse;
    coarse.row_pitch_mm = 0.5;
    coarse.angle_step_deg = 2;
    write("coarse.xyz", rows(scanShaft(nominalShaft(), coarse)));
    write("bracket.xyz", rows(scanBracket(20000, 0.02, Eigen::Isometry3d::Identity(), 3)));
}

}  // namespace lathelier::golden
