#include "widgets/deflection_common/deflection_inputs.h"

#include <QCoreApplication>
#include <algorithm>

#include "engine/io/shaft/shaft_kind.h"
#include "engine/receptance/spindle_item.h"
#include "engine/receptance/spindle_kind.h"
#include "engine/shaft/shaft_item.h"
#include "widgets/chatter_common/input_value.h"
#include "widgets/chatter_common/model_inputs.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/deflection_common/turning_files.h"

namespace lathelier::deflection_common {
namespace {

struct TurningFacts {
    Q_DECLARE_TR_FUNCTIONS(lathelier::deflection_common::TurningFacts)
};

std::vector<InputRole> turningRoles()
{
    std::vector<InputRole> roles{
        chatter_common::inputRole(programRole, LT_TEXT("Engine", "Program"),
                                  LT_TEXT("Engine", "The NC program that turns the work."), gcode::programFiles(),
                                  gcode::programItem),
        chatter_common::inputRole(setupRole, LT_TEXT("Engine", "Set-up"),
                                  LT_TEXT("Engine", "Machine, tool and material: SETUP.json."),
                                  deflection::setupFiles(), ""),
        chatter_common::inputRole(chatter_common::shaftRole, LT_TEXT("Engine", "Stock"),
                                  LT_TEXT("Engine",
                                          "In place of the one that the set-up names: a stock file, "
                                          "SHAFT.json, or a shaft of the project."),
                                  io::shaftFiles(), shaftItem),
        chatter_common::inputRole(chatter_common::spindleRole, LT_TEXT("Engine", "Spindle"),
                                  LT_TEXT("Engine",
                                          "In place of the chuck in the set-up: SPINDLE.json, or a spindle of "
                                          "the project."),
                                  receptance::spindleFiles(), receptance::spindleItem)};
    for (std::size_t i = 2; i < roles.size(); ++i) roles[i].required = false;
    return roles;
}

/// Fields of the check of a program alone: without set-up and spindle.
std::vector<InputRole> programRoles()
{
    std::vector<InputRole> roles = turningRoles();
    roles.resize(3);
    roles[1].required = false;
    return roles;
}

std::vector<FieldInfo> fieldsOfKeys(const std::vector<std::string>& keys)
{
    std::vector<FieldInfo> fields;
    const std::vector<FieldInfo> all = infos<DeflectionQuestion>();
    for (const std::string& key : keys)
        for (const FieldInfo& info : all)
            if (info.key == key) {
                fields.push_back(info);
                fields.back().advanced = false;
            }
    return fields;
}

}  // namespace

PanelInputs deflectionInputs(const std::vector<std::string>& unfolded, Text invitation)
{
    PanelInputs inputs;
    inputs.roles = turningRoles();
    inputs.defaults = toValues(DeflectionQuestion{});
    inputs.invitation = invitation;
    inputs.fields = fieldsOfKeys(unfolded);
    for (const FieldInfo& info : infos<DeflectionQuestion>()) {
        const bool is_open = std::find(unfolded.begin(), unfolded.end(), info.key) != unfolded.end();
        if (is_open || info.key == draftsKey) continue;  // drafts come from the editor, not from the form
        inputs.fields.push_back(info);
        inputs.fields.back().advanced = true;
    }
    return inputs;
}

PanelInputs programInputs(const std::vector<std::string>& keys, Text invitation)
{
    PanelInputs inputs;
    inputs.roles = programRoles();
    inputs.defaults = toValues(DeflectionQuestion{});
    inputs.invitation = invitation;
    inputs.fields = fieldsOfKeys(keys);
    return inputs;
}

PanelFacts turningFacts(const char* id, Text title, const char* icon)
{
    PanelFacts facts;
    facts.id = id;
    facts.title = title;
    facts.icon = icon;
    facts.state = "deflection";
    facts.workspaces = {{"deflection", LT_TEXT("Engine", "Deflection"), "deflection", 40}};
    facts.kinds = {&gcode::programFiles(), &deflection::setupFiles()};
    facts.roles = programRoles();
    facts.part_inputs = {programRole};
    facts.item_inputs = {{gcode::programItem, programRole}};
    return facts;
}

PanelFacts deflectionFacts(const char* id, Text title, const char* icon, StudyKind studyKind)
{
    PanelFacts facts = turningFacts(id, title, icon);
    facts.roles = turningRoles();
    facts.report = [studyKind](const project::PanelState& state, Stores& stores, const Language& language,
                               const Progress& progress) {
        return reportOf(deflectionOutcome(state, studyKind, stores, progress), language);
    };
    return facts;
}

void assignTurningFiles(project::PanelState& state, const std::vector<FoundFile>& files)
{
    for (const FoundFile& file : files) {
        const char* role = file.kind == &gcode::programFiles()        ? programRole
                           : file.kind == &deflection::setupFiles()   ? setupRole
                           : file.kind == &receptance::spindleFiles() ? chatter_common::spindleRole
                                                                      : chatter_common::shaftRole;
        state.inputs[role] = newSource(QString::fromStdString(file.path));
    }
}

Worker::Job readingJob(const project::PanelState& state, std::shared_ptr<Stores> stores)
{
    return [state, stores = std::move(stores)](const Progress& progress) -> std::shared_ptr<const void> {
        const Progress part = progress.part(0, 1, LT_TEXT("Engine", "Reading"));
        if (state.inputs.count(programRole) > 0) takenProgram(state, *stores, part);
        if (const auto given = state.inputs.find(setupRole); given != state.inputs.end())
            stores->of<SetupStore>()->load(given->second, part);
        chatter_common::takeShaft(state, *stores, part);
        chatter_common::takeSpindle(state, *stores, part);
        return nullptr;
    };
}

QString understoodTurning(const std::string& role, const project::Source& source, Stores& stores)
{
    if (role == chatter_common::shaftRole || role == chatter_common::spindleRole)
        return chatter_common::understoodModel(role, source, stores);
    if (role == setupRole) {
        const auto loaded = stores.of<SetupStore>()->known(source);
        if (!loaded) return {};
        return understoodText(loaded->file.facts, loaded->file.setup.tailstock ? TurningFacts::tr("chuck and tailstock")
                                                                               : TurningFacts::tr("chuck"));
    }
    const auto loaded = stores.of<ProgramStore>()->known(source);
    if (!loaded) return {};
    return understoodText(loaded->file.facts, TurningFacts::tr("%L1 blocks").arg(loaded->file.facts.rows));
}

}  // namespace lathelier::deflection_common
