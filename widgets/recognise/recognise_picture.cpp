#include "widgets/recognise/recognise_picture.h"

#include <algorithm>
#include <filesystem>

#include "engine/cad/steps_view.h"
#include "engine/drawing/shaft_drawing.h"
#include "engine/features/refit.h"
#include "engine/io/io_codes.h"
#include "widgets/part_common/drawing_words.h"

namespace lathelier::recognise_panel {
namespace {

constexpr std::size_t kOnNoRow = 3;

/// Of a place along the axis; a shoulder belongs to the row after it.
std::size_t kindAt(const features::Recognition& result, double z_mm)
{
    const auto& rows = result.segments;
    const auto after =
        std::upper_bound(rows.begin(), rows.end(), z_mm,
                         [](double z, const features::RecognizedRow& row) { return z < row.z_start_mm; });
    if (after == rows.begin()) return kOnNoRow;
    const features::RecognizedRow& row = *(after - 1);
    return z_mm <= row.z_end_mm ? static_cast<std::size_t>(row.kind) : kOnNoRow;
}

ScanByKind partedByKind(const Scan& scan, const features::Recognition& result)
{
    std::array<std::shared_ptr<Scan>, 4> parts;
    for (auto& part : parts) part = std::make_shared<Scan>();
    const auto kindOf = [&](const Eigen::Vector3d& point) { return kindAt(result, (result.part_T_scan * point).z()); };
    if (scan.isMesh()) {
        for (auto& part : parts) part->points_mm = scan.points_mm;
        for (const auto& triangle : scan.triangles) {
            Eigen::Vector3d middle = Eigen::Vector3d::Zero();
            for (const std::uint32_t corner : triangle) middle += scan.points_mm[corner] / 3;
            parts[kindOf(middle)]->triangles.push_back(triangle);
        }
    } else {
        for (const Eigen::Vector3d& point : scan.points_mm) parts[kindOf(point)]->points_mm.push_back(point);
    }
    ScanByKind result_parts;
    std::copy(parts.begin(), parts.end(), result_parts.begin());
    return result_parts;
}

/// As the published method found them, else the rows in the form of its table.
void addSteps(RecognisePicture& picture)
{
    const features::Recognition& result = *picture.result;
    picture.steps = result.paper_steps;
    if (result.parameters.method == features::RecognitionMethod::Paper) return;
    picture.steps = cad::stepsOf(picture.shaft);
    for (ShaftStep& step : picture.steps) {
        const Eigen::Vector3d middle =
            result.axis_point_mm + (step.z_start_mm + step.z_end_mm) / 2 * result.axis_direction;
        step.x_mm = middle.x();
        step.y_mm = middle.y();
    }
    picture.beside = cad::rowsBesideSteps(picture.shaft);
}

bool sameParameters(const features::RecognitionParameters& a, const features::RecognitionParameters& b)
{
    return toValues(a) == toValues(b);
}

}  // namespace

Shaft measuredRows(const RecognisePicture& picture)
{
    Shaft shaft = picture.shaft;
    const auto& rows = picture.result->segments;
    if (rows.size() != shaft.segments.size()) return shaft;  // a gap became a row, or a published table rules
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ShaftSegment& row = shaft.segments[i];
        if (row.measured) continue;
        row.measured = MeasuredSize{row.length_mm, row.start_diameter_mm, row.end_diameter_mm, row.arc_radius_mm,
                                    rows[i].uncertainty};
    }
    return shaft;
}

RecoveredFrom recoveredFrom(const RecognisePicture& picture)
{
    const InputFile& scan = picture.inputs.front();
    return {std::filesystem::path(scan.path).filename().string(), scan.sha256, picture.result->method_used};
}

drawing::Drawing drawingOf(const RecognisePicture& picture, const Language& language)
{
    drawing::DrawingOptions options;
    options.scan = picture.inputs.front();
    options.method = picture.result->method_used;
    options.date = part_common::today();
    options.measured = true;
    for (const auto& bore : picture.result->bores) {
        auto& known = options.bore_uncertainties.emplace_back();
        for (const features::RecognizedRow& row : bore) known.push_back(row.uncertainty);
    }
    options.decimal_separator = part_common::decimalSeparator(language);
    options.translate = [&language](Text english) { return text(english, language); };
    return drawing::drawShaft(measuredRows(picture), options);
}

RecognisePicture LastRecognition::find(const project::PanelState& state, ScanStore& scans, const Progress& progress)
{
    const auto parameters = fromValues<features::RecognitionParameters>(state.parameters);
    const project::Source& source = state.inputs.at(scanRole);
    RecognisePicture picture;
    picture.points = scans.load(source, progress.part(0, 0.3, LT_TEXT("Engine", "Reading")));
    picture.synthetic = source.synthetic || contains(picture.points->file.notes, notes::syntheticData);
    picture.inputs = {picture.points->inputs.front()};

    RecognisePicture last;
    {
        const std::lock_guard lock(mutex_);
        last = last_;
    }
    const Scan& scan = picture.points->file.scan;
    const auto word = [&](const char* key) {
        const Value* const value = lathelier::find(state.parameters, key);
        const auto* const text = value ? std::get_if<std::string>(value) : nullptr;
        return text ? *text : std::string();
    };
    if (word(changesOfKey) == source.path) picture.changes = features::rowChanges(word(changesKey));
    const bool known =
        last.found && last.points == picture.points && sameParameters(last.found->parameters, parameters);
    picture.found = known ? last.found
                          : std::make_shared<const features::Recognition>(features::recognize(
                                scan, parameters, progress.part(0.3, 0.85, LT_TEXT("Engine", "Recognising the rows"))));
    if (known && last.result && last.changes == picture.changes) {
        picture.result = last.result;
        picture.by_kind = last.by_kind;
    } else {
        picture.result = picture.changes.empty() ? picture.found
                                                 : std::make_shared<const features::Recognition>(refit(
                                                       *picture.found, picture.changes, progress.part(0.85, 0.95)));
        picture.by_kind = partedByKind(scan, *picture.result);
    }
    if (const Value* accepted = lathelier::find(state.parameters, acceptedKey))
        if (const auto* text = std::get_if<std::string>(accepted)) picture.accepted = features::acceptedSizes(*text);
    picture.shaft = withAccepted(*picture.result, picture.accepted);
    if (picture.shaft.name.empty())
        picture.shaft.name = std::filesystem::path(picture.inputs.front().path).stem().string();
    addSteps(picture);
    picture.notes = picture.result->notes;
    const Notes& of_file = picture.points->file.notes;
    picture.notes.insert(picture.notes.end(), of_file.begin(), of_file.end());
    const std::lock_guard lock(mutex_);
    last_ = picture;
    return picture;
}

}  // namespace lathelier::recognise_panel
