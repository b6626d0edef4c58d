#include "engine/chain/step_runner.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/chain/chain_codes.h"
#include "engine/chain/earlier_files.h"
#include "engine/core/understanding.h"
#include "engine/core/version.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/report/result_json.h"
#include "engine/task/reply.h"

namespace lathelier::chain {
namespace fs = std::filesystem;
namespace {

std::string resultOf(const std::string& step)
{
    return step + ".json";
}

Json readJson(const std::string& path)
{
    const io::FileBytes bytes(path);
    Json json = Json::parse(bytes.view(), nullptr, false);
    return json.is_object() ? json : Json::object();
}

}  // namespace

StepRunner::StepRunner(std::string folder, RunMode mode, std::shared_ptr<const Dossier> earlier)
    : folder_(std::move(folder)), mode_(mode), earlier_(std::move(earlier))
{
    dossier_.version = programVersion;
    if (mode_ == RunMode::DryRun) return;
    std::error_code failure;
    fs::create_directories(folder_, failure);
    if (failure || !fs::is_directory(folder_))
        throw Error(errors::fileNotWritable, {{"path", folder_}, {"reason", failure.message()}});
}

std::string StepRunner::path(const std::string& name) const
{
    return (fs::path(folder_) / name).string();
}

InputFile StepRunner::named(InputFile file) const
{
    // Files below the folder get relative names, so that the folder can be moved.
    std::error_code ignored;
    const fs::path whole = fs::weakly_canonical(fs::absolute(file.path, ignored), ignored);
    const fs::path below = whole.lexically_relative(fs::weakly_canonical(fs::absolute(folder_, ignored), ignored));
    if (!below.empty() && *below.begin() != "..")
        file.path = below.string();
    else if (fs::path(file.path).is_relative())
        file.path = fs::absolute(file.path, ignored).lexically_normal().string();
    return file;
}

/// Digest of a file by its name in the dossier.
const std::string& StepRunner::digest(const std::string& name, const Progress& progress)
{
    const auto [found, is_new] = digests_.try_emplace(name);
    if (is_new) {
        try {
            found->second = io::fileSha256(path(name), progress);  // absolute paths are unchanged
        } catch (const Error&) {
            found->second.clear();
        }
    }
    return found->second;
}

InputFile StepRunner::madeFile(const std::string& name, const Progress& progress)
{
    std::error_code ignored;
    return {name, static_cast<std::int64_t>(fs::file_size(path(name), ignored)), digest(name, progress)};
}

bool StepRunner::canRead(const std::string& name) const
{
    std::error_code ignored;
    return !failed_ && !isStale(name) && fs::exists(path(name), ignored);
}

void StepRunner::write(const std::string& name, const std::string& text)
{
    if (failed_) return;
    furtherOutputs_.push_back(name);
    if (digest(name, {}) == io::sha256(text)) return;
    if (mode_ == RunMode::DryRun) {
        stale_.insert(name);
        return;
    }
    io::writeFile(path(name), text);
    digests_.erase(name);
}

std::string StepRunner::requestOf(const StepRequest& step) const
{
    Json asked = {{"task", step.task ? step.task->key : std::string()},
                  {"operands", Json::array()},
                  {"given", lathelier::toJson(step.given)}};
    for (const std::string& operand : step.operands) asked["operands"].push_back(named({operand, 0, {}}).path);
    // The request does not depend on the directory from which files are named.
    for (auto& [key, value] : asked["given"].items()) {
        if (!value.is_string()) continue;
        const std::string word = value;
        std::error_code ignored;
        if (word.starts_with(folder_) || fs::is_regular_file(word, ignored)) value = named({word, 0, {}}).path;
    }
    asked["outputs"] = step.outputs;
    asked["if_possible"] = step.outputs_if_possible;
    for (const InputFile& file : furtherInputs_) asked["takes"].push_back(file.path);
    asked["writes"] = furtherOutputs_;
    return io::sha256(asked.dump());
}

/// Files that the step may write, its result first.
std::vector<std::string> StepRunner::namesOf(const StepRequest& step) const
{
    std::vector<std::string> names{resultOf(step.id)};
    names.insert(names.end(), furtherOutputs_.begin(), furtherOutputs_.end());
    for (const auto* outputs : {&step.outputs, &step.outputs_if_possible})
        for (const auto& [option, name] : *outputs) {
            names.push_back(name);
            // With two clampings each has its own file.
            const fs::path parts(name);
            for (const char* number : {"_1", "_2"})
                names.push_back(parts.stem().string() + number + parts.extension().string());
        }
    return names;
}

/// The same step of the earlier run; null if request, files or version differ.
const ChainStep* StepRunner::unchanged(const ChainStep& step, const Progress& progress)
{
    if (mode_ == RunMode::Everything || !earlier_ || earlier_->version != dossier_.version) return nullptr;
    const ChainStep* const before = earlier_->step(step.id);
    if (!before || before->request != step.request) return nullptr;
    const bool is_failure = before->state == StepState::Failed && mode_ == RunMode::DryRun;
    if (before->state != StepState::Done && !is_failure) return nullptr;
    const auto isThere = [&](const InputFile& file) {
        return !isStale(file.path) && digest(file.path, progress) == file.sha256;
    };
    if (!std::all_of(before->inputs.begin(), before->inputs.end(), isThere)) return nullptr;
    return std::all_of(before->outputs.begin(), before->outputs.end(), isThere) ? before : nullptr;
}

void StepRunner::finish(ChainStep step, const Json& result)
{
    furtherInputs_.clear();
    furtherOutputs_.clear();
    failed_ = failed_ || step.state == StepState::Failed;
    add(dossier_, std::move(step), result);
}

Json StepRunner::takeOver(const ChainStep& step, const Progress& progress)
{
    progress.check();
    takenOver_ = true;
    Json result = step.state == StepState::Done ? readJson(path(step.result)) : Json::object();
    finish(step, result);
    return result;
}

Json StepRunner::dryRun(ChainStep step, const std::vector<std::string>& names)
{
    const ChainStep* const before = earlier_ ? earlier_->step(step.id) : nullptr;
    step.state = before && before->state == StepState::Done ? StepState::OutOfDate : StepState::NotReached;
    if (before) {
        step.inputs = before->inputs;
        step.outputs = before->outputs;
        step.roles = before->roles;
        step.parameters = before->parameters;
    }
    stale_.insert(names.begin(), names.end());
    finish(std::move(step), Json::object());
    return Json::object();
}

Json StepRunner::run(const StepRequest& wanted, const Progress& progress)
{
    ChainStep step;
    step.id = wanted.id;
    refusal_.reset();
    takenOver_ = false;
    if (failed_) {
        finish(std::move(step), {});
        return Json::object();
    }
    step.request = requestOf(wanted);
    if (const ChainStep* const before = unchanged(step, progress)) return takeOver(*before, progress);
    if (mode_ == RunMode::DryRun) return dryRun(std::move(step), namesOf(wanted));
    progress.report(0);

    task::Request question{wanted.operands, wanted.given, {}};
    for (const auto* outputs : {&wanted.outputs, &wanted.outputs_if_possible})
        for (const auto& [option, name] : *outputs) question.exports[option] = path(name);
    // Afterwards all files are of this run; if cancelled, the earlier files are restored.
    EarlierFiles aside(folder_);
    for (const std::string& name : namesOf(wanted)) {
        digests_.erase(name);
        if (std::find(furtherOutputs_.begin(), furtherOutputs_.end(), name) == furtherOutputs_.end())
            aside.setAside(name);
    }
    const bool may_refuse = !wanted.outputs_if_possible.empty();
    task::Reply reply = task::reply(*wanted.task, question, progress.part(0, may_refuse ? 0.5 : 1));
    if (may_refuse && !reply.errors.empty() && reply.errors.front().code().kind == ErrorKind::NoAnswer) {
        refusal_ = reply.errors.front();
        for (const auto& [option, name] : wanted.outputs_if_possible) question.exports.erase(option);
        reply = task::reply(*wanted.task, question, progress.part(0.5, 1));
    }
    Json result = task::resultOf(*wanted.task, reply);
    step.result = resultOf(wanted.id);
    io::writeFile(path(step.result), report::toText(result));
    aside.forget();
    for (const InputFile& file : reply.sources.inputs) step.inputs.push_back(named(file));
    step.inputs.insert(step.inputs.end(), furtherInputs_.begin(), furtherInputs_.end());
    std::error_code ignored;
    for (const std::string& name : namesOf(wanted))
        if (fs::exists(path(name), ignored)) step.outputs.push_back(madeFile(name, progress.quiet()));
    for (const auto& [role, source] : reply.state.inputs) step.roles[role] = named({source.path, 0, {}}).path;
    step.parameters = parametersOf(*wanted.task, reply.state);
    step.notes = std::move(reply.notes);
    step.state = reply.errors.empty() ? StepState::Done : StepState::Failed;
    if (reply.errors.empty() && reply.outcome.report) step.sections = reply.outcome.report({}).sections;
    step.verdict = reply.outcome.verdict;
    if (!reply.errors.empty()) step.error = reply.errors.front();
    finish(std::move(step), result);
    return result;
}

Json StepRunner::make(const std::string& id, const std::vector<std::string>& inputs,
                      const std::function<MadeStep()>& make, const Progress& progress)
{
    ChainStep step;
    step.id = id;
    takenOver_ = false;
    if (failed_) {
        finish(std::move(step), {});
        return Json::object();
    }
    StepRequest wanted{id, nullptr, {}, {}, {}};
    for (const std::string& name : inputs) wanted.operands.push_back(path(name));
    step.request = requestOf(wanted);
    if (const ChainStep* const before = unchanged(step, progress)) return takeOver(*before, progress);
    if (mode_ == RunMode::DryRun) return dryRun(std::move(step), {resultOf(id)});
    MadeStep made = make();
    step.result = resultOf(id);
    io::writeFile(path(step.result), report::toText(*made.result));
    digests_.erase(step.result);
    for (const std::string& name : inputs) step.inputs.push_back(madeFile(name, progress));
    step.outputs = {madeFile(step.result, progress)};
    step.notes = std::move(made.notes);
    step.sections = std::move(made.sections);
    step.verdict = made.verdict;
    step.state = StepState::Done;
    finish(std::move(step), *made.result);
    return *made.result;
}

void StepRunner::recordMissing(const std::string& id, Text what)
{
    ChainStep step;
    step.id = id;
    takenOver_ = false;
    if (!failed_) {
        step.state = StepState::Missing;
        step.error = Error(errors::chainInputMissing, {{"what", what}});
    }
    finish(std::move(step), {});
}

void StepRunner::recordFailure(const std::string& id, const Error& error)
{
    ChainStep step;
    step.id = id;
    takenOver_ = false;
    if (!failed_) {
        step.state = StepState::Failed;
        step.error = error;
    }
    finish(std::move(step), {});
}

void StepRunner::keepEarlierSteps()
{
    if (!earlier_) return;
    for (const ChainStep& step : earlier_->steps) {
        if (dossier_.step(step.id)) continue;
        dossier_.steps.push_back(step);
        for (const TracedNumber& number : earlier_->numbers)
            if (number.step == step.id) dossier_.numbers.push_back(number);
    }
}

void StepRunner::addNote(Note note)
{
    ChainStep& step = dossier_.steps.back();
    if (takenOver_ || step.state != StepState::Done) return;
    step.notes.push_back(note);
    if (note.code.role == NoteRole::Assumed) {  // beside what the result of the step assumes
        Json understanding = step.understanding ? *step.understanding : lathelier::toJson(Understanding{});
        const Json of_note = lathelier::toJson(lathelier::understandingOf({note}));
        for (Json entry : of_note["assumed"]) {
            entry["step"] = step.id;
            understanding["assumed"].push_back(std::move(entry));
        }
        step.understanding = std::make_shared<const Json>(std::move(understanding));
    }
    set(note.values, "step", step.id);
    dossier_.notes.push_back(std::move(note));
}

bool StepRunner::isDone(const std::string& id) const
{
    const ChainStep* const step = dossier_.step(id);
    return step && step->state == StepState::Done;
}

}  // namespace lathelier::chain
