#include "engine/cam/drawn/drawn_plan.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/check/drawn_contour.h"
#include "engine/cam/job_bodies.h"
#include "engine/stability/speed_choice.h"

namespace lathelier::cam {
namespace {

constexpr double drawnSpacing_mm = 0.5;
constexpr double narrow = 0.6, wide = 1.6;  // of a speed: range of its chart

ClampingOutcome clampingOutcome(const cam::TurningPlan& plan, std::size_t index, const Progress& progress)
{
    const cam::CheckResult& check = plan.setups[index].check;
    ClampingOutcome outcome;
    outcome.part_zero_mm = check.stock_zero_mm;
    outcome.z_zero_mm = check.stock_zero_mm + check.parameters.z_zero_mm;
    outcome.drawn = stock::DrawnPath(check.path.moves, outcome.z_zero_mm, check.program.blocks.size(), progress);
    outcome.travelled_mm.reserve(outcome.drawn.corners());
    double way = 0;
    for (std::size_t i = 0; i < outcome.drawn.corners(); ++i) {
        if (i > 0 && outcome.drawn.isPiece(i)) {
            const stock::Corner &a = outcome.drawn.corner(i - 1), &b = outcome.drawn.corner(i);
            way += std::hypot(b.z_mm - a.z_mm, b.x_mm - a.x_mm);
        }
        outcome.travelled_mm.push_back(way);
    }
    const cam::DrawnContour drawing(check.parameters.setup == 2 ? cam::mirrored(plan.part) : plan.part, {},
                                    drawnSpacing_mm);
    for (const cam::DrawnPoint& point : drawing.points()) {
        outcome.drawing_z_mm.push_back(point.at.z_mm + check.stock_zero_mm);
        outcome.drawing_x_mm.push_back(point.at.x_mm);
    }
    if (check.stock) {
        stock::StockResult& bare = outcome.bare.emplace();
        bare.parameters = check.stock->parameters;
        bare.step_mm = check.stock->step_mm;
        bare.length_mm = check.stock->length_mm;
        bare.before = check.stock->before;
        bare.findings = check.stock->findings;
    }
    return outcome;
}

std::shared_ptr<const stability::LobeResult> lobesOf(const SectionSpeed& section, const TurningPlan& plan,
                                                     const Progress& progress)
{
    if (!section.receptance) return nullptr;
    stability::LobeParameters parameters;
    parameters.relation = plan.parameters.relation;
    const double asked_rpm = askedSpeed(plan, section);
    const double at_rpm = section.speed_rpm.value_or(asked_rpm);
    parameters.speed_rpm = {{narrow * std::min(at_rpm, asked_rpm), wide * std::max(at_rpm, asked_rpm)}};
    return std::make_shared<const stability::LobeResult>(
        stability::findLobes(*section.receptance, parameters, progress));
}

}  // namespace

TurningOutcome turningOutcome(const project::PanelState& state, Stores& stores, task::Sources& sources,
                              const Progress& progress)
{
    TurningOutcome outcome{cam::answerTurn(state, true, stores, sources, progress.part(0, 0.8)), {}, {}};
    for (std::size_t i = 0; i < outcome.plan->setups.size(); ++i)
        outcome.clampings.push_back(clampingOutcome(*outcome.plan, i, progress));
    const double share = 0.2 / static_cast<double>(outcome.plan->sections.size() + 1);
    for (std::size_t i = 0; i < outcome.plan->sections.size(); ++i) {
        const double from = 0.8 + share * static_cast<double>(i);
        outcome.lobes.push_back(lobesOf(outcome.plan->sections[i], *outcome.plan, progress.part(from, from + share)));
    }
    return outcome;
}

double askedSpeed(const TurningPlan& plan, const SectionSpeed& section)
{
    return stability::spindleSpeed(plan.job.cutting.finish.cutting_speed_m_min, section.diameter_mm);
}

Interval inStock(const TurningOutcome& outcome, std::size_t setup, const Interval& z_mm)
{
    const double zero = outcome.clampings.at(setup).part_zero_mm, length = outcome.plan->part.length_mm();
    if (!outcome.plan->setups.at(setup).clamping.is_mirrored) return {z_mm.from + zero, z_mm.to + zero};
    return {length - z_mm.to + zero, length - z_mm.from + zero};
}

}  // namespace lathelier::cam
