#include "engine/cam/plan_programs.h"

#include <algorithm>
#include <string_view>

#include "engine/cam/plan_outcome.h"

namespace lathelier::cam {
namespace {

std::vector<std::string_view> linesOf(const std::string& text)
{
    std::vector<std::string_view> lines;
    std::size_t from = 0;
    while (from < text.size()) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        lines.emplace_back(text.data() + from, end - from);
        from = end + 1;
    }
    return lines;
}

/// Locates the first block of each operation in the new text by the next equal line.
void updateFirstLines(SetupPlan& setup, const std::string& text)
{
    const std::vector<std::string_view> before = linesOf(setup.text), now = linesOf(text);
    std::size_t from = 0;
    for (PlannedOperation& operation : setup.operations) {
        if (operation.first_line < 1 || operation.first_line > static_cast<std::int64_t>(before.size())) continue;
        const std::string_view wanted = before[static_cast<std::size_t>(operation.first_line - 1)];
        const auto found = std::find(now.begin() + static_cast<std::ptrdiff_t>(from), now.end(), wanted);
        operation.first_line = found == now.end() ? 0 : found - now.begin() + 1;
        if (found != now.end()) from = static_cast<std::size_t>(found - now.begin()) + 1;
    }
}

/// The parsed program without results of the check.
CheckResult withoutFindings(CheckResult check)
{
    CheckResult read;
    read.parameters = check.parameters;
    read.program = std::move(check.program);
    read.path = std::move(check.path);
    read.stock_zero_mm = check.stock_zero_mm;
    return read;
}

}  // namespace

TurningPlan withPrograms(TurningPlan plan, const std::vector<GivenProgram>& given, const TurningInputs& inputs,
                         const Progress& progress)
{
    bool is_other = false, is_open = false;
    const double share = 1.0 / static_cast<double>(plan.setups.size());
    std::vector<GivenProgram> all;
    for (std::size_t i = 0; i < plan.setups.size(); ++i) {
        SetupPlan& setup = plan.setups[i];
        const auto own = std::find_if(given.begin(), given.end(), [i](const GivenProgram& g) { return g.setup == i; });
        all.push_back(own == given.end() ? GivenProgram{i, setup.text, {}, true, true} : *own);
        if (own != given.end()) {
            updateFirstLines(setup, own->text);
            setup.text = own->text;
            is_other = true;
        }
        if (!is_other) continue;
        const bool meets_errors = i > 0 && plan.setups[i - 1].check.path.has_errors;
        if (!meets_errors)
            setup.check = checkProgram(
                plan.part, plan.job, all[i], i > 0 ? &all[i - 1] : nullptr, setup.check.parameters, inputs.post,
                progress.part(share * static_cast<double>(i), share * static_cast<double>(i + 1)));
        is_open = is_open || meets_errors || setup.check.path.has_errors || !all[i].is_checked;
        if (is_open) setup.check = withoutFindings(std::move(setup.check));
    }
    if (is_other) conclude(plan);
    progress.report(1);
    return plan;
}

}  // namespace lathelier::cam
