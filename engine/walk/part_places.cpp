#include "engine/walk/part_places.h"

#include "engine/cad/task/compare_task.h"
#include "engine/cad/task/draw_task.h"
#include "engine/cad/task/recognize_task.h"
#include "engine/cam/task/turn_task.h"
#include "engine/core/frf_item.h"
#include "engine/deflection/deflection_task.h"
#include "engine/deflection/toolpath_task.h"
#include "engine/gcode/program_item.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "engine/receptance/task/modes_task.h"
#include "engine/receptance/task/shaft_task.h"
#include "engine/receptance/task/spindle_task.h"
#include "engine/receptance/task/tap_task.h"
#include "engine/shaft/shaft_item.h"
#include "engine/stability/task/lobes_task.h"
#include "engine/stability/task/speed_task.h"
#include "engine/task/needed.h"

namespace lathelier::walk {
namespace {

std::function<std::vector<Text>(const project::PanelState&)> missingOf(const task::Task& task)
{
    return [&task](const project::PanelState& state) {
        std::vector<Text> labels;
        for (const task::Input& input : task.inputs)
            if (task::isNeeded(task, input) && state.inputs.count(input.role) == 0) labels.push_back(input.label);
        if (!task.one_of.keys.empty() && givenOf(task, state).empty()) labels.push_back(task.one_of.label);
        return labels;
    };
}

Place placeOf(const char* id, const task::Task& task, std::vector<std::string> gives = {},
              std::vector<std::string> fills = {})
{
    Place place;
    place.id = id;
    place.state = id;
    place.title = task.title;
    place.task = &task;
    place.gives = std::move(gives);
    place.fills = std::move(fills);
    place.missing = missingOf(task);
    place.answer = [&task](const project::PanelState& state, Stores& stores, task::Sources& sources,
                           const Progress& progress) {
        PlaceAnswer made;
        made.outcome = task.run(state, {}, stores, sources, progress);
        made.value = made.outcome.result;
        made.is_synthetic = sources.synthetic;
        return made;
    };
    return place;
}

/// On the part in its bar: that is what vibrates. `speeds`: the field of the speeds that are looked at.
Place held(Place place, const char* speeds = "")
{
    place.takes_held = true;
    place.speeds = speeds;
    return place;
}

Place ofState(Place place, const char* state)
{
    place.state = state;
    return place;
}

/// A computed response is that of the shaft, which later questions take themselves.
Place measuredOnly(Place place, const char* role)
{
    place.may_give = [role](const project::PanelState& state) { return state.inputs.count(role) > 0; };
    return place;
}

}  // namespace

std::vector<Place> partPlaces()
{
    const task::Task &lobes = stability::lobesTask(), &deflection = deflection::deflectionTask();
    return {placeOf("recognise", cad::recognizeTask(), {shaftItem}),
            placeOf("drawing", cad::drawTask(), {shaftItem}, {cad::shaftRole}),
            held(placeOf("shaft", receptance::shaftTask(), {}, {receptance::spindleRole})),
            measuredOnly(placeOf("spindle", receptance::spindleTask(), {receptance::spindleItem}),
                         receptance::measurementsRole),
            placeOf("tap", receptance::tapTask(), {frfItem}),
            measuredOnly(placeOf("frf", receptance::modesTask(), {frfItem}), receptance::responseRole),
            held(placeOf("lobes", lobes, {}, {stability::spindleRole}), "speed_rpm"),
            held(placeOf("pass", lobes, {}, {stability::shaftRole, stability::spindleRole}), "speed_rpm"),
            held(placeOf("speed", stability::speedTask(), {}, {stability::spindleRole})),
            placeOf("turning", cam::turnTask(), {gcode::programItem}, {cam::jobRole, cam::spindleRole}),
            ofState(placeOf("program", deflection::toolpathTask()), "deflection"),
            ofState(placeOf("deflection", deflection), "deflection"),
            ofState(placeOf("correction", deflection), "deflection"),
            placeOf("compare", cad::compareTask())};
}

}  // namespace lathelier::walk
