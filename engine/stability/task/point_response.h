// The receptance of the point that is cut, as every task of chatter takes it: measured, or made by another task; of a
// shaft on its spindle; of modes; of a plain bar. Of those that are given the first in this order is taken.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/frf.h"
#include "engine/core/json.h"
#include "engine/core/used_value.h"
#include "engine/receptance/modal/uncertain_model.h"
#include "engine/receptance/shaft/shaft_receptance.h"
#include "engine/receptance/shaft/shaft_supports.h"
#include "engine/receptance/usable_lines.h"
#include "engine/stability/modes.h"
#include "engine/task/task.h"

namespace lathelier::stability {

inline constexpr const char* frfRole = "frf";
inline constexpr const char* shaftRole = "shaft";
inline constexpr const char* spindleRole = "spindle";
inline constexpr const char* materialRole = "material";
inline constexpr const char* modeKey = "mode";

/// What of a measured response is used: its lines, or the modes fitted to them, on lines as dense as they need.
enum class ResponseUse { Measured, Model };

/// What is asked beside the files.
struct ResponseQuestion {
    std::vector<Mode> mode;                   ///< stated by hand; several are summed
    std::vector<Interval> range_hz;           ///< of a measured response; at most one; empty: what stands out of noise
    ResponseUse use = ResponseUse::Measured;  ///< of a measured response
    receptance::ReceptanceParameters computing;  ///< of a shaft; its places are those of the tool
    receptance::ShaftSupports supports;          ///< of a shaft, beside its chuck
};

const std::vector<Field<ResponseQuestion>>& fieldsOf(const ResponseQuestion*);

/// Response (an operand), shaft, spindle and material.
std::vector<task::Input> responseInputs();

/// The sources of which one is needed: task::Task::one_of.
task::OneOf responseSources();

/// What belongs to which of them: task::Task::only_with. `bar`: fields that give a bar in place of a shaft.
std::vector<task::OnlyWith> responseRules(const std::vector<std::string>& bar = {});

/// A spindle may be given by itself: then the bar is on it.
struct PointResponse {
    std::shared_ptr<const Frf> frf;              ///< mm/N; never null
    std::string basis;                           ///< equal for equal responses
    UsedValues used;                             ///< the material with its origin
    std::vector<Mode> modes;                     ///< where they are stated
    receptance::UncertainModel model;            ///< of modes that are stated, or of the fit that is used
    std::optional<receptance::UsedLines> lines;  ///< of a measured response
    std::optional<Shaft> shaft;                  ///< where it was computed
    std::vector<double> natural_frequencies_hz;  ///< likewise; empty with a table of receptances
    receptance::ShaftHolding holding;            ///< likewise
};

/// {`range_used_hz`: [first, last], `lines_left_out`} of a measured response, else both null.
void addUsedLines(const PointResponse& response, Json& json);

/// `highest_rpm`: that the lobes of modes have to reach; `bar`: taken where nothing else is given. Errors: those of the
/// readers and of shaftReceptance(); valueNotUnderstood where nothing is given. Throws Cancelled.
PointResponse takeResponse(const project::PanelState& state, const ResponseQuestion& question, double highest_rpm,
                           const std::optional<Shaft>& bar, Stores& stores, task::Sources& sources,
                           const Progress& progress);

}  // namespace lathelier::stability
