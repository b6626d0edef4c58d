#include "widgets/chatter_common/input_value.h"

#include <nlohmann/json.hpp>

#include "engine/core/frf_item.h"
#include "engine/core/json.h"
#include "engine/stability/task/point_response.h"
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
    if (!task::sourceOf(state, frfRole)) return std::nullopt;
    task::Sources sources;
    stability::PointResponse response = stability::takeResponse(state, {}, 0, std::nullopt, stores, sources, progress);
    return ResponseInput{inputValue(*response.frf, std::move(sources)), std::move(response.basis)};
}

}  // namespace lathelier::chatter_common
