#include "engine/io/file_kind.h"

#include <algorithm>
#include <filesystem>

#include "engine/core/error.h"
#include "engine/io/cloud/scan_reader.h"
#include "engine/io/file.h"
#include "engine/io/frf/frf_reader.h"
#include "engine/io/probe/probe_reader.h"
#include "engine/io/profile/profile_reader.h"
#include "engine/io/qdas/dfq_reader.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/readable_text.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

template <class File>
FileFacts factsOf(const File& file, Notes& notes)
{
    notes.insert(notes.end(), file.notes.begin(), file.notes.end());
    return file.facts;
}

/// A table without headings of another quantity may contain points.
Likeness likeScan(const std::string& path, std::string_view head, const Values&)
{
    if (hasScanFormat(head)) return Likeness::Certain;
    try {
        refuseForeignName(path, false, LT_TEXT("Engine", "a point cloud or a mesh"));
        return Likeness::Possible;
    } catch (const Error&) {
        return Likeness::No;
    }
}

Likeness likeProfile(const std::string& path, std::string_view head, const Values& reading)
{
    try {
        refuseForeignName(path, true, LT_TEXT("Engine", "a table of a profile"));
    } catch (const Error&) {
        return Likeness::No;
    }
    const bool fits =
        isProfileTable(head, fromValues<ImportOptions>(reading), fromValues<ProfileOptions>(reading).columns);
    return fits ? Likeness::Likely : Likeness::No;
}

/// An L-Graph pair that is whole is certain; a single binary .dat may be one.
Likeness likeProbeRecord(const std::string& path, std::string_view head, const Values& reading)
{
    const RecordFiles files = findRecordFiles(path, head);
    const bool is_pair = files.kind == RecordFiles::Kind::LGraph;
    if (is_pair) return files.par.empty() ? Likeness::Likely : Likeness::Certain;
    return isProbeTable(head, fromValues<ImportOptions>(reading)) ? Likeness::Certain : Likeness::No;
}

Likeness likeQdas(const std::string& path, std::string_view head, const Values&)
{
    const std::string extension = lowerCase(std::filesystem::path(path).extension().string());
    return isDfq(head) || extension == ".dfq" ? Likeness::Certain : Likeness::No;
}

std::vector<std::string> pairsOnce(const std::vector<std::string>& paths)
{
    std::vector<std::string> result;
    for (const std::string& path : paths) {
        const std::vector<std::string> partners = recordPartners(path);
        const bool given = std::any_of(partners.begin(), partners.end(), [&](const std::string& partner) {
            return std::find(paths.begin(), paths.end(), partner) != paths.end();
        });
        const bool is_dat = lowerCase(std::filesystem::path(path).extension().string()) == ".dat";
        if (!(given && is_dat)) result.push_back(path);
    }
    return result;
}

}  // namespace

KindFound likeliestKind(const FileKinds& kinds, const std::string& path, std::string_view head, const Values& reading)
{
    head = head.substr(0, headForKind);
    KindFound best;
    for (const FileKind* kind : kinds)
        if (const Likeness likeness = kind->sniff(path, head, reading); likeness > best.likeness)
            best = {kind, likeness};
    return best;
}

KindFound findKind(const FileKinds& kinds, const std::string& path, const Values& reading)
{
    try {
        return likeliestKind(kinds, path, fileHead(path, headForKind), reading);
    } catch (const Error&) {
        return {};
    }
}

void unite(FileKinds& kinds, const FileKinds& more)
{
    for (const FileKind* kind : more)
        if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
}

const FileKind& scanFiles()
{
    static const FileKind kind{
        "scan",
        LT_TEXT("Engine", "Point clouds and meshes"),
        "*.xyz *.asc *.csv *.txt *.pts *.ply *.pcd *.stl *.obj",
        {},
        {},
        likeScan,
        [](const FileToRead& file, Notes& notes) {
            return factsOf(readScan(file.path, file.bytes, fromValues<ImportOptions>(file.reading), file.progress),
                           notes);
        }};
    return kind;
}

const FileKind& profileFiles()
{
    static const FileKind kind{"profile",
                               LT_TEXT("Engine", "Profiles"),
                               "*.csv *.txt *.tsv *.xy *.asc *.dat",
                               infos<ProfileOptions>(),
                               toValues(ProfileOptions{}),
                               likeProfile,
                               [](const FileToRead& file, Notes& notes) {
                                   return factsOf(
                                       readProfile(file.path, file.bytes, fromValues<ImportOptions>(file.reading),
                                                   fromValues<ProfileOptions>(file.reading), file.progress),
                                       notes);
                               }};
    return kind;
}

const FileKind& probeRecordFiles()
{
    static const FileKind kind{
        "probe_record",
        LT_TEXT("Engine", "Probe records"),
        "*.csv *.txt *.tsv *.dat *.par *.DAT *.PAR",
        infos<RecorderOptions>(),
        toValues(RecorderOptions{}),
        likeProbeRecord,
        [](const FileToRead& file, Notes& notes) {
            return factsOf(readProbeRecord(file.path, file.bytes, file.inputs, fromValues<ImportOptions>(file.reading),
                                           fromValues<RecorderOptions>(file.reading), file.progress),
                           notes);
        },
        pairsOnce};
    return kind;
}

const FileKind& qdasFiles()
{
    static const FileKind kind{"qdas",
                               LT_TEXT("Engine", "Q-DAS characteristics"),
                               "*.dfq",
                               {},
                               {},
                               likeQdas,
                               [](const FileToRead& file, Notes&) { return readDfqFacts(file.path, file.bytes); }};
    return kind;
}

const FileKind& frfFiles()
{
    static const FileKind kind{"frf",
                               LT_TEXT("Engine", "Frequency responses"),
                               "*.uff *.unv *.csv *.txt *.mat *.frf",
                               infos<FrfOptions>(),
                               toValues(FrfOptions{}),
                               [](const std::string& path, std::string_view head, const Values& reading) {
                                   return likeFrf(path, head, fromValues<ImportOptions>(reading),
                                                  fromValues<FrfOptions>(reading));
                               },
                               [](const FileToRead& file, Notes& notes) {
                                   return readFrfFacts(file.path, file.bytes, fromValues<ImportOptions>(file.reading),
                                                       fromValues<FrfOptions>(file.reading), notes, file.progress);
                               }};
    return kind;
}

}  // namespace lathelier::io
