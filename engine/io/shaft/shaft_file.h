// Files that describe a shaft: SHAFT.json, a material as JSON, and the stock text file.
//
// SHAFT.json: {"schema": "lathelier-shaft", "schema_version": 1, "name", "segments": [{"length_mm",
// "start_diameter_mm", "end_diameter_mm", "bore_diameter_mm"?, "arc_radius_mm"?, "role"?}… from the free end],
// "bores"?, "marks"?, "material"?, "general_tolerance"?}; beam models require bores merged into the rows
// (engine/shaft/shaft_contour.h). Stock file: a line for each segment from the free end, with outer radius and bore
// radius at its start, the same at its end, and its length, all in mm; blank lines and remarks after # are skipped.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/io/json/json_document.h"
#include "engine/shaft/shaft.h"

namespace lathelier::io {

/// Errors with line and column: malformed (also a schema that is not this one), keyMissing, keyOutOfRange. Notes:
/// unknownKey. The rules of checkShaft() are not checked here.
Shaft readShaft(const std::string& json, Notes& notes);

/// The same of a shaft within another document.
Shaft readShaft(const JsonCursor& object, Notes& notes);

/// {"name"?, "elastic_modulus_MPa", "poisson_ratio", "density_kg_m3", "loss_factor"}; missing values are those of
/// steel. Errors and notes as above.
Material readMaterial(const std::string& json, Notes& notes);

/// A tapered bore becomes 50 segments of constant bore. Errors malformed with line and column; shaftEmpty.
Shaft readStock(std::string_view text);

/// Either kind, distinguished by content, in any encoding, with bores merged into the rows. Errors of the above;
/// fileEmpty; those of checkShaft().
Shaft readShaftFile(std::string_view bytes, Notes& notes, const Progress& progress = {});

/// Writes the text such that readShaft() restores the same bits.
std::string shaftText(const Shaft& shaft);

/// A stock file: without name, material and roles; an arc is approximated by 50 cones. Contains radii, which
/// readStock() doubles.
std::string stockText(const Shaft& shaft);

}  // namespace lathelier::io
