#include "widgets/roundness/roundness_views.h"

#include <QButtonGroup>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "engine/form/roundness/roundness_plots.h"
#include "engine/form/roundness/roundness_report.h"
#include "engine/form/roundness/superimpose_report.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/flow_row.h"
#include "widgets/roundness/roundness_charts.h"

namespace lathelier::roundness_panel {

RoundnessViews::RoundnessViews(trajectory_common::MarkedAngle& angle, QWidget* parent)
    : QWidget(parent),
      angle_(angle),
      section_(new trajectory_common::SectionBar),
      form_(new QToolButton),
      laid_(new QToolButton),
      difference_(new QLabel),
      synthetic_(new QLabel),
      polar_(new plot::PolarView),
      spectrum_(new plot::ChartView),
      primaryViews_(new PrimaryViews),
      tabs_(new QTabWidget),
      circles_(new CopyTable),
      methods_(new CopyTable),
      hints_(new CopyTable),
      numbers_(new CopyTable)
{
    polar_->setObjectName("polar");
    spectrum_->setObjectName("spectrum");
    circles_->setObjectName("circles");
    methods_->setObjectName("methods");
    hints_->setObjectName("hints");
    numbers_->setObjectName("numbers");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    buildBar();
    tabs_->setDocumentMode(true);
    for (CopyTable* table : {circles_, methods_, hints_, numbers_}) tabs_->addTab(table, QString());
    primaryViews_->add("polar", polar_);
    primaryViews_->add("spectrum", spectrum_);
    primaryViews_->add("tables", tabs_);
    layout->addWidget(primaryViews_, 1);

    connect(section_, &trajectory_common::SectionBar::sectionRequested, this, &RoundnessViews::sectionRequested);
    connect(polar_, &plot::PolarView::clicked, this, [this](double deg) { angle_.set(deg); });
    connect(&angle_, &trajectory_common::MarkedAngle::changed, this, &RoundnessViews::markAngle);
    connect(polar_, &plot::PolarView::unmarked, this, [this] { angle_.set({}); });
    connect(spectrum_, &plot::PlotCanvas::clickTakenBack, this, [this] { markHarmonic(harmonicBefore_); });
    connect(spectrum_, &plot::PlotCanvas::clicked, this, [this](double upr, double) {
        harmonicBefore_ = harmonic_;
        const int wanted = static_cast<int>(std::lround(upr));
        markHarmonic(harmonic_ == wanted ? std::nullopt : std::optional(wanted));
    });
    circles_->setMouseTracking(true);
    circles_->viewport()->installEventFilter(this);
    connect(circles_, &QTableWidget::cellEntered, this, [this](int row, int) {
        pointedRow_ = row;
        askCircle();
    });
    connect(circles_, &QTableWidget::itemSelectionChanged, this, &RoundnessViews::askCircle);
    connect(hints_, &QTableWidget::cellClicked, this, [this](int row, int) {
        const auto& hints = outcome_->judged().hints;
        if (row < static_cast<int>(hints.size())) markHarmonic(hints[static_cast<std::size_t>(row)].upr);
    });
    for (plot::PlotWidget* plot : {static_cast<plot::PlotWidget*>(polar_), static_cast<plot::PlotWidget*>(spectrum_)})
        connect(plot, &plot::PlotWidget::notWritten, this, &RoundnessViews::notWritten);
    retranslate();
}

void RoundnessViews::buildBar()
{
    auto* row = new FlowRow;
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    row->addWidget(section_);
    auto* group = new QButtonGroup(this);
    for (QToolButton* button : {form_, laid_}) {
        button->setCheckable(true);
        button->setAutoRaise(true);
        group->addButton(button);
        row->addWidget(button);
        button->hide();
    }
    form_->setObjectName("showForm");
    laid_->setObjectName("showLaid");
    form_->setChecked(true);
    difference_->setObjectName("difference");
    row->addWidget(difference_);
    synthetic_->setFrameShape(QFrame::Box);
    synthetic_->setMargin(2);
    synthetic_->hide();
    row->setTrailing(synthetic_);
    connect(group, &QButtonGroup::idToggled, this, [this] { showPolar(); });
}

void RoundnessViews::setOutcome(const std::shared_ptr<const RoundnessShown>& outcome, bool sectionChosen)
{
    const bool newTrace =
        outcome->trace() && (!outcome_ || !outcome_->trace() || *outcome_->trace() != *outcome->trace());
    outcome_ = outcome;
    section_->setSections(outcome->trajectory, outcome->section, sectionChosen);
    const bool laid = outcome->superimposed != nullptr;
    form_->setVisible(laid);
    laid_->setVisible(laid);
    difference_->setVisible(laid);
    if (newTrace && laid) laid_->setChecked(true);  // shows the newly added trace
    if (!laid) form_->setChecked(true);
    if (laid)
        difference_->setText(tr("largest difference %1, mean %2")
                                 .arg(screenQuantity(outcome->superimposed->largest_difference_um, micrometre, 2),
                                      screenQuantity(outcome->superimposed->mean_difference_um, micrometre, 2)));
    synthetic_->setVisible(outcome->sources.synthetic);
    spectrum_->setData(spectrumPlot(outcome->judged(), screenLanguage()));
    showPolar();
    showTables();
}

void RoundnessViews::showPolar()
{
    if (!outcome_) return;
    plot::PolarPicturePtr shown = laid_->isChecked() && outcome_->laid ? outcome_->laid : outcome_->polar;
    if (harmonic_ && shown == outcome_->polar) {
        const std::vector<signal::Harmonic>& all = outcome_->judged().harmonics;
        const auto wanted =
            std::find_if(all.begin(), all.end(), [&](const signal::Harmonic& h) { return h.upr == *harmonic_; });
        if (wanted != all.end()) shown = withHarmonic(shown, *wanted);
    }
    polar_->setPicture(shown);
    markAngle();
}

void RoundnessViews::showTables()
{
    const form::RoundnessResult& result = outcome_->judged();
    circles_->setTable(circlesTable(result));
    const std::string_view chosen = name(result.parameters.circle);
    for (int row = 0; row < circles_->rowCount(); ++row)
        if (QTableWidgetItem& circle = *circles_->item(row, 0);
            circle.text().contains(QLatin1String(chosen.data(), static_cast<int>(chosen.size()))))
            circle.setText(circle.text() + " ◀");
    methods_->setTable(methodTable(result, screenLanguage()));
    hints_->setTable(hintTable(result));
    report::Document document = form::roundnessReport({result}, outcome_->sources.inputs, screenLanguage());
    if (outcome_->superimposed)
        document.sections.insert(document.sections.begin(), superimposeSection(*outcome_->superimposed));
    numbers_->setQuantities(document);
}

void RoundnessViews::markHarmonic(std::optional<int> upr)
{
    harmonic_ = upr;
    spectrum_->setMarker(upr ? std::optional<double>(*upr) : std::nullopt);
    hints_->clearSelection();
    if (outcome_ && upr) {
        const auto& hints = outcome_->judged().hints;
        for (std::size_t row = 0; row < hints.size(); ++row)
            if (hints[row].upr == *upr) hints_->selectRow(static_cast<int>(row));
    }
    showPolar();
}

/// Besides the chosen circle that of the hovered row is drawn, else that of the selected row.
void RoundnessViews::askCircle()
{
    const QList<QTableWidgetSelectionRange> selected = circles_->selectedRanges();
    const int row = pointedRow_ >= 0 || selected.isEmpty() ? pointedRow_ : selected.front().topRow();
    const bool known = row >= 0 && row < static_cast<int>(form::circlesOfTable.size());
    polar_->setAsked(known ? std::string(name(form::circlesOfTable[static_cast<std::size_t>(row)])) : std::string());
}

bool RoundnessViews::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Leave && watched == circles_->viewport()) {
        pointedRow_ = -1;
        askCircle();
    }
    return QWidget::eventFilter(watched, event);
}

