#include "engine/shop/shop_fill.h"

#include <algorithm>

#include "engine/cam/job_item.h"
#include "engine/cam/task/turn_question.h"
#include "engine/deflection/setup_item.h"
#include "engine/gcode/program_item.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "engine/shaft/shaft_item.h"
#include "engine/shop/shop_job.h"
#include "engine/task/edited_segments.h"
#include "engine/task/needed.h"

namespace lathelier::shop {
namespace {

constexpr const char* holdKey = "hold";  // of the task frf: springs, clamped or free in place of a spindle
constexpr const char* postKey = "post";

const task::Input* inputOf(const task::Task& task, const char* kind)
{
    const auto found = std::find_if(task.inputs.begin(), task.inputs.end(),
                                    [&](const task::Input& one) { return one.item_kind == kind; });
    return found == task.inputs.end() ? nullptr : &*found;
}

/// Something else is in the place of the input, or nothing with which it would say something is given.
bool isReplaced(const project::PanelState& state, const task::Task& task, const task::Input& input)
{
    if (task::isReplaceable(task, input) && !task.one_of.together && !task::givenOf(task, state).empty()) return true;
    return task::saysNothing(task, state, input);
}

/// The input of this kind of item; nullptr: the task has none, or it is not free.
const task::Input* freeInput(const project::PanelState& state, const task::Task& task, const char* kind)
{
    const task::Input* const input = inputOf(task, kind);
    return input && !task::sourceOf(state, input->role) && !isReplaced(state, task, *input) ? input : nullptr;
}

const task::Input* freeJob(const project::PanelState& state, const task::Task& task)
{
    return cam::hasTools(state) ? nullptr : freeInput(state, task, cam::jobItem);
}

const task::Input* freeSpindle(const project::PanelState& state, const task::Task& task)
{
    if (inputOf(task, deflection::setupItem) || task::isGiven(task, state, holdKey)) return nullptr;
    const task::Input* const input = freeInput(state, task, receptance::spindleItem);
    if (!input || inputOf(task, cam::jobItem)) return input;
    const bool has_rule = std::any_of(task.only_with.begin(), task.only_with.end(), [&](const task::OnlyWith& rule) {
        return std::find(rule.keys.begin(), rule.keys.end(), input->role) != rule.keys.end();
    });
    const task::Input* const shaft = inputOf(task, shaftItem);
    return has_rule || (shaft && task::hasShaft(state, shaft->role)) ? input : nullptr;
}

void take(project::PanelState& state, const task::Input& input, const char* name, Values values)
{
    state.inputs[input.role].item = name;
    state.items[input.role] = {input.item_kind, std::move(values), {}};
}

/// Whether the program of the task is one of the project that brings its bar.
bool bringsBar(const project::PanelState& state)
{
    return std::any_of(state.items.begin(), state.items.end(), [](const auto& item) {
        if (item.second.kind != gcode::programItem && item.second.kind != gcode::correctedItem) return false;
        const auto program = gcode::programOf(item.second.values);
        return program && program->stock;
    });
}

deflection::HeldSetup setupFor(const project::PanelState& state, const task::Task& task, const Shop& shop,
                               const Shaft& part, const cam::Job* job)
{
    const task::Input* const stock = inputOf(task, shaftItem);
    if (stock && task::sourceOf(state, stock->role)) return {setupOfStock(shop, part), {}};
    deflection::HeldSetup held = setupOf(shop, job ? *job : jobOf(shop, part));
    if (bringsBar(state)) held.stock.reset();
    return held;
}

}  // namespace

bool takesShop(const task::Task& task)
{
    return inputOf(task, cam::jobItem) || inputOf(task, deflection::setupItem) ||
           inputOf(task, receptance::spindleItem);
}

bool wantsPart(const project::PanelState& state, const task::Task& task)
{
    return freeJob(state, task) || freeInput(state, task, deflection::setupItem);
}

void fillFromShop(project::PanelState& state, const task::Task& task, const Shop& shop, const Shaft* part, Notes& notes,
                  const cam::Job* job)
{
    UsedEntries used;
    const auto use = [&](const UsedEntries& more) {
        used = {used.lathe || more.lathe, used.chuck || more.chuck, used.tailstock || more.tailstock,
                used.tools || more.tools, used.material || more.material};
    };
    if (const task::Input* const input = part ? freeJob(state, task) : nullptr) {
        const cam::Job made = jobOf(shop, *part);
        take(state, *input, jobName, cam::valuesOf(made));
        use(usedBy(made));
    }
    if (const task::Input* const input = part ? freeInput(state, task, deflection::setupItem) : nullptr) {
        const deflection::HeldSetup held = setupFor(state, task, shop, *part, job);
        take(state, *input, setupName, deflection::valuesOf(held));
        UsedEntries of_setup = usedBy(held.setup);
        of_setup.tools = !job;  // else the finishing tool is that of the given job
        use(of_setup);
    }
    if (const task::Input* const input = freeSpindle(state, task)) {
        take(state, *input, spindleName, receptance::toValues(chuckFaceOf(shop)));
        use(usedByChuckFace());
    }
    const bool has_post = std::any_of(task.fields.begin(), task.fields.end(),
                                      [](const FieldInfo& field) { return field.key == postKey; });
    if (has_post && !task::isGiven(task, state, postKey) && !task::sourceOf(state, cam::postRole)) {
        set(state.parameters, postKey, shop.lathe.value.post);
        used.lathe = true;
    }
    noteAssumed(shop, used, notes);
}

}  // namespace lathelier::shop
