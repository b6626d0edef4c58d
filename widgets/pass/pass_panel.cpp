#include "widgets/pass/pass_panel.h"

#include <algorithm>
#include <cmath>

#include "engine/io/file.h"
#include "engine/io/shaft/shaft_kind.h"
#include "engine/receptance/spindle_item.h"
#include "engine/receptance/spindle_kind.h"
#include "engine/report/chart_csv.h"
#include "engine/shaft/shaft_item.h"
#include "widgets/chatter_common/model_inputs.h"
#include "widgets/core/language.h"
#include "widgets/core/session.h"
#include "widgets/pass/pass_views.h"

namespace lathelier::pass_panel {
namespace {

PanelInputs panelInputs()
{
    PanelInputs inputs;
    inputs.roles = {chatter_common::inputRole(shaftRole, LT_TEXT("Engine", "Shaft"),
                                              LT_TEXT("Engine", "Before the pass: SHAFT.json or a stock file."),
                                              io::shaftFiles(), shaftItem),
                    chatter_common::inputRole(spindleRole, LT_TEXT("Engine", "Spindle"),
                                              LT_TEXT("Engine", "That holds the shaft: SPINDLE.json."),
                                              receptance::spindleFiles(), receptance::spindleItem)};
    inputs.fields = infos<PassQuestion>();
    inputs.defaults = toValues(PassQuestion{});
    inputs.invitation =
        LT_TEXT("Engine", "Drop a shaft and a spindle here, then state the pass, its depth and the coefficient.");
    return inputs;
}

/// Missing required inputs of a pass.
std::vector<Text> missingValues(const project::PanelState& state)
{
    std::vector<Text> labels;
    for (const FieldInfo& info : infos<PassQuestion>())
        for (const char* key : {"pass_z_mm", depthKey, "cutting_coefficient_N_mm2"}) {
            if (info.key != key) continue;
            const Value* const value = find(state.parameters, key);
            const auto* const intervals = value ? std::get_if<std::vector<Interval>>(value) : nullptr;
            if (!value || std::holds_alternative<std::monostate>(*value) || (intervals && intervals->empty()))
                labels.push_back(info.label);
        }
    return labels;
}

}  // namespace

PanelFacts passPanelFacts()
{
    PanelFacts facts;
    facts.id = "pass";
    facts.title = LT_TEXT("Engine", "Pass");
    facts.icon = "pass";
    facts.workspaces = {workspaceOf("chatter")};
    facts.kinds = {&io::shaftFiles(), &receptance::spindleFiles()};
    facts.roles = panelInputs().roles;
    facts.make = [](Session& session) -> PanelBase* { return new PassPanel(session); };
    facts.missing = missingValues;
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) { return reportOf(passOutcome(state, stores, progress), language); };
    return facts;
}

PassPanel::PassPanel(Session& owner, QWidget* parent)
    : Panel(owner, passPanelFacts(), panelInputs(), parent), views_(new PassViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &PassViews::pointMoved, this, &PassPanel::movePoint);
    connect(views_, &PassViews::notWritten, this, &PassPanel::reportWriteFailure);
}

void PassPanel::movePoint(double speed_rpm, double depth_mm, bool dropped)
{
    constexpr double least = 1e-3;  // least depth of cut and rounding step, mm
    editState(
        tr("Move the operating point"),
        [&](project::PanelState& state) {
            lathelier::set(state.parameters, speedKey, std::round(speed_rpm));
            lathelier::set(state.parameters, depthKey, std::max(least, std::round(depth_mm / least) * least));
        },
        QString("pass/point/%1").arg(gesture_));
    gesture_ += dropped;
}

PassPanel::Compute PassPanel::compute(const project::PanelState& state) const
{
    fromValues<PassQuestion>(state.parameters);  // validates ranges before the computation
    return [state, stores = session().sharedStores()](const Progress& progress) {
        return passOutcome(state, *stores, progress);
    };
}

void PassPanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    chatter_common::assignModels(state, files);
}

QString PassPanel::understood(const InputRole& role, const project::Source& source) const
{
    return chatter_common::understoodModel(role.role, source, session().stores());
}

void PassPanel::showResult(const std::shared_ptr<const PassOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

report::Answer PassPanel::answer(const PassOutcome& outcome) const
{
    return passAnswer(*outcome.pass, outcome.speed_rpm, screenLanguage());
}

report::Document PassPanel::document(const PassOutcome& outcome) const
{
    return reportOf(outcome, screenLanguage());
}

std::vector<PanelExport> PassPanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    return {{tr("Least limit (CSV)…"), tr("Table (*.csv)"), "csv", [outcome](const QString& path) {
                 io::writeFile(path.toStdString(), report::toCsv(passPlot(*outcome->pass)));
             }}};
}

void PassPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::pass_panel
