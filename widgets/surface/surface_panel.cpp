#include "widgets/surface/surface_panel.h"

#include <algorithm>
#include <cmath>

#include "engine/io/file.h"
#include "engine/io/image/image_input.h"
#include "engine/stability/task/point_response.h"
#include "engine/surface/surface_pictures.h"
#include "widgets/chatter_common/understood_models.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"
#include "widgets/surface/surface_views.h"

namespace lathelier::surface_panel {
namespace {

const std::vector<std::string> roles{surface::beforeRole, surface::afterRole, stability::frfRole};

/// Fields of the form, in display order.
// clang-format off
const std::vector<std::string> shownFields{
    "feed_mm_rev", "diameter_mm", surface::speedBeforeKey, surface::speedAfterKey, "mm_per_px", "scale_px_mm",
    "scale_from_feed", "scale_from_file", "feed_direction_deg", "cut_direction", "unroll", "lighting", "taken_alike",
    "after_mm_per_px", "after_feed_direction_deg", surface::layRightKey, surface::layDownKey, "expect_hz",
    surface::makeKey, "axis_px", "roi", "alpha", "speed_uncertainty_percent"};
// clang-format on

/// One picture before, which can be made, and one after.
std::vector<InputRole> shownRoles()
{
    std::vector<InputRole> all = rolesOf(surface::surfaceTask(), roles);
    all[0].several = false;
    all[0].required = false;
    all[1].takes_next = true;
    return all;
}

/// Regions are drawn in each picture and outlive it.
Values beginning()
{
    return {{surface::spareRegionsKey, true}};
}

PanelInputs panelInputs()
{
    const task::Task& task = surface::surfaceTask();
    PanelInputs inputs;
    inputs.roles = shownRoles();
    for (const std::string& key : shownFields)
        for (const FieldInfo& info : task.fields)
            if (info.key == key) inputs.fields.push_back(info);
    foldAllBut(inputs, {"feed_mm_rev", "diameter_mm", surface::speedBeforeKey, surface::speedAfterKey, "mm_per_px",
                        "taken_alike", surface::makeKey});
    inputs.defaults = task.defaults;
    for (const auto& [key, value] : beginning()) lathelier::set(inputs.defaults, key, value);
    inputs.invitation = LT_TEXT("Engine",
                                "Drop one or two photographs of a turned surface here, or let one be made (Make a "
                                "picture).");
    return inputs;
}

bool hasPicture(const project::PanelState& state)
{
    return state.inputs.count(surface::beforeRole) > 0 || surface::makesPicture(state.parameters);
}

}  // namespace

PanelFacts surfacePanelFacts()
{
    PanelFacts facts = factsOf(surface::surfaceTask(), "surface", "surface", roles, {}, beginning());
    facts.kinds = {&io::imageFiles()};  // a response opens the panels of chatter
    facts.item_inputs.clear();          // likewise
    facts.alone = facts.kinds;          // the chain takes photographs too
    facts.roles = shownRoles();
    facts.answer = answeredBy(answerAndPrepare);
    facts.make = [](Session& session) -> PanelBase* { return new SurfacePanel(session); };
    facts.missing = [](const project::PanelState& state) {
        std::vector<Text> labels;
        if (!hasPicture(state)) labels.push_back(LT_TEXT("Engine", "Picture (before)"));
        return labels;
    };
    facts.has_work = hasPicture;
    return facts;
}

SurfacePanel::SurfacePanel(Session& owner, QWidget* parent)
    : TaskPanel(owner, surfacePanelFacts(), panelInputs(), parent), views_(new SurfaceViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &SurfaceViews::sendRequested, this, [this] { offer(stability::marksItem); });
    connect(views_, &SurfaceViews::candidateRequested, this, &SurfacePanel::chooseCandidate);
    connect(views_, &SurfaceViews::regionRequested, this, &SurfacePanel::setRegion);
    connect(views_, &SurfaceViews::scaleRequested, this, &SurfacePanel::setScale);
    connect(views_, &SurfaceViews::directionRequested, this, &SurfacePanel::setDirection);
    connect(views_, &SurfaceViews::alikeRequested, this, &SurfacePanel::setAlike);
    connect(views_, &SurfaceViews::layRequested, this, &SurfacePanel::lay);
    connectQuiz();
    connect(views_, &SurfaceViews::madeRequested, this, &SurfacePanel::setMade);
    connect(views_, &SurfaceViews::notWritten, this, &SurfacePanel::reportWriteFailure);
}

