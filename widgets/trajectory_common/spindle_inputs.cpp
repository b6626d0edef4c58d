#include "widgets/trajectory_common/spindle_inputs.h"

#include <map>

#include "engine/core/profile_item.h"
#include "widgets/core/form/input_column.h"

namespace lathelier::trajectory_common {
const InputRole& recordRole()
{
    static const InputRole role = [] {
        InputRole result;
        result.role = "record";
        result.label = LT_TEXT("Engine", "Probe record");
        result.hint = LT_TEXT("Engine", "One record of all sections, or one for each: CSV or L-Graph");
        result.required = false;
        result.several = true;
        result.kinds = {&io::probeRecordFiles()};
        return result;
    }();
    return role;
}

const InputRole& profileRole()
{
    static const InputRole role = [] {
        InputRole result;
        result.role = "profile";
        result.label = LT_TEXT("Engine", "Measured profile");
        result.hint = LT_TEXT("Engine", "x and y, or angle and radius, of one section; goes before the record");
        result.required = false;
        result.kinds = {&io::profileFiles()};
        result.item_kind = profileItem;
        return result;
    }();
    return role;
}

const InputRole& traceRole()
{
    static const InputRole role = [] {
        InputRole result = profileRole();
        result.role = "trace";
        result.label = LT_TEXT("Engine", "Trace to lay over");
        result.hint = LT_TEXT("Engine", "The same section from a roundness instrument, for the difference");
        return result;
    }();
    return role;
}

bool hasRecord(const project::PanelState& state)
{
    return state.inputs.count(recordRole().role) > 0;
}

bool hasProfile(const project::PanelState& state)
{
    return state.inputs.count(profileRole().role) > 0;
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
        setSources(state, recordRole(), records);
        if (others.empty()) {  // removes an earlier profile, which would have precedence over the dropped file
            setSources(state, profileRole(), {});
            setSources(state, traceRole(), {});
        } else {
            setSources(state, traceRole(), {others.front()});
        }
        return;
    }
    if (others.empty()) return;
    setSources(state, profileRole(), {others.front()});
    if (others.size() > 1) setSources(state, traceRole(), {others[1]});
}

}  // namespace lathelier::trajectory_common
