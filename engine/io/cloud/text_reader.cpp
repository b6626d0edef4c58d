// Clouds in text tables: XYZ, ASC, CSV, TXT, PTS.
#include "engine/io/cloud/text_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "engine/core/parallel.h"
#include "engine/io/cloud/raw_scan.h"
#include "engine/io/io_codes.h"
#include "engine/io/probe/probe_columns.h"
#include "engine/io/table/column_names.h"
#include "engine/io/table/table_facts.h"
#include "engine/io/table/table_layout.h"
#include "engine/io/table/table_rows.h"
#include "engine/io/text/readable_text.h"

namespace lathelier::io {
namespace {

constexpr std::array<Text, 3> axisNames = {LT_TEXT("Engine", "x"), LT_TEXT("Engine", "y"), LT_TEXT("Engine", "z")};

/// Role of a column name in a cloud.
enum class CloudRole { Unknown, X, Y, Z, NormalX, NormalY, NormalZ, Other, Polar };

/// "Position_X", "x-coordinate", "Points:0" are synonyms of "x".
CloudRole cloudRoleOf(const std::string& name)
{
    std::string core;
    for (const char c : name)
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) core += c;
    for (const char* word : {"coordinates", "coordinate", "koordinate", "coord", "positions", "position", "points",
                             "point", "pos", "measured", "actual", "axis", "achse", "value", "wert"}) {
        const std::size_t at = core.find(word);
        if (at != std::string::npos && core.size() > std::string_view(word).size())
            core.erase(at, std::string_view(word).size());
    }
    if (core == "x" || core == "px" || (core == "0" && name.find("point") == 0)) return CloudRole::X;
    if (core == "y" || core == "py" || (core == "1" && name.find("point") == 0)) return CloudRole::Y;
    if (core == "z" || core == "pz" || (core == "2" && name.find("point") == 0)) return CloudRole::Z;
    if (core == "nx" || core == "normalx" || core == "normalsx" || core == "normals0" || core == "xnormal")
        return CloudRole::NormalX;
    if (core == "ny" || core == "normaly" || core == "normalsy" || core == "normals1" || core == "ynormal")
        return CloudRole::NormalY;
    if (core == "nz" || core == "normalz" || core == "normalsz" || core == "normals2" || core == "znormal")
        return CloudRole::NormalZ;
    for (const char* word :
         {"r",         "g",     "b",       "a",         "red",    "green",       "blue",      "alpha",  "i",
          "intensity", "index", "id",      "nr",        "no",     "n",           "number",    "name",   "label",
          "time",      "t",     "quality", "curvature", "scalar", "reflectance", "amplitude", "weight", "deviation",
          "class",     "line",  "row",     "punkt",     "point",  "pt",          "lp"})
        if (core == word) return CloudRole::Other;
    for (const char* word : {"angle", "theta", "phi", "azimuth", "elevation", "radius", "rho", "range", "winkel"})
        if (core == word) return CloudRole::Polar;
    return CloudRole::Unknown;
}

/// Column indices of coordinates and normals; normals are -1 when absent.
struct PointColumns {
    std::array<int, 3> point = {-1, -1, -1};
    std::array<int, 3> normal = {-1, -1, -1};
    bool normals_guessed = false;  ///< three columns without names behind x, y, z
    bool grid_left_out = false;    ///< row and column numbers without names in front of x, y, z
};

[[noreturn]] void throwNoCoordinates(const TableLayout& layout)
{
    throw Error(errors::malformed, {{"line", layout.body_line},
                                    {"column", std::int64_t{1}},
                                    {"found", columnNames(layout)},
                                    {"expected", LT_TEXT("Engine", "columns named x, y and z")}});
}

/// The column of one coordinate; -1 without one. A plain "x" has precedence over "X position". Error columnsAmbiguous
/// when several are named alike: two sets of coordinates in one table.
int coordinate(const TableLayout& layout, const std::vector<CloudRole>& roles, std::size_t axis)
{
    const std::string letter(1, static_cast<char>('x' + axis));
    std::vector<std::size_t> named, plain;
    for (std::size_t k = 0; k < roles.size(); ++k) {
        if (!layout.columns[k].is_number ||
            static_cast<std::size_t>(roles[k]) != static_cast<std::size_t>(CloudRole::X) + axis)
            continue;
        named.push_back(k);
        if (layout.columns[k].name == letter) plain.push_back(k);
    }
    const std::vector<std::size_t>& candidates = plain.empty() ? named : plain;
    if (candidates.size() > 1) throwAmbiguous(layout, candidates, axisNames[axis]);
    return candidates.empty() ? -1 : static_cast<int>(candidates.front());
}

PointColumns findPointColumns(const TableLayout& layout)
{
    PointColumns columns;
    bool polar = false;
    std::vector<CloudRole> roles;
    for (const TableColumn& column : layout.columns) roles.push_back(cloudRoleOf(column.name));
    for (std::size_t axis = 0; axis < 3; ++axis) columns.point[axis] = coordinate(layout, roles, axis);
    for (std::size_t k = 0; k < roles.size(); ++k) {
        if (!layout.columns[k].is_number) continue;
        const auto axis = static_cast<int>(roles[k]) - static_cast<int>(CloudRole::NormalX);
        if (axis >= 0 && axis < 3 && columns.normal[static_cast<std::size_t>(axis)] < 0)
            columns.normal[static_cast<std::size_t>(axis)] = static_cast<int>(k);
        polar = polar || roles[k] == CloudRole::Polar;
    }
    const bool anyAxis = std::any_of(columns.point.begin(), columns.point.end(), [](int k) { return k >= 0; });
    if (columns.normal[0] < 0 || columns.normal[1] < 0 || columns.normal[2] < 0) columns.normal = {-1, -1, -1};
    if (columns.point[0] >= 0 && columns.point[1] >= 0 && columns.point[2] >= 0) return columns;
    if (anyAxis || polar || hasProbeNames(layout)) throwNoCoordinates(layout);

    // Without usable names: the first three columns of numbers, after a row number.
    std::vector<int> candidates;
    for (std::size_t k = 0; k < roles.size(); ++k)
        if (layout.columns[k].is_number && roles[k] == CloudRole::Unknown) candidates.push_back(static_cast<int>(k));
    const auto column = [&](std::size_t i) { return layout.columns[static_cast<std::size_t>(candidates[i])]; };
    // Row and column of a scanner's grid in front of x, y, z.
    if (candidates.size() >= 5 && column(0).is_grid_index && column(1).is_grid_index && column(0).name.empty() &&
        column(2).has_decimal_marks && column(3).has_decimal_marks && column(4).has_decimal_marks) {
        candidates.erase(candidates.begin(), candidates.begin() + 2);
        columns.grid_left_out = true;
    } else if (candidates.size() >= 4 && column(0).is_count && column(0).name.empty() &&
               (column(1).has_decimal_marks || column(2).has_decimal_marks)) {
        candidates.erase(candidates.begin());
    }
    if (candidates.size() < 3) throwNoCoordinates(layout);
    // Rejects columns of other quantities, such as forces over time, that would be read as points.
    const std::vector<std::size_t> taken(candidates.begin(), candidates.begin() + 3);
    if (haveNamesOfOtherQuantities(layout, taken)) throwNoCoordinates(layout);
    std::copy_n(candidates.begin(), 3, columns.point.begin());
    if (!layout.has_names && candidates.size() == 6) {
        std::copy_n(candidates.begin() + 3, 3, columns.normal.begin());
        columns.normals_guessed = true;
    }
    return columns;
}

std::optional<LengthScale> pointUnit(const TableLayout& layout, const PointColumns& columns)
{
    std::optional<LengthScale> unit;
    for (const int k : columns.point) {
        const std::optional<LengthScale>& found = layout.columns[static_cast<std::size_t>(k)].unit;
        if (unit && found && found->key != unit->key)
            throw Error(errors::malformed, {{"line", layout.body_line},
                                            {"column", std::int64_t{1}},
                                            {"found", found->key},
                                            {"expected", LT_TEXT("Engine", "one unit for x, y and z")}});
        if (found) unit = found;
    }
    return unit ? unit : layout.unit;
}

/// Reads points and normals together and separates them.
TableRows readWithNormals(std::string_view text, const TableLayout& layout, const std::vector<WantedColumn>& wanted,
                          bool guessed, const Progress& progress, Scan& scan)
{
    std::unique_ptr<double[]> values;
    TableRows rows = readRows(
        text, layout, wanted,
        [&values](std::size_t count) { return (values = std::unique_ptr<double[]>(new double[count * 6])).get(); },
        progress);
    scan.points_mm.resize(rows.rows);
    scan.normals.resize(rows.rows);
    const bool unitLength = parallelReduce(
        rows.rows, pointsPerTask, progress, true,
        [&](std::size_t begin, std::size_t end) {
            bool all = true;
            for (std::size_t i = begin; i < end; ++i) {
                const Eigen::Map<const Eigen::Vector3d> normal(&values[6 * i + 3]);
                scan.points_mm[i] = Eigen::Map<const Eigen::Vector3d>(&values[6 * i]);
                scan.normals[i] = normal.cast<float>();
                all = all && std::abs(normal.squaredNorm() - 1) < 0.01;
            }
            return all;
        },
        [](bool a, bool b) { return a && b; });
    // Without names, three columns are normals only when they all have unit length (else colours, for instance).
    if (guessed && !unitLength) scan.normals.clear();
    return rows;
}

}  // namespace

