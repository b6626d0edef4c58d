#include "widgets/cylindricity/cylindricity_picture.h"

#include "engine/io/io_codes.h"

namespace lathelier::cylindricity_panel {

CylindricityPicture LastCylinder::find(const project::PanelState& state, ScanStore& scans, const Progress& progress)
{
    const auto parameters = fromValues<form::CylindricityParameters>(state.parameters);
    const project::Source& source = state.inputs.at("points");
    CylindricityPicture picture;
    picture.points = scans.load(source, progress.part(0, 0.3, LT_TEXT("Engine", "Reading")));
    picture.synthetic = source.synthetic || contains(picture.points->file.notes, notes::syntheticData);
    picture.inputs = {picture.points->inputs.front()};

    CylindricityPicture last;
    {
        const std::lock_guard lock(mutex_);
        last = last_;
    }
    if (last.result && last.points == picture.points && sameButVerdict(last.result->parameters, parameters)) {
        form::CylindricityResult again = *last.result;
        judge(again, parameters);
        picture.result = std::make_shared<const form::CylindricityResult>(std::move(again));
        picture.surface = last.surface;
    } else {
        picture.result = std::make_shared<const form::CylindricityResult>(cylindricity(
            picture.scan().points_mm, parameters, progress.part(0.3, 0.95, LT_TEXT("Engine", "Fitting cylinders"))));
        picture.surface = std::make_shared<const form::CylinderSurface>(surfaceAbout(
            picture.result->MZCY, picture.scan().points_mm, picture.result->sections, progress.part(0.95, 1)));
    }
    picture.notes = picture.result->notes;
    const Notes& of_file = picture.points->file.notes;
    picture.notes.insert(picture.notes.end(), of_file.begin(), of_file.end());
    const std::lock_guard lock(mutex_);
    last_ = picture;
    return picture;
}

}  // namespace lathelier::cylindricity_panel
