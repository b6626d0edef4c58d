#include "engine/cad/task/compare_copies.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/features/comparison/shaft_mesh.h"
#include "engine/io/file.h"
#include "engine/registration/drawn_reference.h"
#include "engine/registration/verdict/verdict.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/task/memo.h"

namespace lathelier::cad {
namespace {

struct KnownCopy {
    InputFile file;                      ///< that it was read from
    registration::CompareResult result;  ///< CompareDetail::Summary
};

struct KnownCopies : Memo<KnownCopy> {
    KnownCopies() : Memo(64) {}
};

std::string nameOf(const std::string& path)
{
    return std::filesystem::path(path).filename().string();
}

/// By the stamp of the file: it is not read to know whether it was compared.
std::string keyOf(const project::Source& source, const CompareOutcome& outcome)
{
    return source.path + '\n' + toJson(source.import).dump() + io::fileStamp(source.path) + outcome.reference.key +
           toJson(toValues(fittedOf(outcome.question.compare))).dump();
}

KnownCopy compared(const project::Source& source, const CompareOutcome& outcome, const Progress& progress)
{
    task::CacheOf<io::ScanInput> once;  // released at the end: the scans of many copies would fill the memory
    const auto scan = once.load(source, progress.part(0, 0.3));
    const Scan& copy = scan->file.scan;
    constexpr auto detail = registration::CompareDetail::Summary;
    const Progress comparing = progress.part(0.3, 1);
    const registration::CompareParameters& asked = outcome.question.compare;
    if (const auto& drawn = outcome.reference.drawn) {
        const registration::DrawnReference reference{features::shaftMesh(drawn->shaft).scan,
                                                     closedContour(drawn->shaft)};
        return {scan->inputs.front(), registration::compare(reference, copy, asked, comparing, detail)};
    }
    return {scan->inputs.front(),
            registration::compare(outcome.reference.scan->file.scan, copy, asked, comparing, detail)};
}

registration::CopySummary summaryOf(const project::Source& source, const CompareOutcome& outcome, KnownCopies& known,
                                    const Progress& progress)
{
    registration::CopySummary copy;
    copy.name = nameOf(source.path);
    try {
        const auto found = known.find(keyOf(source, outcome), progress.part(0, 0.99),
                                      [&](const Progress& part) { return compared(source, outcome, part); });
        registration::CompareResult result = found->result;
        judge(result, outcome.question.compare, progress.part(0.99, 1));
        copy = registration::summaryOf(copy.name, result);
        copy.file = found->file;
    } catch (const Error& error) {
        copy.error = error;
    }
    return copy;
}

}  // namespace

std::vector<project::Source> furtherCopies(const project::PanelState& state)
{
    std::vector<project::Source> sources;
    for (const std::string& key : project::keysOf(state, copiesRole)) sources.push_back(state.inputs.at(key));
    return sources;
}

std::vector<registration::CopySummary> compareCopies(const CompareOutcome& outcome, Stores& stores,
                                                     const Progress& progress)
{
    const std::string& first = outcome.asked.inputs.at(copyRole).path;
    std::vector<registration::CopySummary> all{registration::summaryOf(nameOf(first), *outcome.result)};
    const std::vector<project::Source> sources = furtherCopies(withUnits(outcome.asked, outcome.question));
    const double share = 1.0 / static_cast<double>(std::max<std::size_t>(1, sources.size()));
    for (const project::Source& source : sources) {
        const double done = static_cast<double>(all.size() - 1) * share;
        all.push_back(summaryOf(source, outcome, *stores.of<KnownCopies>(), progress.part(done, done + share)));
    }
    return all;
}

void addCopies(CompareOutcome& outcome, std::vector<registration::CopySummary> copies)
{
    for (const registration::CopySummary& copy : copies)
        if (copy.file) outcome.sources.inputs.push_back(*copy.file);
    outcome.copies = std::move(copies);
}

}  // namespace lathelier::cad
