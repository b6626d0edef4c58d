#include "engine/trajectory/trajectory.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/form/form_codes.h"
#include "engine/io/text/header_lines.h"
#include "engine/io/text/number.h"
#include "engine/trajectory/longitudinal.h"
#include "engine/trajectory/record_plan.h"
#include "engine/trajectory/section.h"
#include "engine/trajectory/trajectory_codes.h"

namespace lathelier::trajectory {
namespace {

using Records = std::vector<const io::ProbeFile*>;

/// Input of the evaluation of one section.
struct Task {
    const PreparedRecord* raw = nullptr;
    RecordSegment segment;
    const io::AveragedSection* averages = nullptr;
    int averaged_revolutions = 0;
    int number = 0;
    std::string record;
    std::string path;
};

const Values& headerOf(const io::ProbeFile& file)
{
    return std::visit([](const auto& record) -> const Values& { return record.header; }, file.record);
}

std::string pathOf(const io::ProbeFile& file)
{
    if (!file.facts.path.empty()) return file.facts.path;
    return std::visit([](const auto& record) { return record.name; }, file.record);
}

/// The diameter of the parameters, or that of the records, which must agree.
double diameterOf(const Records& records, const TrajectoryParameters& parameters, UsedValues& used)
{
    std::optional<double> first;
    if (parameters.workpiece_diameter_mm)
        return resolve<TrajectoryParameters>(used, "workpiece_diameter_mm", parameters.workpiece_diameter_mm, {}, 0.0);
    for (const io::ProbeFile* file : records) {
        auto stated = io::headerNumber(headerOf(*file), "D_mm");
        if (!stated) stated = io::headerNumber(headerOf(*file), "workpiece_diameter_mm");
        if (!stated || !(*stated > 0)) throw Error(errors::diameterMissing, {{"path", pathOf(*file)}});
        if (first && *first != *stated)
            throw Error(errors::recordsDiffer, {{"path", pathOf(*file)},
                                                {"parameter", LT_TEXT("Engine", "the workpiece's diameter")},
                                                {"first", *first},
                                                {"found", *stated}});
        first = stated;
    }
    return resolve<TrajectoryParameters>(used, "workpiece_diameter_mm", {}, first.value(), 0.0);
}

std::vector<double> parsePlaces(const std::string& typed)
{
    std::vector<double> places;
    // In a list separated by semicolons a comma is the decimal mark.
    const bool semicolons = typed.find(';') != std::string::npos;
    for (std::size_t begin = 0; begin <= typed.size() && !typed.empty();) {
        const std::size_t end = std::min(typed.find(semicolons ? ';' : ',', begin), typed.size());
        std::string part = typed.substr(begin, end - begin);
        std::erase(part, ' ');
        if (semicolons) std::replace(part.begin(), part.end(), ',', '.');
        const auto number = io::wholeNumber(part, '.');
        if (!number || !std::isfinite(*number))
            throw Error(errors::valueNotUnderstood,
                        {{"parameter", "z_mm"},
                         {"found", part},
                         {"expected", LT_TEXT("Engine", "numbers such as 5,10,15 or 5,5;10;15")},
                         {"column", static_cast<std::int64_t>(begin + 1)}});
        places.push_back(*number);
        begin = end + 1;
    }
    return places;
}

/// Notes of a section's roundness that the result does not contain yet, since all sections tend to repeat them. The
/// nominal size is noted once, with the diameter.
void addOnce(Notes& notes, const TrajectorySection& section)
{
    for (const Note& note : section.roundness.notes) {
        if (note.code == notes::sizeNominal || contains(notes, note.code)) continue;
        notes.push_back(note);
        set(notes.back().values, "section", std::int64_t{section.section});
    }
}

void noteLargeDisplacements(const TrajectoryResult& result, const std::vector<Task>& tasks, Notes& notes)
{
    constexpr double largestShare = 0.05;  // largest displacement over diameter without a note
    for (std::size_t probe = 0; probe < 4; ++probe)
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            double largest_um = 0;
            for (const double value : result.sections[i].probes[probe].mean_um)
                largest_um = std::fmax(largest_um, std::abs(value));
            if (largest_um <= largestShare * 1e3 * result.workpiece_diameter_mm) continue;
            notes.push_back(
                {notes::displacementsLarge,
                 {{"path", tasks[i].path}, {"signal", name(static_cast<Probe>(probe))}, {"largest_um", largest_um}}});
            break;
        }
}

/// Notes it once, with the values of the worst section.
void noteFormNotMeasured(TrajectoryResult& result)
{
    const TrajectorySection* worst = nullptr;
    std::int64_t count = 0;
    const auto share = [](const TrajectorySection& section) {
        return headlineDeviation_um(section.roundness) / section.roundness.RONt_expanded_uncertainty_um;
    };
    for (const TrajectorySection& section : result.sections) {
        if (section.form_measured) continue;
        ++count;
        if (!worst || share(section) < share(*worst)) worst = &section;
    }
    if (!worst) return;
    const auto rounded = [](double value) {
        return std::isfinite(value) ? Value(std::round(100 * value) / 100) : Value();
    };
    result.notes.push_back({notes::formNotMeasured,
                            {{"count", count},
                             {"section", std::int64_t{worst->section}},
                             {"RONt_um", rounded(headlineDeviation_um(worst->roundness))},
                             {"expanded_uncertainty_um", rounded(worst->roundness.RONt_expanded_uncertainty_um)},
                             {"synchronous_um", rounded(worst->spindle.synchronous_um)},
                             {"asynchronous_um", rounded(worst->spindle.asynchronous_um)}}});
}

std::vector<Task> plan(const Records& records, std::vector<PreparedRecord>& prepared, TrajectoryResult& result,
                       const Progress& progress)
{
    const TrajectoryParameters& parameters = result.parameters;
    Notes& notes = result.notes;
    if (parameters.feed_mm_rev && (records.size() != 1 || !parameters.z_mm.empty()))
        throw Error(errors::valueNotUnderstood,
                    {{"parameter", "feed_mm_rev"},
                     {"found", *parameters.feed_mm_rev},
                     {"expected", LT_TEXT("Engine", "one continuous record, and no places of its sections")}});
    std::vector<Task> tasks;
    prepared.reserve(records.size());  // tasks point into it
    for (std::size_t i = 0; i < records.size(); ++i) {
        progress.report(static_cast<double>(i) / static_cast<double>(records.size()));
        const std::string path = pathOf(*records[i]);
        if (const auto* averaged = std::get_if<io::AveragedRecord>(&records[i]->record)) {
            const int revolutions =
                static_cast<int>(std::clamp(io::headerNumber(averaged->header, "n_rev").value_or(0), 0.0, 1e9));
            for (const io::AveragedSection& section : averaged->sections) {
                Task task{nullptr, {}, &section, revolutions, section.section, averaged->name, path};
                task.segment.z_mm = section.z_mm;
                tasks.push_back(std::move(task));
            }
            notes.push_back({notes::averagesOnly, {{"path", path}}});
            continue;
        }
        const auto& record = std::get<io::ProbeRecord>(records[i]->record);
        const PreparedRecord& ready = prepared.emplace_back(prepare(record, path, parameters, notes));
        for (const UsedValue& value : ready.used)
            if (!std::count(result.used.begin(), result.used.end(), value)) result.used.push_back(value);
        std::vector<RecordSegment> segments;
        if (const auto segmentation =
                records.size() == 1 ? segmentationOf(record, parameters, notes, result.used) : std::nullopt) {
            segments = segmentRecord(ready, parameters, *segmentation);
        } else {
            segments.push_back(wholeRecord(ready, parameters));
            segments.back().z_mm = io::headerNumber(record.header, "z_mm").value_or(notANumber);
        }
        std::size_t fewest = static_cast<std::size_t>(parameters.revolutions);
        std::int64_t found = 0, used = 0;
        for (RecordSegment& segment : segments) {
            found += segment.found;
            used += static_cast<std::int64_t>(segment.chosen.size());
            fewest = std::min(fewest, segment.chosen.size());
            tasks.push_back({&ready, std::move(segment), nullptr, 0, 0, record.name, path});
        }
        if (used < found)
            notes.push_back({notes::revolutionsUnused, {{"path", path}, {"found", found}, {"used", used}}});
        if (fewest < static_cast<std::size_t>(parameters.revolutions))
            notes.push_back({notes::fewerRevolutions,
                             {{"path", path},
                              {"found", static_cast<std::int64_t>(fewest)},
                              {"asked", std::int64_t{parameters.revolutions}}}});
    }
    const std::vector<double> places = parsePlaces(parameters.z_mm);
    if (!places.empty() && places.size() != tasks.size())
        throw Error(errors::valueNotUnderstood, {{"parameter", "z_mm"},
                                                 {"found", parameters.z_mm},
                                                 {"expected", LT_TEXT("Engine", "one place for each section")},
                                                 {"sections", static_cast<std::int64_t>(tasks.size())}});
    const bool numbered = std::all_of(tasks.begin(), tasks.end(), [](const Task& task) { return task.averages; });
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        if (!places.empty()) tasks[i].segment.z_mm = places[i];
        if (!numbered || records.size() > 1) tasks[i].number = static_cast<int>(i + 1);
    }
    return tasks;
}

