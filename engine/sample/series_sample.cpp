#include "engine/sample/series_sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "engine/batch/recipe_file.h"
#include "engine/cad/task/compare_task.h"
#include "engine/core/random.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/sample/sample.h"
#include "engine/sample/scan_ply.h"

namespace lathelier::sample {
namespace {

namespace fs = std::filesystem;

constexpr double length_mm = 70, seatStart_mm = 20, seatEnd_mm = 45;
constexpr double fromEdge_mm = 2;  ///< of the zone on the seat, from its shoulders
constexpr std::size_t seat = 1;    ///< its piece
constexpr int timesDenser = 10;    ///< the original

/// Streams of random numbers.
enum SeriesStream : std::uint64_t { Pose = 40 };

ShaftModel partOfSeries(double seat_um)
{
    ShaftModel shaft{{.z_start_mm = 0, .z_end_mm = seatStart_mm, .radius_start_mm = 12, .radius_end_mm = 12},
                     {.z_start_mm = seatStart_mm, .z_end_mm = seatEnd_mm, .radius_start_mm = 15, .radius_end_mm = 15},
                     {.z_start_mm = seatEnd_mm, .z_end_mm = 65, .radius_start_mm = 20, .radius_end_mm = 20},
                     {.z_start_mm = 65, .z_end_mm = length_mm, .radius_start_mm = 20, .radius_end_mm = 16}};
    shaft[seat].oversize_um = seat_um;
    return shaft;
}

/// Twice as many rows along the part as rays around it for each length that is a turn.
ScannerModel scannerOf(const SeriesModel& model, int points, std::uint64_t seed)
{
    ScannerModel scanner;
    const double columns = std::max(12.0, std::round(std::sqrt(1.2 * points)));
    scanner.angle_step_deg = 360 / columns;
    scanner.row_pitch_mm = length_mm * columns / points;
    scanner.spot_mm = model.spot_mm;
    scanner.sigma_mm = model.sigma_mm;
    scanner.seed = seed;
    return scanner;
}

Scan scanOfPart(const SeriesModel& model, int number, const Progress& progress)
{
    const auto place = static_cast<std::uint64_t>(number);
    ScannerModel scanner = scannerOf(model, model.points, 1000003 * model.seed + place + 1);
    const auto random = [&](std::uint64_t i) { return 2 * randomUniform(model.seed, Pose, 4 * place + i) - 1; };
    scanner.frame_T_scan = Eigen::Translation3d(5 * random(0), 5 * random(1), 10 * random(2)) *
                           Eigen::AngleAxisd(0.02 * random(3), Eigen::Vector3d(1, 2, 0).normalized());
    return scanShaft(partOfSeries(oversize_um(model, number)), scanner, progress);
}

void writeRecipeOf(const SeriesModel& model, const std::string& path, const std::string& original,
                   const std::string& part, const Progress& progress)
{
    cad::CompareQuestion question;
    question.compare.zones = {
        {"seat", seatStart_mm + fromEdge_mm, seatEnd_mm - fromEdge_mm, -model.limit_mm, model.limit_mm}};
    project::PanelState state;
    state.parameters = toValues(question);
    state.inputs[cad::referenceRole].path = original;
    state.inputs[cad::copyRole].path = part;
    batch::writeRecipe(path, batch::recipeOf(cad::compareTask(), state, progress));
}

Json truthOf(const SeriesModel& model)
{
    Json parts = Json::array();
    const std::vector<int> bad = badParts(model);
    for (int i = 0; i < model.parts; ++i)
        parts.push_back({{"file", fmt::format("parts/part-{:04}.ply", i + 1)},
                         {"seat_oversize_um", oversize_um(model, i)},
                         {"out_of_tolerance", std::find(bad.begin(), bad.end(), i) != bad.end()}});
    return {{"about", syntheticScan},
            {"seed", model.seed},
            {"seat_z_mm", {seatStart_mm, seatEnd_mm}},
            {"limit_mm", model.limit_mm},
            {"parts", parts}};
}

}  // namespace

std::vector<int> badParts(const SeriesModel& model)
{
    return {model.parts / 4, model.parts / 2, model.parts * 7 / 8};
}

double oversize_um(const SeriesModel& model, int number)
{
    const double along = model.parts > 1 ? static_cast<double>(number) / (model.parts - 1) - 0.5 : 0;
    const std::vector<int> bad = badParts(model);
    const auto which = std::find(bad.begin(), bad.end(), number);
    if (which == bad.end()) return model.drift_um * along;
    return model.drift_um * along + (which == bad.begin() + 1 ? -model.bad_um : model.bad_um);
}

std::vector<std::string> writeSeries(const std::string& directory, const SeriesModel& model, const Progress& progress)
{
    std::error_code failure;
    fs::create_directories(fs::path(directory) / "parts", failure);
    if (failure) throw Error(errors::fileNotWritable, {{"path", directory}, {"reason", failure.message()}});
    const auto path = [&](const std::string& name) {
        return (fs::absolute(directory) / name).lexically_normal().string();
    };
    std::vector<std::string> paths{path("original.ply"), path("recipe.json"), path("truth.json")};
    const Progress writing = progress.part(0, 1, LT_TEXT("Engine", "Scanning the parts"));
    io::writeFile(paths[0], scanPly(scanShaft(partOfSeries(0), scannerOf(model, timesDenser * model.points, model.seed),
                                              progress.quiet())));
    for (int i = 0; i < model.parts; ++i) {
        paths.push_back(path(fmt::format("parts/part-{:04}.ply", i + 1)));
        io::writeFile(paths.back(), scanPly(scanOfPart(model, i, progress.quiet())));
        writing.report(static_cast<double>(i + 1) / model.parts);
    }
    writeRecipeOf(model, paths[1], paths[0], paths[3], progress.quiet());
    io::writeFile(paths[2], truthOf(model).dump(1) + "\n");
    return paths;
}

}  // namespace lathelier::sample
