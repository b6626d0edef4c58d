#include "widgets/trajectory_common/spindle_picture.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/form/roundness/roundness_plots.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/panel_facts.h"
#include "widgets/core/task/memo.h"
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

/// A text that tells apart all values, to the last bit.
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
    Finder(const project::PanelState& state, SpindleWant want, Stores& stores, const Progress& progress)
        : state_(state), want_(want), stores_(stores), progress_(progress), answers_(stores.of<SpindleAnswers>())
    {
    }

    SpindlePicture find()
    {
        const auto profile = state_.inputs.find(profileRole().role);
        const auto trace = state_.inputs.find(traceRole().role);
        const bool ofProfile = want_ == SpindleWant::Roundness && profile != state_.inputs.end();
        if (ofProfile)
            readProfile(profile->second);
        else
            readRecords();
        if (want_ == SpindleWant::Roundness && trace != state_.inputs.end()) layOver(trace->second);
        if (want_ == SpindleWant::Roundness && picture_.roundness())
            picture_.polar = plot::polarPicture(roundnessPolarPlot(*picture_.roundness(), screenLanguage()));
        if (picture_.superimposed) picture_.laid = plot::polarPicture(laidPlot());
        return std::move(picture_);
    }

private:
    LoadedProfilePtr load(const project::Source& source, const InputRole& role, const Progress& progress)
    {
        if (!source.item.empty()) return profileFromItem(source, role.role, state_);
        return stores_.of<ProfileStore>()->load(source, progress);
    }

    void readProfile(const project::Source& source)
    {
        picture_.profile =
            load(source, profileRole(), progress_.part(0, 0.3, LT_TEXT("Engine", "Reading the profile")));
        const auto parameters = fromValues<form::RoundnessParameters>(state_.parameters);
        profileKey_ = keyOf(picture_.profile, source);
        picture_.profileRoundness = answers_->profiles.find(
            profileKey_ + keyOf(toValues(parameters)), progress_.part(0.3, 0.9, LT_TEXT("Engine", "Roundness")),
            [&](const Progress& progress) { return roundness(picture_.profile->file.profile, parameters, progress); });
        add(picture_.inputs, picture_.profile->inputs);
        picture_.synthetic = picture_.synthetic || source.synthetic;
        add(picture_.notes, picture_.profileRoundness->notes);
        add(picture_.notes, picture_.profile->file.notes);
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
            picture_.records.push_back(store->load(sources[i], reading.part(done / count, (done + 1) / count)));
            key += keyOf(picture_.records.back(), sources[i]);
            add(picture_.inputs, picture_.records.back()->inputs);
            picture_.synthetic = picture_.synthetic || sources[i].synthetic;
        }
        const auto parameters = fromValues<trajectory::TrajectoryParameters>(state_.parameters);
        profileKey_ = key + keyOf(toValues(parameters));
        if (want_ == SpindleWant::Trajectory) readSignals(parameters);
        try {
            picture_.trajectory =
                answers_->trajectories.find(profileKey_, progress_.part(0.5, 0.95, LT_TEXT("Engine", "Trajectories")),
                                            [&](const Progress& progress) {
                                                std::vector<const io::ProbeFile*> files;
                                                for (const LoadedRecordPtr& record : picture_.records)
                                                    files.push_back(&record->file);
                                                return trajectory::trajectory(files, parameters, progress);
                                            });
        } catch (const Error& error) {
            if (want_ != SpindleWant::Trajectory) throw;
            picture_.problem = error;
        }
        if (picture_.trajectory) {
            chooseSection();
            add(picture_.notes, picture_.trajectory->notes);
        }
        for (const LoadedRecordPtr& record : picture_.records) add(picture_.notes, record->file.notes);
    }

    void readSignals(const trajectory::TrajectoryParameters& parameters)
    {
        const auto* record = std::get_if<io::ProbeRecord>(&picture_.records.front()->file.record);
        if (!record) return;
        picture_.time_signals = answers_->time_signals.find(
            profileKey_, progress_.part(0.4, 0.5, LT_TEXT("Engine", "Signals")),
            [&](const Progress& progress) { return timeSignals(*record, parameters, signalPoints, progress); });
    }

    void chooseSection()
    {
        const std::vector<trajectory::TrajectorySection>& sections = picture_.trajectory->sections;
        picture_.section = picture_.trajectory->worstSection();
        const Value* wanted = lathelier::find(state_.parameters, sectionKey);
        const auto* number = wanted ? std::get_if<std::int64_t>(wanted) : nullptr;
        if (!number) return;
        const auto chosen = std::find_if(sections.begin(), sections.end(),
                                         [&](const trajectory::TrajectorySection& s) { return s.section == *number; });
        if (chosen != sections.end()) picture_.section = static_cast<std::size_t>(chosen - sections.begin());
    }

    void layOver(const project::Source& source)
    {
        picture_.trace = load(source, traceRole(), progress_.part(0.9, 0.95, LT_TEXT("Engine", "Reading the trace")));
        const trajectory::TrajectorySection* section = picture_.chosenSection();
        const Profile* first = nullptr;
        if (picture_.profile)
            first = &picture_.profile->file.profile;
        else if (section)
            first = &section->image;
        if (!first) return;
        form::SuperimposeParameters parameters;
        parameters.form = fromValues<form::RoundnessParameters>(state_.parameters);
        const std::string place = section ? std::to_string(section->section) : std::string();
        picture_.superimposed = answers_->superimposed.find(
            profileKey_ + keyOf(toValues(fromValues<form::RoundnessParameters>(state_.parameters))) + place + "\n" +
                keyOf(picture_.trace, source),
            progress_.part(0.95, 1, LT_TEXT("Engine", "Laying the trace on the profile")),
            [&](const Progress& progress) {
                return superimpose(*first, picture_.trace->file.profile, parameters, progress);
            });
        add(picture_.inputs, picture_.trace->inputs);
        picture_.synthetic = picture_.synthetic || source.synthetic;
        add(picture_.notes, picture_.superimposed->notes);
        add(picture_.notes, picture_.trace->file.notes);
    }

    report::PolarPlot laidPlot() const
    {
        const form::SuperimposeResult& result = *picture_.superimposed;
        report::PolarPlot plot;
        plot.title = LT_TEXT("Engine", "Laid over each other");
        plot.base_radius_mm = picture_.roundness()->circles.LSCI.radius_mm;
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
    SpindleWant want_;
    Stores& stores_;
    const Progress& progress_;
    std::shared_ptr<SpindleAnswers> answers_;
    SpindlePicture picture_;
    std::string profileKey_;
};

}  // namespace

