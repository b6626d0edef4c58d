// What the panel "Surface" says: the answer, the page of sentences, the report.
#pragma once

#include <vector>

#include "engine/report/document.h"
#include "widgets/surface/surface_picture.h"

namespace lathelier::surface_panel {

/// The frequency of the marks with U; findings: the other picture, the model, the referee. Precondition: a result.
report::Answer answerOf(const SurfacePicture& picture, const Language& language);

/// The sentences of the page "What the picture says", by heading. Precondition: a result.
std::vector<report::Section> words(const SurfacePicture& picture, const Language& language);

/// Throws what the evaluation refused. Of an open question: the question.
report::Document reportOf(const SurfacePicture& picture, const Language& language);

}  // namespace lathelier::surface_panel
