#include "engine/sample/chain_sample.h"

#include <array>
#include <nlohmann/json.hpp>

#include "engine/cam/job_bodies.h"
#include "engine/cam/job_file.h"
#include "engine/cam/plan.h"
#include "engine/deflection/setup_file.h"
#include "engine/deflection/turning_job.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/sample/sample.h"
#include "engine/sample/scan_ply.h"
#include "engine/sample/surface_sample.h"

namespace lathelier::sample {
namespace {

constexpr double longSeatBarrel_um = 14;    ///< wear of the long seat, on the radius
constexpr double secondSeatTaper_um = -10;  ///< wear of the second one, on the radius along it

Shaft drawing()
{
    Shaft shaft;
    shaft.name = "Shaft of the paper";
    for (const auto& [length_mm, start_mm, end_mm] : {std::array{98.0, 30.0, 30.0}, std::array{10.0, 37.0, 37.0},
                                                      std::array{70.0, 33.8, 33.8}, std::array{5.0, 33.8, 23.8}}) {
        ShaftSegment row;
        row.length_mm = length_mm;
        row.start_diameter_mm = start_mm;
        row.end_diameter_mm = end_mm;
        shaft.segments.push_back(row);
    }
    shaft.segments.back().role = "chamfer";
    shaft.material = Material{};
    return shaft;
}

cam::JobTool insert(int number, cam::ToolUse use, const char* name, double corner_radius_mm, double tip_angle_deg,
                    double edge_length_mm)
{
    cam::JobTool tool;
    tool.number = number;
    tool.use = use;
    tool.name = name;
    tool.corner_radius_mm = corner_radius_mm;
    tool.entering_angle_deg = 93;
    tool.tip_angle_deg = tip_angle_deg;
    tool.edge_length_mm = edge_length_mm;
    return tool;
}

cam::Job job()
{
    cam::Job made;
    made.title = "SHAFT OF THE PAPER";
    made.stock.diameter_mm = 40;
    made.stock.face_allowance_mm = 1;
    made.setup.chuck_face_z_mm = 200;
    made.tools = {insert(5, cam::ToolUse::Rough, "DNMG 150608 / PDJNL", 0.8, 55, 15),
                  insert(4, cam::ToolUse::Finish, "VBMT 160404 / SVJBL", 0.4, 35, 16),
                  insert(6, cam::ToolUse::FinishBack, "VBMT 160404 / SVJBR", 0.4, 35, 16)};
    made.tools.back().hand = Hand::FromChuck;
    cam::JobTool blade;
    blade.number = 8;
    blade.use = cam::ToolUse::Groove;
    blade.name = "N123 3 mm";
    blade.width_mm = 3;
    blade.corner_radius_mm = 0.2;
    blade.feed_mm_rev = 0.06;
    blade.reach_mm = 22;
    made.tools.push_back(blade);
    made.cutting.material = "C45";
    made.cutting.rough = {2, 0.25, 190, 0.3};
    made.cutting.finish = {0.1, 190};
    made.max_rpm = 3000;
    return made;
}

deflection::TurningSetup setup()
{
    deflection::TurningSetup made;
    made.material.cutting = {1748, 99, 600, 80};
    made.tool.corner_radius_mm = 0.4;
    made.tool.entering_angle_deg = 93;
    made.chuck = {14850, 0, 198.3e6, 0};  // the springs of spindle.json: one machine
    return made;
}

/// Adds the predicted deflection errors, linear along each piece.
void addDeflectionErrors(ShaftModel& shaft, const Shaft& part, const Progress& progress)
{
    const cam::Job planned = job();
    cam::TurningInputs inputs;
    inputs.post = cam::postNamed("fanuc_a");
    cam::TurningPlan plan = planTurning(part, planned, inputs, {}, progress.part(0, 0.5));
    gcode::Program program = gcode::readProgram(std::move(plan.setups.front().text), inputs.post.control);
    gcode::Toolpath path = findToolpath(program);
    deflection::TurningSetup held = setup();
    held.z_zero_mm = planned.stock.face_allowance_mm;
    Shaft bar = cam::stockOf(planned);
    bar.segments.back().length_mm -=
        bar.length_mm() - (planned.setup.chuck_face_z_mm + planned.stock.face_allowance_mm);
    const deflection::TurningJob work =
        deflection::turningJob(std::move(program), std::move(path), std::move(bar), std::move(held));
    const deflection::FinalContour contour = predictJob(work, progress.part(0.5, 1)).final;
    const auto error_um = [&](double z_mm) {
        const double at = z_mm + planned.stock.face_allowance_mm;
        for (std::size_t i = 0; i + 1 < contour.z_mm.size(); ++i)
            if (contour.z_mm[i] <= at && at < contour.z_mm[i + 1])
                return contour.diameter_error_um[i] +
                       (contour.diameter_error_um[i + 1] - contour.diameter_error_um[i]) * (at - contour.z_mm[i]) /
                           (contour.z_mm[i + 1] - contour.z_mm[i]);
        return 0.0;
    };
    double behind_um = 0;  // error at the end of the last cylinder, continued by a chamfer
    for (ShaftPiece& piece : shaft) {
        if (piece.radius_start_mm != piece.radius_end_mm) {
            piece.oversize_um = behind_um;
            continue;
        }
        // A parabola through three points within the piece, as the contour jumps at shoulders.
        const double length_mm = piece.z_end_mm - piece.z_start_mm, inset_mm = 0.1 * length_mm;
        const double start_um = error_um(piece.z_start_mm + inset_mm) / 2;
        const double middle_um = error_um(piece.z_start_mm + length_mm / 2) / 2;
        const double end_um = error_um(piece.z_end_mm - inset_mm) / 2;
        piece.barrel_um = (2 * middle_um - start_um - end_um) / 1.28;
        const double mean_um = middle_um - piece.barrel_um, half_um = (end_um - start_um) / 1.6;
        piece.taper_start_um = mean_um - half_um;
        behind_um = piece.taper_end_um = mean_um + half_um;
    }
}

ScannerModel scanner(std::uint64_t seed)
{
    ScannerModel made;
    made.seed = seed;
    made.row_pitch_mm = 0.2;
    made.angle_step_deg = 1.8;
    made.scan_T_part = Eigen::Translation3d(0.3, -0.5, 1) * Eigen::AngleAxisd(0.006, Eigen::Vector3d(0.8, -0.6, 0));
    return made;
}

SampleContent makeChain(std::uint64_t seed, const Progress& progress)
{
    const Shaft part = drawing();
    ShaftModel worn = nominalShaft(), copy = nominalShaft();
    worn.front().barrel_um = longSeatBarrel_um;
    worn[2].taper_end_um = secondSeatTaper_um;
    for (std::size_t i = 3; i < worn.size(); ++i) worn[i].oversize_um = secondSeatTaper_um;  // continued by the chamfer
    addDeflectionErrors(copy, part, progress.part(0, 0.2));
    SampleContent content;
    content.texts = {scanPly(scanShaft(worn, scanner(2000 + seed), progress.part(0.2, 0.6))), io::shaftText(part),
                     cam::jobText(job()), deflection::setupText(setup()),
                     scanPly(scanShaft(copy, scanner(3000 + seed), progress.part(0.6, 1)))};
    content.truth = std::make_shared<Json>(Json{{"chain",
                                                 {{"about", syntheticScan},
                                                  {"barrel_of_row_1_um", longSeatBarrel_um},
                                                  {"taper_of_row_3_um", secondSeatTaper_um}}}});
    // One part: what a question is not given here it takes from the ones before.
    content.panels["recognise"] = {.inputs = {{"scan", "chain_worn.ply"}}, .parameters = {}};
    content.panels["drawing"] = {.inputs = {{"shaft", "chain_drawing.json"}},
                                 .parameters = {{"date", std::string("2026-01-15")}}};
    content.panels["turning"] = {.inputs = {{"job", "chain_job.json"}}, .parameters = {}};
    content.panels["deflection"] = {.inputs = {{"setup", "chain_setup.json"}}, .parameters = {{"tolerance_um", 25.0}}};
    content.panels["compare"] = {
        .inputs = {{"copy", "chain_copy.ply"}}, .parameters = {{"tolerance_mm", 0.1}}, .in_report = true};
    content.panels["chain"] = {.inputs = {{"scan", "chain_worn.ply"},
                                          {"shaft", "chain_drawing.json"},
                                          {"job", "chain_job.json"},
                                          {"setup", "chain_setup.json"},
                                          {"copy", "chain_copy.ply"},
                                          {"before", "surface_before.png"},
                                          {"after", "surface_after.png"}},
                               .parameters = {{"tolerance_mm", 0.1},
                                              {"confirmed_by", std::string("nobody: a sample")},
                                              {"photograph_z_mm", 49.0},
                                              {"photograph_feed_deg", 0.0},
                                              {"photograph_cut", std::string("down")},
                                              {"photograph_mm_px", surfaceSample_mm_px}}};
    return content;
}

}  // namespace

const SamplePart& chainSample()
{
    static const SamplePart part{
        "chain",
        {"chain_worn.ply", "chain_drawing.json", "chain_job.json", "chain_setup.json", "chain_copy.ply"},
        makeChain};
    return part;
}

}  // namespace lathelier::sample