TrajectorySection evaluateTask(const Task& task, const TrajectoryResult& result, const Progress& progress)
{
    try {
        TrajectorySection section =
            task.raw ? evaluate(*task.raw, task.segment, result.parameters, result.workpiece_diameter_mm, progress)
                     : evaluate(*task.averages, task.averaged_revolutions, result.parameters,
                                result.workpiece_diameter_mm, progress);
        section.section = task.number;
        section.record = task.record;
        section.image.name = task.record + " #" + std::to_string(task.number);
        section.roundness.name = section.image.name;
        section.z_mm = task.segment.z_mm;
        return section;
    } catch (Error& error) {
        throw error.with("path", task.path).with("section", std::int64_t{task.number});
    }
}

/// Notes of the sections, counted together or once each.
void collectNotes(TrajectoryResult& result, const std::vector<Task>& tasks)
{
    std::int64_t samples = 0, revolutions = 0;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        const TrajectorySection& section = result.sections[i];
        samples += section.samples_rejected;
        if (tasks[i].raw)
            revolutions += static_cast<std::int64_t>(tasks[i].segment.chosen.size()) - section.revolutions_used;
        addOnce(result.notes, section);
    }
    if (samples + revolutions > 0)
        result.notes.push_back({result.parameters.outliers == form::OutlierRule::Hampel ? notes::motionOutliers
                                                                                        : notes::revolutionsIncomplete,
                                {{"path", tasks.front().path},
                                 {"count", revolutions},
                                 {"revolutions", revolutions},
                                 {"samples", samples}}});
    noteFormNotMeasured(result);
    noteLargeDisplacements(result, tasks, result.notes);
    result.notes.push_back({notes::sizeReferenced, {{"diameter_mm", result.workpiece_diameter_mm}}});
    result.notes.push_back({notes::mandrelFloor, {{"form_um", result.mandrel_form_um}}});
}

