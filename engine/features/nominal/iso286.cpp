#include "engine/features/nominal/iso286.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "engine/features/nominal/nominal_limits.h"

namespace lathelier::features {
namespace {

constexpr std::size_t rangeCount = 13;
using RangeValues = std::array<double, rangeCount>;

// ISO 286-1:2010. A range goes over the limit before it up to and including its own.
constexpr RangeValues sizeTo_mm{3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500};

// Table 1: standard tolerances in µm, IT5 to IT13.
constexpr int firstGrade = 5, lastGrade = 13, lastGradeOfFits = 11;
constexpr std::array<RangeValues, lastGrade - firstGrade + 1> standardTolerances_um{{
    {4, 5, 6, 8, 9, 11, 13, 15, 18, 20, 23, 25, 27},
    {6, 8, 9, 11, 13, 16, 19, 22, 25, 29, 32, 36, 40},
    {10, 12, 15, 18, 21, 25, 30, 35, 40, 46, 52, 57, 63},
    {14, 18, 22, 27, 33, 39, 46, 54, 63, 72, 81, 89, 97},
    {25, 30, 36, 43, 52, 62, 74, 87, 100, 115, 130, 140, 155},
    {40, 48, 58, 70, 84, 100, 120, 140, 160, 185, 210, 230, 250},
    {60, 75, 90, 110, 130, 160, 190, 220, 250, 290, 320, 360, 400},
    {100, 120, 150, 180, 210, 250, 300, 350, 400, 460, 520, 570, 630},
    {140, 180, 220, 270, 330, 390, 460, 540, 630, 720, 810, 890, 970},
}};

// Tables 4 and 5: fundamental deviations of shafts in µm.
enum class Side { Upper, Lower, Both };
struct Deviation {
    std::string_view shaft, hole;  // letters; an empty one: not known
    Side side;                     // which limit the deviation is, of the shaft
    RangeValues deviation_um;
};
constexpr std::array<Deviation, 10> fundamentalDeviations{{
    {"d", "D", Side::Upper, {-20, -30, -40, -50, -65, -80, -100, -120, -145, -170, -190, -210, -230}},
    {"e", "E", Side::Upper, {-14, -20, -25, -32, -40, -50, -60, -72, -85, -100, -110, -125, -135}},
    {"f", "F", Side::Upper, {-6, -10, -13, -16, -20, -25, -30, -36, -43, -50, -56, -62, -68}},
    {"g", "G", Side::Upper, {-2, -4, -5, -6, -7, -9, -10, -12, -14, -15, -17, -18, -20}},
    {"h", "H", Side::Upper, {}},
    {"js", "JS", Side::Both, {}},
    {"k", "", Side::Lower, {0, 1, 1, 1, 2, 2, 2, 3, 3, 4, 4, 4, 5}},
    {"m", "", Side::Lower, {2, 4, 6, 7, 8, 9, 11, 13, 15, 17, 20, 21, 23}},
    {"n", "", Side::Lower, {4, 8, 10, 12, 15, 17, 20, 23, 27, 31, 34, 37, 40}},
    {"p", "", Side::Lower, {6, 12, 15, 18, 22, 26, 32, 37, 43, 50, 56, 62, 68}},
}};

std::optional<std::size_t> sizeRangeOf(double nominal_mm)
{
    if (!(nominal_mm > 0) || nominal_mm > sizeTo_mm.back()) return {};
    return static_cast<std::size_t>(std::lower_bound(sizeTo_mm.begin(), sizeTo_mm.end(), nominal_mm) -
                                    sizeTo_mm.begin());
}

Limits limitsIn(const Deviation& letter, bool hole, int grade, std::size_t range)
{
    const double tolerance = standardTolerances_um[static_cast<std::size_t>(grade - firstGrade)][range];
    if (letter.side == Side::Both) return {-tolerance / 2, tolerance / 2};
    double deviation = letter.deviation_um[range];
    if (letter.side == Side::Upper && hole) return {-deviation, -deviation + tolerance};
    if (letter.side == Side::Upper) return {deviation - tolerance, deviation};
    if (letter.shaft == "k" && grade > 7) deviation = 0;
    return {deviation, deviation + tolerance};
}

}  // namespace

std::optional<IsoClass> parseIsoClass(std::string_view text)
{
    const auto digits = std::find_if(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    const auto letters = static_cast<std::size_t>(digits - text.begin());
    const std::string_view deviation = text.substr(0, letters), number = text.substr(letters);
    int grade = 0;
    const auto [end, failure] = std::from_chars(number.data(), number.data() + number.size(), grade);
    if (failure != std::errc() || end != number.data() + number.size() || number.front() == '0') return {};
    const bool known = std::any_of(
        fundamentalDeviations.begin(), fundamentalDeviations.end(),
        [&](const Deviation& one) { return !deviation.empty() && (one.shaft == deviation || one.hole == deviation); });
    if (!known || grade < firstGrade || grade > lastGrade) return {};
    return IsoClass{std::string(deviation), grade};
}

std::optional<double> standardTolerance_um(int grade, double nominal_mm)
{
    const auto range = sizeRangeOf(nominal_mm);
    if (!range || grade < firstGrade || grade > lastGrade) return {};
    return standardTolerances_um[static_cast<std::size_t>(grade - firstGrade)][*range];
}

std::optional<Limits> limitsOf(std::string_view iso_class, double nominal_mm)
{
    const auto parsed = parseIsoClass(iso_class);
    const auto range = sizeRangeOf(nominal_mm);
    if (!parsed || !range) return {};
    for (const Deviation& letter : fundamentalDeviations)
        if (letter.shaft == parsed->deviation || letter.hole == parsed->deviation)
            return limitsIn(letter, letter.hole == parsed->deviation, parsed->grade, *range);
    return {};
}

std::vector<std::string> fitsOf(double measured_mm, double U_mm, double nominal_mm, Surface surface)
{
    constexpr double rounding_um = nominalLimits.fit_rounding_um;
    const auto range = sizeRangeOf(nominal_mm);
    std::vector<std::string> fits;
    if (!range) return fits;
    const double low_um = 1000 * (measured_mm - U_mm - nominal_mm), high_um = 1000 * (measured_mm + U_mm - nominal_mm);
    const bool hole = surface == Surface::Bore;
    for (int grade = firstGrade; grade <= lastGradeOfFits; ++grade)
        for (const Deviation& letter : fundamentalDeviations) {
            const std::string_view name = hole ? letter.hole : letter.shaft;
            if (name.empty() || fits.size() == nominalLimits.most_fits) continue;
            const Limits zone = limitsIn(letter, hole, grade, *range);
            if (zone.lower_um <= low_um + rounding_um && high_um <= zone.upper_um + rounding_um)
                fits.push_back(std::string(name) + std::to_string(grade));
        }
    return fits;
}

}  // namespace lathelier::features
