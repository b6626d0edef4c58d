#include "engine/surface/task/surface_answer.h"

#include <cmath>

#include "engine/core/texts.h"
#include "engine/surface/quiz.h"
#include "engine/surface/surface_report.h"
#include "engine/surface/surface_words.h"
#include "engine/surface/task/next_speed.h"

namespace lathelier::surface {
namespace {

report::Finding asFinding(report::Paragraph paragraph)
{
    return {paragraph.pattern, std::move(paragraph.values), {}, {}};
}

/// Ambiguity of the picture that the model resolves.
std::optional<report::Finding> choiceByModel(const SurfaceOutcome& outcome, const Language& language)
{
    const ChatterMarks& chatter = *outcome.first().chatter_marks;
    if (!outcome.check || chatter.m_certain || outcome.question.surface.expect_hz) return std::nullopt;
    report::Finding finding;
    finding.pattern = LT_TEXT("Engine", "Let the model choose among the candidates: near {model} Hz");
    finding.values = {{"model", fixed(outcome.check->model_hz, 1, language)}};
    finding.offer = {{"expect_hz", std::round(10 * outcome.check->model_hz) / 10}};
    return finding;
}

report::Answer openQuestion(const SurfaceOutcome& outcome, const Language& language)
{
    const SyntheticParameters made = pictureOf(outcome.question);
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Question");
    answer.subject = std::to_string(outcome.question.quiz_number);
    answer.verdict_words = LT_TEXT("Engine", "not answered yet");
    answer.sentence = LT_TEXT("Engine",
                              "D {diameter} mm, f {feed} mm, N {speed} rpm, feed to the right, cut downward: which "
                              "frequency made these marks? Measure with the ruler, then f_c = n (m + ν).");
    answer.values = {{"diameter", fixed(made.diameter_mm, 0, language)},
                     {"feed", fixed(made.feed_mm_rev, 2, language)},
                     {"speed", fixed(made.speed_rpm, 0, language)}};
    return answer;
}

std::optional<report::Finding> checkedQuestion(const SurfaceOutcome& outcome, const Language& language)
{
    const SurfaceQuestion& question = outcome.question;
    if (!question.make_picture || !question.quiz || !question.quiz_answer_hz) return std::nullopt;
    const QuizAnswer checked = checkedAnswer(*question.quiz_answer_hz, pictureOf(question));
    report::Finding finding;
    finding.values = {{"answer", fixed(*question.quiz_answer_hz, 1, language)},
                      {"k", std::int64_t{std::abs(checked.waves)}}};
    switch (checked.verdict) {
        case QuizVerdict::Right:
            finding.pattern = LT_TEXT("Engine", "{answer} Hz is right");
            finding.verdict = Verdict::Pass;
            break;
        case QuizVerdict::OtherSign:
            finding.pattern = LT_TEXT("Engine", "{answer} Hz has ν with the other sign: look which way the bands lean");
            break;
        case QuizVerdict::OtherWaves:
            finding.pattern = LT_TEXT("Engine", "{answer} Hz has ν right and m wrong by {k}: count the waves again");
            break;
        case QuizVerdict::Multiple:
            finding.pattern = LT_TEXT("Engine", "{answer} Hz is a multiple or a part of the frequency");
            break;
        case QuizVerdict::Wrong: finding.pattern = LT_TEXT("Engine", "{answer} Hz is no reading of these marks"); break;
    }
    if (checked.verdict != QuizVerdict::Right) finding.verdict = Verdict::Fail;
    return finding;
}

report::Paragraph lightSentence(const SurfaceOutcome& outcome, Text not_stated)
{
    const std::string& light = outcome.question.lighting;
    if (light.empty()) return {not_stated, {}};
    return {LT_TEXT("Engine", "Light, as stated: {light}"), {{"light", light}}};
}

std::optional<report::Finding> truthOfMade(const SurfaceOutcome& outcome, const Language& language)
{
    if (!outcome.question.make_picture) return std::nullopt;
    const SyntheticParameters made = pictureOf(outcome.question);
    const Waves waves = wavesPerRevolution(made.frequency_hz, made.speed_rpm);
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
void addModel(const SurfaceOutcome& outcome, report::Section& section, const Language& language)
{
    const auto say = [&](report::Finding finding) {
        section.blocks.emplace_back(report::Paragraph{finding.pattern, std::move(finding.values)});
    };
    say(modelFinding(*outcome.marks, *outcome.check, language));
    if (auto next = nextSpeedFinding(outcome, language)) say(*std::move(next));
}

/// In place of the report of a question that is open.
report::Document reportOfQuestion(const SurfaceOutcome& outcome, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Marks of turned surfaces");
    document.sections.push_back({LT_TEXT("Engine", "Question"),
                                 {openQuestion(outcome, language),
                                  report::Picture{LT_TEXT("Engine", "Picture that is made"), outcome.made_png}}});
    return document;
}

}  // namespace

report::Answer answer(const SurfaceOutcome& outcome, const Language& language)
{
    if (outcome.asks()) return openQuestion(outcome, language);
    report::Answer all = answer(outcome.first(), language);
    all.subject = outcome.names.front();
    if (outcome.marks) all.quantity = LT_TEXT("Engine", "Chatter frequency");
    const auto say = [&](std::optional<report::Finding> finding) {
        if (finding && all.findings.size() < 3) all.findings.push_back(*std::move(finding));
    };
    say(checkedQuestion(outcome, language));
    say(truthOfMade(outcome, language));
    if (outcome.result->images.size() > 1) say(asFinding(beforeAndAfter(*outcome.result, language)[1]));
    if (outcome.marks) {
        say(choiceByModel(outcome, language));
        if (outcome.check) say(modelFinding(*outcome.marks, *outcome.check, language));
        say(nextSpeedFinding(outcome, language));
    }
    if (auto relation_check = speedRelationSentence(outcome.first(), outcome.result->parameters, language))
        say(asFinding(*std::move(relation_check)));
    return all;
}

std::vector<report::Section> words(const SurfaceOutcome& outcome, const Language& language)
{
    std::vector<report::Section> sections = surfaceWords(*outcome.result, language);
    if (outcome.marks && outcome.check && sections.size() > 1) addModel(outcome, sections[1], language);
    if (!outcome.question.make_picture)
        sections.back().blocks.emplace_back(lightSentence(
            outcome, LT_TEXT("Engine", "How the light fell is not stated; state it in the field Light.")));
    return sections;
}

report::Document reportOf(const SurfaceOutcome& outcome, const Language& language)
{
    if (outcome.asks()) return reportOfQuestion(outcome, language);
    SurfaceResult result = *outcome.result;
    for (std::size_t i = 0; i < result.images.size(); ++i) result.images[i].path = outcome.names[i];
    result.notes = outcome.notes;  // those of the files as well
    report::Document document = surfaceReport(result, language);
    report::Section& summary = document.sections.front();
    if (!summary.blocks.empty()) summary.blocks.front() = report::Block(answer(outcome, language));
    if (outcome.marks && outcome.check) addModel(outcome, document.sections.at(2), language);
    if (outcome.next) document.sections.at(2).blocks.emplace_back(nextSpeedTable(outcome));
    if (!outcome.question.make_picture)
        summary.blocks.emplace_back(lightSentence(outcome, LT_TEXT("Engine", "How the light fell is not stated.")));
    return document;
}

}  // namespace lathelier::surface
