#include "widgets/compare/compare_outcome.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "engine/cad/step_reader.h"
#include "engine/features/shaft_mesh.h"
#include "engine/io/file.h"
#include "engine/io/json/json_head.h"
#include "engine/registration/compare_plots.h"
#include "engine/registration/surface_form.h"
#include "engine/registration/verdict/verdict.h"
#include "engine/shaft/shaft_rules.h"

namespace lathelier::compare_panel {
namespace {

constexpr double shownSagitta_mm = 0.01;  // sagitta of the displayed mesh; deviations refer to the exact contour

double angleOf(const Eigen::Vector3d& axisPlace)
{
    const double angle = std::atan2(axisPlace.y(), axisPlace.x()) * 180 / std::numbers::pi;
    return angle < 0 ? angle + 360 : angle;
}

/// Index of the map's cell; none outside.
std::optional<std::size_t> cellOf(const registration::UnrolledMap& map, double z_mm, double angle_deg)
{
    const double row = std::floor((z_mm - map.z_start_mm) / map.z_step_mm);
    if (!(row >= 0 && row < map.z_count)) return std::nullopt;
    const int column = std::clamp(static_cast<int>(angle_deg / 360 * map.angle_count), 0, map.angle_count - 1);
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(map.angle_count) + static_cast<std::size_t>(column);
}

/// `windows`: window index by point.
std::shared_ptr<const std::vector<std::int8_t>> alongAxis(const registration::CompareResult& result,
                                                          const std::vector<std::uint32_t>& windows)
{
    const registration::SurfaceWindows& all = *result.windows;
    if (all.faces.empty() || !all.axis_T_reference || !result.alignment.reference_axis) return nullptr;
    const Eigen::Vector3d z = all.axis_T_reference->linear().row(2);
    const int sense = z.dot(result.alignment.reference_axis->direction) < 0 ? -1 : 1;
    auto along = std::make_shared<std::vector<std::int8_t>>(windows.size());
    for (std::size_t i = 0; i < windows.size(); ++i) {
        if (windows[i] == registration::noWindow) continue;
        const std::int32_t stretch = all.windows[windows[i]].stretch;
        if (stretch >= 0)
            (*along)[i] = static_cast<std::int8_t>(sense * all.stretches[static_cast<std::size_t>(stretch)].facing);
    }
    return along;
}

void addLocalMeans(CompareOutcome& outcome, const Progress& progress)
{
    const registration::CompareResult& result = *outcome.result;
    if (result.windows) {
        const std::vector<std::uint32_t> windows =
            registration::windowsOfPoints(outcome.copyScan(), result, progress.part(0, 0.9));
        outcome.local_mean_mm = std::make_shared<const std::vector<float>>(
            registration::meansOf(*result.windows, windows, registration::colourSigmaLimit_mm(result)));
        outcome.along_axis = alongAxis(result, windows);
    }
    if (result.unrolled)
        outcome.map_mean_mm =
            std::make_shared<const std::vector<float>>(registration::localMeansOfMap(result, progress.part(0.9, 1)));
}

void fillAxisPlace(const CompareOutcome& outcome, ComparePlace& place)
{
    const registration::CompareResult& result = *outcome.result;
    if (!result.axis_T_reference) return;
    const Eigen::Vector3d axisPlace = *result.axis_T_reference * place.reference_mm;
    place.z_mm = axisPlace.z();
    place.angle_deg = angleOf(axisPlace);
    if (!outcome.map_mean_mm || place.local_mean_mm) return;
    const auto cell = cellOf(*result.unrolled, axisPlace.z(), *place.angle_deg);
    if (!cell) return;
    const float mean = (*outcome.map_mean_mm)[*cell];
    if (!std::isnan(mean)) place.local_mean_mm = mean;
}

/// The shaft with its mesh; reuses the last mesh for an equal shaft.
std::shared_ptr<const DrawnShaft> drawnShaft(const project::PanelState& state,
                                             const std::shared_ptr<const DrawnShaft>& last, Stores& stores,
                                             const Progress& progress)
{
    auto drawn = std::make_shared<DrawnShaft>();
    drawn->part = part_common::takePart(state, referenceRole, stores, progress.part(0, 0.5));
    const Notes remarks = checkShaft(drawn->part.shaft);
    drawn->part.notes.insert(drawn->part.notes.end(), remarks.begin(), remarks.end());
    if (last && last->part.shaft == drawn->part.shaft && last->part.input.sha256 == drawn->part.input.sha256) {
        drawn->mesh = last->mesh;
        return drawn;
    }
    auto mesh = std::make_shared<LoadedScan>();
    mesh->file.scan = features::shaftMesh(drawn->part.shaft, shownSagitta_mm, progress.part(0.5, 1)).scan;
    mesh->inputs = {drawn->part.input};
    drawn->mesh = std::move(mesh);
    return drawn;
}

/// Whether only the limits of the surface differ. Sizes depend on the decision rule and U.
bool sameButLimits(const CompareOutcome& last, const registration::CompareParameters& parameters)
{
    const registration::CompareParameters& before = last.result->parameters;
    if (!sameButVerdict(before, parameters)) return false;
    return !last.sizes ||
           (before.decision == parameters.decision && before.scanner_accuracy_mm == parameters.scanner_accuracy_mm);
}

void takeSizes(features::ShaftComparison found, CompareOutcome& outcome)
{
    outcome.sizes = std::make_shared<const features::ShaftComparison>(std::move(found));
    outcome.result = {outcome.sizes, &outcome.sizes->surface};
}

void judgeAgain(const CompareOutcome& last, const registration::CompareParameters& parameters, const Progress& progress,
                CompareOutcome& outcome)
{
    if (last.sizes) {
        features::ShaftComparison again = *last.sizes;
        judgeSurface(again, parameters, progress);
        takeSizes(std::move(again), outcome);
    } else {
        registration::CompareResult again = *last.result;
        judge(again, parameters, progress);
        outcome.result = std::make_shared<const registration::CompareResult>(std::move(again));
    }
    outcome.local_mean_mm = last.local_mean_mm;
    outcome.along_axis = last.along_axis;
    outcome.map_mean_mm = last.map_mean_mm;
}

void computeAnew(const registration::CompareParameters& parameters, const Progress& progress, CompareOutcome& outcome)
{
    if (outcome.drawn)
        takeSizes(features::compareWithShaft(outcome.drawn->part.shaft, outcome.copyScan(), parameters, progress),
                  outcome);
    else
        outcome.result = std::make_shared<const registration::CompareResult>(
            compare(outcome.reference->file.scan, outcome.copyScan(), parameters, progress));
}

}  // namespace

bool isDrawn(const project::Source& source)
{
    if (!source.item.empty()) return true;
    std::ifstream file(source.path, std::ios::binary);
    std::string head(io::headForKind, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, file.gcount())));
    return cad::looksLikeStep(head) ||
           (io::hasKey(io::keysOfHead(head), "segments") && !io::hasKey(io::keysOfHead(head), "command"));
}

