#include "engine/io/profile/profile_reader.h"

#include "engine/io/cloud/scan_reader.h"
#include "engine/io/cloud/unit_choice.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/io/probe/probe_reader.h"
#include "engine/io/profile/profile_points.h"
#include "engine/io/table/table_facts.h"
#include "engine/io/text/header_lines.h"
#include "engine/io/text/readable_text.h"

namespace lathelier::io {
namespace {

using Shape = ProfileColumnChoice::Shape;

constexpr Text expectedProfile = LT_TEXT("Engine", "a profile as text: x and y, or angle and r");

void readProfileValues(std::string_view text, const ImportOptions& import, const Progress& progress, RawProfile& raw)
{
    std::vector<WantedColumn> wanted;
    const double largest = largestCoordinate(statedUnit(raw), import);
    for (const std::size_t column : raw.choice.columns) wanted.push_back({column, largest, false});
    raw.rows = readRows(
        text, raw.layout, wanted,
        [&raw](std::size_t count) {
            raw.values.resize(count * raw.width());
            return raw.values.data();
        },
        progress);
    raw.values.resize(raw.rows.rows * raw.width());
}

ProfileFile readProfileTable(const std::string& name, const DecodedText& text, const ImportOptions& import,
                             const ProfileOptions& options, const Progress& progress)
{
    RawProfile raw;
    raw.layout = findLayout(text.view(), profileExpectation(), import);
    raw.file.header = readHeaderLines(text.view(), raw.layout.body_offset);
    raw.choice = chooseProfileColumns(raw.layout, options.columns);
    readProfileValues(text.view(), import, progress.part(0, 0.8, LT_TEXT("Engine", "Reading")), raw);
    describeTable(raw.layout, raw.rows, text.encoding(), raw.file.facts, raw.file.notes);
    if (raw.rows.rows == 0) throw Error(errors::noPoints, {});
    if (raw.choice.shape == Shape::Undecided) {
        const bool angles = holdsAngles(raw.values, raw.layout);
        raw.choice.shape = angles ? Shape::Polar : Shape::Xy;
        raw.file.notes.push_back({notes::columnsGuessed, {{"columns", std::string(angles ? "angle,r" : "x,y")}}});
    }
    if (raw.choice.shape == Shape::Polar || raw.choice.shape == Shape::Trace)
        layPolar(raw, import, options, progress);
    else
        layXy(raw, import, progress);
    noteColumns(raw.layout, raw.choice.columns, raw.file.facts, raw.file.notes);
    raw.file.profile.name = name.substr(name.find_last_of('/') + 1);
    set(raw.file.facts.details, "points", static_cast<std::int64_t>(raw.file.profile.points_mm.size()));
    finishTableNotes(raw.layout, raw.rows, name, raw.file.facts, raw.file.notes);
    progress.report(1);
    return std::move(raw.file);
}

}  // namespace

const std::vector<Field<ProfileOptions>>& fieldsOf(const ProfileOptions*)
{
    static const std::vector<Field<ProfileOptions>> all = {
        field("columns", &ProfileOptions::columns,
              {{"auto", LT_TEXT("Engine", "automatic")},
               {"x,y", {"x, y"}},
               {"angle,radius", LT_TEXT("Engine", "angle, radius")}},
              {LT_TEXT("Engine", "Columns"), LT_TEXT("Engine", "What the columns of a profile without names hold.")}),
        field("nominal_radius_mm", &ProfileOptions::nominal_radius_mm, {1e-3, 1e6},
              {LT_TEXT("Engine", "Nominal radius"),
               LT_TEXT("Engine", "Radius that the deviations are laid on, when a file holds nothing but deviations."),
               {"mm"}}),
    };
    return all;
}

ProfileFile readProfile(const std::string& name, std::string_view bytes, const ImportOptions& options,
                        const ProfileOptions& profile, const Progress& progress)
{
    try {
        const DecodedText text = readableTable(name, bytes, options.encoding, expectedProfile, progress);
        return readProfileTable(name, text, options, profile, progress);
    } catch (Error& error) {
        error.with("path", name);
        throw;
    }
}

ProfileFile readProfile(const std::string& path, const ImportOptions& options, const ProfileOptions& profile,
                        const Progress& progress)
{
    const FileBytes file(path, progress);
    return readProfile(path, file.view(), options, profile, progress);
}

bool isProfileTable(std::string_view bytes, const ImportOptions& options, ProfileColumns columns)
{
    try {
        const std::string_view head = bytes.substr(0, headForKind);
        const DecodedText text = readableTable({}, head, options.encoding, expectedProfile, {});
        const TableLayout layout = findLayout(text.view(), profileExpectation(), options);
        return chooseProfileColumns(layout, columns).shape != Shape::Xyz;
    } catch (const Error& error) {
        return error.code() == errors::columnsAmbiguous;  // several columns of angles or radii
    }
}

}  // namespace lathelier::io