RawScan readTextScan(const ScanSource& source)
{
    refuseProgram(source.text, LT_TEXT("Engine", "points as text"));
    TableExpectation expectation;
    expectation.minimum_columns = 3;
    expectation.knows_name = [](const std::string& name) {
        const CloudRole role = cloudRoleOf(name);
        return role != CloudRole::Unknown && role != CloudRole::Other;
    };
    const TableLayout layout = findLayout(source.text, expectation, source.options);
    const PointColumns columns = findPointColumns(layout);

    RawScan raw;
    raw.stated_unit = pointUnit(layout, columns);
    raw.facts.format = "xyz_text";
    const double largest = largestCoordinate(raw.stated_unit, source.options);
    std::vector<WantedColumn> wanted;
    for (const int k : columns.point) wanted.push_back({static_cast<std::size_t>(k), largest, false});
    TableRows rows;
    const Progress reading = source.progress.part(0, 0.9, LT_TEXT("Engine", "Reading"));
    if (columns.normal[0] >= 0) {
        for (const int k : columns.normal)
            wanted.push_back({static_cast<std::size_t>(k), std::numeric_limits<double>::infinity(), true});
        rows = readWithNormals(source.text, layout, wanted, columns.normals_guessed, reading, raw.scan);
    } else {
        std::vector<Eigen::Vector3d>& points = raw.scan.points_mm;
        rows = readRows(
            source.text, layout, wanted,
            [&points](std::size_t count) {
                points.resize(count);
                return points.empty() ? nullptr : points.front().data();
            },
            reading);
        points.resize(rows.rows);
    }
    describeTable(layout, rows, source.encoding, raw.facts, raw.notes);
    // Three columns without names need no note on the choice.
    const std::array<std::size_t, 3> read{wanted[0].column, wanted[1].column, wanted[2].column};
    if (columns.grid_left_out)
        raw.notes.push_back({notes::columnsGuessed, {{"columns", std::string("row,column,x,y,z")}}});
    if (layout.has_names || layout.columns.size() > 3) noteColumns(layout, read, raw.facts, raw.notes);
    raw.not_finite = rows.not_finite;
    raw.skipped_count = countSkipped(layout, rows);
    raw.places.first_line = layout.body_line;
    return raw;
}

}  // namespace lathelier::io
