#include "engine/walk/walk.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/io/file.h"
#include "engine/shaft/shaft_item.h"
#include "engine/task/edited_segments.h"
#include "engine/task/memo.h"
#include "engine/task/needed.h"
#include "engine/walk/walk_codes.h"

namespace lathelier::walk {
namespace {

constexpr const char* supplyName = "shop";

std::string itemName(const std::string& giver, const std::string& kind)
{
    return giver + ":" + kind;
}

/// Of what the answer depends on: files by their content where it was read.
std::string digestOf(const Place& place, const project::PanelState& state, const Stores* stores, int generation)
{
    Json json{{"place", place.id}, {"generation", generation}, {"parameters", toJson(state.parameters)}};
    json["inputs"] = Json::object();
    for (const auto& [role, source] : state.inputs) {
        const auto content = stores ? stores->digest(source) : std::nullopt;
        Json& input = json["inputs"][role] = {{"name", task::nameOf(source)},
                                              {"content", content.value_or("")},
                                              {"import", toJson(source.import)},
                                              {"synthetic", source.synthetic}};
        if (const auto item = state.items.find(role); item != state.items.end())
            input["item"] = {{"kind", item->second.kind},
                             {"values", toJson(item->second.values)},
                             {"origin", item->second.origin.state_sha256}};
    }
    return io::sha256(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// An answer or its error: an earlier place that has none is not computed again for every later one.
struct Settled {
    std::shared_ptr<const PlaceAnswer> answer;
    std::optional<Error> error;
};

/// The last answer of each place.
class Answers {
public:
    Memo<Settled>& of(const std::string& id)
    {
        const std::lock_guard lock(mutex_);
        auto& memo = memos_[id];
        if (!memo) memo = std::make_unique<Memo<Settled>>(1);
        return *memo;
    }

private:
    std::mutex mutex_;
    std::map<std::string, std::unique_ptr<Memo<Settled>>> memos_;
};

/// A table of segments that was edited from another input, or typed, stands in place of this one.
bool isReplacedByTable(const task::Task& task, const project::PanelState& state, const std::string& name)
{
    if (!find(task.defaults, task::segmentsKey)) return false;
    const Value* const table = find(state.parameters, task::segmentsKey);
    const auto* const rows = table ? std::get_if<Rows>(table) : nullptr;
    if (!rows || rows->rows.empty()) return false;
    const Value* const of = find(state.parameters, task::segmentsOfKey);
    return !of || *of != Value(name);
}

/// Whether the place names which of the inputs that stand in each other's place is filled.
bool namesOneOf(const Place& place)
{
    const std::vector<std::string>& keys = place.task->one_of.keys;
    return std::any_of(place.fills.begin(), place.fills.end(), [&](const std::string& role) {
        return std::find(keys.begin(), keys.end(), role) != keys.end();
    });
}

}  // namespace

Walk::Walk(project::Project project, std::vector<Place> places, Supply supply, std::shared_ptr<Stores> stores,
           int generation)
    : project_(std::move(project)),
      places_(std::move(places)),
      supply_(std::move(supply)),
      stores_(std::move(stores)),
      generation_(generation)
{
}

const Place* Walk::place(const std::string& id) const
{
    const auto found = std::find_if(places_.begin(), places_.end(), [&](const Place& place) { return place.id == id; });
    return found == places_.end() ? nullptr : &*found;
}

const project::PanelState& Walk::promised(const std::string& id) const
{
    if (const Place* const there = place(id)) return promiseOf(*there).state;
    const std::lock_guard lock(mutex_);
    const auto known = promises_.find(id);
    if (known != promises_.end()) return known->second.state;
    Promise other;
    other.state = project::resolved(project_, id);
    return promises_.emplace(id, std::move(other)).first->second.state;
}

const std::vector<Taken>& Walk::taken(const std::string& id) const
{
    static const std::vector<Taken> none;
    const Place* const there = place(id);
    return there ? promiseOf(*there).taken : none;
}

bool Walk::canAnswer(const std::string& id) const
{
    const Place* const there = place(id);
    return there && isReady(*there);
}

bool Walk::isReady(const Place& place) const
{
    return place.missing(promiseOf(place).state).empty();
}

const Walk::Promise& Walk::promiseOf(const Place& place) const
{
    const std::lock_guard lock(mutex_);
    const auto known = promises_.find(place.id);
    if (known != promises_.end()) return known->second;
    Promise made = makePromise(place);
    return promises_.emplace(place.id, std::move(made)).first->second;
}

Walk::Promise Walk::makePromise(const Place& place) const
{
    Promise promise;
    promise.state = project::resolved(project_, place.state);
    for (const auto& [key, value] : place.begins_with)
        if (!find(promise.state.parameters, key)) set(promise.state.parameters, key, value);
    if (place.task)
        for (const task::Input& input : place.task->inputs) promiseInput(place, input, promise);
    promise.digest = digestOf(place, promise.state, nullptr, generation_);
    return promise;
}

void Walk::promiseInput(const Place& place, const task::Input& input, Promise& promise) const
{
    if (input.item_kind.empty() || promise.state.inputs.count(input.role) > 0) return;
    const task::Task& task = *place.task;
    const bool is_named = std::find(place.fills.begin(), place.fills.end(), input.role) != place.fills.end();
    const bool is_one = task::isReplaceable(task, input);
    if (!is_named && !is_one && !task::isNeeded(task, input)) return;
    if (is_one && (!givenOf(task, promise.state).empty() || (!is_named && namesOneOf(place)))) return;
    if (task::saysNothing(task, promise.state, input)) return;
    const Place* const giver = giverOf(place, input.item_kind);
    const bool has_work = !promise.state.inputs.empty() || !givenOf(task, promise.state).empty();
    const bool is_supplied = !giver && supply_.has && supply_.has(input.item_kind) &&
                             (supply_.needs_part(input.item_kind) ? giverOf(place, shaftItem) != nullptr : has_work);
    if (!giver && !is_supplied) return;
    const std::string name = itemName(giver ? giver->id : supplyName, input.item_kind);
    if (isReplacedByTable(task, promise.state, name)) return;
    project::Item item;
    item.kind = input.item_kind;
    item.origin.panel = giver ? giver->id : supplyName;
    item.origin.state_sha256 = giver ? promiseOf(*giver).digest : supply_.digest;
    // What is made for a part follows from it and from the job that clamps it.
    const bool follows_part = place.takes_held || (!giver && supply_.needs_part(input.item_kind));
    if (const Place* const of_part = follows_part ? giverOf(place, shaftItem) : nullptr)
        item.origin.state_sha256 = io::sha256(item.origin.state_sha256 + promiseOf(*of_part).digest + supply_.digest +
                                              (supply_.job_digest ? supply_.job_digest(project_) : std::string()));
    promise.state.inputs[input.role].item = name;
    promise.state.items[input.role] = std::move(item);
    promise.taken.push_back({input.role, giver ? giver->title : Text{}, !giver});
    promise.givers[input.role] = giver;
}

/// The nearest earlier place that gives this kind and can be answered.
const Place* Walk::giverOf(const Place& place, const std::string& kind) const
{
    const Place* nearest = nullptr;
    for (const Place& earlier : places_) {
        if (earlier.id == place.id) break;
        const bool gives = std::find(earlier.gives.begin(), earlier.gives.end(), kind) != earlier.gives.end();
        if (!gives || earlier.state == place.state || !isReady(earlier)) continue;
        if (!earlier.may_give || earlier.may_give(promiseOf(earlier).state)) nearest = &earlier;
    }
    return nearest;
}

Walk::Given Walk::give(const Place& giver, const std::string& kind, Notes& notes, const Progress& progress) const
{
    std::shared_ptr<const PlaceAnswer> answered;
    try {
        answered = answer(giver.id, progress);
    } catch (Error& error) {
        throw error.with("of_place", giver.title);
    }
    for (const Note& note : answered->outcome.notes)
        if (note.code.role == NoteRole::Assumed && std::none_of(notes.begin(), notes.end(), [&](const Note& known) {
                return known.code == note.code && known.values == note.values;
            }))
            notes.push_back(note);
    if (answered->outcome.products)
        for (const task::Product& product : answered->outcome.products({}))
            if (product.kind == kind) return {{kind, product.values(), {giver.id, {}, {}, {}}}, answered->is_synthetic};
    if (!answered->outcome.errors.empty()) {
        Error error = answered->outcome.errors.front();
        throw error.with("of_place", giver.title);
    }
    throw Error(errors::nothingFollows, {{"place", giver.title}});
}

std::optional<Shaft> Walk::partFor(const Place& place, Notes& notes, const Progress& progress) const
{
    const Place* const giver = giverOf(place, shaftItem);
    return giver ? shaftOf(give(*giver, shaftItem, notes, progress).item.values) : std::nullopt;
}

project::PanelState Walk::complete(const std::string& id, Notes& notes, const Progress& progress) const
{
    const Place* const there = place(id);
    if (!there) return promised(id);
    const Promise& promise = promiseOf(*there);
    project::PanelState state = promise.state;
    bool is_supplied = false;
    for (const auto& [role, giver] : promise.givers) {
        if (!giver) {  // the supply fills what is free
            is_supplied = true;
            state.inputs.erase(role);
            state.items.erase(role);
            continue;
        }
        const std::string kind = state.items.at(role).kind;
        auto [item, is_synthetic] = give(*giver, kind, notes, progress);
        if (there->takes_held && supply_.held && kind == shaftItem)
            if (const auto part = shaftOf(item.values)) {
                const HeldPart held = supply_.held(*part, project_, *stores_, progress, notes);
                item.values = toValues(held.body);
                if (!there->speeds.empty() && !find(state.parameters, there->speeds))
                    set(state.parameters, there->speeds, std::vector<Interval>{held.speeds_rpm});
            }
        item.origin.state_sha256 = state.items.at(role).origin.state_sha256;
        state.items[role] = std::move(item);
        state.inputs[role].synthetic = is_synthetic;
    }
    if (!is_supplied) return state;
    const std::optional<Shaft> part = partFor(*there, notes, progress);
    supply_.fill(state, *there->task, part ? &*part : nullptr, project_, *stores_, progress, notes);
    for (const auto& [role, giver] : promise.givers)
        if (!giver && state.items.count(role) > 0) {
            state.inputs[role].item = promise.state.inputs.at(role).item;
            state.items[role].origin = promise.state.items.at(role).origin;
        }
    return state;
}

std::shared_ptr<const PlaceAnswer> Walk::answer(const std::string& id, const Progress& progress) const
{
    const Place& there = *place(id);
    const Progress before = progress.part(0, 0.3);
    task::Sources sources;
    const project::PanelState state = complete(id, sources.notes, before);
    const auto answered = [&] {
        Settled settled;
        try {
            settled.answer =
                std::make_shared<const PlaceAnswer>(there.answer(state, *stores_, sources, progress.part(0.3, 1)));
        } catch (const Error& error) {
            settled.error = error;
        }
        return settled;
    };
    try {  // content first: a file that was accepted anew is another question
        for (const task::Input& input : there.task ? there.task->inputs : std::vector<task::Input>{})
            if (input.read) input.read(state, *stores_, before);
    } catch (const Error&) {
        // the task reports it with all that it knows of the place
    }
    const std::string key = digestOf(there, state, stores_.get(), generation_);
    const auto settled =
        stores_->of<Answers>()->of(id).find(key, progress, [&](const Progress&) { return answered(); });
    if (settled->error) throw Error(*settled->error);
    return settled->answer;
}

}  // namespace lathelier::walk
