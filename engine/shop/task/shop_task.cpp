#include "engine/shop/task/shop_task.h"

#include <nlohmann/json.hpp>

#include "engine/io/file.h"
#include "engine/io/json/json_fields.h"
#include "engine/shop/shop_input.h"
#include "engine/shop/shop_job.h"

namespace lathelier::shop {
namespace {

/// One table of the shop with the key that is chosen of it.
template <class T>
struct Part {
    const char* list;
    Text name;
    const std::vector<ShopEntry<T>>& entries;
    const std::string& chosen;
};

/// Calls `work` for each table, in the order of the choice.
template <class Work>
void forEach(const ShopLibrary& library, const ShopChoice& choice, Work work)
{
    work(Part<Lathe>{"lathes", LT_TEXT("Engine", "Lathe"), library.lathes, choice.lathe});
    work(Part<Chuck>{"chucks", LT_TEXT("Engine", "Chuck"), library.chucks, choice.chuck});
    work(Part<Tailstock>{"tailstocks", LT_TEXT("Engine", "Tailstock"), library.tailstocks, choice.tailstock});
    work(Part<ToolSet>{"tool_sets", LT_TEXT("Engine", "Set of tools"), library.tool_sets, choice.tools});
    work(Part<BarMaterial>{"materials", LT_TEXT("Engine", "Material"), library.materials, choice.material});
}

Json toJson(const ShopOutcome& outcome)
{
    Json result = {{"choice", io::objectOf(infos<ShopChoice>(), lathelier::toValues(outcome.stated.choice))},
                   {"post", outcome.shop.lathe.value.post}};
    forEach(outcome.library, outcome.stated.choice, [&]<class T>(const Part<T>& part) {
        Json& table = result[part.list] = Json::array();
        for (const ShopEntry<T>& entry : part.entries) {
            Json item = io::objectOf(infos<T>(), lathelier::toValues(entry.value));
            item["key"] = entry.key;
            item["source"] = entry.source;
            item["is_own"] = entry.is_own;
            item["is_chosen"] = entry.key == part.chosen;
            table.push_back(std::move(item));
        }
    });
    return result;
}

report::Section summaryOf(const ShopOutcome& outcome)
{
    report::Table table;
    table.columns = {LT_TEXT("Engine", "Table"), LT_TEXT("Engine", "Key"), LT_TEXT("Engine", "Name"),
                     LT_TEXT("Engine", "Chosen"), LT_TEXT("Engine", "Source")};
    forEach(outcome.library, outcome.stated.choice, [&]<class T>(const Part<T>& part) {
        for (const ShopEntry<T>& entry : part.entries) {
            const bool is_chosen = entry.key == part.chosen;
            table.rows.push_back({part.name, entry.key, entry.value.name,
                                  is_chosen ? Value(LT_TEXT("Engine", "chosen")) : Value(), entry.source});
        }
    });
    return {LT_TEXT("Engine", "Shop"), {std::move(table)}};
}

/// Fields of the question that were changed rule over the choice of the file.
ShopChoice chosenBy(const project::PanelState& state, const ShopChoice& of_file)
{
    Values values = lathelier::toValues(of_file);
    for (const auto& [key, value] : state.parameters)
        if (task::isGiven(shopTask(), state, key)) set(values, key, value);
    return fromValues<ShopChoice>(values);
}

/// Appends the entry of this key.
template <class T>
void keep(const std::vector<ShopEntry<T>>& entries, const std::string& key, std::vector<ShopEntry<T>>& kept)
{
    for (const ShopEntry<T>& entry : entries)
        if (entry.key == key) kept.push_back(entry);
}

task::Outcome outcomeOf(const std::shared_ptr<const ShopOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    all.json = [outcome] { return toJson(*outcome); };
    all.summary = [outcome](const Language&) { return summaryOf(*outcome); };
    all.report = [outcome](const Language&) {
        report::Document document;
        document.title = LT_TEXT("Engine", "Shop");
        document.sections = {summaryOf(*outcome)};
        return document;
    };
    all.writers[shopExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        io::writeFile(path, shopText(chosenOnly(*outcome)));
    };
    return settled(shopTask(), std::move(all), outcome->understanding);
}

}  // namespace

ShopOutcome answerShop(const project::PanelState& state, Stores& stores, task::Sources& sources,
                       const Progress& progress)
{
    ShopOutcome outcome;
    if (const auto loaded = task::takeFile<ShopInput>(state, shopRole, stores, progress, sources))
        outcome.stated = loaded->file.shop;
    outcome.stated.choice = chosenBy(state, outcome.stated.choice);
    outcome.library = united(outcome.stated.own, shopLibrary());
    outcome.shop = shopOf(outcome.stated.choice, outcome.library);
    Notes assumed;
    noteAssumed(outcome.shop, {true, true, true, true, true}, assumed);
    outcome.record(state, sources, assumed);
    return outcome;
}

StatedShop chosenOnly(const ShopOutcome& outcome)
{
    StatedShop made{outcome.stated.choice, {}};
    keep(outcome.library.lathes, made.choice.lathe, made.own.lathes);
    keep(outcome.library.chucks, made.choice.chuck, made.own.chucks);
    keep(outcome.library.tailstocks, made.choice.tailstock, made.own.tailstocks);
    keep(outcome.library.tool_sets, made.choice.tools, made.own.tool_sets);
    keep(outcome.library.materials, made.choice.material, made.own.materials);
    return made;
}

const task::Task& shopTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "shop";
        made.title = LT_TEXT("Engine", "Shop");
        made.summary =
            "Show lathes, chucks, tailstocks, tools and materials of a shop, and write what is chosen of them.";
        made.question = "machine";
        made.inputs = {
            task::optionalInput<ShopInput>(shopRole, "", LT_TEXT("Engine", "Shop"),
                                           LT_TEXT("Engine", "SHOP.json; without it the shop that is built in."))};
        made.inputs.front().operand = "SHOP";
        task::askFor<ShopChoice>(made);
        made.exports = {{shopExport, "Write the chosen entries as FILE.json, to be edited.",
                         LT_TEXT("Engine", "Chosen entries (SHOP.json)…"), LT_TEXT("Engine", "JSON (*.json)"), "json"}};
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(std::make_shared<const ShopOutcome>(answerShop(state, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::shop