/// One for each picture: the other picture's stays, or is the whole of it.
void SurfacePanel::setRegion(int image, const std::optional<QRectF>& region)
{
    const auto outcome = result();
    if (!outcome) return;
    const auto chosen = static_cast<std::size_t>(image);
    std::vector<surface::Region> all;
    const std::vector<surface::Region> before = outcome->question.surface.roi;
    bool any = false;
    for (std::size_t i = 0; i < outcome->shown.size(); ++i) {
        const QSize size = outcome->shown[i].photograph.size();
        const surface::Region whole{0, 0, double(size.width()), double(size.height())};
        surface::Region each = before.empty() ? whole : before[std::min(i, before.size() - 1)];
        if (i == chosen)
            each = region ? surface::Region{std::floor(region->x()), std::floor(region->y()),
                                            std::floor(region->width()), std::floor(region->height())}
                          : whole;
        any = any || toValues(each) != toValues(whole);
        all.push_back(each);
    }
    if (!any) all.clear();
    editState(region ? tr("Choose a region") : tr("Take the whole picture"), [&](project::PanelState& state) {
        surface::SurfaceQuestion question;
        question.surface.roi = all;
        lathelier::set(state.parameters, "roi", *lathelier::find(toValues(question), "roi"));
    });
}

/// Of both pictures; where they were not taken alike, of the one that is shown.
void SurfacePanel::setScale(int image, double pixels, double mm)
{
    editState(tr("Set the scale"), [&](project::PanelState& state) {
        if (image == 1 && !surface::areTakenAlike(state.parameters)) {
            lathelier::set(state.parameters, "after_mm_per_px", mm / pixels);
            return;
        }
        lathelier::set(state.parameters, "scale_px_mm",
                       QStringLiteral("%1:%2").arg(pixels, 0, 'f', 2).arg(mm, 0, 'g', 9).toStdString());
        lathelier::set(state.parameters, "mm_per_px", Value());
        lathelier::set(state.parameters, "scale_from_feed", false);
        lathelier::set(state.parameters, "scale_from_file", false);
    });
}

void SurfacePanel::setDirection(int image, double direction_deg)
{
    editState(tr("Set the direction of feed"), [&](project::PanelState& state) {
        const bool own = image == 1 && !surface::areTakenAlike(state.parameters);
        lathelier::set(state.parameters, own ? "after_feed_direction_deg" : "feed_direction_deg",
                       std::round(10 * direction_deg) / 10);
    });
}

void SurfacePanel::setAlike(bool alike)
{
    editState(alike ? tr("Take both pictures alike") : tr("Take the pictures apart"),
              [&](project::PanelState& state) { lathelier::set(state.parameters, "taken_alike", alike); });
}

void SurfacePanel::lay(const QPointF& further_px)
{
    const auto outcome = result();
    if (!outcome) return;
    const double right = outcome->laid.x + further_px.x(), down = outcome->laid.y + further_px.y();
    editState(tr("Lay the pictures over each other"), [&](project::PanelState& state) {
        lathelier::set(state.parameters, surface::layRightKey, std::round(10 * right) / 10);
        lathelier::set(state.parameters, surface::layDownKey, std::round(10 * down) / 10);
    });
}

void SurfacePanel::connectQuiz()
{
    QuizPane* const quiz = views_->generator()->quiz();
    connect(quiz, &QuizPane::quizRequested, this, [this](bool on) {
        editState(on ? tr("Ask a question") : tr("Leave the questions"), [&](project::PanelState& state) {
            lathelier::set(state.parameters, surface::quizKey, on);
            lathelier::set(state.parameters, surface::quizAnswerKey, Value());
        });
    });
    connect(quiz, &QuizPane::answerRequested, this, [this](double frequency_hz) {
        editState(tr("Answer the question"), [&](project::PanelState& state) {
            lathelier::set(state.parameters, surface::quizAnswerKey, frequency_hz);
        });
    });
    connect(quiz, &QuizPane::questionRequested, this, [this](int number) {
        editState(tr("Take the next question"), [&](project::PanelState& state) {
            lathelier::set(state.parameters, surface::quizNumberKey, std::int64_t{number});
            lathelier::set(state.parameters, surface::quizAnswerKey, Value());
        });
    });
}

