#include "widgets/trajectory_common/spindle_inputs.h"

#include "engine/io/probe_reader.h"
#include "engine/io/profile_reader.h"
#include "widgets/core/input_column.h"
#include "widgets/trajectory_common/spindle_files.h"

namespace lathelier {
namespace {

FileKind recordFiles()
{
    return {LT_TEXT("Engine", "Probe records"), "*.csv *.txt *.tsv *.dat *.par *.DAT *.PAR"};
}

FileKind profileFiles()
{
    return {LT_TEXT("Engine", "Profiles"), "*.csv *.txt *.tsv *.xy *.asc *.dat"};
}

}  // namespace

const InputRole& recordRole()
{
    static const InputRole role = [] {
        InputRole result;
        result.role = "record";
        result.label = LT_TEXT("Engine", "Probe record");
        result.hint = LT_TEXT("Engine", "One record of all sections, or one for each: CSV or L-Graph");
        result.required = false;
        result.several = true;
        result.reading = infos<RecorderOptions>();
        result.readingDefaults = toValues(RecorderOptions{});
        result.kind = recordFiles();
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
        result.reading = infos<ProfileOptions>();
        result.readingDefaults = toValues(ProfileOptions{});
        result.kind = profileFiles();
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

FileKind spindleFiles()
{
    return {LT_TEXT("Engine", "Probe records and profiles"), "*.csv *.txt *.tsv *.xy *.asc *.dat *.par *.DAT *.PAR"};
}

bool hasRecord(const PanelState& state)
{
    return state.inputs.count(recordRole().role) > 0;
}

bool hasProfile(const PanelState& state)
{
    return state.inputs.count(profileRole().role) > 0;
}

void assignSpindleFiles(PanelState& state, const QStringList& paths, bool profiles)
{
    std::vector<std::string> given;
    for (const QString& path : counted(paths)) given.push_back(path.toStdString());
    std::vector<Source> records, others;
    for (const std::string& path : withoutPartners(given)) {
        const Source source = newSource(QString::fromStdString(path));
        (!profiles || isProbeRecord(source.path) ? records : others).push_back(source);
    }
    if (!records.empty()) {
        setSources(state, recordRole(), records);
        if (others.empty()) {  // what is dropped is what is meant: an earlier profile would hide it
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

}  // namespace lathelier
