#include "widgets/chatter_common/input_value.h"

#include <nlohmann/json.hpp>

#include "engine/core/frf_item.h"
#include "engine/core/json.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/project/project_codes.h"
#include "engine/receptance/frf_checks.h"
#include "engine/receptance/spindle_item.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/shaft_item.h"
#include "engine/stability/stability_codes.h"
#include "widgets/chatter_common/frf_files.h"
#include "widgets/chatter_common/shaft_files.h"

namespace lathelier::chatter_common {
namespace {

/// `restored` converts the values of an item of this kind; none when they are invalid.
template <class T, class Restored>
InputValue<T> itemValue(const project::PanelState& state, const char* role, const char* kind, Restored restored)
{
    const project::Source& source = state.inputs.at(role);
    const auto item = state.items.find(role);
    std::optional<T> value;
    if (item != state.items.end() && item->second.kind == kind) value = restored(item->second.values);
    if (!value) throw Error(errors::itemNotThere, {{"item", source.item}, {"kind", std::string(kind)}});
    const std::string content = toJson(item->second.values).dump();
    const InputFile input{source.item, static_cast<std::int64_t>(content.size()), io::sha256(content)};
    return {*std::move(value), input, {}, source.synthetic};
}

/// `part` selects the value in a loaded file.
template <class Store, class T, class Part>
InputValue<T> fileValue(const project::Source& source, Stores& stores, const Progress& progress, Part part)
{
    const auto loaded = stores.of<Store>()->load(source, progress);
    return {loaded->file.*part, loaded->inputs.front(), loaded->file.notes,
            source.synthetic || contains(loaded->file.notes, notes::syntheticData)};
}

}  // namespace

const project::Source* sourceOf(const project::PanelState& state, const char* role)
{
    const auto source = state.inputs.find(role);
    return source == state.inputs.end() ? nullptr : &source->second;
}

std::optional<InputValue<Shaft>> takeShaft(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const project::Source* const source = sourceOf(state, shaftRole);
    if (!source) return std::nullopt;
    if (!source->item.empty()) {
        const auto asBeam = [](const Values& values) -> std::optional<Shaft> {
            const std::optional<Shaft> shaft = shaftOf(values);
            return shaft ? std::optional(beamView(*shaft)) : std::nullopt;
        };
        return itemValue<Shaft>(state, shaftRole, shaftItem, asBeam);
    }
    return fileValue<ShaftStore, Shaft>(*source, stores, progress, &io::ShaftFile::shaft);
}

std::optional<InputValue<receptance::SpindleReceptance>> takeSpindle(const project::PanelState& state, Stores& stores,
                                                                     const Progress& progress)
{
    using receptance::SpindleReceptance;
    const project::Source* const source = sourceOf(state, spindleRole);
    if (!source) return std::nullopt;
    if (!source->item.empty())
        return itemValue<SpindleReceptance>(state, spindleRole, receptance::spindleItem, receptance::spindleOf);
    return fileValue<SpindleStore, SpindleReceptance>(*source, stores, progress, &receptance::SpindleFile::spindle);
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
    const project::Source* const source = sourceOf(state, frfRole);
    if (!source || source->item.empty()) return std::nullopt;
    return itemValue<Frf>(state, frfRole, frfItem, frfOf);
}

std::optional<ResponseInput> takeResponse(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const project::Source* const source = sourceOf(state, frfRole);
    if (!source) return std::nullopt;
    if (auto item = takeResponseItem(state)) {
        std::string basis = item->input.sha256;
        return ResponseInput{*std::move(item), std::move(basis)};
    }
    const auto loaded = stores.of<FrfStore>()->load(*source, progress);
    const io::MeasuredFrf& first = loaded->file.frfs.front();
    ResponseInput found{{io::toReceptance(first.frf), loaded->inputs.front(), loaded->file.notes,
                         source->synthetic || contains(loaded->file.notes, notes::syntheticData)},
                        loaded->digest() + toJson(source->import).dump()};
    Notes& readingNotes = found.taken.notes;
    const Notes checked = receptance::checkResponse(first, source->path);
    readingNotes.insert(readingNotes.end(), checked.begin(), checked.end());
    if (const std::size_t count = loaded->file.frfs.size(); count > 1)
        readingNotes.push_back(
            {notes::severalResponses, {{"path", source->path}, {"count", static_cast<std::int64_t>(count)}}});
    return found;
}

}  // namespace lathelier::chatter_common
