// remanufacture SCAN: the whole chain from the scan of a worn part to its program and the proof of its copy.
#include <nlohmann/json.hpp>

#include "app/cli/remanufacture_steps.h"
#include "app/cli/verbs.h"
#include "engine/cam/job_file.h"
#include "engine/chain/dossier_kind.h"
#include "engine/chain/dossier_report.h"
#include "engine/core/core_codes.h"
#include "engine/deflection/setup_file.h"
#include "engine/features/recognition.h"
#include "engine/io/file.h"
#include "engine/receptance/spindle_kind.h"
#include "engine/report/html.h"
#include "engine/report/plain_text.h"
#include "engine/report/result_json.h"

namespace lathelier::cli {
namespace {

Label fileLabel(Text label, Text help, bool required = false)
{
    Label made{label, help};
    made.required = required;
    return made;
}

}  // namespace

const std::vector<Field<ChainFiles>>& fieldsOf(const ChainFiles*)
{
    using F = ChainFiles;
    static const std::vector<Field<F>> all{
        field("out", &F::out,
              fileLabel(LT_TEXT("Engine", "Folder"),
                        LT_TEXT("Engine", "Where every file goes; made when it is missing."), true)),
        field("machine", &F::machine,
              fileLabel(LT_TEXT("Engine", "Machine"),
                        LT_TEXT("Engine", "The spindle at the chuck face, from SPINDLE.json."), true)),
        field("job", &F::job,
              fileLabel(LT_TEXT("Engine", "Job"),
                        LT_TEXT("Engine", "Stock, set-up, tools and cutting data, from JOB.json."), true)),
        field("setup", &F::setup,
              fileLabel(LT_TEXT("Engine", "Set-up of deflection"),
                        LT_TEXT("Engine", "SETUP.json; without a stock of its own it takes the job's bar."))),
        field("copy", &F::copy,
              fileLabel(LT_TEXT("Engine", "Copy"), LT_TEXT("Engine", "The scan of the machined copy."))),
        field("drawing", &F::drawing,
              fileLabel(LT_TEXT("Engine", "Drawing"),
                        LT_TEXT("Engine", "SHAFT.json that somebody has confirmed, in place of what was recognised."))),
        field("confirmed_by", &F::confirmed_by,
              fileLabel(LT_TEXT("Engine", "Confirmed by"), LT_TEXT("Engine", "Who answers for the drawing."))),
        field("post", &F::post,
              fileLabel(LT_TEXT("Engine", "Post"),
                        LT_TEXT("Engine",
                                "Control that the program is for: fanuc_a, fanuc_b, haas, sinumerik, linuxcnc, grbl, "
                                "or POST.json."))),
        field("tolerance_mm", &F::tolerance_mm, Range{0, 1e6},
              Label{LT_TEXT("Engine", "Tolerance of the copy"), LT_TEXT("Engine", "Of its surface, to both sides."),
                    LT_TEXT("Engine", "mm")}),
        field("tolerance_um", &F::tolerance_um, Range{0, 1e6},
              Label{LT_TEXT("Engine", "Tolerance of the predicted diameter"), LT_TEXT("Engine", "To both sides."),
                    LT_TEXT("Engine", "µm")})};
    return all;
}

namespace {

/// Options of the recognition but those of the published method, which a chain does not need.
std::vector<Option> chainOptions()
{
    std::vector<Option> options = optionsOf<ChainFiles>();
    for (Option& option : optionsOf<features::RecognitionParameters>())
        for (const char* key : {"snap", "form_tolerance_mm", "scanner_accuracy_mm", "free_end", "length_mm"})
            if (option.info.key == key) options.push_back(option);
    return options;
}

/// Dossier and report stand in the folder, whatever happened before.
void finish(const Request& request, io::InputFiles& inputs, ChainRun& chain, Answer& answer)
{
    chain::Dossier& dossier = chain.dossier();
    const auto kept = std::make_shared<const chain::Dossier>(dossier);
    answer.notes = dossier.notes;
    answer.json = [kept] { return chain::toJson(*kept); };
    answer.report = [kept, sections = chain.sections()] { return chain::dossierReport(*kept, sections); };
    answer.summary = report::toPlainText({{}, {chain::answer(*kept), chain::stepsTable(*kept)}});
    if (dossier.verdict) answer.pass = passed(dossier.verdict);
    io::writeFile(chain.path(chain::dossierFile),
                  report::toText(report::wholeResult("remanufacture", inputs.list(), request.parameters,
                                                     chain::toJson(*kept), kept->notes)));
    report::Document document = answer.report();
    document.inputs = inputs.list();
    io::writeFile(chain.path("report.html"), report::toHtml(document));
    if (chain.error()) answer.errors.push_back(*chain.error());
}

void requireFiles(const ChainFiles& files)
{
    const auto require = [](const std::string& given, const char* option, Text expected) {
        if (given.empty())
            throw Error(errors::valueNotUnderstood, {{"parameter", option}, {"found", ""}, {"expected", expected}});
    };
    require(files.out, "--out", LT_TEXT("Engine", "a folder"));
    require(files.machine, "--machine", LT_TEXT("Engine", "a spindle (SPINDLE.json)"));
    require(files.job, "--job", LT_TEXT("Engine", "a job (JOB.json)"));
}

void runRemanufacture(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const auto files = fromValues<ChainFiles>(request.parameters);
    requireFiles(files);
    inputs.open(request.operands.front(), progress);
    Remanufacture all(request, files, inputs, progress);
    all.recognise();
    all.draw();
    all.planSpeeds();
    all.program();
    all.deflect();
    all.compareCopy();
    all.prove();
    finish(request, inputs, all.chain(), answer);
}

}  // namespace

Verb remanufactureVerb()
{
    return {"remanufacture",
            "From the scan of a worn part to its drawing, its program and the proof of its copy, in one folder.",
            {{"SCAN", "The worn part: a point cloud or mesh."}},
            chainOptions(),
            {&io::scanFiles(), &cam::jobFiles(), &receptance::spindleFiles(), &deflection::setupFiles(),
             &chain::dossierFiles()},
            {},
            true,
            runRemanufacture};
}

}  // namespace lathelier::cli
