#include "engine/cam/plan_programs.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace lathelier::cam {
namespace {

constexpr double kUmPerMm = 1000;

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

/// Where the first blocks of operations stand in the new text: the next line that reads the same.
void followLines(SetupPlan& setup, const std::string& text)
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

CheckResult checkedAgain(const TurningPlan& plan, std::size_t index, const std::string& text,
                         const StatedCorrection& correction, const TurningInputs& inputs, const Progress& progress)
{
    CheckInputs further;
    further.correction = correction;
    const bool is_b = inputs.post.dialect && inputs.post.is_system_b;
    if (index > 0) {
        further.before = plan.setups[index - 1].text;
        if (is_b) further.before = asSystemA(*further.before);
    }
    return checkTurning(is_b ? asSystemA(text) : text, plan.part, plan.job, plan.setups[index].check.parameters,
                        further, progress);
}

/// What was read of a program; nothing that a check says of it.
CheckResult readAlone(CheckResult check)
{
    CheckResult read;
    read.parameters = check.parameters;
    read.program = std::move(check.program);
    read.path = std::move(check.path);
    read.stock_zero_mm = check.stock_zero_mm;
    return read;
}

/// Measured on the last clamping's check, which has seen the cuts of all; causes that the plan knew stay.
std::vector<RestInterval> restOf(const TurningPlan& plan)
{
    std::vector<RestInterval> all;
    const SetupPlan& last = plan.setups.back();
    for (RestInterval rest : last.check.rest) {
        if (last.clamping.is_mirrored) {
            const double from = rest.z_start_mm;
            rest.z_start_mm = plan.part.length_mm() - rest.z_end_mm;
            rest.z_end_mm = plan.part.length_mm() - from;
        }
        for (const RestInterval& known : plan.rest) {
            const bool meets = rest.z_start_mm <= known.z_end_mm && rest.z_end_mm >= known.z_start_mm;
            if (meets && std::abs(known.left_mm - rest.left_mm) <= gougeLimit_mm) rest.cause = known.cause;
        }
        all.push_back(rest);
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const RestInterval& a, const RestInterval& b) { return a.z_start_mm < b.z_start_mm; });
    return all;
}

}  // namespace

TurningPlan withPrograms(TurningPlan plan, const std::vector<GivenProgram>& given, const TurningInputs& inputs,
                         const Progress& progress)
{
    bool is_other = false, is_open = false;
    const double share = 1.0 / static_cast<double>(plan.setups.size());
    for (std::size_t i = 0; i < plan.setups.size(); ++i) {
        SetupPlan& setup = plan.setups[i];
        const auto own = std::find_if(given.begin(), given.end(), [i](const GivenProgram& g) { return g.setup == i; });
        if (own != given.end()) {
            followLines(setup, own->text);
            setup.text = own->text;
            is_other = true;
        }
        if (!is_other) continue;
        const bool meets_errors = i > 0 && plan.setups[i - 1].check.path.has_errors;
        if (!meets_errors)
            setup.check =
                checkedAgain(plan, i, setup.text, own == given.end() ? StatedCorrection{} : own->correction, inputs,
                             progress.part(share * static_cast<double>(i), share * static_cast<double>(i + 1)));
        is_open = is_open || meets_errors || setup.check.path.has_errors || (own != given.end() && !own->is_checked);
        if (is_open) setup.check = readAlone(std::move(setup.check));
    }
    if (!is_other) return plan;
    plan.rest = restOf(plan);
    plan.left_max_mm = 0;
    for (const RestInterval& rest : plan.rest) plan.left_max_mm = std::max(plan.left_max_mm, rest.left_mm);
    plan.is_refused = std::any_of(plan.setups.begin(), plan.setups.end(), [](const SetupPlan& setup) {
        return setup.check.path.has_errors || !setup.check.findings.empty() ||
               setup.check.gouge_um > kUmPerMm * gougeLimit_mm;
    });
    plan.verdict.reset();
    if (!is_open) plan.verdict = plan.is_refused || !plan.rest.empty() ? Verdict::Fail : Verdict::Pass;
    progress.report(1);
    return plan;
}

}  // namespace lathelier::cam
