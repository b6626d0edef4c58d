#include "app/cli/task_verb.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/shop_option.h"
#include "app/cli/verb_answer.h"
#include "engine/batch/recipe_file.h"
#include "engine/io/file.h"
#include "engine/report/plain_text.h"
#include "engine/shop/shop_fill.h"
#include "engine/shop/shop_library.h"
#include "engine/task/asked_state.h"
#include "engine/task/needed.h"
#include "engine/task/reply.h"

namespace lathelier::cli {
namespace {

constexpr std::string_view dashes = "--";
constexpr const char* recipeOption = "--save-recipe";

std::string exportOf(const std::string& option)
{
    return option.substr(dashes.size());
}

FieldInfo fileOption(const task::Input& input)
{
    FieldInfo info;
    info.key = input.option;
    info.kind = FieldInfo::Kind::Word;
    info.label = input.label;
    info.help = input.help;
    info.required = input.required;
    return info;
}

Operand operandOf(const task::Task& task, const task::Input& input)
{
    Operand operand{task::operandOf(input), input.help.english, input.several, false, !task::isNeeded(task, input)};
    if (!input.required || !operand.optional) return operand;
    for (const task::Input& other : task.inputs)
        if (!other.option.empty() && task::isReplaceable(task, other)) operand.replaced_by.push_back(other.option);
    return operand;
}

/// The recipe of what was asked, before the shop completed it.
void saveRecipe(const std::string& path, const task::Task& task, const task::Request& asked, const std::string& shop,
                const Request& request, const Progress& progress)
{
    batch::Recipe recipe =
        batch::recipeOf(task, task::statedState(task, asked.operands, asked.parameters), progress.quiet());
    if (!shop.empty()) {
        // What is not typed is that of the shop.
        std::erase_if(recipe.parameters, [&](const auto& parameter) {
            return parameter.first == postKey && !request.typed.contains(postKey);
        });
        if (shop == shop::builtInName)
            recipe.shop.name = shop;
        else
            recipe.shop.file = {shop, io::fileSha256(shop, progress.quiet())};
    }
    batch::writeRecipe(path, recipe);
}

void runTask(const task::Task& task, const Request& request, const Progress& progress, Answer& answer)
{
    task::Request asked{request.operands, request.parameters, {}, request.in_full};
    const std::string shop = shop::takesShop(task) ? takeShopOption(asked.parameters) : std::string();
    if (!shop.empty()) asked.complete = completedFromShop(task, shop, request, progress);
    for (const auto& [option, path] : request.outputs)
        if (option != recipeOption) asked.exports[exportOf(option)] = path;
    const auto recipe = request.outputs.find(recipeOption);
    if (recipe != request.outputs.end())
        batch::requireVaried(task, task::statedState(task, asked.operands, asked.parameters));
    const task::Reply found = task::reply(task, asked, progress);
    const task::Outcome& outcome = found.outcome;
    answer.sources = std::make_shared<const task::Sources>(found.sources);
    const bool is_asked = !found.state.inputs.empty() || !found.state.parameters.empty();
    if (is_asked) answer.parameters = parametersOf(task, found.state);  // of a refused request as they were given
    if (is_asked && !shop.empty()) set(answer.parameters, shopKey, shop);
    answer.always_strict = task.always_strict;
    answer.notes = found.notes;
    answer.understanding = outcome.understanding;
    answer.json = outcome.json;
    if (outcome.report) answer.report = [report = outcome.report] { return report({}); };
    if (outcome.summary) answer.summary = report::toPlainText(outcome.summary({}));
    answer.pass = passed(outcome.verdict);
    answer.errors = found.errors;
    if (recipe != request.outputs.end() && outcome.json)
        gather(answer, [&] { saveRecipe(recipe->second, task, asked, shop, request, progress); });
}

}  // namespace

Verb verbOf(const task::Task& task)
{
    Verb verb;
    verb.name = task.key;
    verb.summary = task.summary;
    verb.has_report = true;
    for (const task::Input& input : task.inputs) {
        if (!task::isOfCommandLine(input)) continue;
        io::unite(verb.kinds, input.kinds);
        if (input.option.empty())
            verb.operands.push_back(operandOf(task, input));
        else if (!task::givesField(task, input))
            verb.parameters.push_back({fileOption(input), std::string()});
    }
    for (const FieldInfo& field : task.fields) {
        if (field.is_kept) continue;
        if (const task::Input* const file = task.fileOf(field))
            verb.parameters.push_back({fileOption(*file), Value()});
        else
            verb.parameters.push_back({field, *find(task.defaults, field.key)});
    }
    if (shop::takesShop(task)) verb.parameters.push_back(shopOption());
    for (const task::Export& output : task.exports)
        verb.outputs.push_back({std::string(dashes) + output.option, output.help});
    verb.outputs.push_back(
        {recipeOption, "Write the question and what all parts share as FILE.json, for the command batch."});
    verb.task = &task;
    verb.run = [&task](const Request& request, io::InputFiles&, const Progress& progress, Answer& answer) {
        runTask(task, request, progress, answer);
    };
    return verb;
}

}  // namespace lathelier::cli