std::optional<Verdict> worstVerdict(const std::vector<TrajectorySection>& sections)
{
    std::optional<Verdict> worst;
    for (const TrajectorySection& section : sections) {
        const auto verdict = section.roundness.verdict;
        if (!verdict) continue;
        worst = worst ? worse(*worst, *verdict) : *verdict;
    }
    return worst;
}

}  // namespace

std::optional<std::size_t> TrajectoryResult::worstSection() const
{
    if (sections.empty()) return std::nullopt;
    const auto worst =
        std::max_element(sections.begin(), sections.end(), [](const TrajectorySection& a, const TrajectorySection& b) {
            return headlineDeviation_um(a.roundness) < headlineDeviation_um(b.roundness);
        });
    return static_cast<std::size_t>(worst - sections.begin());
}

TrajectoryResult trajectory(const std::vector<const io::ProbeFile*>& records, const TrajectoryParameters& parameters,
                            const Progress& progress)
{
    TrajectoryResult result;
    result.parameters = parameters;
    if (records.empty()) return result;
    result.workpiece_diameter_mm = diameterOf(records, parameters, result.used);
    for (const io::ProbeFile* file : records)
        for (const auto& [key, value] : headerOf(*file))
            if (!find(result.cutting, key)) result.cutting.emplace_back(key, value);

    std::vector<PreparedRecord> prepared;
    const std::vector<Task> tasks =
        plan(records, prepared, result, progress.part(0, 0.2, LT_TEXT("Engine", "Finding revolutions")));

    const Progress evaluating = progress.part(0.2, 0.8, LT_TEXT("Engine", "Evaluating sections"));
    result.sections.resize(tasks.size());
    std::atomic<std::size_t> done = 0;
    parallelFor(tasks.size(), 1, evaluating, [&](std::size_t begin, std::size_t) {
        result.sections[begin] = evaluateTask(tasks[begin], result, evaluating.quiet());
        evaluating.report(static_cast<double>(++done) / static_cast<double>(tasks.size()));
    });
    collectNotes(result, tasks);
    result.longitudinal = longitudinalSection(result.sections, result.notes,
                                              progress.part(0.8, 1, LT_TEXT("Engine", "Longitudinal section")));
    result.verdict = worstVerdict(result.sections);
    progress.report(1);
    return result;
}

TrajectoryResult trajectory(const std::vector<io::ProbeFile>& records, const TrajectoryParameters& parameters,
                            const Progress& progress)
{
    Records pointers;
    for (const io::ProbeFile& file : records) pointers.push_back(&file);
    return trajectory(pointers, parameters, progress);
}

}  // namespace lathelier::trajectory
