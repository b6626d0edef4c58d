#include "engine/io/profile/profile_points.h"

#include <cmath>

#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/io/cloud/unit_choice.h"
#include "engine/io/io_codes.h"
#include "engine/io/table/column_names.h"
#include "engine/io/text/header_lines.h"
#include "engine/io/text/quantity.h"
#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

using Shape = ProfileColumnChoice::Shape;

constexpr double smallestRadius_mm = 0.1;       ///< smaller values are deviations
constexpr double largestDeviationShare = 0.05;  ///< values below this share of the nominal radius are deviations
constexpr double planeShare = 0.01;  ///< relative variation below which a coordinate is normal to the section

struct Extent {
    double smallest = std::numeric_limits<double>::infinity();
    double largest = -std::numeric_limits<double>::infinity();
    double span() const { return largest - smallest; }
};

Extent extentOf(const RawProfile& raw, std::size_t column)
{
    Extent extent;
    for (std::size_t i = 0; i < raw.rows.rows; ++i) {
        extent.smallest = std::min(extent.smallest, raw.at(i, column));
        extent.largest = std::max(extent.largest, raw.at(i, column));
    }
    return extent;
}

/// Three coordinates: the section is normal to the nearly constant one.
void projectToSectionPlane(RawProfile& raw, double mm)
{
    const std::array<Extent, 3> extents = {extentOf(raw, 0), extentOf(raw, 1), extentOf(raw, 2)};
    const double largest = std::max({extents[0].span(), extents[1].span(), extents[2].span()});
    std::size_t across = 2;
    for (std::size_t k = 0; k < 3; ++k)
        if (extents[k].span() < extents[across].span()) across = k;
    const bool isNamed = raw.layout.has_names;
    if (extents[across].span() > planeShare * largest) {
        if (!isNamed)
            throw Error(errors::columnsUnknown,
                        {{"line", raw.layout.body_line},
                         {"column", std::int64_t{1}},
                         {"found", columnNames(raw.layout)},
                         {"expected", LT_TEXT("Engine", "x and y, or x, y and z in a coordinate plane")}});
        across = 2;
        raw.file.notes.push_back({notes::coordinateIgnored,
                                  {{"coordinate", std::string("z")},
                                   {"from_mm", extents[2].smallest * mm},
                                   {"to_mm", extents[2].largest * mm}}});
    } else if (across != 2 || !isNamed) {
        // In the order that preserves the handedness of the plane.
        const std::array<std::string, 3> planes = {"yz", "zx", "xy"};
        raw.file.notes.push_back(
            {notes::profilePlane,
             {{"plane", planes[across]}, {"at_mm", (extents[across].smallest + extents[across].largest) / 2 * mm}}});
    }
    const std::size_t a = (across + 1) % 3;
    const std::size_t b = (across + 2) % 3;
    for (std::size_t i = 0; i < raw.rows.rows; ++i) {
        const double first = raw.at(i, a);
        const double second = raw.at(i, b);
        raw.values[2 * i] = first;
        raw.values[2 * i + 1] = second;
    }
    const std::array<char, 3> letters = {'x', 'y', 'z'};
    raw.choice.axes = {letters[a], letters[b]};
    raw.choice.columns = {raw.choice.columns[a], raw.choice.columns[b]};
    raw.choice.shape = Shape::Xy;
}

/// True for angles over one or more whole turns, with or without the step that closes the last; for many points the
/// steps may be uneven.
bool isWholeTurns(double span, double turn, std::size_t rows)
{
    constexpr std::size_t many = 40;
    constexpr double rounding = 0.25;  // of a step
    if (rows < 4) return false;
    const double step = span / static_cast<double>(rows - 1);
    const double turns = std::round((span + step / 2) / turn);
    const double missing = (turns * turn - span) / step;
    if (turns < 1 || missing < -rounding) return false;
    return rows >= many ? missing < 1.5 : std::abs(missing) < rounding || std::abs(missing - 1) < rounding;
}

