#include "widgets/lobes/lobes_panel.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/frf_item.h"
#include "engine/io/file.h"
#include "engine/report/chart_csv.h"
#include "engine/report/result_json.h"
#include "engine/stability/stability_quantities.h"
#include "engine/stability/stability_report.h"
#include "widgets/chatter_common/model_inputs.h"
#include "widgets/core/language.h"
#include "widgets/core/session.h"
#include "widgets/lobes/lobes_views.h"

namespace lathelier::lobes_panel {
namespace {

PanelInputs panelInputs()
{
    PanelInputs inputs;
    inputs.roles = {chatter_common::responseRole(
        LT_TEXT("Engine", "Of the point that is cut, in the direction of the chip thickness: UFF, CSV or MAT."))};
    inputs.roles.front().takes_next = true;
    InputRole marks;
    marks.role = marksRole;
    marks.label = LT_TEXT("Engine", "Chatter marks");
    marks.hint = LT_TEXT("Engine", "Read off a photograph by the panel Surface. They may be missing.");
    marks.item_kind = stability::marksItem;
    marks.required = false;
    inputs.roles.push_back(marks);
    inputs.fields = infos<LobesQuestion>();
    inputs.defaults = toValues(LobesQuestion{});
    inputs.invitation =
        LT_TEXT("Engine", "Drop a frequency response here, or state the modes of the point that is cut.");
    return inputs;
}

bool hasModes(const project::PanelState& state)
{
    const Value* const modes = find(state.parameters, "modes");
    const Rows* const rows = modes ? std::get_if<Rows>(modes) : nullptr;
    return rows && !rows->rows.empty();
}

report::Document reportOf(const LobesOutcome& outcome, const Language& language)
{
    stability::LobeResult lobes = *outcome.lobes;
    lobes.notes = outcome.notes;  // including those of the file
    report::Document document =
        lobesReport(lobes, *outcome.frf, outcome.speed ? &*outcome.speed : nullptr, {}, language);
    if (!document.sections.empty())
        document.sections.front().blocks.insert(document.sections.front().blocks.begin(),
                                                report::Block(answer(outcome, language)));
    document.inputs = outcome.inputs;
    document.synthetic = outcome.synthetic;
    document.results = {report::toText(
        report::wholeResult("lobes", outcome.inputs, toValues(outcome.question), toJson(*outcome.lobes), lobes.notes))};
    return document;
}

}  // namespace

PanelFacts lobesPanelFacts()
{
    PanelFacts facts;
    facts.id = "lobes";
    facts.title = LT_TEXT("Engine", "Lobes");
    facts.icon = "chatter";
    facts.workspaces = {workspaceOf("chatter")};
    facts.kinds = {&io::frfFiles()};
    facts.roles = panelInputs().roles;
    facts.part_inputs = {frfRole, marksRole};
    facts.item_inputs = {{frfItem, frfRole}, {stability::marksItem, marksRole}};
    facts.make = [](Session& session) -> PanelBase* { return new LobesPanel(session); };
    facts.missing = [](const project::PanelState& state) {
        std::vector<Text> labels;
        if (!state.inputs.count(frfRole) && !hasModes(state))
            labels.push_back(LT_TEXT("Engine", "Frequency response or modes"));
        return labels;
    };
    facts.has_work = [](const project::PanelState& state) {
        return state.inputs.count(frfRole) > 0 || hasModes(state);
    };
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) { return reportOf(lobesOutcome(state, stores, progress), language); };
    return facts;
}

LobesPanel::LobesPanel(Session& owner, QWidget* parent)
    : Panel(owner, lobesPanelFacts(), panelInputs(), parent), views_(new LobesViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &LobesViews::operatingPointMoved, this, &LobesPanel::moveOperatingPoint);
    connect(views_, &LobesViews::speedRequested, this,
            [this](double speed_rpm) { moveOperatingPoint(speed_rpm, {}, true); });
    connect(views_, &LobesViews::notWritten, this, &LobesPanel::reportWriteFailure);
}

void LobesPanel::moveOperatingPoint(double speed_rpm, std::optional<double> depth, bool dropped)
{
    constexpr double least = 1e-4;  // least depth of cut and rounding step
    editState(
        tr("Move the operating point"),
        [&](project::PanelState& state) {
            lathelier::set(state.parameters, "operating_speed_rpm", std::round(speed_rpm));
            if (depth)
                lathelier::set(state.parameters, "operating_depth",
                               std::max(least, std::round(*depth / least) * least));
        },
        QString("lobes/operating_point/%1").arg(gesture_));
    gesture_ += dropped;
}

LobesPanel::Compute LobesPanel::compute(const project::PanelState& state) const
{
    fromValues<LobesQuestion>(state.parameters);  // validates ranges before the computation
    return [state, stores = session().sharedStores()](const Progress& progress) {
        return lobesOutcome(state, *stores, progress);
    };
}

Worker::Job LobesPanel::makeReadingJob(const project::PanelState& state) const
{
    return [state, store = session().stores().of<FrfStore>()](const Progress& progress) -> std::shared_ptr<const void> {
        for (const auto& [role, source] : state.inputs)
            if (source.item.empty()) store->load(source, progress);
        return nullptr;
    };
}

QString LobesPanel::understood(const InputRole&, const project::Source& source) const
{
    return chatter_common::understoodResponse(source, session().stores());
}

void LobesPanel::showResult(const std::shared_ptr<const LobesOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

report::Answer LobesPanel::answer(const LobesOutcome& outcome) const
{
    return lobes_panel::answer(outcome, screenLanguage());
}

Notes LobesPanel::notes(const LobesOutcome& outcome) const
{
    return outcome.notes;
}

report::Document LobesPanel::document(const LobesOutcome& outcome) const
{
    return reportOf(outcome, screenLanguage());
}

std::vector<PanelExport> LobesPanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    return {{tr("Limit and lobes (CSV)…"), tr("Table (*.csv)"), "csv", [outcome](const QString& path) {
                 io::writeFile(path.toStdString(), report::toCsv(lobesPlot(*outcome->lobes)));
             }}};
}

void LobesPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::lobes_panel