CompareOutcome LastComparison::find(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const auto parameters = fromValues<registration::CompareParameters>(state.parameters);
    const project::Source& referenceSource = state.inputs.at(referenceRole);
    const project::Source& copySource = state.inputs.at("copy");
    ScanStore& scans = *stores.of<ScanStore>();
    const Text reading = LT_TEXT("Engine", "Reading the reference");
    CompareOutcome last;
    {
        const std::lock_guard lock(mutex_);
        last = last_;
    }
    CompareOutcome outcome;
    if (isDrawn(referenceSource)) {
        outcome.drawn = drawnShaft(state, last.drawn, stores, progress.part(0, 0.2, reading));
        outcome.reference = outcome.drawn->mesh;
    } else {
        outcome.reference = scans.load(referenceSource, progress.part(0, 0.2, reading));
    }
    outcome.copy = scans.load(copySource, progress.part(0.2, 0.4, LT_TEXT("Engine", "Reading the copy")));
    outcome.synthetic =
        (outcome.drawn ? outcome.drawn->part.synthetic : referenceSource.synthetic) || copySource.synthetic;
    outcome.inputs = {outcome.reference->inputs.front(), outcome.copy->inputs.front()};
    if (last.result && last.reference == outcome.reference && last.copy == outcome.copy &&
        sameButLimits(last, parameters)) {
        judgeAgain(last, parameters, progress.part(0.4, 1), outcome);
    } else {
        computeAnew(parameters, progress.part(0.4, 0.9), outcome);
        addLocalMeans(outcome, progress.part(0.9, 1, LT_TEXT("Engine", "Averaging the deviation locally")));
    }
    const Notes& of_reference = outcome.drawn ? outcome.drawn->part.notes : outcome.reference->file.notes;
    for (const Notes* notes : {&outcome.result->notes, &of_reference, &outcome.copy->file.notes})
        outcome.notes.insert(outcome.notes.end(), notes->begin(), notes->end());
    const std::lock_guard lock(mutex_);
    last_ = outcome;
    return outcome;
}