const trajectory::TrajectorySection* SpindlePicture::chosenSection() const
{
    return trajectory && section ? &trajectory->sections[*section] : nullptr;
}

const form::RoundnessResult* SpindlePicture::roundness() const
{
    if (profileRoundness) return profileRoundness.get();
    const trajectory::TrajectorySection* chosen = chosenSection();
    return chosen ? &chosen->roundness : nullptr;
}

SpindlePicture findPicture(const project::PanelState& state, SpindleWant want, Stores& stores, const Progress& progress)
{
    return Finder(state, want, stores, progress).find();
}

SpindlePicture answeredPicture(const project::PanelState& state, SpindleWant want, Stores& stores,
                               const Progress& progress)
{
    SpindlePicture picture = findPicture(state, want, stores, progress);
    if (picture.problem) throw *picture.problem;
    return picture;
}

void saySection(const SpindlePicture& picture, report::Document& document)
{
    const trajectory::TrajectorySection* section = picture.profile ? nullptr : picture.chosenSection();
    if (!section || document.sections.empty()) return;
    const bool placed = std::isfinite(section->z_mm);
    report::Paragraph words{
        placed ? LT_TEXT("Engine", "Section {section} of {count}, {z_mm} mm from the free end; revolutions: {turns}.")
               : LT_TEXT("Engine", "Section {section} of {count}; revolutions: {turns}."),
        {{"section", std::int64_t{section->section}},
         {"count", static_cast<std::int64_t>(picture.trajectory->sections.size())},
         {"turns", std::int64_t{section->revolutions_used}}}};
    if (placed) words.values.emplace_back("z_mm", section->z_mm);
    std::vector<report::Block>& blocks = document.sections.front().blocks;
    for (report::Block& block : blocks)
        if (auto* answer = std::get_if<report::Answer>(&block)) answer->used = picture.trajectory->used;
    blocks.insert(blocks.begin() + (blocks.empty() ? 0 : 1), words);  // below the headline
}

}  // namespace lathelier::trajectory_common
