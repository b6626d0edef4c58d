// A shaft as an input with a table of segments: a file or an item fills the table; once edited, the table has
// precedence until another input is chosen or the table is emptied.
#pragma once

#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/project/project.h"
#include "engine/shaft/shaft.h"

namespace lathelier::task {

inline constexpr const char* segmentsKey = "segments";       ///< key of the table
inline constexpr const char* segmentsOfKey = "segments_of";  ///< key of the identity() of the edited table's input

/// Captions of both parameters.
Label segmentsLabel();
Label segmentsOfLabel();

/// The segments as the value of the table.
Value rowsOf(const std::vector<ShaftSegment>& segments);

/// Whether there is an input `role` or a table.
bool hasShaft(const project::PanelState& state, const std::string& role);

/// Identity of the input; empty without one.
std::string identity(const project::PanelState& state, const std::string& role);

/// Assigns a table edited by hand to the present input.
void takeTable(project::PanelState& state, const std::string& role);

/// Stores the segments in the table, assigned to the present input.
void setTable(project::PanelState& state, const std::string& role, const std::vector<ShaftSegment>& segments);

/// Adds shaftChanged with the name of the source.
void noteShaftChanged(const project::Source& source, Notes& notes);

/// Replaces the segments read by `take` by the table where it has precedence; the source need not be readable then.
/// Returns whether it has precedence; the note shaftChanged where it differs. Errors of `take`.
template <class Take>
bool chooseSegments(const std::vector<ShaftSegment>& table, const std::string& table_of,
                    const project::PanelState& state, const std::string& role, Shaft& shaft, Notes& notes,
                    const Take& take)
{
    const bool rules = !table.empty() && table_of == identity(state, role);
    const auto source = state.inputs.find(role);
    if (source != state.inputs.end()) {
        try {
            take(source->second);
        } catch (const Error&) {
            if (!rules) throw;
        }
        if (rules && shaft.segments != table) noteShaftChanged(source->second, notes);
    }
    if (rules || shaft.segments.empty()) shaft.segments = table;
    return rules;
}

}  // namespace lathelier::task
