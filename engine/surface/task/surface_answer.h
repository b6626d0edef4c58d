// Answer, sentences and report of the task surface.
#pragma once

#include <vector>

#include "engine/report/document.h"
#include "engine/surface/task/surface_task.h"

namespace lathelier::surface {

/// The frequency of the marks with U; findings: the other picture, the model, the check of the speed relation. Of an
/// open question only the question. Precondition: a result.
report::Answer answer(const SurfaceOutcome& outcome, const Language& language);

/// What the picture says, as sentences by heading. Precondition: a result.
std::vector<report::Section> words(const SurfaceOutcome& outcome, const Language& language);

/// For an open question only the question. Precondition: a result.
report::Document reportOf(const SurfaceOutcome& outcome, const Language& language);

}  // namespace lathelier::surface
