#include "engine/features/nominal/standards.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lathelier::features {
namespace {

constexpr double anySize = std::numeric_limits<double>::infinity();

// DIN 509:2006-12, table 1.
constexpr std::array<Undercut, 11> undercutTable{{
    {0.2, 0.1, 1, 0.1, 1.6, 3, false},
    {0.4, 0.2, 2, 0.1, 3, 18, false},
    {0.6, 0.2, 2, 0.1, 10, 18, false},
    {0.8, 0.3, 2.5, 0.2, 18, 80, false},
    {1, 0.2, 2.5, 0.1, 18, 50, true},
    {1, 0.4, 4, 0.3, 80, anySize, false},
    {1.2, 0.2, 2.5, 0.1, 18, 50, true},
    {1.2, 0.4, 4, 0.3, 80, anySize, false},
    {1.6, 0.3, 4, 0.2, 50, 80, true},
    {2.5, 0.4, 5, 0.3, 80, 125, true},
    {4, 0.5, 7, 0.3, 125, anySize, true},
}};

// DIN 471:2011-04, table 1, normal series.
constexpr std::array<CirclipGroove, 20> circlipGrooveTable{{
    {8, 7.6, 0.9},    {10, 9.6, 1.1},   {12, 11.5, 1.1}, {14, 13.4, 1.1}, {15, 14.3, 1.1},
    {16, 15.2, 1.1},  {17, 16.2, 1.1},  {18, 17, 1.3},   {20, 19, 1.3},   {22, 21, 1.3},
    {25, 23.9, 1.3},  {28, 26.6, 1.6},  {30, 28.6, 1.6}, {32, 30.3, 1.6}, {35, 33, 1.6},
    {40, 37.5, 1.85}, {45, 42.5, 1.85}, {50, 47, 2.15},  {55, 52, 2.15},  {60, 57, 2.15},
}};

// DIN 6885-1:1968-08, table 1.
constexpr std::array<ParallelKey, 19> parallelKeyTable{{
    {6, 8, 2, 2, 1.2},      {8, 10, 3, 3, 1.8},     {10, 12, 4, 4, 2.5},    {12, 17, 5, 5, 3},
    {17, 22, 6, 6, 3.5},    {22, 30, 8, 7, 4},      {30, 38, 10, 8, 5},     {38, 44, 12, 8, 5},
    {44, 50, 14, 9, 5.5},   {50, 58, 16, 10, 6},    {58, 65, 18, 11, 7},    {65, 75, 20, 12, 7.5},
    {75, 85, 22, 14, 9},    {85, 95, 25, 14, 9},    {95, 110, 28, 16, 10},  {110, 130, 32, 18, 11},
    {130, 150, 36, 20, 12}, {150, 170, 40, 22, 13}, {170, 200, 45, 25, 15},
}};
constexpr std::array<double, 31> keyLengthTable_mm{6,   8,   10,  12,  14,  16,  18,  20,  22, 25, 28,
                                                   32,  36,  40,  45,  50,  56,  63,  70,  80, 90, 100,
                                                   110, 125, 140, 160, 180, 200, 220, 250, 280};

// ISO 261:1998, table 2, coarse pitches.
constexpr std::array<CoarseThread, 19> coarseThreadTable{{
    {3, 0.5},  {4, 0.7},  {5, 0.8}, {6, 1},  {8, 1.25}, {10, 1.5}, {12, 1.75}, {14, 2},   {16, 2}, {18, 2.5},
    {20, 2.5}, {22, 2.5}, {24, 3},  {27, 3}, {30, 3.5}, {33, 3.5}, {36, 4},    {42, 4.5}, {48, 5},
}};
constexpr std::array<double, 8> finePitchTable_mm{0.5, 0.75, 1, 1.25, 1.5, 2, 3, 4};

// Preferred sizes of drawings.
constexpr std::array<double, 12> chamferLegTable_mm{0.2, 0.3, 0.5, 0.8, 1, 1.2, 1.5, 2, 2.5, 3, 4, 5};
constexpr std::array<double, 5> chamferAngleTable_deg{45, 30, 60, 15, 20};
// DIN 250:2002, to 50 mm.
constexpr std::array<double, 22> radiusTable_mm{0.2, 0.4, 0.6, 0.8, 1,  1.2, 1.6, 2,  2.5, 3,  4,
                                                5,   6,   8,   10,  12, 16,  20,  25, 32,  40, 50};

// ISO 1119:2011 and, of Morse tapers, DIN 228-1:1987 with the diameters of their gauge planes.
constexpr std::array<StandardTaper, 17> taperTable{{
    {"1:3", 1.0 / 3, 0},
    {"1:5", 1.0 / 5, 0},
    {"1:10", 1.0 / 10, 0},
    {"1:12", 1.0 / 12, 0},
    {"1:16", 1.0 / 16, 0},
    {"1:20", 1.0 / 20, 0},
    {"1:30", 1.0 / 30, 0},
    {"1:50", 1.0 / 50, 0},
    {"1:100", 1.0 / 100, 0},
    {"7:24", 7.0 / 24, 0},
    {"Morse 0", 1 / 19.212, 9.045},
    {"Morse 1", 1 / 20.047, 12.065},
    {"Morse 2", 1 / 20.020, 17.780},
    {"Morse 3", 1 / 19.922, 23.825},
    {"Morse 4", 1 / 19.254, 31.267},
    {"Morse 5", 1 / 19.002, 44.399},
    {"Morse 6", 1 / 19.180, 63.348},
}};

// ISO 2768-1:1989, tables 1 and 2, classes f, m, c, v; 0: none.
struct Classes {
    double to_mm;
    std::array<double, 4> tolerance_mm;
};
constexpr std::array<Classes, 8> linearTolerances_mm{{{3, {0.05, 0.1, 0.2, 0}},
                                                      {6, {0.05, 0.1, 0.3, 0.5}},
                                                      {30, {0.1, 0.2, 0.5, 1}},
                                                      {120, {0.15, 0.3, 0.8, 1.5}},
                                                      {400, {0.2, 0.5, 1.2, 2.5}},
                                                      {1000, {0.3, 0.8, 2, 4}},
                                                      {2000, {0.5, 1.2, 3, 6}},
                                                      {4000, {0, 2, 4, 8}}}};
constexpr std::array<Classes, 3> edgeTolerances_mm{
    {{3, {0.2, 0.2, 0.4, 0.4}}, {6, {0.5, 0.5, 1, 1}}, {anySize, {1, 1, 2, 2}}}};
constexpr std::string_view generalTolerancePrefix = "ISO 2768-", generalClassLetters = "fmcv",
                           geometricClassLetters = "HKL";

// Table 3, class m.
struct Step {
    double to_mm, tolerance;
};
constexpr std::array<Step, 5> angularTolerances_arcmin{{{10, 60}, {50, 30}, {120, 20}, {400, 10}, {anySize, 5}}};
constexpr double smallestSize_mm = 0.5;

std::optional<double> toleranceIn(std::span<const Classes> table, double size_mm, GeneralClass general)
{
    if (!(size_mm >= smallestSize_mm)) return {};
    for (const Classes& range : table) {
        const double tolerance_mm = range.tolerance_mm[static_cast<std::size_t>(general)];
        if (size_mm <= range.to_mm) return tolerance_mm > 0 ? std::optional(tolerance_mm) : std::nullopt;
    }
    return {};
}

}  // namespace

