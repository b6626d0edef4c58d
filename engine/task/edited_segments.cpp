#include "engine/task/edited_segments.h"

#include "engine/task/inputs.h"
#include "engine/task/task_codes.h"

namespace lathelier::task {

Label segmentsLabel()
{
    return {
        LT_TEXT("Engine", "Segments"),
        LT_TEXT("Engine",
                "From the free end toward the chuck. A file fills the table; once it is changed, the table rules.")};
}

Label segmentsOfLabel()
{
    return {LT_TEXT("Engine", "Segments changed from"),
            LT_TEXT("Engine", "The input that the table was changed from.")};
}

Value rowsOf(const std::vector<ShaftSegment>& segments)
{
    Rows rows;
    rows.rows.reserve(segments.size());
    for (const ShaftSegment& segment : segments) rows.rows.push_back({toValues(segment)});
    return rows;
}

bool hasShaft(const project::PanelState& state, const std::string& role)
{
    const Value* const segments = find(state.parameters, segmentsKey);
    const Rows* const rows = segments ? std::get_if<Rows>(segments) : nullptr;
    return state.inputs.count(role) > 0 || (rows && !rows->rows.empty());
}

std::string identity(const project::PanelState& state, const std::string& role)
{
    const auto source = state.inputs.find(role);
    if (source == state.inputs.end()) return {};
    return source->second.item.empty() ? source->second.path : "item " + source->second.item;
}

void takeTable(project::PanelState& state, const std::string& role)
{
    set(state.parameters, segmentsOfKey, identity(state, role));
}

void setTable(project::PanelState& state, const std::string& role, const std::vector<ShaftSegment>& segments)
{
    set(state.parameters, segmentsKey, rowsOf(segments));
    takeTable(state, role);
}

void noteShaftChanged(const project::Source& source, Notes& notes)
{
    notes.push_back({notes::shaftChanged, {{"source", nameOf(source)}}});
}

}  // namespace lathelier::task
