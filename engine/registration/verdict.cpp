#include "engine/registration/verdict.h"

#include <cmath>
#include <functional>

#include "engine/core/parallel.h"
#include "engine/registration/registration_codes.h"

namespace lathelier::registration {
namespace {

constexpr std::size_t grain = 65536;
constexpr double clearlyAbove = 1.1;

std::int64_t countWithin(const CompareResult& result, double tolerance_mm, const Progress& progress)
{
    const auto count = [&](std::size_t begin, std::size_t end) {
        std::int64_t within = 0;
        for (std::size_t i = begin; i < end; ++i)
            within += result.used[i] && std::abs(static_cast<double>(result.deviation_mm[i])) <= tolerance_mm;
        return within;
    };
    return parallelReduce(result.used.size(), grain, progress, std::int64_t{0}, count, std::plus<>());
}

}  // namespace

bool sameButVerdict(const CompareParameters& a, const CompareParameters& b)
{
    return a.method == b.method && a.symmetry == b.symmetry && a.initial == b.initial &&
           a.max_distance_mm == b.max_distance_mm && a.exclude_z_mm == b.exclude_z_mm;
}

void judge(CompareResult& result, const CompareParameters& parameters, const Progress& progress)
{
    result.parameters.tolerance_mm = parameters.tolerance_mm;
    result.parameters.pass_percent = parameters.pass_percent;
    result.parameters.scanner_accuracy_mm = parameters.scanner_accuracy_mm;
    result.within_tolerance_percent.reset();
    result.verdict.reset();
    result.distinguishable_from_scanner.reset();
    std::erase_if(result.notes, [](const Note& note) { return note.code == notes::notDistinguishable; });

    if (parameters.tolerance_mm && result.statistics.points_used > 0) {
        const std::int64_t within = countWithin(result, *parameters.tolerance_mm, progress);
        result.within_tolerance_percent =
            100.0 * static_cast<double>(within) / static_cast<double>(result.statistics.points_used);
        result.verdict = *result.within_tolerance_percent >= parameters.pass_percent ? Verdict::Pass : Verdict::Fail;
    }
    if (parameters.scanner_accuracy_mm) {
        result.distinguishable_from_scanner =
            result.statistics.rmse_mm > clearlyAbove * *parameters.scanner_accuracy_mm;
        if (!*result.distinguishable_from_scanner)
            result.notes.push_back(
                {notes::notDistinguishable, {{"scanner_accuracy_mm", *parameters.scanner_accuracy_mm}}});
    }
}

}  // namespace lathelier::registration