void SurfacePanel::chooseCandidate(double frequency_hz)
{
    editState(tr("Choose a reading of the marks"), [&](project::PanelState& state) {
        lathelier::set(state.parameters, "expect_hz", std::round(10 * frequency_hz) / 10);
    });
}

void SurfacePanel::setMade(const std::string& key, const Value& value, int gesture)
{
    editState(
        tr("Change the picture that is made"),
        [&](project::PanelState& state) { lathelier::set(state.parameters, surface::madePrefix + key, value); },
        QStringLiteral("surface/made/%1/%2").arg(QString::fromStdString(key)).arg(gesture));
}

/// Pictures in their order: before, after; one more picture is the next one after.
void SurfacePanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    std::vector<project::Source> pictures;
    for (const FoundFile& file : files) {
        const project::Source source = newSource(QString::fromStdString(file.path));
        if (file.kind == &io::frfFiles())
            state.inputs[stability::frfRole] = source;
        else
            pictures.push_back(source);
    }
    if (pictures.empty()) return;
    lathelier::set(state.parameters, surface::makeKey, false);
    if (pictures.size() == 1) {
        state.inputs[state.inputs.count(surface::beforeRole) > 0 ? surface::afterRole : surface::beforeRole] =
            pictures.front();
        return;
    }
    state.inputs[surface::beforeRole] = pictures[0];
    state.inputs[surface::afterRole] = pictures[1];
}

QString SurfacePanel::understood(const InputRole& role, const project::Source& source) const
{
    Stores& stores = session().stores();
    if (role.role == stability::frfRole) return chatter_common::understoodModel(source, stores);
    const auto loaded = stores.of<task::CacheOf<io::ImageInput>>()->known(source);
    if (!loaded) return {};
    const io::Image& image = loaded->file;
    return understoodText(io::imageFacts(source.path, image),
                          tr("%1 × %2 px, %3 bit").arg(image.width).arg(image.height).arg(image.bits));
}

void SurfacePanel::showResult(const std::shared_ptr<const ShownOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

std::vector<PanelExport> SurfacePanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    std::vector<PanelExport> all;
    const auto write = [](const QString& path, const std::string& text) { io::writeFile(path.toStdString(), text); };
    const QString svg = tr("Picture (*.svg)");
    if (!outcome->made_png.empty())
        all.push_back({tr("Picture that was made (PNG)…"), tr("Picture (*.png)"), "png",
                       [outcome, write](const QString& path) { write(path, outcome->made_png); }});
    if (!outcome->result || outcome->asks()) return all;
    for (std::size_t i = 0; i < outcome->result->images.size(); ++i)
        all.push_back({i == 0 ? tr("Picture with its marks (SVG)…") : tr("Picture after with its marks (SVG)…"), svg,
                       "svg", [outcome, write, i](const QString& path) {
                           write(path, markedPictureSvg(outcome->result->images[i], outcome->result->parameters,
                                                        screenLanguage()));
                       }});
    if (outcome->result->images.size() > 1)
        all.push_back({tr("Before and after (SVG)…"), svg, "svg", [outcome, write](const QString& path) {
                           write(path, comparisonSvg(*outcome->result, {outcome->shown[0].name, outcome->shown[1].name},
                                                     screenLanguage()));
                       }});
    return all;
}

Values SurfacePanel::view() const
{
    return views_->view();
}

void SurfacePanel::restoreView(const Values& kept)
{
    views_->restoreView(kept);
}

void SurfacePanel::setPresenting(bool presenting)
{
    Panel::setPresenting(presenting);
    views_->setPresenting(presenting);
}

void SurfacePanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::surface_panel
