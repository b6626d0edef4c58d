// Universal files (UFF, UNV) of SDRC: data sets between separators, -1 in columns 5 and 6. Set 58 holds a function of
// one abscissa (a frequency response, a spectrum, a time signal) as text, 58b the same with binary values.
// Source: Structural Dynamics Research Laboratory, University of Cincinnati, Universal File Formats for Modal Analysis
// Testing (data sets 15, 58, 58b, 151, 164, 2411).
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/progress.h"

namespace lathelier::io {

/// Axis of a function (records 8 to 11).
struct UffAxis {
    std::int64_t type = 0;  ///< specific data type: 8 displacement, 11 velocity, 12 acceleration, 13 excitation force,
                            ///< 17 time, 18 frequency, 0 unknown
    std::string label;      ///< as stated, "Acceleration"; "NONE" is kept
    std::string unit;       ///< as stated, "m/s^2"; "NONE" is kept
    std::int64_t line = 0;  ///< where it stands
    std::int64_t unit_column = 1;  ///< character of its line at which the unit begins, from 1
    std::int64_t byte = 0;         ///< offset of its line
};

/// Set 164: divisors that convert values of the file to SI units.
struct UffUnits {
    std::int64_t code = 0;  ///< 1 SI, 2 BG, … 9 user defined
    std::string description;
    double length_per_metre = 1;  ///< units of length in a metre
    double force_per_newton = 1;  ///< units of force in a newton
};

/// Set 15 or 2411: position of a node.
struct UffNode {
    std::int64_t label = 0;         ///< number of the node
    std::array<double, 3> place{};  ///< x, y, z in the file's unit of length
};

/// Set 58 or 58b.
struct UffFunction {
    std::array<std::string, 5> id;         ///< the ID lines, trimmed
    std::int64_t function = 0;             ///< 1 time response, 4 frequency response, 6 coherence…
    std::string response_entity;           ///< name of the response's place, "NONE" is kept
    std::int64_t response_node = 0;        ///< node number; may be negative
    std::int64_t response_direction = 0;   ///< ±1 x, ±2 y, ±3 z, ±4…6 rotations about them, 0 scalar
    std::string reference_entity;          ///< name of the reference's place, "NONE" is kept
    std::int64_t reference_node = 0;       ///< node number; may be negative
    std::int64_t reference_direction = 0;  ///< see response_direction
    int data_type = 0;                     ///< of the ordinate: 2 real single, 4 real double, 5 complex single,
                                           ///< 6 complex double
    bool is_even = true;                   ///< the abscissa is given by start and step
    UffAxis abscissa;                      ///< axis of `x`
    UffAxis ordinate;                      ///< axis of `y`: numerator
    UffAxis denominator;                   ///< axis of `y`: denominator, the force of a frequency response
    std::optional<UffUnits> units;         ///< applicable set 164
    std::vector<double> x;                 ///< one for each point, as stored
    std::vector<std::complex<double>> y;   ///< as stored; real values have no imaginary part

    bool isComplex() const { return data_type == 5 || data_type == 6; }
};

/// One data set.
struct UffSet {
    std::string type;                     ///< set number: "58", "58b", "151"…
    std::int64_t line = 0;                ///< line of the set's number, from 1; binary values count by their LF
    std::int64_t byte = 0;                ///< offset of that line
    std::optional<UffFunction> function;  ///< of types 58 and 58b only
};

struct UffFile {
    std::vector<UffSet> sets;       ///< in the order of the file, including skipped ones
    std::optional<UffUnits> units;  ///< of the first set 164
    std::vector<UffNode> nodes;     ///< of the sets 15 and 2411
    Notes notes;                    ///< codes uffDataBeyond, uffTextOutside
};

/// True when the first two lines are those of a universal file: a separator in its columns, and the number of a set;
/// behind lines of text both in their exact columns.
bool isUff(std::string_view head);

/// Reads all sets; sets of other types are skipped by number. Binary values are as long as their header says, not
/// searched for a separator, which they may contain. The declared number of points has precedence over the padding of
/// the last line. Numbers stand in columns of 13 and 20 characters, may touch, and have exponents such as E-04, E-004
/// and D-04; lines that do not keep the columns are split at blanks. Text between the sets is skipped with a note.
/// Memory grows with the bytes present, not with those stated in a header. Errors formatUnknown, malformed,
/// uffPointsMissing (`line`), truncated (`byte`); throws Cancelled.
UffFile readUff(std::string_view bytes, const Progress& progress = {});

}  // namespace lathelier::io
