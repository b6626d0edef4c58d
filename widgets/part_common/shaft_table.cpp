#include "widgets/part_common/shaft_table.h"

#include "engine/receptance/receptance_codes.h"
#include "widgets/core/form/input_column.h"

namespace lathelier::part_common {

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

bool hasShaft(const project::PanelState& state)
{
    const Value* const segments = find(state.parameters, segmentsKey);
    const Rows* const rows = segments ? std::get_if<Rows>(segments) : nullptr;
    return state.inputs.count(shaftRole) > 0 || (rows && !rows->rows.empty());
}

std::string identity(const project::PanelState& state)
{
    const auto source = state.inputs.find(shaftRole);
    if (source == state.inputs.end()) return {};
    return source->second.item.empty() ? source->second.path : "item " + source->second.item;
}

void setTable(project::PanelState& state, const std::vector<ShaftSegment>& segments)
{
    lathelier::set(state.parameters, segmentsKey, rowsOf(segments));
    takeTable(state);
}

void takeTable(project::PanelState& state)
{
    lathelier::set(state.parameters, segmentsOfKey, identity(state));
}

void openShaft(project::PanelState& state, const std::string& path)
{
    state.inputs[shaftRole] = newSource(QString::fromStdString(path));
    lathelier::set(state.parameters, segmentsKey, Rows{});
}

void noteShaftChanged(const project::Source& source, Notes& notes)
{
    notes.push_back({notes::shaftChanged, {{"source", source.item.empty() ? source.path : source.item}}});
}

bool chooseMaterial(const std::string& choice, Shaft& shaft, Notes& notes)
{
    const auto* const entry = entryOf(receptance::materials(), choice);
    if (!entry) return false;
    shaft.material = entry->value;
    notes.push_back(
        {notes::materialOfLibrary, {{"material", receptance::nameOfMaterial(choice)}, {"source", entry->source}}});
    return true;
}

}  // namespace lathelier::part_common
