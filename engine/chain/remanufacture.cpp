#include "engine/chain/remanufacture.h"

#include <nlohmann/json.hpp>

#include "engine/chain/chain_steps.h"
#include "engine/chain/dossier_cover.h"
#include "engine/io/file.h"
#include "engine/report/html.h"
#include "engine/report/result_json.h"

namespace lathelier::chain {
namespace {

/// Errors of writing are ignored, as the original exception is rethrown.
void tryToWriteDossier(const std::string& path, const Json& dossier)
{
    try {
        io::writeFile(path, report::toText(dossier));
    } catch (const Error&) {
    }
}

}  // namespace

Dossier remanufacture(const ChainQuestion& question, RunMode mode, std::shared_ptr<const Dossier> earlier,
                      io::InputFiles& inputs, const Progress& progress)
{
    if (mode != RunMode::DryRun) refuseOverwriting(question);
    StepRunner runner(question.out, mode, std::move(earlier));
    ChainSteps steps(question, runner, inputs, progress);
    try {
        steps.recognise();
        steps.draw();
        steps.planSpeeds();
        steps.program();
        steps.deflect();
        steps.compareCopy();
        steps.prove();
        steps.comparePhotographs();
    } catch (...) {  // cancelled or disk full: the dossier records the files written so far
        if (mode != RunMode::DryRun) {
            runner.keepEarlierSteps();
            tryToWriteDossier(runner.path(dossierFile), wholeDossier(runner.dossier(), {}, toValues(question)));
        }
        throw;
    }
    return std::move(runner.dossier());
}

void writeDossier(const ChainQuestion& question, const Dossier& dossier, const std::vector<InputFile>& inputs,
                  const Values& parameters)
{
    const std::string folder = question.out + "/";
    io::writeFile(folder + dossierFile, report::toText(wholeDossier(dossier, inputs, parameters)));
    io::writeFile(folder + reportFile, report::toHtml(dossierReport(dossier)));
    for (const Annex& annex : annexesOf(dossier, inputs))
        io::writeFile(folder + annex.file, report::toHtml(annex.document));
}

}  // namespace lathelier::chain
