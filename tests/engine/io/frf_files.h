// Universal files made by the tests.
#pragma once

#include <fmt/format.h>

#include <array>
#include <bit>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "engine/io/frf/frf_reader.h"

namespace lathelier::testing {

/// Header and place of a set 58.
struct UffText {
    int function = 4;                    ///< 4 frequency response, 6 coherence
    int data_type = 6;                   ///< 2, 4 real, 5, 6 complex
    int points = 0;                      ///< declared
    bool even = true;                    ///< start and step, or a value for each point
    double start = 50, step = 2;         ///< of an even abscissa
    int response_node = 1;               ///< of the response
    int response_direction = 1;          ///< of the response
    int reference_node = 1;              ///< of the force
    int reference_direction = 1;         ///< of the force
    int ordinate = 12;                   ///< 8, 11, 12
    std::string label = "Acceleration";  ///< of the ordinate
    std::string unit = "m/s^2";          ///< of the ordinate
    int denominator = 13;                ///< of the denominator
    std::string per = "N";               ///< unit of the denominator
    std::string frequency_unit = "Hz";   ///< of the abscissa
    std::string id = "made by a test";   ///< first ID line
    std::string end = "\n";              ///< of every line
};

/// The eleven lines of a header.
inline std::string uffHeader(const UffText& set)
{
    const auto axis = [&set](int type, const std::string& label, const std::string& unit) {
        return fmt::format("{:10}{:5}{:5}{:5} {:<20} {:<20}{}", type, 0, 0, 0, label, unit, set.end);
    };
    std::string text = set.id + set.end;
    for (int k = 0; k < 4; ++k) text += set.end;  // blank ID lines
    text += fmt::format("{:5}{:10}{:5}{:10} {:<10}{:10}{:4} {:<10}{:10}{:4}{}", set.function, 0, 1, 0, "NONE",
                        set.response_node, set.response_direction, "NONE", set.reference_node, set.reference_direction,
                        set.end);
    text += fmt::format("{:10}{:10}{:10}{:13.5E}{:13.5E}{:13.5E}{}", set.data_type, set.points, set.even ? 1 : 0,
                        set.start, set.step, 0.0, set.end);
    return text + axis(18, "Frequency", set.frequency_unit) + axis(set.ordinate, set.label, set.unit) +
           axis(set.denominator, "Force", set.per) + axis(0, "NONE", "NONE");
}

/// A whole set 58 around these lines of values.
inline std::string uffSet(const UffText& set, const std::string& values)
{
    return "    -1" + set.end + "    58" + set.end + uffHeader(set) + values + "    -1" + set.end;
}

/// A whole set 58b around these bytes; `stated` bytes in the header, -1: those that are there.
inline std::string uffBinarySet(const UffText& set, const std::string& payload, bool big = false, long stated = -1)
{
    const long bytes = stated < 0 ? static_cast<long>(payload.size()) : stated;
    return "    -1" + set.end +
           fmt::format("    58b{:6}{:6}{:12}{:12}{:6}{:6}{:12}{:12}", big ? 2 : 1, 2, 11, bytes, 0, 0, 0, 0) + set.end +
           uffHeader(set) + payload + set.end + "    -1" + set.end;
}

template <class T>
std::string rawBytes(T value, bool big = false)
{
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (big) std::reverse(bytes.begin(), bytes.end());
    return {bytes.begin(), bytes.end()};
}

/// One mode: stiffness 1e4 N/mm, 200 Hz, 2 % of critical damping.
inline std::complex<double> receptance_mm_N(double frequency_hz)
{
    const double r = frequency_hz / 200;
    return 1e-4 / std::complex<double>(1 - r * r, 2 * 0.02 * r);
}

/// A response of that mode at even lines.
inline io::MeasuredFrf modeFrf(FrfQuantity quantity, int lines = 101, double from_hz = 50, double step_hz = 2)
{
    io::MeasuredFrf measured;
    measured.response_node = measured.reference_node = 7;
    measured.response_direction = measured.reference_direction = 3;
    measured.frf.name = "mode";
    measured.frf.quantity = quantity;
    for (int i = 0; i < lines; ++i) {
        const double f = from_hz + step_hz * i;
        const std::complex<double> iw(0, 2 * std::numbers::pi * f);
        const std::complex<double> factor = quantity == FrfQuantity::Receptance ? 1.0
                                            : quantity == FrfQuantity::Mobility ? iw
                                                                                : iw * iw;
        measured.frf.frequency_hz.push_back(f);
        measured.frf.value.push_back(receptance_mm_N(f) * factor);
    }
    return measured;
}

}  // namespace lathelier::testing
