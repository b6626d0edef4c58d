#include "app/cli/remanufacture_steps.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/cli/jobs.h"
#include "engine/cam/job_bodies.h"
#include "engine/chain/chain_codes.h"
#include "engine/chain/normalized_error.h"
#include "engine/core/texts.h"
#include "engine/deflection/setup_file.h"
#include "engine/features/recognition.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/io/shaft/shaft_file.h"

namespace lathelier::cli {
namespace {

Values optional(const char* key, const std::optional<double>& value)
{
    return value ? Values{{key, *value}} : Values{};
}

constexpr const char* measuredFile = "measured.json";
constexpr const char* correctedFile = "program_corrected.nc";

}  // namespace

Remanufacture::Remanufacture(const Request& request, const ChainFiles& files, io::InputFiles& inputs,
                             const Progress& progress)
    : request_(request), files_(files), inputs_(inputs), progress_(progress), chain_(files_.out)
{
    refuseOverwriting();
    Answer read;  // its notes are said by the steps that take the job
    job_ = readJob(files_.job, request_, inputs_, progress_, read);
}

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
        chain_.write("held.json", io::shaftText(cam::heldPart(io::readShaft(std::string(bytes.view()), notes), job_)));
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
    step.outputs_if_possible = {{"--compensate", correctedFile}};
    deflected_ = chain_.run(step, share(0.65, 0.8, LT_TEXT("Engine", "Deflection")));
    if (const std::optional<Error>& refusal = chain_.refusal(); refusal && !chain_.hasFailed()) {
        chain_.remark({notes::correctionRefused, {{"reason", text(*refusal)}}});
        return chain_.miss("corrected_check", LT_TEXT("Engine", "a corrected program"));
    }
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

namespace {

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

}  // namespace

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

}  // namespace lathelier::cli
