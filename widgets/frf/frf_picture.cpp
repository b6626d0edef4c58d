#include "widgets/frf/frf_picture.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/core/core_codes.h"
#include "engine/core/json.h"
#include "engine/io/frf/frf_choice.h"
#include "engine/io/frf/frf_lines.h"
#include "engine/io/io_codes.h"
#include "engine/receptance/frf_checks.h"
#include "engine/receptance/modal/modal_quantities.h"
#include "engine/receptance/modal/modal_report.h"
#include "engine/report/parameters_table.h"
#include "engine/report/result_json.h"
#include "widgets/core/task/memo.h"

namespace lathelier::frf_panel {
namespace {

constexpr double mostLines = 4000;  ///< of the computed response

/// Fits by what they are of: a drag of a peak computes none anew.
struct FitMemo : Memo<receptance::ModalFit> {};
/// Computed responses likewise.
struct ComputedMemo : Memo<receptance::ShaftReceptanceResult> {};

void append(Notes& all, const Notes& more)
{
    for (const Note& note : more) all.push_back(note);
}

/// Gives what tells the response apart; empty without one.
std::string takeMeasured(FrfPicture& picture, const project::PanelState& state, Stores& stores,
                         const Progress& progress)
{
    const project::Source* const found = chatter_common::sourceOf(state, frfRole);
    if (!found) return {};
    const project::Source& source = *found;
    if (const auto item = chatter_common::takeResponseItem(state)) {
        picture.study.measured = std::make_shared<const Frf>(chatter_common::noted(picture, *item));
        picture.name = source.item;
        return item->input.sha256;
    }
    const auto loaded = stores.of<FrfStore>()->load(source, progress);
    const io::MeasuredFrf& chosen = io::chosenResponse(loaded->file.frfs, picture.question.response);
    picture.inputs.push_back(loaded->inputs.front());
    append(picture.notes, loaded->file.notes);
    append(picture.notes, receptance::checkResponse(chosen, source.path));
    picture.study.measured = std::make_shared<const Frf>(io::toReceptance(chosen.frf));
    picture.places = chosen;
    picture.places.frf = {};
    picture.name = std::filesystem::path(source.path).filename().string();
    if (const std::string pair = io::nodePair(chosen); loaded->file.frfs.size() > 1)
        picture.name += " " + (pair.empty() ? picture.question.response : pair);
    picture.synthetic |= source.synthetic || contains(loaded->file.notes, notes::syntheticData);
    const auto number = &chosen - loaded->file.frfs.data();
    return loaded->digest() + toJson(source.import).dump() + "#" + std::to_string(number);
}

/// Error valueNotUnderstood for a mode that nothing holds.
void requireStiffness(const std::vector<receptance::ModalMode>& modes)
{
    for (const receptance::ModalMode& mode : modes)
        if (mode.stiffness_N_mm == 0)
            throw Error(
                errors::valueNotUnderstood,
                {{"parameter", "modes"}, {"found", 0.0}, {"expected", LT_TEXT("Engine", "a stiffness, not 0")}});
}

/// Does the parameter say how the response of the shaft is computed?
bool isOfComputing(const std::string& key)
{
    const auto all = infos<receptance::ReceptanceParameters>();
    return std::any_of(all.begin(), all.end(), [&](const FieldInfo& info) { return info.key == key; });
}

/// The lines of the measured response, evenly spaced; else those of the range asked for.
void chooseLines(receptance::ReceptanceParameters& computing, const FrfPicture& picture)
{
    if (picture.study.measured && picture.study.measured->frequency_hz.size() > 1) {
        const std::vector<double>& lines = picture.study.measured->frequency_hz;
        const double steps = std::min(mostLines, static_cast<double>(lines.size()) - 1);
        computing.step_hz = (lines.back() - lines.front()) / steps;
        computing.from_hz = lines.front() > 0 ? lines.front() : computing.step_hz;
        computing.to_hz = lines.back();
    } else if (!picture.question.modal.range_hz.empty()) {
        const Interval& range = picture.question.modal.range_hz.front();
        computing.step_hz = std::max(1e-3, (range.to - range.from) / mostLines * 2);
        computing.from_hz = std::max(range.from, computing.step_hz);
        computing.to_hz = range.to;
    }
}

std::string takeComputed(FrfPicture& picture, const project::PanelState& state, Stores& stores,
                         const Progress& progress)
{
    const auto shaft = chatter_common::takeShaft(state, stores, progress.part(0, 0.1));
    if (!shaft) return {};
    const Shaft held = chatter_common::noted(picture, *shaft);
    const auto spindle = chatter_common::takeSpindle(state, stores, progress.part(0.1, 0.2));
    std::optional<receptance::SpindleReceptance> machine;
    if (spindle) machine = chatter_common::noted(picture, *spindle);
    receptance::ReceptanceParameters computing = picture.question.computing;
    chooseLines(computing, picture);
    std::string key = shaft->input.sha256 + (spindle ? spindle->input.sha256 : "") + toJson(toValues(computing)).dump();
    const auto found = stores.of<ComputedMemo>()->find(key, progress.part(0.2, 1), [&](const Progress& part) {
        return receptance::shaftReceptance(held, computing, machine, part);
    });
    append(picture.notes, found->notes);
    Frf frf = found->frf;
    io::dropUnusableLines(frf);  // a free shaft has no receptance at 0 Hz
    picture.study.computed = std::make_shared<const Frf>(std::move(frf));
    if (picture.name.empty()) picture.name = held.name.empty() ? shaft->input.path : held.name;
    return key;
}

}  // namespace

FrfPtr FrfPicture::handedOn() const
{
    if (question.handed_on == HandedOn::Measured) return study.measured ? study.measured : study.computed;
    if (study.synthesised.value.empty()) return nullptr;
    return std::make_shared<const Frf>(study.synthesised);
}

FrfPicture frfPicture(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    FrfPicture picture;
    picture.question = fromValues<FrfQuestion>(state.parameters);
    const FrfQuestion& question = picture.question;
    requireStiffness(question.modes);
    std::string basis = takeMeasured(picture, state, stores, progress.part(0, 0.3, LT_TEXT("Engine", "Reading")));
    const std::string computed =
        takeComputed(picture, state, stores, progress.part(0.3, 0.5, LT_TEXT("Engine", "Computing")));
    if (basis.empty()) basis = computed;
    std::shared_ptr<const receptance::ModalFit> fit;
    if (question.fit && picture.study.basis()) {
        const Frf& response = *picture.study.basis();
        fit = stores.of<FitMemo>()->find(
            basis + toJson(toValues(question.modal)).dump(), progress.part(0.5, 1, LT_TEXT("Engine", "Fitting modes")),
            [&](const Progress& fitting) { return receptance::fitModes(response, question.modal, fitting); });
        append(picture.notes, fit->notes);
    }
    picture.study = receptance::studyResponse(picture.study.measured, picture.study.computed, fit, question.modes);
    return picture;
}

report::Document reportOf(const FrfPicture& picture, const Language& language)
{
    report::Document document = receptance::responseReport(picture.study, picture.notes, language);
    if (picture.study.computed) {
        std::vector<FieldInfo> infos;
        for (const FieldInfo& info : lathelier::infos<FrfQuestion>())
            if (isOfComputing(info.key)) infos.push_back(info);
        report::QuantityTable table = report::parametersTable(infos, toValues(picture.question), language);
        table.title = LT_TEXT("Engine", "Computed response");
        document.sections.back().blocks.emplace_back(std::move(table));
    }
    document.inputs = picture.inputs;
    document.synthetic = picture.synthetic;
    document.results = {report::toText(report::wholeResult("frf_modes", picture.inputs, toValues(picture.question),
                                                           toJson(picture.study), picture.notes))};
    return document;
}

}  // namespace lathelier::frf_panel