/// A word in the place of the unit that is none, or "grad": the degree in German, the gon in other languages. The
/// extent of a whole turn decides. Error angleUnitUnknown for an arc.
void resolveAngleUnitWord(RawProfile& raw)
{
    constexpr double degreesOfTurn = 360, gonsOfTurn = 400;
    const double span = extentOf(raw, 0).span();
    const std::string& found = raw.choice.angle_unit_text;
    const bool isGrad = isOneOf(lowerCase(found), {"grad", "grade", "grads", "grd"});
    const auto note = [&](const char* unit) {
        raw.file.notes.push_back(
            {notes::angleUnitFromExtent, {{"found", found}, {"unit", std::string(unit)}, {"extent", span}}});
    };
    if (isWholeTurns(span, degreesOfTurn, raw.rows.rows)) return note("deg");
    if (isGrad && isWholeTurns(span, gonsOfTurn, raw.rows.rows)) {
        raw.choice.degrees_per_unit = degreesOfTurn / gonsOfTurn;
        return note("gon");
    }
    if (isGrad && raw.choice.angle_name.starts_with("winkel")) return note("deg");
    throw Error(errors::angleUnitUnknown,
                {{"line", raw.layout.body_line},
                 {"column", static_cast<std::int64_t>(raw.choice.columns[0]) + 1},
                 {"found", found},
                 {"expected", LT_TEXT("Engine", "deg, rad, mrad, gon, rev, arcmin or arcsec")}});
}

/// Angles over a range of 2π are radians, not an arc of 6.3°.
void resolveAngleUnit(RawProfile& raw)
{
    if (raw.choice.is_angle_unit_stated) return;
    for (const char* key : {"angle_unit", "unit_angle", "angle unit", "unit of angle", "winkeleinheit"})
        if (const std::string* word = headerWord(raw.file.header, key); word && raw.choice.angle_unit_text.empty()) {
            const auto unit = quantityUnit(*word);
            if (unit && unit->kind == QuantityUnit::Kind::Angle) {
                raw.choice.degrees_per_unit = unit->scale;
                return;
            }
            raw.choice.angle_unit_text = *word;
        }
    if (!raw.choice.angle_unit_text.empty()) return resolveAngleUnitWord(raw);
    if (raw.rows.rows < 8) return;
    const double span = extentOf(raw, 0).span();
    const double step = turn_rad / static_cast<double>(raw.rows.rows);
    if (span < turn_rad - 1.5 * step || span > turn_rad * 1.001) return;
    raw.choice.degrees_per_unit = deg_per_rad;
    raw.file.notes.push_back({notes::angleUnitGuessed, {{"extent", span}}});
}

/// Checked against the range of the option, since a header may contain any value.
bool isRadius(double radius_mm)
{
    return radius_mm >= 1e-3 && radius_mm <= 1e6;
}

/// The nominal radius that the caller or the file's header states.
std::optional<double> nominalRadius(const RawProfile& raw, const ProfileOptions& options)
{
    if (options.nominal_radius_mm) return options.nominal_radius_mm;
    for (const char* key : {"nominal_radius_mm", "radius_mm", "R_mm"})
        if (const auto radius = headerNumber(raw.file.header, key); radius && isRadius(*radius)) return radius;
    for (const char* key : {"nominal_diameter_mm", "diameter_mm", "D_mm"})
        if (const auto diameter = headerNumber(raw.file.header, key); diameter && isRadius(*diameter / 2))
            return *diameter / 2;
    return std::nullopt;
}

[[noreturn]] void throwNominalMissing(const RawProfile& raw, const Extent& extent)
{
    throw Error(errors::nominalRadiusMissing, {{"line", raw.layout.body_line},
                                               {"column", std::int64_t{1}},
                                               {"minimum", extent.smallest},
                                               {"maximum", extent.largest}});
}

/// Error unitUnknown at the first line of numbers.
[[noreturn]] void throwUnitUnknown(const RawProfile& raw, double extent)
{
    throw Error(errors::unitUnknown, {{"line", raw.layout.body_line}, {"column", std::int64_t{1}}, {"extent", extent}});
}

LengthScale chosenUnit(RawProfile& raw, const std::optional<LengthScale>& stated, const ImportOptions& import,
                       double extent)
{
    try {
        return chooseLengthUnit(stated, import, extent, raw.file.facts, raw.file.notes);
    } catch (Error& error) {
        throw error.with("line", raw.layout.body_line).with("column", std::int64_t{1});
    }
}

