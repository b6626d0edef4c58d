// What the views of a comparison show besides its numbers.
#include <nlohmann/json.hpp>

#include "engine/cad/task/compare_task.h"
#include "engine/core/json.h"
#include "engine/features/comparison/shaft_mesh.h"
#include "engine/registration/compare_plots.h"
#include "engine/registration/deviation_skin.h"
#include "engine/registration/surface_form.h"
#include "engine/registration/verdict/verdict.h"
#include "engine/task/memo.h"

namespace lathelier::cad {
namespace {

constexpr double shownSagitta_mm = 0.01;  // of the displayed mesh; deviations refer to the exact contour

struct DrawnMeshes : Memo<LoadedScan> {
    DrawnMeshes() : Memo(2) {}
};

struct DeviationForms : Memo<DeviationForm> {
    DeviationForms() : Memo(2) {}
};

/// `windows`: window index by point.
std::shared_ptr<const std::vector<std::int8_t>> alongAxis(const registration::CompareResult& result,
                                                          const std::vector<std::uint32_t>& windows)
{
    const registration::SurfaceWindows& all = *result.windows;
    if (all.faces.empty() || !all.axis_T_reference || !result.alignment.reference_axis) return nullptr;
    const Eigen::Vector3d z = all.axis_T_reference->linear().row(2);
    const int sense = z.dot(result.alignment.reference_axis->direction) < 0 ? -1 : 1;
    auto along = std::make_shared<std::vector<std::int8_t>>(windows.size());
    for (std::size_t i = 0; i < windows.size(); ++i) {
        if (windows[i] == registration::noWindow) continue;
        const std::int32_t stretch = all.windows[windows[i]].stretch;
        if (stretch >= 0)
            (*along)[i] = static_cast<std::int8_t>(sense * all.stretches[static_cast<std::size_t>(stretch)].facing);
    }
    return along;
}

DeviationForm formOf(const CompareOutcome& outcome, const Progress& progress)
{
    const registration::CompareResult& result = *outcome.result;
    DeviationForm form;
    if (result.windows) {
        const std::vector<std::uint32_t> windows =
            registration::windowsOfPoints(outcome.copyScan(), result, progress.part(0, 0.9));
        form.local_mean_mm = std::make_shared<const std::vector<float>>(
            registration::meansOf(*result.windows, windows, registration::colourSigmaLimit_mm(result)));
        form.along_axis = alongAxis(result, windows);
    }
    if (result.unrolled)
        form.map_mean_mm =
            std::make_shared<const std::vector<float>>(registration::localMeansOfMap(result, progress.part(0.9, 0.95)));
    auto skin = std::make_shared<const Skin>(registration::deviationSkin(result, progress.part(0.95, 1)));
    if (!skin->stations.empty()) form.skin = std::move(skin);
    return form;
}

}  // namespace

void addViews(CompareOutcome& outcome, Stores& stores, const Progress& progress)
{
    const Progress meshing = progress.part(0, 0.2);
    if (const auto& drawn = outcome.reference.drawn)
        outcome.original = stores.of<DrawnMeshes>()->find(outcome.reference.key, meshing, [&](const Progress& part) {
            LoadedScan mesh;
            mesh.file.scan = features::shaftMesh(drawn->shaft, shownSagitta_mm, part).scan;
            return mesh;
        });
    const std::string key = outcome.scansKey() + toJson(toValues(fittedOf(outcome.question.compare))).dump();
    outcome.form = *stores.of<DeviationForms>()->find(
        key, progress.part(0.2, 1, LT_TEXT("Engine", "Averaging the deviation locally")),
        [&](const Progress& part) { return formOf(outcome, part); });
}

}  // namespace lathelier::cad
