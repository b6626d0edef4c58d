// remanufacture SCAN: the whole chain from the scan of a worn part to its program and the proof of its copy.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/any_shaft.h"
#include "app/cli/chain_run.h"
#include "app/cli/shafts.h"
#include "app/cli/verbs.h"
#include "engine/cam/job_bodies.h"
#include "engine/cam/job_file.h"
#include "engine/chain/chain_codes.h"
#include "engine/chain/dossier_kind.h"
#include "engine/chain/dossier_report.h"
#include "engine/chain/normalized_error.h"
#include "engine/core/core_codes.h"
#include "engine/core/texts.h"
#include "engine/deflection/setup_file.h"
#include "engine/features/recognition.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/receptance/spindle_kind.h"
#include "engine/report/html.h"
#include "engine/report/plain_text.h"
#include "engine/report/result_json.h"

namespace lathelier::cli {
namespace {

/// Files and choices of the chain.
struct ChainFiles {
    std::string out;                     ///< folder
    std::string machine;                 ///< path
    std::string job;                     ///< path
    std::string setup;                   ///< path; empty: deflection is left out
    std::string copy;                    ///< path; empty: no copy yet
    std::string drawing;                 ///< path; empty: the drawing is what was recognised
    std::string confirmed_by;            ///< name of who answers for the drawing
    std::string post = "fanuc_a";        ///< control
    std::optional<double> tolerance_mm;  ///< of the copy's surface
    std::optional<double> tolerance_um;  ///< of the predicted diameter error
};

Label fileLabel(Text label, Text help, bool required = false)
{
    Label made{label, help};
    made.required = required;
    return made;
}

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

/// Options of the recognition but those of the published method, which a chain does not need.
std::vector<Option> chainOptions()
{
    std::vector<Option> options = optionsOf<ChainFiles>();
    for (Option& option : optionsOf<features::RecognitionParameters>())
        for (const char* key : {"snap", "form_tolerance_mm", "scanner_accuracy_mm", "free_end", "length_mm"})
            if (option.info.key == key) options.push_back(option);
    return options;
}

Values optional(const char* key, const std::optional<double>& value)
{
    return value ? Values{{key, *value}} : Values{};
}

/// The finished part with the rest of its bar up to the chuck: what the spindle carries.
Shaft heldPart(const Shaft& part, const cam::Job& job)
{
    Shaft held = part;
    const double rest_mm = job.setup.chuck_face_z_mm - part.length_mm();
    if (rest_mm > 0) {
        ShaftSegment bar;
        bar.length_mm = rest_mm;
        bar.start_diameter_mm = bar.end_diameter_mm = job.stock.diameter_mm;
        held.segments.push_back(bar);
    }
    return held;
}

class Remanufacture {
public:
    Remanufacture(const Request& request, io::InputFiles& inputs, const Progress& progress)
        : request_(request),
          files_(fromValues<ChainFiles>(request.parameters)),
          inputs_(inputs),
          progress_(progress),
          chain_(files_.out)
    {
        refuseOverwriting();
        const auto bytes = [&](const std::string& path) {
            return io::FileToRead{path, inputs_.open(path, progress_), request_.parameters, inputs_, progress_};
        };
        job_ = cam::loadJob(bytes(files_.job)).job;
    }

    void recognise();
    void draw();
    void planSpeeds();
    void program();
    void deflect();
    void compareCopy();
    void prove();
    ChainRun& chain() { return chain_; }

private:
    void refuseOverwriting() const;
    void correct(StepRequest step);
    Progress share(double from, double to, Text stage) const { return progress_.part(from, to, stage); }

