#include "widgets/recognise/recognise_outcome.h"

#include <algorithm>
#include <filesystem>

#include "engine/cad/steps_view.h"
#include "engine/drawing/shaft_drawing.h"
#include "engine/features/refit.h"
#include "engine/io/io_codes.h"
#include "widgets/part_common/drawing_words.h"

namespace lathelier::recognise_panel {
namespace {

constexpr std::size_t noRowKind = 3;

/// Kind of the row at z; a shoulder belongs to the following row.
std::size_t kindAt(const features::Recognition& result, double z_mm)
{
    const auto& rows = result.segments;
    const auto after =
        std::upper_bound(rows.begin(), rows.end(), z_mm,
                         [](double z, const features::RecognizedRow& row) { return z < row.z_start_mm; });
    if (after == rows.begin()) return noRowKind;
    const features::RecognizedRow& row = *(after - 1);
    return z_mm <= row.z_end_mm ? static_cast<std::size_t>(row.kind) : noRowKind;
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

/// Steps found by the published method, else the rows converted to its table.
void addSteps(RecogniseOutcome& outcome)
{
    const features::Recognition& result = *outcome.result;
    outcome.steps = result.paper_steps;
    if (result.parameters.method == features::RecognitionMethod::Paper) return;
    outcome.steps = cad::stepsOf(outcome.shaft);
    for (ShaftStep& step : outcome.steps) {
        const Eigen::Vector3d middle =
            result.axis_point_mm + (step.z_start_mm + step.z_end_mm) / 2 * result.axis_direction;
        step.x_mm = middle.x();
        step.y_mm = middle.y();
    }
    outcome.beside = cad::rowsBesideSteps(outcome.shaft);
}

bool sameParameters(const features::RecognitionParameters& a, const features::RecognitionParameters& b)
{
    return toValues(a) == toValues(b);
}

}  // namespace

Shaft measuredRows(const RecogniseOutcome& outcome)
{
    Shaft shaft = outcome.shaft;
    const auto& rows = outcome.result->segments;
    if (rows.size() != shaft.segments.size()) return shaft;  // a gap became a row, or a published table has precedence
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ShaftSegment& row = shaft.segments[i];
        if (row.measured) continue;
        row.measured = MeasuredSize{row.length_mm, row.start_diameter_mm, row.end_diameter_mm, row.arc_radius_mm,
                                    rows[i].uncertainty};
    }
    return shaft;
}

RecoveredFrom recoveredFrom(const RecogniseOutcome& outcome)
{
    const InputFile& scan = outcome.inputs.front();
    return {std::filesystem::path(scan.path).filename().string(), scan.sha256, outcome.result->method_used};
}

drawing::Drawing drawingOf(const RecogniseOutcome& outcome, const Language& language)
{
    drawing::DrawingOptions options;
    options.scan = outcome.inputs.front();
    options.method = outcome.result->method_used;
    options.date = part_common::today();
    options.measured = true;
    for (const auto& bore : outcome.result->bores) {
        auto& known = options.bore_uncertainties.emplace_back();
        for (const features::RecognizedRow& row : bore) known.push_back(row.uncertainty);
    }
    options.decimal_separator = part_common::decimalSeparator(language);
    options.translate = [&language](Text english) { return text(english, language); };
    return drawing::drawShaft(measuredRows(outcome), options);
}

RecogniseOutcome LastRecognition::find(const project::PanelState& state, ScanStore& scans, const Progress& progress)
{
    const auto parameters = fromValues<features::RecognitionParameters>(state.parameters);
    const project::Source& source = state.inputs.at(scanRole);
    RecogniseOutcome outcome;
    outcome.points = scans.load(source, progress.part(0, 0.3, LT_TEXT("Engine", "Reading")));
    outcome.synthetic = source.synthetic || contains(outcome.points->file.notes, notes::syntheticData);
    outcome.inputs = {outcome.points->inputs.front()};

    RecogniseOutcome last;
    {
        const std::lock_guard lock(mutex_);
        last = last_;
    }
    const Scan& scan = outcome.points->file.scan;
    const auto word = [&](const char* key) {
        const Value* const value = lathelier::find(state.parameters, key);
        const auto* const text = value ? std::get_if<std::string>(value) : nullptr;
        return text ? *text : std::string();
    };
    if (word(changesOfKey) == source.path) outcome.changes = features::rowChanges(word(changesKey));
    const bool known =
        last.found && last.points == outcome.points && sameParameters(last.found->parameters, parameters);
    outcome.found = known ? last.found
                          : std::make_shared<const features::Recognition>(features::recognize(
                                scan, parameters, progress.part(0.3, 0.85, LT_TEXT("Engine", "Recognising the rows"))));
    if (known && last.result && last.changes == outcome.changes) {
        outcome.result = last.result;
        outcome.by_kind = last.by_kind;
    } else {
        outcome.result = outcome.changes.empty() ? outcome.found
                                                 : std::make_shared<const features::Recognition>(refit(
                                                       *outcome.found, outcome.changes, progress.part(0.85, 0.95)));
        outcome.by_kind = partedByKind(scan, *outcome.result);
    }
    if (const Value* accepted = lathelier::find(state.parameters, acceptedKey))
        if (const auto* text = std::get_if<std::string>(accepted)) outcome.accepted = features::acceptedSizes(*text);
    outcome.shaft = withAccepted(*outcome.result, outcome.accepted);
    if (outcome.shaft.name.empty())
        outcome.shaft.name = std::filesystem::path(outcome.inputs.front().path).stem().string();
    addSteps(outcome);
    outcome.notes = outcome.result->notes;
    const Notes& of_file = outcome.points->file.notes;
    outcome.notes.insert(outcome.notes.end(), of_file.begin(), of_file.end());
    const std::lock_guard lock(mutex_);
    last_ = outcome;
    return outcome;
}

}  // namespace lathelier::recognise_panel
