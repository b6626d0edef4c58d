// The receptance of the point that is cut, as every task of chatter takes it: measured, or made by another task; of a
// shaft on its spindle; of modes; of a plain bar. Of those that are given the first in this order is taken.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/frf.h"
#include "engine/core/used_value.h"
#include "engine/receptance/shaft_receptance.h"
#include "engine/stability/modes.h"
#include "engine/task/task.h"

namespace lathelier::stability {

inline constexpr const char* frfRole = "frf";
inline constexpr const char* shaftRole = "shaft";
inline constexpr const char* spindleRole = "spindle";
inline constexpr const char* materialRole = "material";
inline constexpr const char* modeKey = "mode";

/// What is asked beside the files.
struct ResponseQuestion {
    std::vector<Mode> mode;                      ///< stated by hand; several are summed
    receptance::ReceptanceParameters computing;  ///< of a shaft; its places are those of the tool
};

const std::vector<Field<ResponseQuestion>>& fieldsOf(const ResponseQuestion*);

/// Response (an operand), shaft, spindle and material.
std::vector<task::Input> responseInputs();

/// The sources of which one is needed: task::Task::one_of.
task::OneOf responseSources();

/// A spindle may be given by itself: then the bar is on it.
struct PointResponse {
    std::shared_ptr<const Frf> frf;                        ///< mm/N; never null
    std::string basis;                                     ///< equal for equal responses
    UsedValues used;                                       ///< the material with its origin
    std::vector<Mode> modes;                               ///< where they are stated
    std::optional<Shaft> shaft;                            ///< where it was computed
    std::vector<double> natural_frequencies_hz;            ///< likewise; empty with a table of receptances
    std::optional<receptance::SpindleReceptance> spindle;  ///< likewise; none: free
};

/// `highest_rpm`: that the lobes of modes have to reach; `bar`: taken where nothing else is given. Errors: those of the
/// readers and of shaftReceptance(); valueNotUnderstood where nothing is given. Throws Cancelled.
PointResponse takeResponse(const project::PanelState& state, const ResponseQuestion& question, double highest_rpm,
                           const std::optional<Shaft>& bar, Stores& stores, task::Sources& sources,
                           const Progress& progress);

}  // namespace lathelier::stability
