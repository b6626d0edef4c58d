// A shaft as an input of a panel: a file or an item fills the table of segments; once the table is changed it rules
// until another input is chosen or the table is emptied. What panels with such a table share.
#pragma once

#include <string>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/shaft.h"
#include "engine/project/project.h"
#include "widgets/chatter_common/libraries.h"

namespace lathelier::part_common {

inline constexpr const char* shaftRole = "shaft";            ///< of the input
inline constexpr const char* segmentsKey = "segments";       ///< of the table
inline constexpr const char* segmentsOfKey = "segments_of";  ///< identity() of the input it was changed from; no form

/// Captions of both parameters.
Label segmentsLabel();
Label segmentsOfLabel();

/// The segments as the value of the table.
Value rowsOf(const std::vector<ShaftSegment>& segments);

/// Is there an input or a table?
bool hasShaft(const project::PanelState& state);

/// What tells the input of the shaft from another one; empty without one.
std::string identity(const project::PanelState& state);

/// Puts the segments into the table, changed from the input that is there now.
void setTable(project::PanelState& state, const std::vector<ShaftSegment>& segments);

/// A table changed by hand is of the input that is there now.
void takeTable(project::PanelState& state);

/// A file that is opened is what is meant: an earlier table would hide it.
void openShaft(project::PanelState& state, const std::string& path);

/// Puts the table in place of what `take` reads into the shaft, where it rules; there the source need not be readable
/// any more. Gives whether it rules; the note shaftChanged where it says something else. Errors of `take`.
template <class Take>
bool chooseSegments(const std::vector<ShaftSegment>& table, const std::string& table_of,
                    const project::PanelState& state, Shaft& shaft, Notes& notes, const Take& take);

/// The material of the library where it was chosen, with the note materialOfLibrary.
bool chooseMaterial(chatter_common::MaterialChoice choice, Shaft& shaft, Notes& notes);

/// Adds shaftChanged with the name of the source.
void sayChanged(const project::Source& source, Notes& notes);

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
        if (rules && shaft.segments != table) sayChanged(source->second, notes);
    }
    if (rules || shaft.segments.empty()) shaft.segments = table;
    return rules;
}

}  // namespace lathelier::part_common
