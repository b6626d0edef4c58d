// Dispatch of probe records: a recorder's pair of files, or a table.
#include "engine/io/probe/probe_reader.h"
#include "engine/io/probe/lgraph.h"
#include "engine/io/probe/probe_table.h"

#include <algorithm>
#include <filesystem>

#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/io/probe/lgraph_header.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

namespace fs = std::filesystem;

std::string extensionOf(const std::string& path)
{
    return lowerCase(fs::path(path).extension().string());
}

std::string stemOf(const fs::path& path)
{
    return path.stem().string();
}

/// The files beside `path` with the same name and this extension, in any case; an equal case comes first.
std::vector<std::string> allBeside(const std::string& path, const std::string& extension)
{
    const fs::path given(path);
    const fs::path folder = given.has_parent_path() ? given.parent_path() : fs::path(".");
    const std::string stem = stemOf(given);
    std::vector<std::pair<int, std::string>> candidates;
    std::error_code problem;
    for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end; entry.increment(problem)) {
        const fs::path& beside = entry->path();
        if (extensionOf(beside.string()) != extension || lowerCase(stemOf(beside)) != lowerCase(stem)) continue;
        const fs::path asGiven = given.has_parent_path() ? beside : beside.filename();
        const bool isUpper = given.extension().string() != extensionOf(path);
        const bool sameCase = (beside.extension().string() != extension) == isUpper;
        candidates.emplace_back((stemOf(beside) == stem ? 0 : 2) + (sameCase ? 0 : 1), asGiven.string());
    }
    std::sort(candidates.begin(), candidates.end());
    std::vector<std::string> names;
    names.reserve(candidates.size());
    for (auto& [rank, name] : candidates) names.push_back(std::move(name));
    return names;
}

std::optional<std::string> findBeside(const std::string& path, const std::string& extension)
{
    const std::vector<std::string> names = allBeside(path, extension);
    return names.empty() ? std::nullopt : std::optional(names.front());
}

/// True when the file starts as the .par of an L-Graph.
bool isLGraphPar(const std::string& path)
{
    try {
        return hasLGraphSignature(fileHead(path, headForKind));
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

RecordFiles findRecordFiles(const std::string& path, std::string_view bytes)
{
    const std::string extension = extensionOf(path);
    if (hasLGraphSignature(bytes) || (extension == ".par" && !looksLikeText(bytes))) {
        const auto dat = findBeside(path, ".dat");
        return {RecordFiles::Kind::LGraph, path, dat.value_or("")};
    }
    if (extension != ".dat") return {};
    const auto par = findBeside(path, ".par");
    if (par && isLGraphPar(*par)) return {RecordFiles::Kind::LGraph, *par, path};
    if (looksLikeText(bytes)) return {};
    return {RecordFiles::Kind::LGraph, par.value_or(""), path};
}

std::vector<std::string> recordPartners(const std::string& path)
{
    const std::string extension = extensionOf(path);
    if (extension == ".par") return allBeside(path, ".dat");
    if (extension == ".dat") return allBeside(path, ".par");
    return {};
}

void requirePartner(const RecordFiles& files)
{
    if (files.kind != RecordFiles::Kind::LGraph || (!files.par.empty() && !files.dat.empty())) return;
    const std::string& given = files.par.empty() ? files.dat : files.par;
    const fs::path partner = fs::path(given).replace_extension(files.par.empty() ? ".par" : ".dat");
    throw Error(errors::partnerMissing,
                {{"path", given}, {"byte", std::int64_t{0}}, {"partner", partner.filename().string()}});
}

ProbeFile readProbeRecord(const std::string& path, const ImportOptions& options, const RecorderOptions& recorder,
                          const Progress& progress)
{
    InputFiles inputs(false);
    return readProbeRecord(path, inputs.open(path, progress), inputs, options, recorder, progress);
}

ProbeFile readProbeRecord(const std::string& path, std::string_view bytes, InputFiles& inputs,
                          const ImportOptions& options, const RecorderOptions& recorder, const Progress& progress)
{
    const RecordFiles files = findRecordFiles(path, bytes);
    if (files.kind == RecordFiles::Kind::Table)
        return readProbeTable(path, bytes, options, progress, [&](std::size_t count) { inputs.release(path, count); });
    requirePartner(files);
    const bool isPar = files.par == path;
    const std::string_view partner = inputs.open(isPar ? files.dat : files.par, progress);
    ProbeFile record =
        readLGraph(files.par, isPar ? bytes : partner, isPar ? partner : bytes, recorder, progress, files.dat);
    record.facts.path = path;
    return record;
}

}  // namespace lathelier::io
