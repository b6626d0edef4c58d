#include "widgets/trajectory_common/spindle_panel.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <map>

#include "engine/core/units.h"
#include "engine/io/profile/profile_input.h"
#include "engine/trajectory/task/roundness_task.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"

namespace lathelier::trajectory_common {
namespace {

/// The words of the base, which is a template.
struct SpindlePanelWords {
    Q_DECLARE_TR_FUNCTIONS(lathelier::trajectory_common::SpindlePanel)
};

double numberOf(const io::FileFacts& facts, const char* name)
{
    const Value* value = find(facts.details, name);
    if (!value) return notANumber;
    if (const auto* number = std::get_if<double>(value)) return *number;
    if (const auto* count = std::get_if<std::int64_t>(value)) return static_cast<double>(*count);
    return notANumber;
}

void assign(project::PanelState& state, const char* role, const std::vector<project::Source>& sources)
{
    InputRole files;
    files.role = role;
    files.several = true;
    setSources(state, files, sources);
}

QString understoodRecord(const io::ProbeFile& file)
{
    QStringList amount;
    if (const auto* averages = std::get_if<io::AveragedRecord>(&file.record)) {
        amount << SpindlePanelWords::tr("averages of %L1 sections").arg(averages->sections.size());
    } else {
        const auto& record = std::get<io::ProbeRecord>(file.record);
        amount << SpindlePanelWords::tr("%L1 channels").arg(record.channels.size())
               << SpindlePanelWords::tr("%L1 frames").arg(record.frames());
        const double duration_s = numberOf(file.facts, "duration_s");
        if (std::isfinite(duration_s)) amount << SpindlePanelWords::tr("%1 s").arg(screenNumber(duration_s, 2));
        if (std::isfinite(record.rate_hz))
            amount << SpindlePanelWords::tr("%1 kHz").arg(screenNumber(record.rate_hz / 1000, 2));
    }
    return understoodText(file.facts, amount.join(QStringLiteral(" · ")));
}

}  // namespace

PanelFacts spindleFacts(PanelFacts facts)
{
    facts.state = "roundness";
    if (!facts.missing) facts.missing = missingOf(facts.roles);
    // The files of the shared state may be those of another panel alone.
    facts.has_work = [missing = facts.missing](const project::PanelState& state) { return missing(state).empty(); };
    return facts;
}

PanelInputs spindleInputs(const task::Task& task, const std::vector<InputRole>& roles,
                          const std::vector<std::string>& plain, const std::vector<std::string>& folded,
                          Text invitation)
{
    std::vector<std::string> keys = plain;
    keys.insert(keys.end(), folded.begin(), folded.end());
    PanelInputs inputs = inputsOf(task, {}, keys, false, invitation);
    inputs.roles = roles;
    for (std::size_t i = plain.size(); i < inputs.fields.size(); ++i) inputs.fields[i].advanced = true;
    return inputs;
}

void assignSpindleFiles(project::PanelState& state, const std::vector<FoundFile>& files, bool profiles)
{
    QStringList given;
    std::map<QString, const io::FileKind*> kinds;
    for (const FoundFile& file : files) {
        given << QString::fromStdString(file.path);
        kinds[given.back()] = file.kind;
    }
    std::vector<std::string> paths;
    for (const QString& path : counted(given)) paths.push_back(path.toStdString());
    std::vector<project::Source> records, others;
    for (const std::string& path : io::probeRecordFiles().counted_once(paths)) {
        const QString name = QString::fromStdString(path);
        (!profiles || kinds[name] == &io::probeRecordFiles() ? records : others).push_back(newSource(name));
    }
    if (!records.empty()) {
        assign(state, trajectory::recordRole, records);
        if (others.empty()) {  // removes an earlier profile, which would have precedence over the dropped file
            assign(state, trajectory::profileRole, {});
            assign(state, trajectory::traceRole, {});
        } else {
            assign(state, trajectory::traceRole, {others.front()});
        }
        return;
    }
    if (others.empty()) return;
    assign(state, trajectory::profileRole, {others.front()});
    if (others.size() > 1) assign(state, trajectory::traceRole, {others[1]});
}

QString understoodSpindle(const std::string& role, const project::Source& source, Stores& stores)
{
    if (role == trajectory::recordRole) {
        const auto record = stores.of<task::CacheOf<io::ProbeInput>>()->known(source);
        return record ? understoodRecord(record->file) : QString();
    }
    const auto profile = stores.of<task::CacheOf<io::ProfileInput>>()->known(source);
    if (!profile) return {};
    return understoodText(profile->file.facts,
                          SpindlePanelWords::tr("%L1 points").arg(profile->file.profile.points_mm.size()));
}

QString chooseSectionStep(std::optional<int> section)
{
    return section ? SpindlePanelWords::tr("Choose section %1").arg(*section)
                   : SpindlePanelWords::tr("Choose the worst section");
}

bool isSectionChosen(const project::PanelState& state)
{
    const Value* const section = find(state.parameters, trajectory::sectionKey);
    return section && std::holds_alternative<std::int64_t>(*section);
}

}  // namespace lathelier::trajectory_common
