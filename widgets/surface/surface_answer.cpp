#include "widgets/surface/surface_answer.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/texts.h"
#include "engine/report/result_json.h"
#include "engine/surface/surface_quantities.h"
#include "engine/surface/surface_report.h"
#include "engine/surface/surface_words.h"

namespace lathelier::surface_panel {
namespace {

report::Finding asFinding(report::Paragraph paragraph)
{
    return {paragraph.pattern, std::move(paragraph.values), {}, {}};
}

/// What the picture leaves open and the model can choose.
std::optional<report::Finding> choiceByModel(const SurfacePicture& picture, const Language& language)
{
    const surface::ChatterMarks& chatter = *picture.first().chatter_marks;
    if (!picture.check || chatter.m_certain || picture.question.surface.expect_hz) return std::nullopt;
    report::Finding finding;
    finding.pattern = LT_TEXT("Engine", "Let the model choose among the candidates: near {model} Hz");
    finding.values = {{"model", fixed(picture.check->model_hz, 1, language)}};
    finding.offer = {{"expect_hz", std::round(10 * picture.check->model_hz) / 10}};
    return finding;
}

std::optional<report::Finding> truthOfMade(const SurfacePicture& picture, const Language& language)
{
    if (!picture.question.make_picture) return std::nullopt;
    const surface::SyntheticParameters made = pictureOf(picture.question);
    const surface::Waves waves = surface::wavesPerRevolution(made.frequency_hz, made.speed_rpm);
    report::Finding finding;
    finding.pattern = made.amplitude_um > 0
                          ? LT_TEXT("Engine", "The picture was made with {frequency} Hz: m = {m}, ν = {nu}")
                          : LT_TEXT("Engine", "The picture was made without vibration");
    finding.values = {{"frequency", fixed(made.frequency_hz, 1, language)},
                      {"m", std::int64_t{waves.m}},
                      {"nu", fixed(waves.nu, 3, language)}};
    return finding;
}

/// The model's frequency beside that of the marks, as a sentence.
void addModel(const SurfacePicture& picture, report::Section& section, const Language& language)
{
    report::Finding finding = modelFinding(*picture.marks, *picture.check, language);
    section.blocks.emplace_back(report::Paragraph{finding.pattern, std::move(finding.values)});
}

}  // namespace

report::Answer answerOf(const SurfacePicture& picture, const Language& language)
{
    report::Answer answer = surface::answer(picture.first(), language);
    answer.subject = picture.shown.front().name;
    if (picture.marks) answer.quantity = LT_TEXT("Engine", "Chatter frequency");
    const auto say = [&](std::optional<report::Finding> finding) {
        if (finding && answer.findings.size() < 3) answer.findings.push_back(*std::move(finding));
    };
    say(truthOfMade(picture, language));
    if (picture.result->images.size() > 1) say(asFinding(beforeAndAfter(*picture.result, language)[1]));
    if (picture.marks) {
        say(choiceByModel(picture, language));
        if (picture.check) say(modelFinding(*picture.marks, *picture.check, language));
    }
    if (auto referee = refereeSentence(picture.first(), picture.result->parameters, language))
        say(asFinding(*std::move(referee)));
    return answer;
}

std::vector<report::Section> words(const SurfacePicture& picture, const Language& language)
{
    std::vector<report::Section> sections = surfaceWords(*picture.result, language);
    if (picture.marks && picture.check && sections.size() > 1) addModel(picture, sections[1], language);
    return sections;
}

report::Document reportOf(const SurfacePicture& picture, const Language& language)
{
    if (!picture.result) throw *picture.refused;
    surface::SurfaceResult result = *picture.result;
    for (std::size_t i = 0; i < result.images.size(); ++i) result.images[i].path = picture.shown[i].name;
    result.notes = picture.notes;  // those of the files as well
    report::Document document = surfaceReport(result, language);
    document.inputs = picture.inputs;
    document.synthetic = picture.synthetic;
    report::Section& summary = document.sections.front();
    if (!summary.blocks.empty()) summary.blocks.front() = report::Block(answerOf(picture, language));
    if (picture.marks && picture.check) addModel(picture, document.sections.at(2), language);
    document.results = {report::toText(report::wholeResult("surface", picture.inputs, toValues(result.parameters),
                                                           toJson(*picture.result), picture.notes))};
    return document;
}

}  // namespace lathelier::surface_panel
