#include "widgets/series/series_panel.h"

#include <utility>

#include "engine/project/parts.h"
#include "widgets/core/session.h"
#include "widgets/series/series_views.h"

namespace lathelier::series_panel {
namespace {

const std::vector<std::string> roles{series::archiveRole};

bool hasArchive(const project::PanelState& state)
{
    const Value* const database = find(state.parameters, series::databaseKey);
    return state.inputs.count(series::archiveRole) > 0 || (database && *database != Value(std::string()));
}

PanelInputs panelInputs()
{
    return inputsOf(series::seriesTask(), roles, {series::characteristicKey, "from", "to", "most"}, true,
                    LT_TEXT("Engine", "Drop an archive of evaluations here, or state its database."));
}

}  // namespace

PanelFacts seriesPanelFacts()
{
    PanelFacts facts = factsOf(series::seriesTask(), "series", "series", roles, {});
    facts.missing = [](const project::PanelState& state) {
        return hasArchive(state) ? std::vector<Text>{} : std::vector<Text>{LT_TEXT("Engine", "Archive")};
    };
    facts.has_work = hasArchive;
    facts.answer = answeredBy(series::answerSeries);
    facts.make = [](Session& session) -> PanelBase* { return new SeriesPanel(session); };
    return facts;
}

SeriesPanel::SeriesPanel(Session& owner, QWidget* parent)
    : TaskPanel(owner, seriesPanelFacts(), panelInputs(), parent), views_(new SeriesViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &SeriesViews::partChosen, this, &SeriesPanel::choosePart);
    connect(views_, &SeriesViews::partOpened, this, &SeriesPanel::open);
    connect(views_, &SeriesViews::characteristicChosen, this, &SeriesPanel::chooseCharacteristic);
    connect(views_, &SeriesViews::notWritten, this, &SeriesPanel::reportWriteFailure);
}

/// What was chosen in another archive is not in this one.
void SeriesPanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    TaskPanel::assignFiles(state, files);
    for (const char* const of_another : {series::taskKey, series::characteristicKey, series::partKey})
        lathelier::set(state.parameters, of_another, std::string());
}

void SeriesPanel::choosePart(const std::string& uuid)
{
    editState(
        tr("Choose a part"),
        [&](project::PanelState& state) { lathelier::set(state.parameters, series::partKey, uuid); }, "series/part");
}

void SeriesPanel::chooseCharacteristic(const std::string& task, const std::string& key)
{
    editState(
        tr("Choose a characteristic"),
        [&](project::PanelState& state) {
            lathelier::set(state.parameters, series::taskKey, task);
            lathelier::set(state.parameters, series::characteristicKey, key);
        },
        "series/characteristic");
}

/// As a part of its own, so that what is open stays; a part that is not the one in detail is shown first.
void SeriesPanel::open(const std::string& uuid)
{
    const auto outcome = result();
    if (!outcome || outcome->part.entry.uuid != uuid) return choosePart(uuid);
    if (!outcome->as_asked.isWhole()) return;
    const std::string panel = outcome->part.entry.task;
    session().edit(tr("Open an archived evaluation"), [&](project::Project& project) {
        project::addPart(project, outcome->part.entry.file);
        project.panels[panel] = outcome->as_asked.state;
    });
    emit panelRequested(panel);
}

void SeriesPanel::showPlace(const report::Place& place)
{
    const auto outcome = result();
    if (!outcome || !place.line || *place.line < 1 || std::cmp_greater(*place.line, outcome->points.size())) return;
    choosePart(outcome->points[static_cast<std::size_t>(*place.line - 1)].uuid);
}

void SeriesPanel::showResult(const std::shared_ptr<const series::SeriesOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

void SeriesPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::series_panel
