#include "engine/link/assistant.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/core/failure.h"
#include "engine/link/link_codes.h"
#include "engine/link/program_bar.h"
#include "engine/stability/stability_codes.h"
#include "engine/stability/task/speed_entry.h"
#include "engine/stability/task/speed_task.h"

namespace lathelier::link {
namespace {

/// Values of the control that the task takes, by the keys of the operator's screen; the depth besides.
const std::vector<std::string>& enteredNames()
{
    static const std::vector<std::string> all{diameterName, lengthName, speedName, lowestName, highestName, depthName};
    return all;
}

std::optional<double> valueOf(const ControlValues& values, const char* name)
{
    const auto found = values.find(name);
    return found == values.end() ? std::nullopt : std::optional(found->second);
}

/// 0 stands for what the control does not state.
bool isStated(const ControlValues& values, const char* name)
{
    const std::optional<double> value = valueOf(values, name);
    return value && *value != 0;
}

bool isWithin(const std::optional<double>& value, const std::optional<double>& from, const std::optional<double>& to)
{
    return !value || ((!from || *value >= *from) && (!to || *value <= *to));
}

/// Whether each value lies within its field, and the range runs forward.
bool areInRange(const ControlValues& values, const Limits& limits)
{
    std::vector<FieldInfo> fields = stability::screenFields();
    for (const FieldInfo& info : infos<stability::SpeedQuestion>())
        if (info.key == depthName) fields.push_back(info);
    for (const FieldInfo& info : fields) {
        if (!isStated(values, info.key.c_str())) continue;
        if (!isWithin(valueOf(values, info.key.c_str()), info.minimum, info.maximum)) return false;
    }
    if (isStated(values, lowestName) && isStated(values, highestName) &&
        values.at(lowestName) >= values.at(highestName))
        return false;
    return isWithin(valueOf(values, diameterName), limits.lowest_diameter_mm, limits.highest_diameter_mm) &&
           isWithin(valueOf(values, lengthName), limits.lowest_length_mm, limits.highest_length_mm);
}

std::optional<double> configuredDepth(const project::PanelState& question)
{
    const Value* const depth = find(question.parameters, depthName);
    return depth && std::holds_alternative<double>(*depth) ? std::optional(std::get<double>(*depth)) : std::nullopt;
}

State stateOf(const Error& error)
{
    return error.code() == errors::noStableSpeed ? State::NoStableSpeed : State::NotComputed;
}

}  // namespace

bool isOfBar(const project::PanelState& question)
{
    const std::vector<std::string> given = task::givenOf(stability::speedTask(), question);
    return given.empty() || given.front() == stability::barLengthKey;
}

project::PanelState machineQuestion(project::PanelState question)
{
    for (const FieldInfo& info : stability::screenFields()) stability::enterValue(question.parameters, info.key, {});
    set(question.parameters, "speed_rpm", {});
    return question;
}

Assistant::Assistant(project::PanelState question, const Limits& limits, std::optional<OfProgram> of_program)
    : question_(machineQuestion(std::move(question))), limits_(limits), ofProgram_(of_program)
{
}

void Assistant::prepare(const Progress& progress)
{
    // Any values that a machine may have: the answer is not used.
    ControlValues values{{diameterName, 30}, {speedName, 200}};
    if (isOfBar(question_)) values[lengthName] = 100;
    task::Sources sources;
    stability::answerSpeed(asked(values), stores_, sources, progress);
}

/// The question with what the control states.
project::PanelState Assistant::asked(const ControlValues& values) const
{
    project::PanelState state = question_;
    for (const std::string& name : enteredNames()) {
        if (name == lengthName && !isOfBar(question_)) continue;
        if (isStated(values, name.c_str())) stability::enterValue(state.parameters, name, values.at(name));
    }
    // The coefficient judges by a depth, which the control may leave open: then the relation of the papers answers.
    if (!isStated(values, depthName) && !configuredDepth(state)) set(state.parameters, "cutting_coefficient_N_mm2", {});
    return state;
}

bool Assistant::needsProgram(const ControlValues& values) const
{
    if (!ofProgram_) return false;
    return !isStated(values, diameterName) || (!isStated(values, lengthName) && isOfBar(question_));
}

/// The state with which it is refused without a computation; none: it can be computed.
std::optional<Reply> Assistant::refused(const ControlValues& values) const
{
    const auto with = [](State state) { return Reply{state, {}, {}, {}, {}, {}}; };
    for (const auto& [name, value] : values)
        if (!std::isfinite(value)) return with(State::NotUnderstood);
    if (isStated(values, runningName)) return with(State::Running);
    for (const char* name : {diameterName, speedName, lengthName})
        if (!isStated(values, name) && (name != lengthName || isOfBar(question_))) return with(State::NotUnderstood);
    if (!areInRange(values, limits_)) return with(State::OutOfRange);
    return std::nullopt;
}

Reply Assistant::answer(const ControlValues& asked, const std::optional<std::string>& program, const Progress& progress)
{
    ControlValues values = asked;
    std::optional<ProgramBar> bar;
    if (needsProgram(values) && !isStated(values, runningName)) {
        try {
            if (!program) throw Error(errors::linkNoProgram, {});
            bar = barOfProgram(*program, *ofProgram_, progress);
        } catch (const Cancelled&) {
            throw;
        } catch (const std::exception& failure) {
            return {State::ProgramNotUsable, {}, {}, {}, {}, toError(failure)};
        }
        if (!isStated(values, diameterName)) values[diameterName] = bar->diameter_mm;
        if (!isStated(values, lengthName) && isOfBar(question_)) values[lengthName] = bar->length_mm;
    }
    Reply reply;
    if (const auto no = refused(values))
        reply = *no;
    else
        reply = computed(values, progress);
    reply.program = bar;
    if (bar) reply.assumed.insert(reply.assumed.end(), bar->assumed.begin(), bar->assumed.end());
    return reply;
}

Reply Assistant::computed(const ControlValues& values, const Progress& progress)
{
    Reply reply;
    try {
        task::Sources sources;
        const stability::SpeedOutcome outcome = stability::answerSpeed(asked(values), stores_, sources, progress);
        reply.assumed = outcome.understanding.assumed;
        if (isStated(values, lengthName) && !isOfBar(question_))  // the stated overhang has no effect
            reply.assumed.push_back({lengthName, task::givenOf(stability::speedTask(), question_).front(), {}, 0});
        if (const auto depth_mm = configuredDepth(question_); depth_mm && !isStated(values, depthName))
            reply.assumed.push_back({depthName, fmt::format("{}", *depth_mm), {}, 0});
        if (outcome.published) reply.selected_rpm = outcome.published->selected_rpm;
        if (outcome.problem && !outcome.safe) throw Error(*outcome.problem);
        const std::optional<double> speed_rpm = outcome.recommendedRpm();
        if (!outcome.understanding.isWhole())
            reply.state = State::NotModelled;
        else if (!speed_rpm)
            reply.state = State::NoStableSpeed;
        else if (std::round(*speed_rpm) > limits_.highest_rpm)
            reply.state = State::AboveSpeedLimit;
        else {
            reply.state = State::Ok;
            reply.n_cor_rpm = std::round(*speed_rpm);
        }
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception& failure) {
        reply.error = toError(failure);
        reply.state = stateOf(*reply.error);
    }
    return reply;
}

}  // namespace lathelier::link