Values RoundnessViews::view() const
{
    return {{"harmonic_upr", harmonic_ ? Value(std::int64_t{*harmonic_}) : Value()},
            {"table", std::int64_t{tabs_->currentIndex()}}};
}

void RoundnessViews::restoreView(const Values& kept)
{
    const auto number = [&kept](const char* key) -> std::optional<int> {
        const Value* const there = lathelier::find(kept, key);
        const auto* const given = there ? std::get_if<std::int64_t>(there) : nullptr;
        return given && *given >= 0 && *given < 100000 ? std::optional(static_cast<int>(*given)) : std::nullopt;
    };
    tabs_->setCurrentIndex(number("table").value_or(0));
    markHarmonic(number("harmonic_upr"));
}

void RoundnessViews::markAngle()
{
    polar_->setMarker(angle_.angle_deg());
}

void RoundnessViews::retranslate()
{
    form_->setText(tr("Roundness"));
    form_->setToolTip(tr("The profile with its reference circles"));
    laid_->setText(tr("Laid over"));
    laid_->setToolTip(tr("The profile and the trace over each other, and their difference"));
    synthetic_->setText(tr("Synthetic data"));
    primaryViews_->setTitle("polar", tr("Roundness plot"));
    primaryViews_->setTitle("spectrum", tr("Harmonic content"));
    primaryViews_->setTitle("tables", tr("Tables"));
    const QStringList names{tr("Circles"), tr("Methods"), tr("Undulations"), tr("Numbers")};
    for (int i = 0; i < names.size(); ++i) {
        tabs_->setTabText(i, names[i]);
        tabs_->widget(i)->setAccessibleName(names[i]);
    }
    if (outcome_) setOutcome(outcome_, !section_->isWorst());
}

}  // namespace lathelier::roundness_panel
