#include "widgets/chatter_common/input_value.h"

#include <nlohmann/json.hpp>

#include "engine/core/frf_item.h"
#include "engine/core/json.h"
#include "engine/io/frf/frf_choice.h"
#include "engine/io/io_codes.h"
#include "engine/receptance/frf_checks.h"
#include "engine/stability/stability_codes.h"
#include "widgets/chatter_common/frf_files.h"
#include "widgets/chatter_common/shaft_files.h"

namespace lathelier::chatter_common {
namespace {

/// Of the only source that was read.
template <class T>
InputValue<T> inputValue(T value, task::Sources sources)
{
    return {std::move(value), std::move(sources.inputs.front()), std::move(sources.notes), sources.synthetic};
}

template <class K>
std::optional<InputValue<typename K::Value>> takeInput(const project::PanelState& state, const char* role,
                                                       Stores& stores, const Progress& progress)
{
    task::Sources sources;
    auto value = task::take<K>(state, role, stores, progress, sources);
    if (!value) return std::nullopt;
    return inputValue(*std::move(value), std::move(sources));
}

}  // namespace

std::optional<InputValue<Shaft>> takeShaft(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    return takeInput<io::ShaftInput>(state, shaftRole, stores, progress);
}

std::optional<InputValue<receptance::SpindleReceptance>> takeSpindle(const project::PanelState& state, Stores& stores,
                                                                     const Progress& progress)
{
    return takeInput<receptance::SpindleInput>(state, spindleRole, stores, progress);
}

receptance::ReceptanceParameters withinTable(receptance::ReceptanceParameters asked,
                                             const receptance::SpindleReceptance& spindle)
{
    if (const auto* table = std::get_if<receptance::SpindleTable>(&spindle.source)) {
        asked.from_hz = table->frequency_hz.front();
        asked.to_hz = table->frequency_hz.back();
    }
    return asked;
}

std::optional<InputValue<Frf>> takeResponseItem(const project::PanelState& state)
{
    const project::Source* const source = task::sourceOf(state, frfRole);
    if (!source || source->item.empty()) return std::nullopt;
    const Values& values = task::itemValues(state, frfRole, frfItem);
    std::optional<Frf> frf = frfOf(values);
    if (!frf) task::throwItemNotThere(source->item, frfItem);
    task::Sources sources;
    sources.add({task::itemAsInput(source->item, task::contentOf(values))}, {}, source->synthetic);
    return inputValue(*std::move(frf), std::move(sources));
}

std::optional<ResponseInput> takeResponse(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const project::Source* const source = task::sourceOf(state, frfRole);
    if (!source) return std::nullopt;
    if (auto item = takeResponseItem(state)) {
        std::string basis = item->input.sha256;
        return ResponseInput{*std::move(item), std::move(basis)};
    }
    const auto loaded = stores.of<FrfStore>()->load(*source, progress);
    const io::MeasuredFrf& used = io::preferredResponse(loaded->file.frfs);
    ResponseInput found{{io::toReceptance(used.frf), loaded->inputs.front(), loaded->file.notes,
                         source->synthetic || contains(loaded->file.notes, notes::syntheticData)},
                        loaded->digest() + toJson(source->import).dump()};
    Notes& readingNotes = found.taken.notes;
    const Notes checked = receptance::checkResponse(used, source->path);
    readingNotes.insert(readingNotes.end(), checked.begin(), checked.end());
    const Notes chosen = io::notesOfChoice(loaded->file.frfs, used, source->path);
    readingNotes.insert(readingNotes.end(), chosen.begin(), chosen.end());
    return found;
}

}  // namespace lathelier::chatter_common
