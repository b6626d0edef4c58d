#include "widgets/trajectory_common/spindle_panel.h"

#include <algorithm>
#include <stdexcept>

#include "engine/core/profile_item.h"
#include "engine/core/units.h"
#include "engine/io/probe/probe_reader.h"
#include "engine/io/profile/profile_reader.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/language.h"
#include "widgets/core/session.h"
#include "widgets/trajectory_common/spindle_inputs.h"

namespace lathelier::trajectory_common {
namespace {

double numberOf(const io::FileFacts& facts, const char* name)
{
    const Value* value = find(facts.details, name);
    if (!value) return notANumber;
    if (const auto* number = std::get_if<double>(value)) return *number;
    if (const auto* count = std::get_if<std::int64_t>(value)) return static_cast<double>(*count);
    return notANumber;
}

}  // namespace

void MarkedAngle::takeBack()
{
    set(before_deg_);
}

void MarkedAngle::set(std::optional<double> angle_deg)
{
    if (angle_deg == angle_deg_) return;
    before_deg_ = angle_deg_;
    angle_deg_ = angle_deg;
    emit changed();
}

PanelFacts spindleFacts(const std::string& id, Text title, const QString& icon, SpindleStudyKind studyKind)
{
    PanelFacts facts;
    facts.id = id;
    facts.title = title;
    facts.icon = icon;
    facts.workspaces = {workspaceOf("roundness")};
    facts.state = spindleState;
    const bool roundness = studyKind == SpindleStudyKind::Roundness;
    facts.kinds = {&io::probeRecordFiles()};
    if (roundness) {
        facts.kinds.push_back(&io::profileFiles());
        facts.item_inputs = {{profileItem, profileRole().role}};
    }
    facts.part_inputs = {"record", "profile"};
    facts.roles = {recordRole()};
    if (roundness) facts.roles = {recordRole(), profileRole(), traceRole()};
    facts.has_work = [roundness](const project::PanelState& state) {
        return hasRecord(state) || (roundness && hasProfile(state));
    };
    facts.missing = [roundness](const project::PanelState& state) {
        std::vector<Text> labels;
        if (!hasRecord(state) && !(roundness && hasProfile(state)))
            labels.push_back(roundness ? LT_TEXT("Engine", "Probe record or profile") : recordRole().label);
        return labels;
    };
    return facts;
}

PanelInputs spindleInputs(const std::vector<const InputRole*>& roles, const std::vector<std::string>& plain,
                          const std::vector<std::string>& advanced, Text invitation)
{
    PanelInputs inputs;
    for (const InputRole* role : roles) inputs.roles.push_back(*role);
    inputs.invitation = invitation;
    inputs.defaults = toValues(form::RoundnessParameters{});
    for (const auto& [name, value] : toValues(trajectory::TrajectoryParameters{}))
        lathelier::set(inputs.defaults, name, value);
    std::vector<FieldInfo> known = infos<trajectory::TrajectoryParameters>();
    for (const FieldInfo& info : infos<form::RoundnessParameters>()) known.push_back(info);
    const auto take = [&](const std::vector<std::string>& keys, bool folded) {
        for (const std::string& key : keys) {
            const auto info =
                std::find_if(known.begin(), known.end(), [&](const FieldInfo& one) { return one.key == key; });
            if (info == known.end()) throw std::logic_error("no such parameter: " + key);
            inputs.fields.push_back(*info);
            inputs.fields.back().advanced = folded;
        }
    };
    take(plain, false);
    take(advanced, true);
    return inputs;
}

SpindlePanel::SpindlePanel(Session& owner, const PanelFacts& facts, const PanelInputs& inputs,
                           SpindleStudyKind studyKind, QWidget* parent)
    : Panel(owner, facts, inputs, parent), studyKind_(studyKind), angle_(owner.stores().of<MarkedAngle>())
{
}

SpindlePanel::Compute SpindlePanel::compute(const project::PanelState& state) const
{
    fromValues<trajectory::TrajectoryParameters>(state.parameters);  // validates ranges before the computation
    bandOf(fromValues<form::RoundnessParameters>(state.parameters));
    return [state, studyKind = studyKind_, stores = session().sharedStores()](const Progress& progress) {
        return findOutcome(state, studyKind, *stores, progress);
    };
}

void SpindlePanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    assignSpindleFiles(state, files, studyKind_ == SpindleStudyKind::Roundness);
}

Worker::Job SpindlePanel::makeReadingJob(const project::PanelState& state) const
{
    return [profiles = session().stores().of<ProfileStore>(),
            state](const Progress& progress) -> std::shared_ptr<const void> {
        for (const InputRole* role : {&profileRole(), &traceRole()})
            for (const project::Source& source : sourcesOf(state, *role))
                if (source.item.empty()) profiles->load(source, progress);
        return nullptr;
    };
}

QString SpindlePanel::understood(const InputRole& role, const project::Source& source) const
{
    if (role.role != recordRole().role) {
        const LoadedProfilePtr loaded = session().stores().of<ProfileStore>()->known(source);
        if (!loaded) return {};
        return understoodText(loaded->file.facts, tr("%L1 points").arg(loaded->file.profile.points_mm.size()));
    }
    const LoadedRecordPtr loaded = session().stores().of<RecordStore>()->known(source);
    if (!loaded) return {};
    const io::FileFacts& facts = loaded->file.facts;
    QStringList amount;
    if (const auto* averages = std::get_if<io::AveragedRecord>(&loaded->file.record)) {
        amount << tr("averages of %L1 sections").arg(averages->sections.size());
    } else {
        const auto& record = std::get<io::ProbeRecord>(loaded->file.record);
        amount << tr("%L1 channels").arg(record.channels.size()) << tr("%L1 frames").arg(record.frames());
        const double duration_s = numberOf(facts, "duration_s");
        if (std::isfinite(duration_s)) amount << tr("%1 s").arg(screenNumber(duration_s, 2));
        if (std::isfinite(record.rate_hz)) amount << tr("%1 kHz").arg(screenNumber(record.rate_hz / 1000, 2));
    }
    return understoodText(facts, amount.join(QStringLiteral(" · ")));
}

void SpindlePanel::chooseSection(std::optional<int> section)
{
    const QString step = section ? tr("Choose section %1").arg(*section) : tr("Choose the worst section");
    setParameter(sectionKey, section ? Value(std::int64_t{*section}) : Value(), step, "roundness/section");
}

bool SpindlePanel::isSectionChosen() const
{
    const Value* section = lathelier::find(state().parameters, sectionKey);
    return section && std::holds_alternative<std::int64_t>(*section);
}

void SpindlePanel::setParameter(const std::string& key, const Value& value, const QString& step,
                                const QString& mergeKey)
{
    editState(
        step, [&](project::PanelState& state) { lathelier::set(state.parameters, key, value); }, mergeKey);
}

}  // namespace lathelier::trajectory_common
