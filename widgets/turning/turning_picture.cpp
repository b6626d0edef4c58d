#include "widgets/turning/turning_picture.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/cam_codes.h"
#include "engine/cam/check/drawn_contour.h"
#include "engine/cam/job_bodies.h"
#include "engine/cam/plan_codes.h"
#include "widgets/chatter_common/taken_input.h"
#include "widgets/part_common/shaft_table.h"
#include "widgets/part_common/taken_part.h"
#include "widgets/turning/job_store.h"

namespace lathelier::turning_panel {
namespace {

constexpr std::size_t shownDigits = 12;
constexpr double drawnSpacing_mm = 0.5;
constexpr double narrow = 0.6, wide = 1.6;  // of a speed: range of its chart

template <class Taken>
void take(TurningPicture& picture, Taken& taken)
{
    picture.inputs.push_back(taken.input);
    picture.notes.insert(picture.notes.end(), taken.notes.begin(), taken.notes.end());
    picture.synthetic = picture.synthetic || taken.synthetic;
}

cam::Job takeJob(TurningPicture& picture, const project::PanelState& state, Stores& stores, const Progress& progress)
{
    cam::Job job = picture.question.job;
    const auto source = state.inputs.find(jobRole);
    if (source == state.inputs.end()) return job;
    picture.is_changed = formRules(picture.question, state);
    const auto loaded = stores.of<JobStore>()->load(source->second, progress);
    picture.inputs.push_back(loaded->inputs.front());
    picture.notes.insert(picture.notes.end(), loaded->file.notes.begin(), loaded->file.notes.end());
    picture.synthetic = picture.synthetic || source->second.synthetic;
    if (!picture.is_changed) return loaded->file.job;
    job.shaft = loaded->file.job.shaft;
    if (!(job == loaded->file.job)) picture.notes.push_back({notes::jobChanged, {{"source", source->second.path}}});
    return job;
}

Shaft takeShaft(TurningPicture& picture, const cam::Job& job, const project::PanelState& state, Stores& stores,
                const Progress& progress)
{
    if (state.inputs.count(part_common::shaftRole) > 0) {
        part_common::TakenPart taken = part_common::takePart(state, part_common::shaftRole, stores, progress);
        take(picture, taken);
        return std::move(taken.shaft);
    }
    if (!job.shaft) throw Error(errors::jobWithoutShaft, {{"path", identity(state)}});
    return *job.shaft;
}

cam::Post takePost(TurningPicture& picture, const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const auto source = state.inputs.find(postRole);
    if (source == state.inputs.end()) return cam::postNamed(nameOf(picture.question.post));
    const auto loaded = stores.of<PostStore>()->load(source->second, progress);
    picture.has_own_post = true;
    picture.inputs.push_back(loaded->inputs.front());
    picture.notes.insert(picture.notes.end(), loaded->file.notes.begin(), loaded->file.notes.end());
    return loaded->file.post;
}

ClampingPicture clampingPicture(const cam::TurningPlan& plan, std::size_t index, const Progress& progress)
{
    const cam::CheckResult& check = plan.setups[index].check;
    ClampingPicture picture;
    picture.part_zero_mm = check.stock_zero_mm;
    picture.z_zero_mm = check.stock_zero_mm + check.parameters.z_zero_mm;
    picture.drawn = stock::DrawnPath(check.path.moves, picture.z_zero_mm, check.program.blocks.size(), progress);
    picture.travelled_mm.reserve(picture.drawn.corners());
    double way = 0;
    for (std::size_t i = 0; i < picture.drawn.corners(); ++i) {
        if (i > 0 && picture.drawn.isPiece(i)) {
            const stock::Corner &a = picture.drawn.corner(i - 1), &b = picture.drawn.corner(i);
            way += std::hypot(b.z_mm - a.z_mm, b.x_mm - a.x_mm);
        }
        picture.travelled_mm.push_back(way);
    }
    const cam::DrawnContour drawing(check.parameters.setup == 2 ? cam::mirrored(plan.part) : plan.part, {},
                                    drawnSpacing_mm);
    for (const cam::DrawnPoint& point : drawing.points()) {
        picture.drawing_z_mm.push_back(point.at.z_mm + check.stock_zero_mm);
        picture.drawing_x_mm.push_back(point.at.x_mm);
    }
    if (check.stock) {
        stock::StockResult& bare = picture.bare.emplace();
        bare.parameters = check.stock->parameters;
        bare.step_mm = check.stock->step_mm;
        bare.length_mm = check.stock->length_mm;
        bare.before = check.stock->before;
        bare.findings = check.stock->findings;
    }
    return picture;
}

std::shared_ptr<const SectionLobes> lobesOf(const cam::SectionSpeed& section, const cam::TurningPlan& plan,
                                            const Progress& progress)
{
    if (!section.receptance) return nullptr;
    const double asked_m_min = plan.job.cutting.finish.cutting_speed_m_min;
    auto found = std::make_shared<SectionLobes>();
    stability::LobeParameters parameters;
    parameters.relation = plan.parameters.relation;
    const double asked_rpm = stability::spindleSpeed(asked_m_min, section.diameter_mm);
    const double at_rpm = section.speed_rpm.value_or(asked_rpm);
    parameters.speed_rpm = {{narrow * std::min(at_rpm, asked_rpm), wide * std::max(at_rpm, asked_rpm)}};
    found->lobes = stability::findLobes(*section.receptance, parameters, progress);
    stability::SpeedParameters speed;
    speed.diameter_mm = section.diameter_mm;
    speed.cutting_speed_m_min = asked_m_min;
    speed.relation = plan.parameters.relation;
    try {
        found->speed = stability::chooseSpeed(*section.receptance, speed);
    } catch (const Error&) {
        found->speed.reset();  // the reason of the section says so
    }
    return found;
}

}  // namespace

TurningPicture turningPicture(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    TurningPicture picture;
    picture.question = fromValues<TurningQuestion>(state.parameters);
    const Progress reading = progress.part(0, 0.1, LT_TEXT("Engine", "Reading"));
    const cam::Job job = takeJob(picture, state, stores, reading);
    const Shaft part = takeShaft(picture, job, state, stores, reading);
    cam::TurningInputs inputs;
    inputs.post = takePost(picture, state, stores, reading);
    inputs.keeps_outlines = true;
    if (auto spindle = chatter_common::takeSpindle(state, stores, reading))
        inputs.spindle = chatter_common::noted(picture, *std::move(spindle));
    for (const InputFile& input : picture.inputs)
        inputs.origin.push_back("SHA-256 " + input.sha256.substr(0, shownDigits));
    cam::TurningPlan planned = cam::planTurning(part, job, inputs, picture.question.plan, progress.part(0.1, 0.7));
    const std::vector<cam::GivenProgram> given = chooseProgram(picture, planned, state, stores, reading);
    picture.plan = std::make_shared<const cam::TurningPlan>(
        cam::withPrograms(std::move(planned), given, inputs, progress.part(0.7, 0.8)));
    for (std::size_t i = 0; i < picture.plan->setups.size(); ++i)
        picture.clampings.push_back(clampingPicture(*picture.plan, i, progress));
    const double share = 0.2 / static_cast<double>(picture.plan->sections.size() + 1);
    for (std::size_t i = 0; i < picture.plan->sections.size(); ++i) {
        const double from = 0.8 + share * static_cast<double>(i);
        picture.lobes.push_back(lobesOf(picture.plan->sections[i], *picture.plan, progress.part(from, from + share)));
    }
    picture.notes.insert(picture.notes.end(), picture.plan->notes.begin(), picture.plan->notes.end());
    return picture;
}

bool TurningPicture::isVoid() const
{
    return std::any_of(programs.begin(), programs.end(), [](const ShownProgram& program) { return program.is_void; });
}

Interval inStock(const TurningPicture& picture, std::size_t setup, const Interval& z_mm)
{
    const double zero = picture.clampings.at(setup).part_zero_mm, length = picture.plan->part.length_mm();
    if (!picture.plan->setups.at(setup).clamping.is_mirrored) return {z_mm.from + zero, z_mm.to + zero};
    return {length - z_mm.to + zero, length - z_mm.from + zero};
}

}  // namespace lathelier::turning_panel
