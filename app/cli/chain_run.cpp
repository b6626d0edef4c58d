#include "app/cli/chain_run.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/chain/chain_codes.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/report/result_json.h"

namespace lathelier::cli {
namespace fs = std::filesystem;
namespace {

const Verb& verbNamed(const std::string& name)
{
    const std::vector<Verb>& all = verbs();
    return *std::find_if(all.begin(), all.end(), [&name](const Verb& verb) { return verb.name == name; });
}

std::string resultOf(const std::string& step)
{
    return step + ".json";
}

}  // namespace

ChainRun::ChainRun(std::string folder) : folder_(std::move(folder))
{
    std::error_code failure;
    fs::create_directories(folder_, failure);
    if (failure || !fs::is_directory(folder_))
        throw Error(errors::fileNotWritable, {{"path", folder_}, {"reason", failure.message()}});
}

std::string ChainRun::path(const std::string& name) const
{
    return (fs::path(folder_) / name).string();
}

InputFile ChainRun::named(InputFile file) const
{
    // A file in the folder itself is one of the chain's, wherever the folder is moved to.
    const fs::path path(file.path);
    std::error_code ignored;
    if (fs::equivalent(path.has_parent_path() ? path.parent_path() : fs::path("."), folder_, ignored))
        file.path = path.filename().string();
    else if (path.is_relative())
        file.path = fs::absolute(path, ignored).lexically_normal().string();
    return file;
}

InputFile ChainRun::madeFile(const std::string& name) const
{
    const std::string at = path(name);
    std::error_code ignored;
    return {name, static_cast<std::int64_t>(fs::file_size(at, ignored)), io::fileSha256(at)};
}

void ChainRun::write(const std::string& name, const std::string& text)
{
    if (failed_) return;
    io::writeFile(path(name), text);
    further_outputs_.push_back(name);
}

void ChainRun::addReport(const Answer& answer)
{
    if (!answer.report || !answer.errors.empty()) return;
    report::Document document = answer.report();
    for (report::Section& section : document.sections) sections_.push_back(std::move(section));
}

Json ChainRun::run(const StepRequest& wanted, const Progress& progress)
{
    chain::ChainStep step;
    step.id = wanted.id;
    if (failed_) {
        chain::add(dossier_, std::move(step), {});
        return Json::object();
    }
    const Verb& verb = verbNamed(wanted.verb);
    std::map<std::string, std::string> wished = wanted.outputs;
    wished.insert(wanted.outputs_if_possible.begin(), wanted.outputs_if_possible.end());
    std::map<std::string, std::string> outputs;
    for (const auto& [option, name] : wished) {
        outputs[option] = path(name);
        std::error_code ignored;
        fs::remove(path(name), ignored);  // of an earlier run: what is there afterwards is this one's
    }
    Request request = requestOf(verb, wanted.operands, wanted.given, std::move(outputs));
    auto inputs = std::make_unique<io::InputFiles>();
    const bool may_refuse = !wanted.outputs_if_possible.empty();
    Answer answer = ask(verb, request, *inputs, progress.part(0, may_refuse ? 0.5 : 1));
    refusal_.reset();
    if (may_refuse && !answer.errors.empty() && answer.errors.front().code().kind == ErrorKind::NoAnswer) {
        refusal_ = answer.errors.front();
        for (const auto& [option, name] : wanted.outputs_if_possible) request.outputs.erase(option);
        inputs = std::make_unique<io::InputFiles>();
        answer = ask(verb, request, *inputs, progress.part(0.5, 1));
    }
    Json result = envelope(verb, request, *inputs, answer);
    step.result = resultOf(wanted.id);
    io::writeFile(path(step.result), report::toText(result));
    for (const InputFile& file : inputs->list()) step.inputs.push_back(named(file));
    step.inputs.insert(step.inputs.end(), further_inputs_.begin(), further_inputs_.end());
    std::vector<std::string> made{step.result};
    made.insert(made.end(), further_outputs_.begin(), further_outputs_.end());
    for (const auto& [option, name] : wished) {
        made.push_back(name);
        // Of two clampings each has a file of its own.
        const fs::path parts(name);
        for (const char* number : {"_1", "_2"})
            made.push_back(parts.stem().string() + number + parts.extension().string());
    }
    for (const std::string& name : made)
        if (fs::exists(path(name))) step.outputs.push_back(madeFile(name));
    further_inputs_.clear();
    further_outputs_.clear();
    step.parameters = request.parameters;
    step.notes = answer.notes;
    step.state = answer.errors.empty() ? chain::StepState::Done : chain::StepState::Failed;
    if (!answer.errors.empty()) {
        failed_ = true;
        error_ = answer.errors.front();
        step.error = error_;
    } else {
        addReport(answer);
    }
    chain::add(dossier_, std::move(step), result);
    return result;
}

void ChainRun::record(const std::string& id, const std::vector<std::string>& inputs, const Json& result, Notes notes,
                      std::vector<report::Section> report)
{
    chain::ChainStep step;
    step.id = id;
    if (failed_) return chain::add(dossier_, std::move(step), {});
    step.result = resultOf(id);
    io::writeFile(path(step.result), report::toText(result));
    for (const std::string& name : inputs) step.inputs.push_back(madeFile(name));
    step.outputs = {madeFile(step.result)};
    step.notes = std::move(notes);
    step.state = chain::StepState::Done;
    for (report::Section& section : report) sections_.push_back(std::move(section));
    chain::add(dossier_, std::move(step), result);
}

void ChainRun::miss(const std::string& id, Text what)
{
    chain::ChainStep step;
    step.id = id;
    if (!failed_) {
        step.state = chain::StepState::Missing;
        step.error = Error(errors::chainInputMissing, {{"what", what}});
    }
    chain::add(dossier_, std::move(step), {});
}

void ChainRun::remark(Note note)
{
    chain::ChainStep& step = dossier_.steps.back();
    step.notes.push_back(note);
    set(note.values, "step", step.id);
    dossier_.notes.push_back(std::move(note));
}

bool ChainRun::isDone(const std::string& id) const
{
    return std::any_of(dossier_.steps.begin(), dossier_.steps.end(), [&id](const chain::ChainStep& step) {
        return step.id == id && step.state == chain::StepState::Done;
    });
}

}  // namespace lathelier::cli
