// The workshop drawing of a turned shaft.
//
// Solid shafts are shown in full view; bored ones in half section with the upper half cut and hatched (ISO 128-3).
// Keyways, flats, cross holes, bolt circles, hexagons, squares, splines and eccentrics get sections A-A, B-B…, seen
// from the free end and standing right of the view or below it (first angle, ISO 5456-2), each turned as it is in the
// part; marks of one place share a section. Dimensions after ISO 129-1:
// - every cylinder ⌀, on a line inside the view where the text fits, else above the view; adjoining cylinders of one
//   diameter that only a groove or an undercut parts are one; bores beside the view where a face opens on them;
// - lengths from the free end on parallel lanes below, or as a chain, the overall length last; depths of bores above
// from their mouth;
// - chamfers "1×45°" (leg along z × angle to the axis), radii "R2", grooves "width×⌀bottom", tapers "▷1:10" or the
//   whole angle of steep ones, each with its large ⌀ (where no cylinder continues it) and its length in brackets as an
//   auxiliary dimension, undercuts "DIN 509 - E 0.6×0.2", threads "M16×2 - length" with the root as a thin line
//   (ISO 6410-1), knurls: by leaders that never cross each other.
// - crowned rows "R2665.3, ⌀50 (⌀49.4 - ⌀49.4)": the largest ⌀, those of the ends in brackets.
// Numbers have up to three decimals. Nominal sizes are upright with their
// tolerance; measured ones (ShaftSegment::measured has the same values, or DrawingOptions::measured and the row holds
// none) are italic with ± U where U is known. U of a length joins those of its two ends. A nominal size in place of a
// measured one has a number [n], its line in the table of differences (measured - nominal) beside the title block.
//
// Scale: the largest of ISO 5455 that fits, with lettering of 3.5 mm, else of 2.5 mm; where the lanes of lengths are
// too high, they become running dimensions on one line; what still does not fit is drawn with its overall length only
// (Drawing::complete is false). What of an undercut lies behind a shoulder is not drawn in the full view.
//
// Precondition: a shaft that keeps checkShaft(). Errors: none; a shaft without rows gives an empty sheet.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/text.h"
#include "engine/drawing/drawing.h"
#include "engine/shaft/shaft.h"

namespace lathelier::drawing {

/// Where lengths begin (ISO 129-1).
enum class LengthsFrom : std::uint8_t {
    Datum,    ///< all from the free end, and the overall length
    Previous  ///< a chain, each from the end of the one before it, and the overall length
};

struct DrawingOptions {
    std::optional<Sheet> sheet = {};                  ///< none: A4, upright where that helps; A3 where A4 is too small
    std::string name = {};                            ///< empty: Shaft::name
    std::string material = {};                        ///< empty: the name of Shaft::material
    std::string surface_texture = {};                 ///< a general note, "Rz 16"; empty: none
    std::string author = {};                          ///< empty: none
    std::string date = {};                            ///< as it is to be printed
    std::string sheet_number = "1/1";                 ///< of the title block
    std::string decimal_separator = ".";              ///< "," where the reader expects it
    LengthsFrom lengths_from = LengthsFrom::Datum;    ///< a chain that finds no room becomes running dimensions
    bool measured = false;                            ///< rows without ShaftSegment::measured are measured values
    std::vector<SizeUncertainty> uncertainties = {};  ///< by row (k = 2); of others those of MeasuredSize
    std::vector<std::vector<SizeUncertainty>> bore_uncertainties = {};  ///< by Shaft::bores and their rows (k = 2)
    std::function<std::string(Text)> translate = {};                    ///< empty: English
};

Drawing drawShaft(const Shaft& shaft, const DrawingOptions& options);

/// Are there sizes that are measured, so that the sheet needs their legend?
bool hasMeasured(const Shaft& shaft, const DrawingOptions& options);

/// Mass without marks, kg; none where the material is not stated.
std::optional<double> massInKilograms(const Shaft& shaft);

}  // namespace lathelier::drawing
