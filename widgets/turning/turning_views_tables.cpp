// The tables of the views: operations, speeds with reasons, remaining material and collisions, set-up sheet.
#include <QSignalBlocker>
#include <algorithm>

#include "engine/cam/check/check_report.h"
#include "engine/cam/drawn/rest_places.h"
#include "engine/cam/plan_report.h"
#include "engine/core/units.h"
#include "widgets/core/language.h"
#include "widgets/turning/turning_views.h"

namespace lathelier::turning_panel {
namespace {

void fillTable(CopyTable* table, const report::Table& rows)
{
    const QSignalBlocker quiet(table);
    const int row = table->currentRow();
    table->setTable(rows);
    if (row >= 0 && row < table->rowCount()) table->setCurrentCell(row, 0);
}

}  // namespace

void TurningViews::connectTables()
{
    const auto onRow = [this](CopyTable* table, auto chosen) {
        connect(table, &QTableWidget::currentCellChanged, this, [this, chosen](int row, int, int before, int) {
            if (outcome_ && row >= 0 && row != before) chosen(static_cast<std::size_t>(row));
        });
    };
    onRow(sections_, [this](std::size_t row) { showWhy(static_cast<int>(row)); });
    onRow(rest_, [this](std::size_t row) { showRest(row); });
    onRow(findings_, [this](std::size_t row) {
        const auto& found = outcome_->plan->setups[clamping_].check.findings;
        if (row < found.size()) goToLine(found[row].line);
    });
    connect(operations(), &OperationsTable::lineChosen, this, &TurningViews::goToLine);
    connect(operations(), &OperationsTable::switched, this, &TurningViews::operationSwitched);
}

void TurningViews::showTables()
{
    const cam::TurningPlan& plan = *outcome_->plan;
    const cam::SetupPlan& setup = plan.setups[clamping_];
    operations_->setOutcome(*outcome_, clamping_);
    showSections();
    fillTable(rest_, cam::restTable(plan));
    fillTable(findings_, cam::findingTable(setup.check));
    report::Document sheet;
    sheet.sections.push_back({{}, {sheetOf(*outcome_, clamping_)}});
    sheet_->setQuantities(sheet);
    fillTable(tools_, cam::toolTable(plan));
    rest_->setVisible(!plan.rest.empty());
    findings_->setVisible(!setup.check.findings.empty());
    primaryViews_->setAvailable("rest", !plan.rest.empty() || !setup.check.findings.empty());
}

void TurningViews::showSections()
{
    const cam::TurningPlan& plan = *outcome_->plan;
    const auto& sections = plan.sections;
    const bool has_speeds = std::any_of(sections.begin(), sections.end(),
                                        [](const cam::SectionSpeed& s) { return s.speed_rpm || s.receptance; });
    fillTable(sections_, cam::sectionTable(plan));
    sections_->setVisible(has_speeds);
    sentence_->setVisible(!has_speeds);
    sentence_->setText(
        tr("Without a spindle there is no dynamics to choose speeds by: the finish keeps its cutting speed of %1, and "
           "the speed follows the diameter. A spindle (SPINDLE.json, or “Spindle” of the project) gives each cylinder "
           "its own speed and says why.")
            .arg(screenQuantity(plan.job.cutting.finish.cutting_speed_m_min, unit::m_min, 0)));
    showWhy(std::max(0, sections_->currentRow()));
}

void TurningViews::showWhy(int section)
{
    if (!outcome_) return;
    report::Plot plot = whyPlot(*outcome_, static_cast<std::size_t>(section), screenLanguage());
    why_->setVisible(!plot.curves.empty());
    lobes_->setVisible(!plot.curves.empty());
    if (!plot.curves.empty()) why_->setData(std::move(plot));
}

void TurningViews::showRest(std::size_t rest)
{
    if (!outcome_ || rest >= outcome_->plan->rest.size()) return;
    const cam::RestPlace place = placeOf(*outcome_, rest);
    setClamping(place.clamping);
    if (place.line > 0) goToLine(place.line);
    showStretch({outcome_->plan->rest[rest].z_start_mm, outcome_->plan->rest[rest].z_end_mm});
}

}  // namespace lathelier::turning_panel
