#include <bit>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "engine/core/json.h"
#include "engine/form/roundness_quantities.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/project/project.h"
#include "engine/sample/sample.h"
#include "engine/sample/sample_record.h"

namespace lathelier {
namespace {

constexpr char kSynthetic[] = "synthetic: ray-cast scan made by Lathelier, not a measurement";
constexpr char kSyntheticRecord[] = "synthetic: probe record made by Lathelier, not a measurement";

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

Json wavesOf(const std::vector<MotionWave>& waves)
{
    Json json = Json::array();
    for (const MotionWave& w : waves)
        json.push_back({{"upr", w.upr},
                        {"x_um", w.x_um},
                        {"x_phase_rad", w.x_phase_rad},
                        {"y_um", w.y_um},
                        {"y_phase_rad", w.y_phase_rad}});
    return json;
}

/// What has to come out of the probe record.
Json truthOf(const SpindleModel& model)
{
    Json sections = Json::array();
    for (int i = 0; i < model.sections; ++i)
        sections.push_back({{"section", i + 1},
                            {"z_mm", sectionMiddle_mm(model, i)},
                            {"circles", nestedJson(describedValues(form::fitCircles(trueImage_mm(model, i))))}});
    return {{"about", kSyntheticRecord},
            {"workpiece_diameter_mm", model.workpiece_diameter_mm},
            {"taper_diameter_um", model.taper_diameter_um},
            {"barrel_um", model.barrel_um},
            {"axis", wavesOf(model.axis)},
            {"tool", wavesOf(model.tool)},
            {"axis_noise_um", model.axis_noise_um},
            {"tool_noise_um", model.tool_noise_um},
            {"whirl_um", model.whirl_um},
            {"sections", sections}};
}

}  // namespace

std::vector<std::string> sampleFileNames()
{
    return {"original.ply", "copy.ply", "truth.json", "probe_record.csv", "averaged.csv", "sample.lathelier"};
}

std::vector<std::string> writeSample(const std::string& directory, std::uint64_t seed, const Progress& progress)
{
    namespace fs = std::filesystem;
    std::error_code failure;
    fs::create_directories(directory, failure);
    if (failure) throw Error(errors::fileNotWritable, {{"path", directory}, {"reason", failure.message()}});
    const auto path = [&](const std::string& name) {
        return (fs::absolute(directory) / name).lexically_normal().string();
    };

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

    std::vector<std::string> paths;
    for (const std::string& name : sampleFileNames()) paths.push_back(path(name));
    const std::string original_ply =
        plyOf(scanShaft(nominalShaft(), original, progress.part(0, 0.35, LT_TEXT("Engine", "Scanning the original"))));
    writeFile(paths[0], original_ply);
    progress.report(0.45);
    const std::string copy_ply =
        plyOf(scanShaft(copiedShaft(), copy, progress.part(0.45, 0.8, LT_TEXT("Engine", "Scanning the copy"))));
    writeFile(paths[1], copy_ply);
    progress.report(0.9);

    SpindleModel spindle = sampleSpindle();
    spindle.seed = seed;
    const std::string record = toCsv(makeProbeRecord(spindle));
    writeFile(paths[3], record);
    progress.report(0.95);
    writeFile(paths[4], toCsv(makeAveragedRecord(spindle)));

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
                     {"pose_copy_part_to_scan", rowsOf(copy.scan_T_part)},
                     {"probe_record", truthOf(spindle)}};
    writeFile(paths[2], truth.dump(1) + "\n");

    Project project;
    project.title = "Sample: a shaft and its copy; a record of a lathe's spindle";
    PanelState& panel = project.panels["compare"];
    panel.inputs["reference"] = {.path = paths[0], .import = {}, .sha256 = sha256(original_ply), .synthetic = true};
    panel.inputs["copy"] = {.path = paths[1], .import = {}, .sha256 = sha256(copy_ply), .synthetic = true};
    panel.parameters = {{"tolerance_mm", 0.1}, {"scanner_accuracy_mm", 0.05}};
    PanelState& form = project.panels["roundness"];
    form.inputs["record"] = {.path = paths[3], .import = {}, .sha256 = sha256(record), .synthetic = true};
    form.parameters = {{"tolerance_um", 15.0}};
    project.report = {"compare"};
    writeProject(paths[5], project);
    progress.report(1);
    return paths;
}

}  // namespace lathelier