    const Request& request_;
    ChainFiles files_;
    io::InputFiles& inputs_;
    const Progress& progress_;
    ChainRun chain_;
    cam::Job job_;
    std::string shaft_;         // path of the drawing
    std::string program_;       // path of the first program
    double stock_zero_mm_ = 0;  // z of deflection's stock less z of the part
    Json drawn_, deflected_, compared_;
};

constexpr const char* measuredFile = "measured.json";
constexpr const char* correctedFile = "program_corrected.nc";

void Remanufacture::refuseOverwriting() const
{
    std::vector<std::string> inputs{files_.machine, files_.job, files_.setup, files_.copy, files_.drawing};
    inputs.push_back(request_.operands.front());
    for (const std::string& path : inputs) {
        std::error_code ignored;
        const std::filesystem::path file(path);
        const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
        if (!path.empty() && std::filesystem::equivalent(folder, files_.out, ignored))
            throw Error(errors::outputIsInput, {{"parameter", "--out"}, {"file", path}});
    }
}

void Remanufacture::recognise()
{
    StepRequest step{"recognise", "recognize", {request_.operands.front()}, {}, {}};
    for (const Option& option : optionsOf<features::RecognitionParameters>())
        if (const Value* const given = find(request_.parameters, option.info.key))
            set(step.given, option.info.key, *given);
    // The contour as well: an incomplete drawing is refused here and not further on.
    step.outputs = {{"--shaft", measuredFile}, {"--stock", "measured.txt"}};
    chain_.run(step, share(0, 0.3, LT_TEXT("Engine", "Recognising")));
    shaft_ = files_.drawing.empty() ? chain_.path(measuredFile) : files_.drawing;
    if (!files_.drawing.empty())
        chain_.dossier().confirmed.push_back({"drawing", files_.drawing, files_.confirmed_by});
    else if (!files_.confirmed_by.empty())
        chain_.dossier().confirmed.push_back({"drawing", measuredFile, files_.confirmed_by});
    const Value* const snap = find(request_.parameters, "snap");
    if (!chain_.hasFailed() && files_.drawing.empty() && !(snap && *snap == Value(std::string("apply"))))
        chain_.remark({notes::measuredSizesCut, {{"file", std::string("recognise.json")}}});
}

void Remanufacture::draw()
{
    drawn_ = chain_.run({"draw",
                         "draw",
                         {shaft_},
                         {},
                         {{"--shaft", "drawing.json"},
                          {"--drawing", "drawing.svg"},
                          {"--dxf", "drawing.dxf"},
                          {"--step", "part.step"},
                          {"--freecad", "part.FCMacro"},
                          {"--csv", "rows.csv"}}},
                        share(0.3, 0.4, LT_TEXT("Engine", "Drawing")));
    shaft_ = chain_.path("drawing.json");
}

void Remanufacture::planSpeeds()
{
    if (!chain_.hasFailed()) {
        Notes notes;
        const io::FileBytes bytes(shaft_);
        chain_.write("held.json", io::shaftText(heldPart(io::readShaft(std::string(bytes.view()), notes), job_)));
        for (const InputFile& file : inputs_.list()) chain_.alsoTakes(chain_.named(file));
    }
    const std::string held = chain_.path("held.json");
    chain_.run({"machine", "frf", {held}, {{"spindle", files_.machine}}, {{"--csv", "receptance.csv"}}},
               share(0.4, 0.5, LT_TEXT("Engine", "Receptance")));
    chain_.run({"speeds", "lobes", {}, {{"shaft", held}, {"spindle", files_.machine}}, {}},
               share(0.5, 0.55, LT_TEXT("Engine", "Stable depths and speeds")));
}

void Remanufacture::program()
{
    const std::string extension = files_.post == "sinumerik" ? ".mpf" : files_.post == "linuxcnc" ? ".ngc" : ".nc";
    const std::string name = "program" + extension;
    const Json planned = chain_.run({"program",
                                     "turn",
                                     {shaft_},
                                     {{"job", files_.job}, {"post", files_.post}, {"spindle", files_.machine}},
                                     {{"--out", name}}},
                                    share(0.55, 0.65, LT_TEXT("Engine", "Planning the program")));
    if (chain_.hasFailed()) return;
    const std::size_t count = planned.contains("setups") ? planned["setups"].size() : 1;
    program_ = chain_.path(count > 1 ? "program_1" + extension : name);
    if (count > 1 && !files_.setup.empty())
        chain_.remark({notes::firstClampingOnly, {{"count", static_cast<std::int64_t>(count)}}});
}

void Remanufacture::deflect()
{
    if (files_.setup.empty()) {
        for (const char* id : {"deflection", "corrected_check"})
            chain_.miss(id, LT_TEXT("Engine", "a set-up of deflection (--setup)"));
        return;
    }
    StepRequest step{"deflection", "deflection", {program_}, {{"setup", files_.setup}}, {}};
    set(step.given, "band", true);
    if (files_.tolerance_um) set(step.given, "tolerance_um", *files_.tolerance_um);
    if (!chain_.hasFailed()) {
        deflection::SetupFile setup = deflection::loadSetup(
            {files_.setup, inputs_.open(files_.setup, progress_), request_.parameters, inputs_, progress_});
        stock_zero_mm_ = setup.setup.z_zero_mm;
        if (!setup.stock) {
            stock_zero_mm_ = setup.setup.z_zero_mm = job_.stock.face_allowance_mm;
            setup.setup.stock = "bar.json";
            Shaft bar = cam::stockOf(job_);
            // The beam ends at the chuck's face.
            double beyond_mm = bar.length_mm() - (job_.setup.chuck_face_z_mm + job_.stock.face_allowance_mm);
            if (beyond_mm > 0 && !bar.segments.empty()) bar.segments.back().length_mm -= beyond_mm;
            chain_.write("bar.json", io::shaftText(bar));
            chain_.write("setup.json", deflection::setupText(setup.setup));
            set(step.given, "setup", chain_.path("setup.json"));
        }
        for (const InputFile& file : inputs_.list()) chain_.alsoTakes(chain_.named(file));
    }
    correct(std::move(step));
}

/// A program that cannot be corrected is still predicted.
void Remanufacture::correct(StepRequest step)
{
    const Progress progress = share(0.65, 0.8, LT_TEXT("Engine", "Deflection"));
    std::optional<Error> refused;
    if (!chain_.hasFailed()) {
        const std::vector<Verb>& all = verbs();
        const auto verb =
            std::find_if(all.begin(), all.end(), [](const Verb& one) { return one.name == "deflection"; });
        io::InputFiles own;
        const Answer tried =
            ask(*verb, requestOf(*verb, step.operands, step.given, {{"--compensate", chain_.path(correctedFile)}}), own,
                progress.part(0, 0.5));
        if (!tried.errors.empty() && tried.errors.front().code().kind == ErrorKind::NoAnswer)
            refused = tried.errors.front();
    }
    if (!refused) step.outputs = {{"--compensate", correctedFile}};
    deflected_ = chain_.run(step, progress.part(0.5, 1));
    if (refused && chain_.isDone("deflection")) chain_.remark({notes::correctionRefused, {{"reason", text(*refused)}}});
    if (refused && !chain_.hasFailed()) return chain_.miss("corrected_check", LT_TEXT("Engine", "a corrected program"));
    chain_.run({"corrected_check",
                "check",
                {chain_.path(correctedFile)},
                {{"job", files_.job}, {"shaft", shaft_}, {"correction", chain_.path("deflection.json")}},
                {}},
               share(0.8, 0.85, LT_TEXT("Engine", "Checking the corrected program")));
}

void Remanufacture::compareCopy()
{
    if (files_.copy.empty()) return chain_.miss("copy", LT_TEXT("Engine", "the scan of the copy (--copy)"));
    compared_ = chain_.run({"copy",
                            "compare",
                            {shaft_, files_.copy},
                            optional("tolerance_mm", files_.tolerance_mm),
                            {{"--deviations", "deviations.ply"}}},
                           share(0.85, 0.98, LT_TEXT("Engine", "Comparing the copy")));
    if (!chain_.isDone("copy") || !compared_["verdict"].is_string()) return;
    for (const Verdict verdict : {Verdict::Pass, Verdict::Fail, Verdict::Undecided})
        if (compared_["verdict"] == std::string(key(verdict))) chain_.dossier().verdict = verdict;
}

std::vector<double> numbersAt(const Json& json, const char* list, const char* name)
{
    std::vector<double> values;
    if (!json.contains(list) || !json[list].is_object() || !json[list].contains(name)) return values;
    for (const Json& item : json[list][name]) values.push_back(item.is_number() ? item.get<double>() : std::nan(""));
    return values;
}

std::vector<chain::MeasuredError> measuredErrors(const Json& drawn, const Json& compared)
{
    std::vector<chain::MeasuredError> measured;
    if (!compared.contains("rows") || !drawn.contains("segments")) return measured;
    for (const Json& row : compared["rows"]) {
        if (row.value("quantity", "") != "diameter" || !row["bore"].is_null()) continue;
        if (!row["deviation_mm"].is_number() || !row["uncertainty_mm"].is_number()) continue;
        const auto number = row["row"].get<std::int64_t>();
        const Json& segment = drawn["segments"].at(static_cast<std::size_t>(number - 1));
        measured.push_back({number, segment["z_start_mm"], segment["z_end_mm"],
                            1000 * row["deviation_mm"].get<double>(), 1000 * row["uncertainty_mm"].get<double>()});
    }
    return measured;
}

void Remanufacture::prove()
{
    if (!chain_.hasFailed() && !chain_.isDone("deflection"))
        return chain_.miss("proof", LT_TEXT("Engine", "a set-up of deflection (--setup)"));
    if (!chain_.hasFailed() && !chain_.isDone("copy"))
        return chain_.miss("proof", LT_TEXT("Engine", "the scan of the copy (--copy)"));
    if (chain_.hasFailed()) return chain_.record("proof", {}, {}, {}, {});
    chain::PredictedErrors predicted{
        numbersAt(deflected_, "final", "z_mm"), numbersAt(deflected_, "final", "diameter_error_um"), {}, {}};
    const std::vector<double> band_z_mm = numbersAt(deflected_, "band", "z_mm");
    if (band_z_mm.size() == predicted.z_mm.size()) {
        predicted.low_um = numbersAt(deflected_, "band", "low_um");
        predicted.high_um = numbersAt(deflected_, "band", "high_um");
    }
    for (double& z_mm : predicted.z_mm) z_mm -= stock_zero_mm_;
    const std::vector<chain::ComparedError> places = compareErrors(predicted, measuredErrors(drawn_, compared_));
    const Json found = chain::toJson(places);
    Notes notes;
    if (found["largest_normalized_error"].is_number() && std::abs(found["largest_normalized_error"].get<double>()) > 1)
        notes.push_back(
            {notes::predictionDisagrees, {{"normalized_error", found["largest_normalized_error"].get<double>()}}});
    chain_.record("proof", {"deflection.json", "copy.json", "draw.json"}, found, std::move(notes),
                  {{LT_TEXT("Engine", "Predicted and measured"), {chain::errorsPlot(predicted, places)}}});
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
    requireFiles(fromValues<ChainFiles>(request.parameters));
    inputs.open(request.operands.front(), progress);
    Remanufacture all(request, inputs, progress);
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
