// Photographs of surfaces in words: the answer, the tables, the report.
#pragma once

#include "engine/report/document.h"
#include "engine/surface/surface.h"

namespace lathelier::surface {

/// What one picture says: "Marks of 361.0 Hz (m = 11, ε 268°)…", "feed marks, no chatter marks above 2 %…", "no
/// periodic marks found".
report::Answer answer(const ImageMarks& image, const Language& language = {});

/// The answers of all pictures with their tables and notes.
report::Section surfaceSummary(const SurfaceResult& result, const Language& language = {});

/// The tables of numbers alone: quick, for a screen. `names`: of the pictures, above their tables where there are two.
report::Document surfaceNumbers(const SurfaceResult& result, const std::vector<std::string>& names,
                                const Language& language = {});

report::Document surfaceReport(const SurfaceResult& result, const Language& language = {});

}  // namespace lathelier::surface
