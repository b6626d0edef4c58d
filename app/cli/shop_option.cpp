#include "app/cli/shop_option.h"

#include <algorithm>

#include "engine/cad/part_input.h"
#include "engine/cam/job_file.h"
#include "engine/shop/shop_codes.h"
#include "engine/shop/shop_fill.h"
#include "engine/shop/shop_input.h"
#include "engine/task/asked_state.h"

namespace lathelier::cli {
namespace {

const task::Input* partInput(const task::Task& task)
{
    const auto found = std::find_if(task.inputs.begin(), task.inputs.end(),
                                    [](const task::Input& one) { return one.item_kind == shaftItem; });
    return found == task.inputs.end() ? nullptr : &*found;
}

/// An operand that is a job holds its part.
bool isJob(const project::Source& source)
{
    return io::findKind({&cam::jobFiles()}, source.path, source.import).likeness == io::Likeness::Certain;
}

std::optional<Shaft> partOf(const project::PanelState& state, const task::Task& task, Stores& stores,
                            const Progress& progress)
{
    const task::Input* const input = partInput(task);
    const project::Source* const source = input ? task::sourceOf(state, input->role) : nullptr;
    if (!source) {
        const std::string name = !input                  ? std::string()
                                 : input->option.empty() ? task::operandOf(*input)
                                                         : task::optionName(input->option);
        throw Error(errors::shopNeedsPart, {{"what", LT_TEXT("Engine", "a job or a set-up")}, {"name", name}});
    }
    if (isJob(*source)) return std::nullopt;
    task::Sources read_again_by_the_task;
    return task::take<cad::PartInput>(state, input->role, stores, progress, read_again_by_the_task);
}

}  // namespace

Option shopOption()
{
    FieldInfo info;
    info.key = shopKey;
    info.kind = FieldInfo::Kind::Word;
    info.label = LT_TEXT("Engine", "Shop");
    info.help = LT_TEXT("Engine",
                        "Makes the job, set-up or spindle that is not given, from SHOP.json or the shop that is "
                        "built-in; what nobody stated is marked as assumed.");
    return {info, std::string()};
}

std::string takeShopOption(Values& parameters)
{
    const Value* const stated = find(parameters, shopKey);
    const auto* const word = stated ? std::get_if<std::string>(stated) : nullptr;
    std::string shop = word ? *word : std::string();
    std::erase_if(parameters, [](const auto& parameter) { return parameter.first == shopKey; });
    return shop;
}

task::Completion completedFromShop(const task::Task& task, const std::string& shop, const Request& request,
                                   const Progress& progress)
{
    const Value* const post = request.typed.contains(postKey) ? find(request.parameters, postKey) : nullptr;
    const std::string typed_post = post ? text(*post) : std::string();
    return [&task, &progress, shop, typed_post](project::PanelState& state, Stores& stores, task::Sources& sources) {
        shop::Shop taken = shop::takeShop(shop, stores, progress.quiet(), sources);
        if (!typed_post.empty()) taken.lathe.value.post = typed_post;
        std::optional<Shaft> part;
        if (shop::wantsPart(state, task)) part = partOf(state, task, stores, progress.quiet());
        shop::fillFromShop(state, task, taken, part ? &*part : nullptr, sources.notes);
    };
}

}  // namespace lathelier::cli
