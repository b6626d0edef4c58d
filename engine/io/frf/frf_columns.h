// The columns of a frequency response in a table, by their headings or as they are stated.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/io/frf/frf_reader.h"
#include "engine/io/table/table_layout.h"

namespace lathelier::io {

enum class FrfRole { Frequency, Real, Imaginary, Magnitude, Phase, Coherence, Other };

/// A parsed heading: "real_mm_N" is Real and "mm/N", "Re(H) [m/N]" Real and "m/N", "dB re 1 m/N" Magnitude.
struct FrfHeading {
    FrfRole role = FrfRole::Other;
    bool is_angular = false;  ///< named as an angular frequency: "omega", "w"
    std::string unit;         ///< as written, with / for _; empty: none
};
FrfHeading parseFrfHeading(std::string_view heading);

/// True for "w", "om", "omega", "ω", and for names that begin with one of them and _.
bool isAngularName(std::string_view name);

/// Names and units that a table of a frequency response may have.
TableExpectation frfExpectation();

/// Indices of the columns.
struct FrfColumns {
    enum class Form { Parts, Polar, Level };  ///< Level: magnitude in decibel, and phase
    std::size_t frequency = 0, first = 0, second = 0;
    std::optional<std::size_t> coherence = {};
    Form form = Form::Parts;
    std::optional<double> phase_rad = {};  ///< radians in a unit of the phase, where that is stated with the columns

    std::vector<std::size_t> all() const;  ///< frequency, first, second, coherence
};

/// The columns as `stated` ("frequency,real,imag", see FrfOptions::frf_columns), by their places; empty: by the
/// headings. None where they cannot be told. Errors valueNotUnderstood (what is stated), columnsAmbiguous.
std::optional<FrfColumns> findFrfColumns(const TableLayout& layout, const std::string& stated);

/// The unit of a column as written, from its heading or a row of units.
std::string unitWord(const TableColumn& column);

}  // namespace lathelier::io
