// surface IMAGE...: photographs of turned surfaces: feed marks, chatter marks and their frequency.
#include "engine/surface/surface.h"

#include <nlohmann/json.hpp>

#include "app/cli/verbs.h"
#include "engine/io/image/image_kind.h"
#include "engine/report/plain_text.h"
#include "engine/surface/surface_quantities.h"
#include "engine/surface/surface_report.h"

namespace lathelier::cli {
namespace {

/// Unreadable pictures are reported together; a comparison requires all.
std::vector<surface::NamedImage> readImages(const Request& request, io::InputFiles& inputs, const Progress& progress,
                                            Answer& answer)
{
    std::vector<surface::NamedImage> images;
    const double share = 1.0 / static_cast<double>(request.operands.size());
    for (const std::string& path : request.operands) {
        const double done = static_cast<double>(images.size()) * share;
        const Progress part = progress.part(done, done + share, LT_TEXT("Engine", "Reading"));
        try {
            images.emplace_back(path, io::readImage(path, inputs.open(path, part.part(0, 0.2)), part.part(0.2, 1)));
            const Notes& notes = images.back().image->notes;
            answer.notes.insert(answer.notes.end(), notes.begin(), notes.end());
        } catch (Error& error) {
            answer.errors.push_back(error.with("path", path));
        }
        inputs.drop();
    }
    return images;
}

void runSurface(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const auto parameters = fromValues<surface::SurfaceParameters>(request.parameters);
    const std::vector<surface::NamedImage> images = readImages(request, inputs, progress.part(0, 0.2), answer);
    if (!answer.errors.empty()) return;
    const auto result = std::make_shared<surface::SurfaceResult>(
        findSurfaceMarks(images, parameters, progress.part(0.2, 1, LT_TEXT("Engine", "Evaluating"))));
    answerWith(
        answer, result, [](const auto& found) { return surface::toJson(found); },
        [](const auto& found) { return surfaceReport(found); },
        [](const auto& found) { return report::toPlainText(surfaceSummary(found)); });
}

}  // namespace

Verb surfaceVerb()
{
    return {"surface",
            "Photographs of turned surfaces: feed marks, chatter marks and their frequency.",
            {{"IMAGE", "A photograph (PNG, JPEG, TIFF); several are compared, the first being before.", true}},
            optionsOf<surface::SurfaceParameters>(),
            {&io::imageFiles()},
            {},
            true,
            runSurface};
}

}  // namespace lathelier::cli
