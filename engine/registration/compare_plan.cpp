#include "engine/registration/compare_plan.h"

#include "engine/core/parallel.h"
#include "engine/registration/registration_codes.h"
#include "engine/registration/revolution/revolution_refusal.h"

namespace lathelier::registration {
namespace {

Note methodNote(const char* method, Text reason, const ComparePlan& plan)
{
    Note note{notes::methodChosen, {{"method", std::string(method)}, {"reason", reason}}};
    const auto add = [&](const char* name, const RevolutionFit& fit) {
        if (fit.iterations > 0) note.values.emplace_back(name, 100 * fit.consistent_share);
    };
    add("reference_on_one_meridian_percent", plan.reference.fit);
    add("copy_on_one_meridian_percent", plan.copy.fit);
    return note;
}

}  // namespace

ComparePlan makePlan(const std::vector<Eigen::Vector3d>& reference, const std::vector<Eigen::Vector3d>& copy,
                     const CompareParameters& asked, Notes& notes, const Progress& progress)
{
    ComparePlan plan;
    const bool is_auto = asked.method == CompareMethod::Auto;
    const bool forced =
        asked.method == CompareMethod::Revolution || (is_auto && asked.symmetry == Symmetry::Revolution);
    if (!is_auto) plan.method = asked.method;
    if (asked.symmetry == Symmetry::None && !forced) {
        if (is_auto) notes.push_back(methodNote("plane", LT_TEXT("Engine", "symmetry is not to be used"), plan));
        return plan;
    }
    // In parallel: each has serial sections. The copy's fit may turn out not to be needed.
    const bool both_wanted = forced || is_auto;
    parallelFor(both_wanted ? 2 : 1, 1, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (i == 0)
                plan.reference.fit =
                    fitRevolution(reference, progress.part(0, 0.5, LT_TEXT("Engine", "Axis of the reference")));
            else
                plan.copy.fit = fitRevolution(copy, progress.part(0.5, 1, LT_TEXT("Engine", "Axis of the copy")));
    });
    plan.reference_turned = isBodyOfRevolution(plan.reference.fit);
    remarkRevolution(plan.reference.fit, "reference", notes);
    if (forced && !plan.reference_turned) refuseRevolution(plan.reference.fit, "reference");
    if (plan.reference_turned) orientAxis(plan.reference.fit);
    if (!forced && (!is_auto || !plan.reference_turned)) {
        plan.copy = {};
        if (is_auto)
            notes.push_back(methodNote("plane", LT_TEXT("Engine", "the reference is not a body of revolution"), plan));
        return plan;
    }
    const bool copy_turned = isBodyOfRevolution(plan.copy.fit);
    remarkRevolution(plan.copy.fit, "copy", notes);
    if (forced && !copy_turned) refuseRevolution(plan.copy.fit, "copy");
    if (copy_turned) orientAxis(plan.copy.fit);  // the same data give the same frame: compared with itself, exactly
    plan.method = copy_turned ? CompareMethod::Revolution : CompareMethod::Plane;
    if (is_auto)
        notes.push_back(copy_turned
                            ? methodNote("revolution", LT_TEXT("Engine", "both parts are bodies of revolution"), plan)
                            : methodNote("plane", LT_TEXT("Engine", "the copy is not a body of revolution"), plan));
    return plan;
}

}  // namespace lathelier::registration
