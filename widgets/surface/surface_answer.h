// Answer, sentences and report of the panel Surface.
#pragma once

#include <vector>

#include "engine/report/document.h"
#include "widgets/surface/surface_outcome.h"

namespace lathelier::surface_panel {

/// The frequency of the marks with U; findings: the other picture, the model, the check of the speed relation.
/// Precondition: a result.
report::Answer answerOf(const SurfaceOutcome& outcome, const Language& language);

/// The sentences of the page "What the picture says", by heading. Precondition: a result.
std::vector<report::Section> words(const SurfaceOutcome& outcome, const Language& language);

/// Throws the error of the evaluation. For an open question only the question.
report::Document reportOf(const SurfaceOutcome& outcome, const Language& language);

}  // namespace lathelier::surface_panel
