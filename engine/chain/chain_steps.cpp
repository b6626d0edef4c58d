#include "engine/chain/chain_steps.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/cam/job_bodies.h"
#include "engine/cam/job_file.h"
#include "engine/cam/post/post.h"
#include "engine/cam/setup_plan.h"
#include "engine/chain/chain_codes.h"
#include "engine/chain/proof.h"
#include "engine/chain/step_state.h"
#include "engine/core/texts.h"
#include "engine/deflection/setup_file.h"
#include "engine/gcode/controls/controls.h"
#include "engine/io/file.h"
#include "engine/io/shaft/shaft_file.h"

namespace lathelier::chain {
namespace {

constexpr const char* measuredFile = "measured.json";
constexpr const char* drawingFile = "drawing.json";
constexpr const char* heldFile = "held.json";

const Text noScan = LT_TEXT("Engine", "the scan of the worn part, or a drawing");
const Text noDrawing = LT_TEXT("Engine", "a drawing");
const Text noMachine = LT_TEXT("Engine", "the machine (--machine)");
const Text noJob = LT_TEXT("Engine", "the job (--job)");
const Text noProgram = LT_TEXT("Engine", "a program");
const Text noSetup = LT_TEXT("Engine", "a set-up of deflection (--setup)");
const Text noCopy = LT_TEXT("Engine", "the scan of the copy (--copy)");
const Text noPhotographs = LT_TEXT("Engine", "photographs before and after (--photograph-before, --photograph-after)");

void setIfGiven(Values& values, const char* key, const std::optional<double>& value)
{
    if (value) set(values, key, *value);
}

}  // namespace

struct ChainSteps::Results {
    Results() {}  // not the implicit one: it would be noexcept like that of Json, which allocates
    PlannedProgram planned;
    Json drawn, speeds, deflected, second, compared;
};

ChainSteps::ChainSteps(const ChainQuestion& question, StepRunner& runner, io::InputFiles& inputs,
                       const Progress& progress)
    : question_(question),
      runner_(runner),
      inputs_(inputs),
      progress_(progress),
      machine_(question, runner, inputs, progress),
      results_(std::make_unique<Results>())
{
}

ChainSteps::~ChainSteps() = default;

/// Request with the common values for data that files leave unstated.
StepRequest ChainSteps::asked(const char* id, std::vector<std::string> operands, Values given) const
{
    StepRequest step{id, taskOf(id), std::move(operands), std::move(given), {}};
    for (const auto& [key, value] : question_.reading)
        if (!find(step.given, key)) set(step.given, key, value);
    return step;
}

void ChainSteps::recognise()
{
    const bool is_drawn = !question_.drawing.empty();
    if (is_drawn) runner_.dossier().confirmed.push_back({"drawing", question_.drawing, question_.confirmed_by});
    if (question_.scan.empty())
        return runner_.recordMissing("recognise", LT_TEXT("Engine", "the scan of the worn part"));
    StepRequest step = asked("recognise", {question_.scan}, question_.recognition);
    // The contour as well: an incomplete drawing is refused here rather than in a later step.
    step.outputs = {{"shaft", measuredFile}, {"stock", "measured.txt"}};
    runner_.run(step, share(0, 0.3, LT_TEXT("Engine", "Recognising")));
    if (is_drawn) return;
    if (!question_.confirmed_by.empty())
        runner_.dossier().confirmed.push_back({"drawing", measuredFile, question_.confirmed_by});
    const Value* const snap = find(question_.recognition, "snap");
    if (!(snap && *snap == Value(std::string("apply"))))
        runner_.addNote({notes::measuredSizesCut, {{"file", std::string("recognise.json")}}});
}

void ChainSteps::draw()
{
    shaft_ = question_.drawing;
    if (shaft_.empty() && question_.scan.empty()) return runner_.recordMissing("draw", noScan);
    if (shaft_.empty()) shaft_ = runner_.path(measuredFile);
    // Undated, so that the digests of the dossier are those of the inputs: made again, it is the same.
    StepRequest step = asked("draw", {shaft_}, {{"undated", true}});
    step.outputs = {{"shaft", drawingFile}, {"drawing", "drawing.svg"},  {"dxf", "drawing.dxf"},
                    {"step", "part.step"},  {"freecad", "part.FCMacro"}, {"csv", "rows.csv"}};
    results_->drawn = runner_.run(step, share(0.3, 0.4, LT_TEXT("Engine", "Drawing")));
    shaft_ = runner_.path(drawingFile);
}

/// Adds the files read so far as inputs of the next step.
void ChainSteps::addPreparationInputs()
{
    for (const InputFile& file : inputs_.list())
        if (file.path != question_.scan) runner_.addInput(file);
}

Shaft ChainSteps::readPart()
{
    Notes ignored_notes;  // already reported by the step that made the file
    const io::FileBytes bytes(shaft_);
    return io::readShaft(std::string(bytes.view()), ignored_notes);
}

void ChainSteps::planSpeeds()
{
    const bool has_drawing = runner_.hasFailed() || runner_.dossier().step("draw")->state != StepState::Missing;
    try {
        if (!runner_.hasFailed()) machine_.read();  // errors in job and shop are reported first
    } catch (const Error& error) {
        runner_.recordFailure("machine", error);
    }
    const Text missing = !has_drawing                     ? noDrawing
                         : machine_.spindleFile().empty() ? noMachine
                         : machine_.jobFile().empty()     ? noJob
                                                          : Text{};
    if (!missing.empty() && !runner_.dossier().step("machine")) {
        for (const char* id : {"machine", "speeds"}) runner_.recordMissing(id, missing);
        return;
    }
    if (!runner_.hasFailed() && runner_.canRead(drawingFile)) {
        try {
            const Shaft part = readPart();
            partLength_mm_ = part.length_mm();
            addPreparationInputs();
            runner_.addInput(std::string(drawingFile));
            machine_.makeFor(part);
            runner_.write(heldFile, io::shaftText(cam::heldPart(part, machine_.job().value())));
        } catch (const Error& error) {  // the part does not fit the bar of the job, or the shop
            runner_.recordFailure("machine", error);
        }
    }
    const std::string held = runner_.path(heldFile);
    if (!runner_.hasFailed() || !runner_.dossier().step("machine")) {
        StepRequest machine = asked("machine", {held}, {{"spindle", machine_.spindleFile()}});
        machine.outputs = {{"csv", "receptance.csv"}};
        runner_.run(machine, share(0.4, 0.5, LT_TEXT("Engine", "Receptance")));
        machine_.noteMachine();
    }
    StepRequest speeds = asked("speeds", {}, {{"shaft", held}, {"spindle", machine_.spindleFile()}});
    if (machine_.job()) set(speeds.given, "speed_rpm", std::vector<Interval>{cam::usedSpeeds(*machine_.job())});
    results_->speeds = runner_.run(speeds, share(0.5, 0.55, LT_TEXT("Engine", "Stable depths and speeds")));
}

/// File extension of programs of the control.
std::string ChainSteps::extension() const
{
    gcode::ControlPtr control;
    try {
        if (machine_.post().ends_with(".json")) {
            Notes ignored_notes;  // reported by the step itself
            const io::FileBytes bytes(machine_.post());
            control = cam::readPost(std::string(bytes.view()), ignored_notes).control;
        } else {
            control = cam::postNamed(machine_.post()).control;
        }
    } catch (const Error&) {
        // the step reports the error
    }
    return gcode::extensionOf(control);
}

void ChainSteps::program()
{
    const ChainStep* const drawn = runner_.dossier().step("draw");
    if (drawn->state == StepState::Missing) return runner_.recordMissing("program", noDrawing);
    if (machine_.jobFile().empty()) return runner_.recordMissing("program", noJob);
    StepRequest step = asked("program", {shaft_}, {{"job", machine_.jobFile()}, {"post", machine_.post()}});
    if (!machine_.spindleFile().empty()) set(step.given, "spindle", machine_.spindleFile());
    step.outputs = {{"out", "program" + extension()}};
    results_->planned = plannedProgram(runner_.run(step, share(0.55, 0.65, LT_TEXT("Engine", "Planning the program"))));
    twoClampings_ = results_->planned.clampings > 1;
    if (!twoClampings_ || !runner_.canRead(drawingFile)) return;
    const Shaft part = readPart();
    if (machine_.job()) second_ = secondBar(part, *machine_.job());
    split_mm_ = cam::splitOf(part).value_or(partLength_mm_);
}

void ChainSteps::deflect()
{
    const bool has_setup = machine_.hasSetup();
    if (runner_.dossier().step("program")->state == StepState::Missing || !has_setup) {
        const Text missing = has_setup ? noProgram : noSetup;
        for (const char* id : {"deflection", "corrected_check"}) runner_.recordMissing(id, missing);
        return;
    }
    const HeldBar first = machine_.job() ? firstBar(*machine_.job()) : HeldBar{};  // none: failed, or not made yet
    deflectOne("deflection", first, twoClampings_ ? "_1" : "", 0.65, twoClampings_ ? 0.72 : 0.8);
    if (twoClampings_) {
        if (second_)
            deflectOne("deflection_2", *second_, "_2", 0.72, 0.8);
        else
            runner_.recordMissing("deflection_2", LT_TEXT("Engine", "a cylinder that the second clamping can grip"));
    }
    checkCorrected();
}

/// The prediction is kept if the correction is refused.
void ChainSteps::deflectOne(const char* id, const HeldBar& held, const std::string& number, double from, double to)
{
    const std::string tail = number == "_2" ? "_2" : "";
    StepRequest step = asked(id, {runner_.path("program" + number + extension())}, {{"setup", question_.setup}});
    set(step.given, "band", true);
    setIfGiven(step.given, "tolerance_um", question_.tolerance_um);
    if (!runner_.hasFailed() && machine_.job()) {
        try {
            const deflection::HeldSetup setup = machine_.setup();
            if (tail.empty()) zero_mm_ = setup.setup.z_zero_mm;
            addPreparationInputs();
            if (!setup.stock || held.is_mirrored) {
                if (tail.empty()) zero_mm_ = held.z_zero_mm;
                const std::string bar = "bar" + tail + ".json", made = "setup" + tail + ".json";
                runner_.write(bar, io::shaftText(held.bar));
                runner_.write(made, deflection::setupText(setupFor(setup.setup, held, bar)));
                set(step.given, "setup", runner_.path(made));
            }
        } catch (const Error& error) {
            return runner_.recordFailure(id, error);
        }
    }
    step.outputs_if_possible = {{"compensate", "program_corrected" + number + extension()}};
    Json& result = tail.empty() ? results_->deflected : results_->second;
    result = runner_.run(step, share(from, to, LT_TEXT("Engine", "Deflection")));
    if (const std::optional<Error>& refusal = runner_.refusal(); refusal && !runner_.hasFailed())
        runner_.addNote({notes::correctionRefused, {{"reason", text(*refusal)}}});
    machine_.noteSetup();
}

void ChainSteps::checkCorrected()
{
    const std::string corrected = "program_corrected" + std::string(twoClampings_ ? "_1" : "") + extension();
    // In a dry run its existence is not yet known.
    if (!runner_.hasFailed() && runner_.isDone("deflection") && !hasCorrection(results_->deflected))
        return runner_.recordMissing("corrected_check", LT_TEXT("Engine", "a corrected program"));
    if (twoClampings_) {
        // Only the stretch turned in this clamping is checked.
        if (runner_.canRead(drawingFile)) {
            runner_.write("part_1.json", io::shaftText(cam::cutAt(readPart(), split_mm_)));
            runner_.addInput(std::string(drawingFile));
        }
    }
    const std::string part = twoClampings_ ? runner_.path("part_1.json") : shaft_;
    runner_.run(asked("corrected_check", {runner_.path(corrected)},
                      {{"job", machine_.jobFile()}, {"shaft", part}, {"correction", runner_.path("deflection.json")}}),
                share(0.8, 0.85, LT_TEXT("Engine", "Checking the corrected program")));
}

void ChainSteps::compareCopy()
{
    const ChainStep* const drawn = runner_.dossier().step("draw");
    if (drawn->state == StepState::Missing) return runner_.recordMissing("copy", noDrawing);
    if (question_.copy.empty()) return runner_.recordMissing("copy", noCopy);
    StepRequest step = asked("copy", {shaft_, question_.copy});
    setIfGiven(step.given, "tolerance_mm", question_.tolerance_mm);
    step.outputs = {{"deviations", "deviations.ply"}};
    Json& compared = results_->compared;
    compared = runner_.run(step, share(0.85, 0.95, LT_TEXT("Engine", "Comparing the copy")));
    if (runner_.isDone("copy")) runner_.dossier().verdict = runner_.dossier().step("copy")->verdict;
}

void ChainSteps::prove()
{
    const auto isMissing = [&](const char* id) {
        const ChainStep* const step = runner_.dossier().step(id);
        return step && step->state == StepState::Missing;
    };
    if (isMissing("deflection")) return runner_.recordMissing("proof", machine_.hasSetup() ? noProgram : noSetup);
    if (isMissing("copy")) return runner_.recordMissing("proof", noCopy);
    std::vector<std::string> inputs{"deflection.json", "copy.json", "draw.json"};
    const bool has_second = runner_.isDone("deflection_2");
    if (has_second) inputs.insert(inputs.begin() + 1, "deflection_2.json");
    runner_.make(
        "proof", inputs,
        [&] {
            PredictedErrors predicted = predictedErrors(results_->deflected, zero_mm_);
            if (has_second)
                predicted =
                    joined(predicted, predictedErrors(results_->second, second_->z_zero_mm, partLength_mm_), split_mm_);
            Proof proof{predicted, compareErrors(predicted, measuredErrors(results_->drawn, results_->compared)),
                        measuredPlaces(results_->drawn, results_->compared)};
            Json found = proofJson(proof.predicted, proof.places, proof.along);
            MadeStep made;
            const Json& largest = found["largest_normalized_error"];
            if (largest.is_number()) {
                const double error = std::abs(largest.get<double>());
                made.verdict = error > 1 ? Verdict::Fail : Verdict::Pass;
                if (error > 1)
                    made.notes.push_back({notes::predictionDisagrees, {{"normalized_error", largest.get<double>()}}});
            }
            made.sections = {{LT_TEXT("Engine", "Predicted and measured"), {}}};
            if (!proof.places.empty()) made.sections.front().blocks.emplace_back(proofAnswer(proof, {}));
            made.sections.front().blocks.emplace_back(proofPlot(proof));
            made.sections.front().blocks.emplace_back(proofTable(proof));
            made.result = std::make_shared<const Json>(std::move(found));
            return made;
        },
        share(0.95, 0.96, LT_TEXT("Engine", "Proof")));
}

/// Before: the speed of the job's cutting data; after: the speed of the program there.
std::optional<ChainSteps::LocalCut> ChainSteps::cutAt(const std::optional<double>& z_mm) const
{
    if (!z_mm || !machine_.job()) return std::nullopt;
    const cam::Job& job = *machine_.job();
    for (const PlannedSection& section : results_->planned.sections) {
        if (*z_mm < section.z_start_mm || *z_mm > section.z_end_mm) continue;
        const double stated_rpm =
            1000 * job.cutting.finish.cutting_speed_m_min / (std::numbers::pi * section.diameter_mm);
        return LocalCut{section.diameter_mm, std::min(stated_rpm, job.max_rpm.value_or(stated_rpm)), section.speed_rpm};
    }
    return std::nullopt;
}

void ChainSteps::comparePhotographs()
{
    if (question_.photograph_before.empty() || question_.photograph_after.empty())
        return runner_.recordMissing("surface", noPhotographs);
    StepRequest step = asked("surface", {question_.photograph_before, question_.photograph_after});
    setIfGiven(step.given, "mm_per_px", question_.photograph_mm_px);
    setIfGiven(step.given, "feed_direction_deg", question_.photograph_feed_deg);
    if (question_.photograph_cut != CutInPicture::Unknown)
        set(step.given, "cut_direction",
            std::string(cutsInPicture()[static_cast<std::size_t>(question_.photograph_cut)].key));
    if (machine_.job() && !runner_.hasFailed())
        set(step.given, "feed_mm_rev", machine_.job()->cutting.finish.feed_mm_rev);
    const auto cut = cutAt(question_.photograph_z_mm);
    const auto model_hz = cut ? chatterFrequencyAt(results_->speeds, cut->before_rpm) : std::nullopt;
    setIfGiven(step.given, "expect_hz", model_hz);
    if (cut) {
        set(step.given, "diameter_mm", cut->diameter_mm);
        Rows speeds;
        for (const double rpm : {cut->before_rpm, cut->after_rpm}) speeds.rows.push_back(Row{Values{{"rpm", rpm}}});
        set(step.given, "speed_rpm", std::move(speeds));
    }
    const auto marks = chatterMarks(runner_.run(step, share(0.96, 1, LT_TEXT("Engine", "Photographs"))));
    if (cut) runner_.addNote({notes::speedBeforeAssumed, {{"speed_rpm", cut->before_rpm}}});
    if (marks && model_hz) compareMarks(*marks, *model_hz);
}

/// Compares the chatter marks of the first photograph with the machine model.
void ChainSteps::compareMarks(const ChatterMarks& marks, double model_hz)
{
    constexpr double most_percent = 5;
    const double percent = 100 * (marks.frequency_hz / model_hz - 1);
    runner_.addNote({std::abs(percent) <= most_percent ? notes::marksAndModel : notes::marksDisagree,
                     {{"frequency_hz", marks.frequency_hz},
                      {"uncertainty_hz", 2 * marks.uncertainty_hz},
                      {"model_hz", model_hz},
                      {"difference_percent", percent}}});
}

}  // namespace lathelier::chain
