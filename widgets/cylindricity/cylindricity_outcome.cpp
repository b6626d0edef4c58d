#include "widgets/cylindricity/cylindricity_outcome.h"

#include "engine/io/io_codes.h"

namespace lathelier::cylindricity_panel {

CylindricityOutcome LastCylinder::find(const project::PanelState& state, ScanStore& scans, const Progress& progress)
{
    const auto parameters = fromValues<form::CylindricityParameters>(state.parameters);
    const project::Source& source = state.inputs.at("points");
    CylindricityOutcome outcome;
    outcome.points = scans.load(source, progress.part(0, 0.3, LT_TEXT("Engine", "Reading")));
    outcome.synthetic = source.synthetic || contains(outcome.points->file.notes, notes::syntheticData);
    outcome.inputs = {outcome.points->inputs.front()};

    CylindricityOutcome last;
    {
        const std::lock_guard lock(mutex_);
        last = last_;
    }
    if (last.result && last.points == outcome.points && sameButVerdict(last.result->parameters, parameters)) {
        form::CylindricityResult again = *last.result;
        judge(again, parameters);
        outcome.result = std::make_shared<const form::CylindricityResult>(std::move(again));
        outcome.surface = last.surface;
    } else {
        outcome.result = std::make_shared<const form::CylindricityResult>(cylindricity(
            outcome.scan().points_mm, parameters, progress.part(0.3, 0.95, LT_TEXT("Engine", "Fitting cylinders"))));
        outcome.surface = std::make_shared<const form::CylinderSurface>(surfaceAbout(
            outcome.result->MZCY, outcome.scan().points_mm, outcome.result->sections, progress.part(0.95, 1)));
    }
    outcome.notes = outcome.result->notes;
    const Notes& of_file = outcome.points->file.notes;
    outcome.notes.insert(outcome.notes.end(), of_file.begin(), of_file.end());
    const std::lock_guard lock(mutex_);
    last_ = outcome;
    return outcome;
}

}  // namespace lathelier::cylindricity_panel
