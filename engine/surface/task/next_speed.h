// "What speed next": speeds with whole waves in a revolution by the marks alone, and the best of each pocket by a
// model.
#pragma once

#include <optional>

#include "engine/core/frf.h"
#include "engine/report/answer.h"
#include "engine/report/document.h"
#include "engine/stability/marks_item.h"
#include "engine/stability/speed_choice.h"

namespace lathelier::surface {

struct SurfaceOutcome;

/// The speed to choose in place of that of the cut, by the exact relation: the model's response is moved along the
/// frequencies until it chatters where the marks say. Nothing where no speed is stable.
std::optional<stability::SpeedResult> nextSpeed(Frf response, const stability::SurfaceMarks& marks,
                                                const stability::ModelCheck& check);

/// The speeds about that of the cut, with the best of each pocket where there is a model. No rows without a frequency.
/// Precondition: a result.
report::Table nextSpeedTable(const SurfaceOutcome& outcome);

/// "Speed next: 1979 rpm …"; nothing without a model that agrees.
std::optional<report::Finding> nextSpeedFinding(const SurfaceOutcome& outcome, const Language& language);

}  // namespace lathelier::surface
