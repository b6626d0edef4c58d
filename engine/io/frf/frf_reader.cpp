#include "engine/io/frf/frf_reader.h"

#include <algorithm>
#include <filesystem>

#include "engine/io/file.h"
#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/frf_mat.h"
#include "engine/io/frf/frf_noise.h"
#include "engine/io/frf/frf_table.h"
#include "engine/io/frf/uff_frf.h"
#include "engine/io/io_codes.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

constexpr const char* unitKeys[] = {"auto", "mm/N", "m/N", "mm/s/N", "m/s/N", "mm/s2/N", "m/s2/N"};

FileFacts uffFileFacts(const std::string& name, const UffFile& file)
{
    FileFacts facts;
    facts.path = name;
    facts.format = "UFF";
    Rows sets;
    for (const UffSet& set : file.sets) sets.rows.push_back(uffFacts(set));
    if (file.units) facts.unit = file.units->description;
    if (file.units) facts.unit_source = "stated";
    set(facts.details, "datasets", std::move(sets));
    if (!file.nodes.empty()) set(facts.details, "nodes", static_cast<std::int64_t>(file.nodes.size()));
    return facts;
}

bool hasExtension(const std::string& name, std::initializer_list<std::string_view> extensions)
{
    const std::string extension = lowerCase(std::filesystem::path(name).extension().string());
    return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

bool isUffFile(const std::string& name, std::string_view bytes)
{
    return isUff(bytes) || (!isMat(bytes) && hasExtension(name, {".uff", ".unv"}));
}

bool isMatFile(const std::string& name, std::string_view bytes)
{
    return isMat(bytes) || (!isUff(bytes) && hasExtension(name, {".mat"}));
}

/// The path of a note, and of an error on its way up.
template <class Read>
auto withPath(const std::string& name, Notes& notes, Read read)
{
    try {
        auto result = read();
        for (Note& note : notes)
            if (!find(note.values, "path")) set(note.values, "path", name);
        return result;
    } catch (Error& error) {
        throw error.with("path", name);
    }
}

FrfFile readAnyFrf(const std::string& name, std::string_view bytes, const ImportOptions& options, const FrfOptions& frf,
                   const Progress& progress)
{
    if (isMatFile(name, bytes)) return readFrfMat(name, bytes, frf, progress);
    if (!isUffFile(name, bytes)) return readFrfTable(name, bytes, options, frf, progress);
    UffFile uff = readUff(bytes, progress);
    FrfFile file;
    file.notes = std::move(uff.notes);
    file.frfs = uffFrfs(uff, frf, file.notes);
    file.facts = uffFileFacts(name, uff);
    return file;
}

/// Notes of reading the responses; their absence is not noted.
template <class Read>
void remark(Notes& notes, Read read)
{
    try {
        Notes more = read();
        notes.insert(notes.end(), more.begin(), more.end());
    } catch (const Error&) {
        // `inspect` describes the file anyway
    }
}

FileFacts factsOfAny(const std::string& name, std::string_view bytes, const ImportOptions& options,
                     const FrfOptions& frf, Notes& notes, const Progress& progress)
{
    if (isMatFile(name, bytes)) {
        FileFacts facts = matFacts(name, readMatVariables(bytes, progress));
        remark(notes, [&] { return readFrfMat(name, bytes, frf, progress).notes; });
        return facts;
    }
    if (isUffFile(name, bytes)) {
        UffFile file = readUff(bytes, progress);
        notes.insert(notes.end(), file.notes.begin(), file.notes.end());
        remark(notes, [&] {
            Notes more;
            uffFrfs(file, frf, more);
            return more;
        });
        return uffFileFacts(name, file);
    }
    FrfFile file = readFrfTable(name, bytes, options, frf, progress);
    notes.insert(notes.end(), file.notes.begin(), file.notes.end());
    return file.facts;
}

}  // namespace

Likeness likeFrf(const std::string& path, std::string_view head, const ImportOptions& options)
{
    if (isUff(head) || isMat(head) || isFrfTable(head, options)) return Likeness::Certain;
    return hasExtension(path, {".uff", ".unv", ".mat"}) ? Likeness::Likely : Likeness::No;
}

const std::vector<Field<FrfOptions>>& fieldsOf(const FrfOptions*)
{
    static const std::vector<Field<FrfOptions>> all = {
        field("frf_unit", &FrfOptions::frf_unit,
              {{"auto", LT_TEXT("Engine", "as stated")},
               {"mm/N", {"mm/N"}},
               {"m/N", {"m/N"}},
               {"mm/s/N", {"mm/s/N"}},
               {"m/s/N", {"m/s/N"}},
               {"mm/s2/N", {"mm/s²/N"}},
               {"m/s2/N", {"m/s²/N"}}},
              {LT_TEXT("Engine", "Unit of the response"),
               LT_TEXT("Engine", "Unit of a frequency response that states none. A stated unit always rules.")}),
        field("variables", &FrfOptions::variables,
              {LT_TEXT("Engine", "Variables"),
               LT_TEXT("Engine", "Of a MAT file, where names do not tell: f=NAME,H=NAME.")}),
    };
    return all;
}

std::string frfUnitKey(FrfUnitChoice choice)
{
    return unitKeys[static_cast<std::size_t>(choice)];
}

std::optional<FrfUnit> frfUnit(FrfUnitChoice choice)
{
    return choice == FrfUnitChoice::Auto ? std::nullopt : frfUnit(std::string_view(frfUnitKey(choice)));
}

FrfFile readFrf(const std::string& name, std::string_view bytes, const ImportOptions& options, const FrfOptions& frf,
                const Progress& progress)
{
    Notes none;
    FrfFile file = withPath(name, none, [&] { return readAnyFrf(name, bytes, options, frf, progress); });
    for (Note& note : file.notes)
        if (!find(note.values, "path")) set(note.values, "path", name);
    for (MeasuredFrf& one : file.frfs) one.frf.noise = noiseOf(one.frf);
    return file;
}

FrfFile readFrf(const std::string& path, const ImportOptions& options, const FrfOptions& frf, const Progress& progress)
{
    const FileBytes file(path, progress);
    return readFrf(path, file.view(), options, frf, progress);
}

FileFacts readFrfFacts(const std::string& name, std::string_view bytes, const ImportOptions& options,
                       const FrfOptions& frf, Notes& notes, const Progress& progress)
{
    return withPath(name, notes, [&] { return factsOfAny(name, bytes, options, frf, notes, progress); });
}

}  // namespace lathelier::io