std::span<const Undercut> undercuts()
{
    return undercutTable;
}

std::string designationOf(const Undercut& undercut, UndercutForm form)
{
    return fmt::format("DIN 509 - {} {}×{}", form == UndercutForm::E ? 'E' : 'F', undercut.radius_mm,
                       undercut.depth_mm);
}

double faceExtent_mm(const Undercut& undercut)
{
    const double angle = undercutFace_deg * std::numbers::pi / 180, r = undercut.radius_mm;
    return r * (1 + std::sin(angle)) + (undercut.face_depth_mm - r * (1 - std::cos(angle))) / std::tan(angle);
}

std::span<const CirclipGroove> circlipGrooves()
{
    return circlipGrooveTable;
}

std::span<const ParallelKey> parallelKeys()
{
    return parallelKeyTable;
}

std::span<const double> keyLengths_mm()
{
    return keyLengthTable_mm;
}

std::span<const CoarseThread> coarseThreads()
{
    return coarseThreadTable;
}

std::span<const double> finePitches_mm()
{
    return finePitchTable_mm;
}

std::span<const double> chamferLegs_mm()
{
    return chamferLegTable_mm;
}

std::span<const double> chamferAngles_deg()
{
    return chamferAngleTable_deg;
}

std::span<const double> radii_mm()
{
    return radiusTable_mm;
}

std::span<const StandardTaper> standardTapers()
{
    return taperTable;
}

std::optional<GeneralClass> parseGeneralTolerance(std::string_view text)
{
    if (text.substr(0, generalTolerancePrefix.size()) != generalTolerancePrefix) return {};
    text.remove_prefix(generalTolerancePrefix.size());
    if (text.size() == 2 && geometricClassLetters.find(text.back()) != std::string_view::npos) text.remove_suffix(1);
    const std::size_t found = text.size() == 1 ? generalClassLetters.find(text.front()) : std::string_view::npos;
    if (found == std::string_view::npos) return {};
    return static_cast<GeneralClass>(found);
}

std::optional<double> generalTolerance_mm(double length_mm, GeneralClass general)
{
    return toleranceIn(linearTolerances_mm, length_mm, general);
}

std::optional<double> generalEdgeTolerance_mm(double size_mm, GeneralClass general)
{
    return toleranceIn(edgeTolerances_mm, size_mm, general);
}

double generalAngleTolerance_deg(double shorter_side_mm)
{
    for (const Step& step : angularTolerances_arcmin)
        if (shorter_side_mm <= step.to_mm) return step.tolerance / 60;
    return angularTolerances_arcmin.back().tolerance / 60;
}

}  // namespace lathelier::features
