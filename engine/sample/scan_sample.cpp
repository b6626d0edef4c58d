#include "engine/sample/scan_sample.h"

#include <nlohmann/json.hpp>

#include "engine/sample/sample.h"
#include "engine/sample/scan_ply.h"

namespace lathelier::sample {
namespace {

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

SampleContent makeScans(std::uint64_t seed, const Progress& progress)
{
    // Both parts are slightly tilted on the turntable; the copy is also rotated.
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

    SampleContent content;
    content.texts.push_back(scanPly(
        scanShaft(nominalShaft(), original, progress.part(0, 0.5, LT_TEXT("Engine", "Scanning the original")))));
    content.texts.push_back(
        scanPly(scanShaft(copiedShaft(), copy, progress.part(0.5, 1, LT_TEXT("Engine", "Scanning the copy")))));
    content.truth = std::make_shared<Json>(Json{{"about", syntheticScan},
                                                {"scanner",
                                                 {{"row_pitch_mm", copy.row_pitch_mm},
                                                  {"angle_step_deg", copy.angle_step_deg},
                                                  {"spot_mm", copy.spot_mm},
                                                  {"sigma_mm", copy.sigma_mm}}},
                                                {"original", piecesOf(nominalShaft())},
                                                {"copy", piecesOf(copiedShaft())},
                                                {"pose_original_part_to_scan", rowsOf(original.scan_T_part)},
                                                {"pose_copy_part_to_scan", rowsOf(copy.scan_T_part)}});
    return content;
}

}  // namespace

const SamplePart& scanSample()
{
    static const SamplePart part{"scans", {"original.ply", "copy.ply"}, makeScans};
    return part;
}

}  // namespace lathelier::sample
