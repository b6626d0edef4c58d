#include "engine/sample/worn_sample.h"

#include <nlohmann/json.hpp>

#include "engine/sample/sample.h"
#include "engine/sample/scan_ply.h"

namespace lathelier::sample {
namespace {

constexpr double firstBearingBarrel_um = 15;   ///< of the first bearing seat, on the radius
constexpr double secondBearingTaper_um = -12;  ///< of the second one, on the radius along it

/// Chamfer, seat 20, groove of a circlip, 20, cone 1:10 to 24, collar 34, seat 25, chamfer.
ShaftModel wornShaft()
{
    struct Row {
        double length_mm, start_mm, end_mm;
    };
    constexpr Row rows[] = {{1, 18, 20},  {30, 20, 20}, {1.3, 19, 19}, {8, 20, 20},
                            {40, 20, 24}, {10, 34, 34}, {35, 25, 25},  {1.5, 25, 22}};
    ShaftModel shaft;
    double z_mm = 0;
    for (const Row& row : rows) {
        ShaftPiece piece;
        piece.z_start_mm = z_mm;
        piece.z_end_mm = z_mm += row.length_mm;
        piece.radius_start_mm = row.start_mm / 2;
        piece.radius_end_mm = row.end_mm / 2;
        shaft.push_back(piece);
    }
    shaft[1].barrel_um = firstBearingBarrel_um;
    shaft[6].taper_end_um = secondBearingTaper_um;
    // The chamfer starts at the radius of the worn seat.
    shaft[7].oversize_um = secondBearingTaper_um;
    return shaft;
}

SampleContent makeWorn(std::uint64_t seed, const Progress& progress)
{
    ScannerModel scanner;
    scanner.seed = 1000 + seed;
    scanner.row_pitch_mm = 0.1;
    scanner.angle_step_deg = 1.8;
    scanner.scan_T_part = Eigen::Translation3d(0.4, -0.7, 2) * Eigen::AngleAxisd(0.008, Eigen::Vector3d(0.6, 0.8, 0));
    const ShaftModel shaft = wornShaft();
    Json rows = Json::array();
    for (const ShaftPiece& piece : shaft)
        rows.push_back({{"length_mm", piece.z_end_mm - piece.z_start_mm},
                        {"start_diameter_mm", 2 * piece.radius_start_mm},
                        {"end_diameter_mm", 2 * piece.radius_end_mm}});
    SampleContent content;
    content.texts.push_back(scanPly(scanShaft(shaft, scanner, progress)));
    content.truth = std::make_shared<Json>(Json{{"worn",
                                                 {{"about", syntheticScan},
                                                  {"segments", rows},
                                                  {"barrel_of_row_2_um", firstBearingBarrel_um},
                                                  {"taper_of_row_7_um", secondBearingTaper_um}}}});
    return content;
}

}  // namespace

const SamplePart& wornSample()
{
    static const SamplePart part{"worn", {"worn.ply"}, makeWorn};
    return part;
}

}  // namespace lathelier::sample
