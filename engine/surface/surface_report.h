// Report of photographs of surfaces: answer, tables, document.
#pragma once

#include "engine/report/document.h"
#include "engine/surface/surface.h"

namespace lathelier::surface {

/// Answer of one picture: "Marks of 361.0 Hz (m = 11, ε 268°)…", "feed marks, no chatter marks above 2 %…", "no
/// periodic marks found".
report::Answer answer(const ImageMarks& image, const Language& language = {});

/// The answers of all pictures with their tables and notes.
report::Section surfaceSummary(const SurfaceResult& result, const Language& language = {});

/// Numerical tables only, fast enough for the screen. `names`: of the pictures, above their tables where there are two.
report::Document surfaceNumbers(const SurfaceResult& result, const std::vector<std::string>& names,
                                const Language& language = {});

report::Document surfaceReport(const SurfaceResult& result, const Language& language = {});

}  // namespace lathelier::surface
