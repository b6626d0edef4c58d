#include <bit>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "engine/core/json.h"
#include "engine/io/file.h"
#include "engine/project/project.h"
#include "engine/project/sample.h"

namespace lathelier {
namespace {

constexpr char kSynthetic[] = "synthetic: ray-cast scan made by Lathelier, not a measurement";

/// Binary little-endian PLY with float coordinates.
std::string plyOf(const Scan& scan)
{
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment unit mm\ncomment " + std::string(kSynthetic) +
                       "\nelement vertex " + std::to_string(scan.points_mm.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    const std::size_t header = text.size();
    text.resize(header + scan.points_mm.size() * 12);
    char* place = text.data() + header;
    for (const Eigen::Vector3d& p : scan.points_mm)
        for (int k = 0; k < 3; ++k) {
            const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(p[k]));
            for (int byte = 0; byte < 4; ++byte) *place++ = static_cast<char>(bits >> (8 * byte) & 0xff);
        }
    return text;
}

Json rowsOf(const Eigen::Isometry3d& pose)
{
    Json rows = Json::array();
    for (int r = 0; r < 4; ++r) {
        Json row = Json::array();
        for (int c = 0; c < 4; ++c) row.push_back(pose.matrix()(r, c));
        rows.push_back(row);
    }
    return rows;
}

Json piecesOf(const ShaftModel& shaft)
{
    Json pieces = Json::array();
    for (const ShaftPiece& p : shaft)
        pieces.push_back({{"z_mm", {p.z_start_mm, p.z_end_mm}},
                          {"radius_mm", {p.radius_start_mm, p.radius_end_mm}},
                          {"oversize_um", p.oversize_um},
                          {"taper_um", {p.taper_start_um, p.taper_end_um}},
                          {"barrel_um", p.barrel_um}});
    return pieces;
}

}  // namespace

std::vector<std::string> writeSample(const std::string& directory, std::uint64_t seed, const Progress& progress)
{
    namespace fs = std::filesystem;
    std::error_code failure;
    fs::create_directories(directory, failure);
    if (failure) throw Error(ErrorCode::FileNotWritable, {{"path", directory}, {"reason", failure.message()}});
    const auto path = [&](const char* name) { return (fs::absolute(directory) / name).lexically_normal().string(); };

    // Both parts stand a little askew on the turntable, the copy also turned.
    const auto pose = [](double x, double y, double z, double lean_x, double lean_y, double turn) {
        return Eigen::Isometry3d(Eigen::Translation3d(x, y, z) * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
                                 Eigen::AngleAxisd(lean_x, Eigen::Vector3d::UnitX()) *
                                 Eigen::AngleAxisd(lean_y, Eigen::Vector3d::UnitY()));
    };
    ScannerModel original;
    original.seed = 2 * seed;
    original.scan_T_part = pose(-0.05, 1.3, 0, 0.006, 0.0035, 0);
    ScannerModel copy;
    copy.seed = 2 * seed + 1;
    copy.scan_T_part = pose(1, 1.2, 1, 0.007, -0.025, 0.436);

    const std::vector<std::string> paths{path("original.ply"), path("copy.ply"), path("truth.json"),
                                         path("sample.lathelier")};
    const std::string original_ply =
        plyOf(scanShaft(nominalShaft(), original, progress.part(0, 0.4, LT_TEXT("Engine", "Scanning the original"))));
    writeFile(paths[0], original_ply);
    progress.report(0.5);
    const std::string copy_ply =
        plyOf(scanShaft(copiedShaft(), copy, progress.part(0.5, 0.9, LT_TEXT("Engine", "Scanning the copy"))));
    writeFile(paths[1], copy_ply);

    const Json truth{{"about", kSynthetic},
                     {"seed", seed},
                     {"scanner",
                      {{"row_pitch_mm", copy.row_pitch_mm},
                       {"angle_step_deg", copy.angle_step_deg},
                       {"spot_mm", copy.spot_mm},
                       {"sigma_mm", copy.sigma_mm}}},
                     {"original", piecesOf(nominalShaft())},
                     {"copy", piecesOf(copiedShaft())},
                     {"pose_original_part_to_scan", rowsOf(original.scan_T_part)},
                     {"pose_copy_part_to_scan", rowsOf(copy.scan_T_part)}};
    writeFile(paths[2], truth.dump(1) + "\n");

    Project project;
    project.title = "Sample: a shaft and its copy";
    PanelState& panel = project.panels["compare"];
    panel.inputs["reference"] = {.path = paths[0], .import = {}, .sha256 = sha256(original_ply), .synthetic = true};
    panel.inputs["copy"] = {.path = paths[1], .import = {}, .sha256 = sha256(copy_ply), .synthetic = true};
    panel.parameters = {{"tolerance_mm", 0.1}, {"scanner_accuracy_mm", 0.05}};
    project.report = {"compare"};
    writeProject(paths[3], project);
    progress.report(1);
    return paths;
}

}  // namespace lathelier
