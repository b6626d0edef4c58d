// Files that describe a shaft: SHAFT.json, a material as JSON, and the stock text file.
//
// SHAFT.json: {"schema": "lathelier-shaft", "schema_version": 1, "name", "segments": [{"length_mm",
// "start_diameter_mm", "end_diameter_mm", "bore_diameter_mm"?, "arc_radius_mm"?, "role"?}… from the free end],
// "bores"?, "marks"?, "material"?, "general_tolerance"?}; readers of beams want bores laid into the rows
// (engine/core/shaft_contour.h). Stock file: a line for each segment from the free end, with outer radius and bore
// radius at its start, the same at its end, and its length, all in mm; blank lines and remarks after # are passed over.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/core/shaft.h"
#include "engine/io/json/json_document.h"

namespace lathelier::io {

/// Errors with line and column: malformed (also a schema that is not this one), keyMissing, keyOutOfRange. Notes:
/// unknownKey. What checkShaft() looks at is not looked at here.
Shaft readShaft(const std::string& json, Notes& notes);

/// The same of a shaft within another document.
Shaft readShaft(const JsonCursor& object, Notes& notes);

/// {"name"?, "elastic_modulus_MPa", "poisson_ratio", "density_kg_m3", "loss_factor"}; what is missing is that of steel.
/// Errors and notes as above.
Material readMaterial(const std::string& json, Notes& notes);

/// A bore that widens becomes 50 segments of constant bore. Errors malformed with line and column; shaftEmpty.
Shaft readStock(std::string_view text);

/// Either kind, told apart by its content, in any encoding, with bores laid into the rows. Errors of the above;
/// fileEmpty; those of checkShaft().
Shaft readShaftFile(std::string_view bytes, Notes& notes, const Progress& progress = {});

/// The text of a file that readShaft() reads to the same bits.
std::string shaftText(const Shaft& shaft);

/// A stock file: name, material and roles are not in it, an arc is cut into 50 cones. Radii are those that readStock()
/// doubles.
std::string stockText(const Shaft& shaft);

}  // namespace lathelier::io
