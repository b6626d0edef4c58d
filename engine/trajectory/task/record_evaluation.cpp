#include "engine/trajectory/task/record_evaluation.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/task/memo.h"

namespace lathelier::trajectory {
namespace {

struct EvaluatedRecords : Memo<TrajectoryResult> {};

}  // namespace

task::Input recordInput(const char* option)
{
    task::Input input = task::input<io::ProbeInput>(
        recordRole, option, LT_TEXT("Engine", "Probe record"),
        LT_TEXT("Engine", "A probe record (CSV or L-Graph .dat/.par), or one for each section."));
    input.several = true;
    input.is_of_part = true;
    return input;
}

TakenRecords takeRecords(const project::PanelState& state, Stores& stores, task::Sources& sources,
                         const Progress& progress)
{
    TakenRecords records;
    const std::vector<std::string> keys = project::keysOf(state, recordRole);
    const auto count = static_cast<double>(keys.size());
    for (const std::string& key : keys) {
        const auto done = static_cast<double>(records.files.size());
        const Progress reading = progress.part(done / count, (done + 1) / count, LT_TEXT("Engine", "Reading"));
        records.files.push_back(task::takeFile<io::ProbeInput>(state, key, stores, reading, sources));
        const project::Source& source = state.inputs.at(key);
        if (!records.files.back()) task::throwItemNotThere(source.item, io::ProbeInput::item);
        records.key +=
            source.path + "\n" + records.files.back()->digest() + "\n" + lathelier::toJson(source.import).dump() + "\n";
    }
    return records;
}

std::string keyOf(const TakenRecords& records, const TrajectoryParameters& parameters)
{
    return records.key + lathelier::toJson(toValues(parameters)).dump();
}

std::shared_ptr<const TrajectoryResult> evaluate(const TakenRecords& records, const TrajectoryParameters& parameters,
                                                 Stores& stores, const Progress& progress)
{
    return stores.of<EvaluatedRecords>()->find(keyOf(records, parameters), progress, [&](const Progress& part) {
        std::vector<const io::ProbeFile*> files;
        for (const RecordPtr& record : records.files) files.push_back(&record->file);
        return trajectory(files, parameters, part);
    });
}

std::optional<std::size_t> sectionIndex(const TrajectoryResult& result, std::optional<int> number)
{
    const std::vector<TrajectorySection>& sections = result.sections;
    const auto chosen = std::find_if(sections.begin(), sections.end(),
                                     [&](const TrajectorySection& section) { return section.section == number; });
    if (chosen == sections.end()) return result.worstSection();
    return static_cast<std::size_t>(chosen - sections.begin());
}

report::Paragraph sectionSentence(const TrajectoryResult& result, const TrajectorySection& section)
{
    const bool is_placed = std::isfinite(section.z_mm);
    report::Paragraph words{
        is_placed
            ? LT_TEXT("Engine", "Section {section} of {count}, {z_mm} mm from the free end; revolutions: {turns}.")
            : LT_TEXT("Engine", "Section {section} of {count}; revolutions: {turns}."),
        {{"section", std::int64_t{section.section}},
         {"count", static_cast<std::int64_t>(result.sections.size())},
         {"turns", std::int64_t{section.revolutions_used}}}};
    if (is_placed) words.values.emplace_back("z_mm", section.z_mm);
    return words;
}

void addSectionSentence(report::Document& document, const TrajectoryResult& result, const TrajectorySection& section)
{
    if (document.sections.empty()) return;
    std::vector<report::Block>& blocks = document.sections.front().blocks;
    for (report::Block& block : blocks)
        if (auto* const answer = std::get_if<report::Answer>(&block)) answer->used = result.used;
    blocks.insert(blocks.begin() + (blocks.empty() ? 0 : 1), sectionSentence(result, section));
}

}  // namespace lathelier::trajectory
