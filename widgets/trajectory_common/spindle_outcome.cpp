#include "widgets/trajectory_common/spindle_outcome.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/form/roundness/roundness_plots.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/panel_facts.h"
#include "engine/task/memo.h"
#include "widgets/trajectory_common/spindle_inputs.h"

namespace lathelier::trajectory_common {
namespace {

constexpr int signalPoints = 200000;  // of a channel: single turns have to be seen when zoomed in

/// The answers that several panels show.
struct SpindleAnswers {
    Memo<trajectory::TrajectoryResult> trajectories;
    Memo<std::vector<trajectory::TimeSignal>> time_signals;
    Memo<form::RoundnessResult> profiles;
    Memo<form::SuperimposeResult> superimposed;
};

/// Cache key that distinguishes all values to the last bit.
std::string keyOf(const Values& values)
{
    return toJson(values).dump();
}

/// Content, not path: the same bytes read in the same way.
template <class File>
std::string keyOf(const std::shared_ptr<const Loaded<File>>& file, const project::Source& source)
{
    return source.path + "\n" + file->digest() + "\n" + keyOf(source.import);
}

template <class Item>
void add(std::vector<Item>& items, const std::vector<Item>& more)
{
    items.insert(items.end(), more.begin(), more.end());
}

class Finder {
public:
    Finder(const project::PanelState& state, SpindleStudyKind studyKind, Stores& stores, const Progress& progress)
        : state_(state),
          studyKind_(studyKind),
          stores_(stores),
          progress_(progress),
          answers_(stores.of<SpindleAnswers>())
    {
    }

    SpindleOutcome find()
    {
        const auto profile = state_.inputs.find(profileRole().role);
        const auto trace = state_.inputs.find(traceRole().role);
        const bool ofProfile = studyKind_ == SpindleStudyKind::Roundness && profile != state_.inputs.end();
        if (ofProfile)
            readProfile(profile->second);
        else
            readRecords();
        if (studyKind_ == SpindleStudyKind::Roundness && trace != state_.inputs.end()) superimposeTrace(trace->second);
        if (studyKind_ == SpindleStudyKind::Roundness && outcome_.roundness())
            outcome_.polar = plot::polarPicture(roundnessPolarPlot(*outcome_.roundness(), screenLanguage()));
        if (outcome_.superimposed) outcome_.laid = plot::polarPicture(laidPlot());
        return std::move(outcome_);
    }

private:
    LoadedProfilePtr load(const project::Source& source, const InputRole& role, const Progress& progress)
    {
        if (!source.item.empty()) return profileFromItem(source, role.role, state_);
        return stores_.of<ProfileStore>()->load(source, progress);
    }

    void readProfile(const project::Source& source)
    {
        outcome_.profile =
            load(source, profileRole(), progress_.part(0, 0.3, LT_TEXT("Engine", "Reading the profile")));
        const auto parameters = fromValues<form::RoundnessParameters>(state_.parameters);
        profileKey_ = keyOf(outcome_.profile, source);
        outcome_.profile_roundness = answers_->profiles.find(
            profileKey_ + keyOf(toValues(parameters)), progress_.part(0.3, 0.9, LT_TEXT("Engine", "Roundness")),
            [&](const Progress& progress) { return roundness(outcome_.profile->file.profile, parameters, progress); });
        add(outcome_.inputs, outcome_.profile->inputs);
        outcome_.synthetic = outcome_.synthetic || source.synthetic;
        add(outcome_.notes, outcome_.profile_roundness->notes);
        add(outcome_.notes, outcome_.profile->file.notes);
    }

    void readRecords()
    {
        const std::vector<project::Source> sources = sourcesOf(state_, recordRole());
        const auto store = stores_.of<RecordStore>();
        std::string key;
        const Progress reading = progress_.part(0, 0.4, LT_TEXT("Engine", "Reading the record"));
        const auto count = static_cast<double>(sources.size());
        for (std::size_t i = 0; i < sources.size(); ++i) {
            const double done = static_cast<double>(i);
            outcome_.records.push_back(store->load(sources[i], reading.part(done / count, (done + 1) / count)));
            key += keyOf(outcome_.records.back(), sources[i]);
            add(outcome_.inputs, outcome_.records.back()->inputs);
            outcome_.synthetic = outcome_.synthetic || sources[i].synthetic;
        }
        const auto parameters = fromValues<trajectory::TrajectoryParameters>(state_.parameters);
        profileKey_ = key + keyOf(toValues(parameters));
        if (studyKind_ == SpindleStudyKind::Trajectory) readSignals(parameters);
        try {
            outcome_.trajectory =
                answers_->trajectories.find(profileKey_, progress_.part(0.5, 0.95, LT_TEXT("Engine", "Trajectories")),
                                            [&](const Progress& progress) {
                                                std::vector<const io::ProbeFile*> files;
                                                for (const LoadedRecordPtr& record : outcome_.records)
                                                    files.push_back(&record->file);
                                                return trajectory::trajectory(files, parameters, progress);
                                            });
        } catch (const Error& error) {
            if (studyKind_ != SpindleStudyKind::Trajectory) throw;
            outcome_.problem = error;
        }
        if (outcome_.trajectory) {
            chooseSection();
            add(outcome_.notes, outcome_.trajectory->notes);
        }
        for (const LoadedRecordPtr& record : outcome_.records) add(outcome_.notes, record->file.notes);
    }

    void readSignals(const trajectory::TrajectoryParameters& parameters)
    {
        const auto* record = std::get_if<io::ProbeRecord>(&outcome_.records.front()->file.record);
        if (!record) return;
        outcome_.time_signals = answers_->time_signals.find(
            profileKey_, progress_.part(0.4, 0.5, LT_TEXT("Engine", "Signals")),
            [&](const Progress& progress) { return timeSignals(*record, parameters, signalPoints, progress); });
    }

