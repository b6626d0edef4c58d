#include "engine/io/frf/frf_writer.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/io/file.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/number.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

struct QuantityText {
    int type;             ///< specific data type of the ordinate
    const char* label;    ///< label of the ordinate
    const char* unit;     ///< unit of the ordinate
    const char* columns;  ///< suffix of the column names after "real_"
};

QuantityText quantityText(FrfQuantity quantity)
{
    if (quantity == FrfQuantity::Receptance) return {8, "Displacement", "mm", "mm_N"};
    if (quantity == FrfQuantity::Mobility) return {11, "Velocity", "mm/s", "mm_s_N"};
    return {12, "Acceleration", "mm/s^2", "mm_s2_N"};
}

/// As many digits as fit into a column of 13 characters after a blank, with a point, readable as E13.5.
std::string column13(double value)
{
    for (int digits = 11; digits > 5; --digits)
        if (std::string text = fmt::format("{:#.{}g}", value, digits); text.size() <= 12)
            return fmt::format("{:>13}", text);
    return fmt::format("{:13.5E}", value);
}

/// A number rounded to such a column.
double rounded(double value)
{
    const std::string text = column13(value);
    return wholeNumber(trimmed(text), '.').value_or(value);
}

/// True when start and step, rounded as in the header, reproduce all frequencies.
bool isEven(const std::vector<double>& frequency_hz)
{
    if (frequency_hz.size() < 2) return false;
    const double start = frequency_hz.front();
    const double step = (frequency_hz.back() - start) / static_cast<double>(frequency_hz.size() - 1);
    const double tolerance = 1e-6 * step;
    for (std::size_t i = 0; i < frequency_hz.size(); ++i)
        if (std::abs(rounded(start) + static_cast<double>(i) * rounded(step) - frequency_hz[i]) > tolerance)
            return false;
    return true;
}

/// One line of at most 80 characters without control characters.
std::string idLine(const std::string& text)
{
    const std::string line = excerpt(text);
    return line.empty() ? "NONE" : line;
}

std::string axis(int type, const char* label, const char* unit)
{
    return fmt::format("{:10}{:5}{:5}{:5} {:<20} {:<20}\n", type, 0, 0, 0, label, unit);
}

/// Header of a set, up to its values.
std::string header(const MeasuredFrf& measured, int function, int dataType, bool even, const QuantityText& ordinate,
                   bool perForce)
{
    const Frf& frf = measured.frf;
    const double start = even ? frf.frequency_hz.front() : 0;
    const double step = even ? (frf.frequency_hz.back() - start) / static_cast<double>(frf.frequency_hz.size() - 1) : 0;
    std::string text = fmt::format("    -1\n    58\n{}\nNONE\nNONE\nNONE\nNONE\n", idLine(frf.name));
    text += fmt::format("{:5}{:10}{:5}{:10} {:<10}{:10}{:4} {:<10}{:10}{:4}\n", function, 0, 1, 0, "NONE",
                        measured.response_node, measured.response_direction, "NONE", measured.reference_node,
                        measured.reference_direction);
    text += fmt::format("{:10}{:10}{:10}{}{}{}\n", dataType, frf.frequency_hz.size(), even ? 1 : 0, column13(start),
                        column13(step), column13(0));
    text += axis(18, "Frequency", "Hz") + axis(ordinate.type, ordinate.label, ordinate.unit);
    text += perForce ? axis(13, "Excitation force", "N") : axis(0, "NONE", "NONE");
    return text + axis(0, "NONE", "NONE");
}

std::string responseSet(const MeasuredFrf& measured, bool even)
{
    const Frf& frf = measured.frf;
    std::string text = header(measured, 4, 6, even, quantityText(frf.quantity), true);
    for (std::size_t i = 0; i < frf.value.size(); ++i) {
        if (!even) text += column13(frf.frequency_hz[i]);
        text += fmt::format("{:20.12E}{:20.12E}", frf.value[i].real(), frf.value[i].imag());
        if (!even || i % 2 == 1 || i + 1 == frf.value.size()) text += '\n';
    }
    return text + "    -1\n";
}

std::string coherenceSet(const MeasuredFrf& measured, bool even)
{
    const Frf& frf = measured.frf;
    std::string text = header(measured, 6, 4, even, {0, "Coherence", "NONE", ""}, false);
    for (std::size_t i = 0; i < frf.coherence.size(); ++i) {
        if (!even) text += column13(frf.frequency_hz[i]);
        text += fmt::format("{:20.12E}", frf.coherence[i]);
        if (i % (even ? 4 : 2) == (even ? 3 : 1) || i + 1 == frf.coherence.size()) text += '\n';
    }
    return text + "    -1\n";
}

}  // namespace

std::string toUff(std::span<const MeasuredFrf> responses)
{
    std::string text;
    for (const MeasuredFrf& measured : responses) {
        const bool even = isEven(measured.frf.frequency_hz);
        text += responseSet(measured, even);
        if (!measured.frf.coherence.empty()) text += coherenceSet(measured, even);
    }
    return text;
}

std::string toFrfCsv(const Frf& frf)
{
    const char* columns = quantityText(frf.quantity).columns;
    const bool hasCoherence = !frf.coherence.empty();
    std::string text = fmt::format("frequency_hz,real_{0},imag_{0}{1}\n", columns, hasCoherence ? ",coherence" : "");
    for (std::size_t i = 0; i < frf.value.size(); ++i) {
        text += fmt::format("{},{},{}", frf.frequency_hz[i], frf.value[i].real(), frf.value[i].imag());
        text += hasCoherence ? fmt::format(",{}\n", frf.coherence[i]) : "\n";
    }
    return text;
}

void writeUff(const std::string& path, std::span<const MeasuredFrf> responses)
{
    writeFile(path, toUff(responses));
}

void writeFrfCsv(const std::string& path, const Frf& frf)
{
    writeFile(path, toFrfCsv(frf));
}

}  // namespace lathelier::io