/// Determines whether the last column contains radii or deviations, and its unit. Returns the offset added to each
/// value, in mm.
double resolveRadii(RawProfile& raw, const ImportOptions& import, const ProfileOptions& options, LengthScale& unit)
{
    FileFacts& facts = raw.file.facts;
    const std::optional<double> nominal = nominalRadius(raw, options);
    const Extent extent = extentOf(raw, raw.width() - 1);
    const std::optional<LengthScale> stated = statedUnit(raw);
    const bool isUnitKnown = stated || lengthScale(import.unit);
    bool areDeviations = raw.choice.are_deviations || extent.smallest <= 0;
    if (isUnitKnown || !areDeviations) {
        // Without a unit, strongly varying radii may be deviations with an offset.
        const double share = raw.choice.shape == Shape::Trace ? 0.1 : 0.5;
        if (!isUnitKnown && extent.span() > share * extent.largest) throwNominalMissing(raw, extent);
        unit = chosenUnit(raw, stated, import, 2 * extent.largest);
        areDeviations = areDeviations || extent.largest * unit.mm < smallestRadius_mm ||
                        (nominal && extent.largest * unit.mm < largestDeviationShare * *nominal);
    } else {
        if (!nominal) throwNominalMissing(raw, extent);
        // The extent does not decide between micrometres and millimetres here.
        throwUnitUnknown(raw, extent.span());
    }
    if (facts.unit_source == "guessed" && areDeviations) throwUnitUnknown(raw, extent.span());
    if (!areDeviations) {
        if (options.nominal_radius_mm)
            raw.file.notes.push_back({notes::nominalNotUsed, {{"radius_mm", *options.nominal_radius_mm}}});
        return 0;
    }
    if (!nominal) throwNominalMissing(raw, extent);
    raw.file.profile.size_is_nominal = true;
    raw.file.notes.push_back({notes::sizeFromNominal, {{"radius_mm", *nominal}}});
    set(facts.details, "nominal_radius_mm", *nominal);
    return *nominal;
}

}  // namespace

std::optional<LengthScale> statedUnit(const RawProfile& raw)
{
    std::optional<LengthScale> unit;  // common unit of all columns except an angle
    for (std::size_t i = raw.choice.shape == Shape::Polar ? 1 : 0; i < raw.width(); ++i) {
        const std::optional<LengthScale>& found = raw.layout.columns[raw.choice.columns[i]].unit;
        if (unit && found && found->key != unit->key)
            throw Error(errors::malformed, {{"line", raw.layout.body_line},
                                            {"column", std::int64_t{1}},
                                            {"found", found->key},
                                            {"expected", LT_TEXT("Engine", "one unit for all coordinates")}});
        if (found) unit = found;
    }
    return unit ? unit : raw.layout.unit;
}

void layPolar(RawProfile& raw, const ImportOptions& import, const ProfileOptions& options, const Progress& progress)
{
    LengthScale unit;
    const double added_mm = resolveRadii(raw, import, options, unit);
    const bool isTrace = raw.choice.shape == Shape::Trace;
    if (isTrace)
        raw.file.notes.push_back({notes::anglesUniform, {{"count", static_cast<std::int64_t>(raw.rows.rows)}}});
    else
        resolveAngleUnit(raw);
    std::vector<Eigen::Vector2d>& points = raw.file.profile.points_mm;
    points.resize(raw.rows.rows);
    const double count = static_cast<double>(raw.rows.rows);
    parallelFor(raw.rows.rows, 0x8000, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const double angle_rad = isTrace ? turn_rad * static_cast<double>(i) / count
                                             : raw.at(i, 0) * raw.choice.degrees_per_unit * rad_per_deg;
            const double r_mm = added_mm + raw.at(i, raw.width() - 1) * unit.mm;
            points[i] = {r_mm * std::cos(angle_rad), r_mm * std::sin(angle_rad)};
        }
    });
    raw.file.facts.format = isTrace ? "roundness_trace" : "profile_polar";
    set(raw.file.facts.details, "columns_read", std::string(isTrace ? "r" : "angle,r"));
}

void layXy(RawProfile& raw, const ImportOptions& import, const Progress& progress)
{
    const std::optional<LengthScale> stated = statedUnit(raw);
    double largest = 0;
    for (std::size_t k = 0; k < raw.width(); ++k) largest = std::max(largest, extentOf(raw, k).span());
    const LengthScale unit = chosenUnit(raw, stated, import, largest);
    if (raw.choice.shape == Shape::Xyz) projectToSectionPlane(raw, unit.mm);
    progress.check();
    std::vector<Eigen::Vector2d>& points = raw.file.profile.points_mm;
    points.reserve(raw.rows.rows);
    for (std::size_t i = 0; i < raw.rows.rows; ++i)
        points.emplace_back(raw.values[2 * i] * unit.mm, raw.values[2 * i + 1] * unit.mm);
    raw.file.facts.format = "profile_xy";
    set(raw.file.facts.details, "columns_read", std::string{raw.choice.axes[0], ',', raw.choice.axes[1]});
}

}  // namespace lathelier::io
