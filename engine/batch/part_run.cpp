#include "engine/batch/part_run.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "engine/batch/batch_codes.h"
#include "engine/core/core_codes.h"
#include "engine/core/failure.h"
#include "engine/core/version.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/io/probe/probe_reader.h"
#include "engine/project/project_codes.h"
#include "engine/report/html.h"

namespace lathelier::batch {
namespace {

namespace fs = std::filesystem;

/// Role of a key: "profile" of "profile.2".
std::string roleOf(const std::string& key)
{
    return key.substr(0, key.find('.'));
}

std::vector<std::string> withPartners(const std::string& path)
{
    std::vector<std::string> paths = io::recordPartners(path);
    paths.insert(paths.begin(), path);
    return paths;
}

/// Whether another run would meet it again: not where memory, disk or another program's writing decided.
bool isLasting(const Error& error)
{
    const ErrorCode& code = error.code();
    if (code.kind != ErrorKind::InputRejected && code.kind != ErrorKind::NoAnswer) return false;
    for (const ErrorCode& passing : {errors::outOfMemory, errors::internal, errors::fileTooLarge, errors::fileChanged,
                                     errors::fileNotFound, errors::fileNotReadable, errors::sourceReplaced})
        if (code == passing) return false;
    return true;
}

/// An item made for the run is named among its sources, but is no file.
bool isItem(const project::PanelState& state, const std::string& name)
{
    return std::any_of(state.inputs.begin(), state.inputs.end(),
                       [&](const auto& input) { return input.second.item == name; });
}

}  // namespace

PartRun::PartRun(const Recipe& recipe, const CompleteFrom& complete, const Progress& progress)
    : recipe_(recipe),
      identity_(identityOf(recipe)),
      fixed_(stateOf(recipe)),
      files_(filesOf(recipe)),
      progress_(progress.quiet())
{
    if (recipe.shop.isGiven() && complete) complete_ = complete(recipe_, progress_);
}

archive::Evaluation PartRun::begin(const Part& part) const
{
    archive::Evaluation made;
    made.task = recipe_.task->key;
    made.recipe_sha256 = identity_;
    made.version = programVersion;
    for (const auto& [key, path] : part.files)
        for (const std::string& one : withPartners(path)) {
            std::error_code unknown;
            InputFile file{one, 0, {}};
            try {
                file.sha256 = io::fileSha256(one, progress_);
            } catch (Error& error) {
                throw error.with("path", one);
            }
            file.bytes = static_cast<std::int64_t>(fs::file_size(one, unknown));
            made.inputs.push_back({roleOf(key), std::move(file)});
        }
    return made;
}

PartRun::Answer PartRun::answer(const Part& part, archive::Evaluation begun, bool with_report)
{
    Answer made;
    made.evaluation = std::move(begun);
    project::PanelState state = fixed_;
    for (const auto& [key, path] : part.files) {
        project::Source& source = state.inputs[key];
        source.path = path;
        source.import = recipe_.reading;
    }
    task::Reply reply;
    try {
        reply = task::reply(*recipe_.task, state, complete_, stores_, progress_);
        if (!reply.errors.empty()) made.error = reply.errors.front();
        takeSources(part, reply, made);
        if (with_report && !made.error && reply.outcome.report)
            made.report = report::toHtml(documentOf(*recipe_.task, reply.state, reply.sources, reply.outcome));
        archive::Evaluation& evaluation = made.evaluation;
        evaluation.exit_code = made.error ? task::exitCode(made.error->code().kind) : 0;
        if (!made.error) evaluation.verdict = reply.outcome.verdict;
        if (!made.error && reply.outcome.json) evaluation.characteristics = task::characteristicsOf(reply.outcome);
        evaluation.result = task::resultOf(*recipe_.task, reply).dump(-1, ' ', false, Json::error_handler_t::replace);
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception& failure) {
        Error error = toError(failure);
        if (error.code() == errors::recipeInputChanged) throw error;
        made.error = error;
    }
    made.is_lasting = !made.error || isLasting(*made.error);
    for (archive::EvaluatedInput& input : made.evaluation.inputs) {
        if (!isOfRecipe(input.file.path)) stores_.forget(input.file.path);
        // The evaluation outlives the folder that it was asked from.
        input.file.path = fs::absolute(input.file.path).lexically_normal().string();
    }
    return made;
}

bool PartRun::isOfRecipe(const std::string& path) const
{
    return std::any_of(files_.begin(), files_.end(), [&](const RecipeFile& one) { return one.path == path; });
}

void PartRun::takeSources(const Part& part, const task::Reply& reply, Answer& answer) const
{
    std::vector<archive::EvaluatedInput>& inputs = answer.evaluation.inputs;
    for (const InputFile& read : reply.sources.inputs) {
        const auto of_recipe =
            std::find_if(files_.begin(), files_.end(), [&](const RecipeFile& one) { return one.path == read.path; });
        const auto of_part = std::find_if(inputs.begin(), inputs.end(), [&](const archive::EvaluatedInput& one) {
            return one.file.path == read.path;
        });
        if (of_part != inputs.end()) {
            if (of_part->file.sha256 == read.sha256) {
                of_part->file.bytes = read.bytes;
                continue;
            }
            // The task answered another content than that of the key.
            answer.error = Error(errors::fileChanged, {{"path", read.path}});
        } else if (of_recipe != files_.end()) {
            if (of_recipe->sha256 != read.sha256)
                throw Error(errors::recipeInputChanged, {{"path", read.path},
                                                         {"role", LT_TEXT("Engine", "an input")},
                                                         {"found", read.sha256},
                                                         {"expected", of_recipe->sha256}});
        } else if (!isItem(reply.state, read.path)) {
            inputs.push_back({roleOf(part.files.front().first), read});
        }
    }
}

}  // namespace lathelier::batch