    void chooseSection()
    {
        const std::vector<trajectory::TrajectorySection>& sections = outcome_.trajectory->sections;
        outcome_.section = outcome_.trajectory->worstSection();
        const Value* wanted = lathelier::find(state_.parameters, sectionKey);
        const auto* number = wanted ? std::get_if<std::int64_t>(wanted) : nullptr;
        if (!number) return;
        const auto chosen = std::find_if(sections.begin(), sections.end(),
                                         [&](const trajectory::TrajectorySection& s) { return s.section == *number; });
        if (chosen != sections.end()) outcome_.section = static_cast<std::size_t>(chosen - sections.begin());
    }

    void superimposeTrace(const project::Source& source)
    {
        outcome_.trace = load(source, traceRole(), progress_.part(0.9, 0.95, LT_TEXT("Engine", "Reading the trace")));
        const trajectory::TrajectorySection* section = outcome_.chosenSection();
        const Profile* first = nullptr;
        if (outcome_.profile)
            first = &outcome_.profile->file.profile;
        else if (section)
            first = &section->image;
        if (!first) return;
        form::SuperimposeParameters parameters;
        parameters.form = fromValues<form::RoundnessParameters>(state_.parameters);
        const std::string place = section ? std::to_string(section->section) : std::string();
        outcome_.superimposed = answers_->superimposed.find(
            profileKey_ + keyOf(toValues(fromValues<form::RoundnessParameters>(state_.parameters))) + place + "\n" +
                keyOf(outcome_.trace, source),
            progress_.part(0.95, 1, LT_TEXT("Engine", "Laying the trace on the profile")),
            [&](const Progress& progress) {
                return superimpose(*first, outcome_.trace->file.profile, parameters, progress);
            });
        add(outcome_.inputs, outcome_.trace->inputs);
        outcome_.synthetic = outcome_.synthetic || source.synthetic;
        add(outcome_.notes, outcome_.superimposed->notes);
        add(outcome_.notes, outcome_.trace->file.notes);
    }

    report::PolarPlot laidPlot() const
    {
        const form::SuperimposeResult& result = *outcome_.superimposed;
        report::PolarPlot plot;
        plot.title = LT_TEXT("Engine", "Laid over each other");
        plot.base_radius_mm = outcome_.roundness()->circles.LSCI.radius_mm;
        const auto add = [&](const report::Caption& name, const std::vector<double>& deviation_um, int colour) {
            report::PolarPlot::Trace trace;
            trace.name = name;
            trace.angle_deg = result.angle_deg;
            trace.deviation_um = deviation_um;
            trace.colour = colour;
            plot.traces.push_back(std::move(trace));
        };
        add(LT_TEXT("Engine", "profile"), result.first_um, 0);
        add(LT_TEXT("Engine", "trace"), result.second_um, 1);
        std::vector<double> difference_um = result.second_um;
        for (std::size_t i = 0; i < difference_um.size(); ++i) difference_um[i] -= result.first_um[i];
        add(LT_TEXT("Engine", "difference"), difference_um, 6);
        return plot;
    }

    const project::PanelState& state_;
    SpindleStudyKind studyKind_;
    Stores& stores_;
    const Progress& progress_;
    std::shared_ptr<SpindleAnswers> answers_;
    SpindleOutcome outcome_;
    std::string profileKey_;
};

}  // namespace

const trajectory::TrajectorySection* SpindleOutcome::chosenSection() const
{
    return trajectory && section ? &trajectory->sections[*section] : nullptr;
}

const form::RoundnessResult* SpindleOutcome::roundness() const
{
    if (profile_roundness) return profile_roundness.get();
    const trajectory::TrajectorySection* chosen = chosenSection();
    return chosen ? &chosen->roundness : nullptr;
}

SpindleOutcome findOutcome(const project::PanelState& state, SpindleStudyKind studyKind, Stores& stores,
                           const Progress& progress)
{
    return Finder(state, studyKind, stores, progress).find();
}

SpindleOutcome outcomeOrThrow(const project::PanelState& state, SpindleStudyKind studyKind, Stores& stores,
                              const Progress& progress)
{
    SpindleOutcome outcome = findOutcome(state, studyKind, stores, progress);
    if (outcome.problem) throw *outcome.problem;
    return outcome;
}

void addSectionSentence(const SpindleOutcome& outcome, report::Document& document)
{
    const trajectory::TrajectorySection* section = outcome.profile ? nullptr : outcome.chosenSection();
    if (!section || document.sections.empty()) return;
    const bool placed = std::isfinite(section->z_mm);
    report::Paragraph words{
        placed ? LT_TEXT("Engine", "Section {section} of {count}, {z_mm} mm from the free end; revolutions: {turns}.")
               : LT_TEXT("Engine", "Section {section} of {count}; revolutions: {turns}."),
        {{"section", std::int64_t{section->section}},
         {"count", static_cast<std::int64_t>(outcome.trajectory->sections.size())},
         {"turns", std::int64_t{section->revolutions_used}}}};
    if (placed) words.values.emplace_back("z_mm", section->z_mm);
    std::vector<report::Block>& blocks = document.sections.front().blocks;
    for (report::Block& block : blocks)
        if (auto* answer = std::get_if<report::Answer>(&block)) answer->used = outcome.trajectory->used;
    blocks.insert(blocks.begin() + (blocks.empty() ? 0 : 1), words);  // below the headline
}

}  // namespace lathelier::trajectory_common
