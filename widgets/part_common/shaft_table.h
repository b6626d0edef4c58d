// A shaft as an input with a table of segments: a file or an item fills the table; once edited, the table has
// precedence until another input is chosen or the table is emptied.
#pragma once

#include <string>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/project/project.h"
#include "engine/receptance/library.h"
#include "engine/shaft/shaft.h"

namespace lathelier::part_common {

inline constexpr const char* shaftRole = "shaft";            ///< role of the input
inline constexpr const char* segmentsKey = "segments";       ///< key of the table
inline constexpr const char* segmentsOfKey = "segments_of";  ///< key of the identity() of the edited table's input; not
                                                             ///< in the form

/// Captions of both parameters.
Label segmentsLabel();
Label segmentsOfLabel();

/// The segments as the value of the table.
Value rowsOf(const std::vector<ShaftSegment>& segments);

/// Whether there is an input or a table.
bool hasShaft(const project::PanelState& state);

/// Identity of the input of the shaft; empty without one.
std::string identity(const project::PanelState& state);

/// Stores the segments in the table, assigned to the present input.
void setTable(project::PanelState& state, const std::vector<ShaftSegment>& segments);

/// Assigns a table edited by hand to the present input.
void takeTable(project::PanelState& state);

/// Clears the table when a file is opened, which it would override.
void openShaft(project::PanelState& state, const std::string& path);

/// Replaces the segments read by `take` by the table where it has precedence; the source need not be readable then.
/// Returns whether it has precedence; the note shaftChanged where it differs. Errors of `take`.
template <class Take>
bool chooseSegments(const std::vector<ShaftSegment>& table, const std::string& table_of,
                    const project::PanelState& state, Shaft& shaft, Notes& notes, const Take& take);

/// The material of the library where one is chosen by its key, with the note materialOfLibrary.
bool chooseMaterial(const std::string& choice, Shaft& shaft, Notes& notes);

/// Adds shaftChanged with the name of the source.
void noteShaftChanged(const project::Source& source, Notes& notes);

template <class Take>
bool chooseSegments(const std::vector<ShaftSegment>& table, const std::string& table_of,
                    const project::PanelState& state, Shaft& shaft, Notes& notes, const Take& take)
{
    const bool rules = !table.empty() && table_of == identity(state);
    const auto source = state.inputs.find(shaftRole);
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

}  // namespace lathelier::part_common