ComparePlace placeOfPoint(const CompareOutcome& outcome, std::size_t point, bool of_reference)
{
    const registration::CompareResult& result = *outcome.result;
    ComparePlace place;
    if (of_reference) {
        place.reference_mm = outcome.reference->file.scan.points_mm[point];
    } else {
        place.reference_mm = result.alignment.reference_T_copy * outcome.copyScan().points_mm[point];
        place.point = point;
        if (result.used[point]) place.deviation_mm = result.deviation_mm[point];
        if (outcome.local_mean_mm && !std::isnan((*outcome.local_mean_mm)[point]))
            place.local_mean_mm = (*outcome.local_mean_mm)[point];
    }
    fillAxisPlace(outcome, place);
    return place;
}

ComparePlace placeOnMesh(const CompareOutcome& outcome, const scene::PickedPlace& surface, bool of_reference)
{
    const registration::CompareResult& result = *outcome.result;
    const Scan& mesh = of_reference ? outcome.reference->file.scan : outcome.copyScan();
    Eigen::Vector3d mesh_mm = Eigen::Vector3d::Zero();
    double deviation_mm = 0;
    bool used = !of_reference;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t corner = surface.corners[i];
        const double weight = surface.weights[static_cast<Eigen::Index>(i)];
        mesh_mm += weight * mesh.points_mm[corner];
        if (of_reference) continue;
        used = used && result.used[corner];
        deviation_mm += weight * static_cast<double>(result.deviation_mm[corner]);
    }
    ComparePlace place;
    place.reference_mm = of_reference ? mesh_mm : result.alignment.reference_T_copy * mesh_mm;
    if (!of_reference) place.surface = surface;
    if (used) place.deviation_mm = deviation_mm;
    fillAxisPlace(outcome, place);
    return place;
}

std::vector<std::vector<Eigen::Vector3d>> outlineOf(const registration::CompareResult& result)
{
    constexpr int ringCorners = 96;
    constexpr int along = 12;
    std::vector<std::vector<Eigen::Vector3d>> lines;
    if (!result.windows || !result.axis_T_reference) return lines;
    const Eigen::Isometry3d reference_T_axis = result.axis_T_reference->inverse();
    const auto place = [&](double z, double radius, int part, int parts) {
        const double angle = 2 * std::numbers::pi * part / parts;
        return Eigen::Vector3d(reference_T_axis *
                               Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z));
    };
    struct Corner {
        double z, radius;
    };
    std::vector<Corner> meridian;
    for (const registration::MeridianStretch& stretch : result.windows->stretches) {
        if (stretch.is_bore || stretch.isFace()) continue;
        const double half = stretch.slope * (stretch.end_mm - stretch.start_mm) / 2;
        meridian.push_back({stretch.start_mm, stretch.radius_mm - half});
        meridian.push_back({stretch.end_mm, stretch.radius_mm + half});
    }
    for (const Corner& corner : meridian) {
        std::vector<Eigen::Vector3d>& ring = lines.emplace_back();
        for (int i = 0; i <= ringCorners; ++i) ring.push_back(place(corner.z, corner.radius, i, ringCorners));
    }
    for (int i = 0; i < along && !meridian.empty(); ++i) {
        std::vector<Eigen::Vector3d>& line = lines.emplace_back();
        for (const Corner& corner : meridian) line.push_back(place(corner.z, corner.radius, i, along));
    }
    return lines;
}

ComparePlace placeOnSurface(const CompareOutcome& outcome, double z_mm, double angle_deg)
{
    const registration::CompareResult& result = *outcome.result;
    const registration::Meridian& meridian = *result.meridian;
    double radius_mm = 0;
    double nearest = std::numeric_limits<double>::infinity();
    // The radius is undefined at a shoulder: take the nearest defined one.
    for (std::size_t i = 0; i < meridian.z_mm.size(); ++i) {
        const double away = std::abs(meridian.z_mm[i] - z_mm);
        if (away >= nearest || std::isnan(meridian.reference_radius_mm[i])) continue;
        nearest = away;
        radius_mm = meridian.reference_radius_mm[i];
    }
    const double angle = angle_deg * std::numbers::pi / 180;
    ComparePlace place;
    place.reference_mm = result.axis_T_reference->inverse() *
                         Eigen::Vector3d(radius_mm * std::cos(angle), radius_mm * std::sin(angle), z_mm);
    fillAxisPlace(outcome, place);
    return place;
}

}  // namespace lathelier::compare_panel
