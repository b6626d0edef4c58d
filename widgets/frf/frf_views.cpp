#include "widgets/frf/frf_views.h"

#include <QVBoxLayout>

#include "engine/receptance/modal/modal_plots.h"
#include "engine/receptance/modal/modal_report.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/flow_row.h"

namespace lathelier::frf_panel {

FrfViews::FrfViews(QWidget* parent)
    : QWidget(parent),
      use_(new QToolButton),
      back_(new QToolButton),
      primaryViews_(new PrimaryViews),
      magnitude_(new plot::ChartView),
      phase_(new plot::ChartView),
      real_(new plot::ChartView),
      imaginary_(new plot::ChartView),
      nyquist_(new plot::ChartView),
      coherence_(new plot::ChartView),
      error_(new plot::ChartView),
      stability_(new plot::ChartView),
      shapes_(new CopyTable),
      modes_(new CopyTable)
{
    const std::pair<const char*, QWidget*> views[] = {
        {"magnitude", magnitude_}, {"modes", modes_},         {"real", real_},           {"phase", phase_},
        {"nyquist", nyquist_},     {"imaginary", imaginary_}, {"coherence", coherence_}, {"error", error_},
        {"stability", stability_}, {"shapes", shapes_}};
    for (const auto& [key, view] : views) {
        view->setObjectName(key);
        primaryViews_->add(key, view);
    }
    use_->setObjectName("useThisResponse");
    back_->setObjectName("backToTheFit");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* row = new FlowRow;
    for (QToolButton* button : {use_, back_}) {
        button->setAutoRaise(true);
        row->addWidget(button);
    }
    use_->setEnabled(false);
    back_->setEnabled(false);
    layout->addLayout(row);
    layout->addWidget(primaryViews_, 1);
    connect(use_, &QToolButton::clicked, this, &FrfViews::responseRequested);
    connect(back_, &QToolButton::clicked, this, &FrfViews::fitRequested);
    connect(magnitude_, &plot::ChartView::handleMoved, this,
            [this](const QString& key, double frequency_hz, double magnitude, bool dropped) {
                if (const auto index = receptance::modeOfHandle(key.toStdString()))
                    emit modeDragged(static_cast<int>(*index), frequency_hz, magnitude, dropped);
            });
    for (plot::ChartView* chart : {magnitude_, phase_, real_, imaginary_, nyquist_, coherence_, error_, stability_})
        connect(chart, &plot::PlotWidget::notWritten, this, &FrfViews::notWritten);
    retranslate();
}

void FrfViews::setOutcome(const std::shared_ptr<const receptance::ModesOutcome>& outcome)
{
    outcome_ = outcome;
    show();
}

void FrfViews::show()
{
    if (!outcome_) return;
    const receptance::ResponseStudy& study = outcome_->study;
    const bool has_fit = study.fit != nullptr;
    use_->setEnabled(outcome_->handedOn() != nullptr);
    back_->setEnabled(study.is_changed);
    const report::Plot coherence = coherencePlot(study);
    primaryViews_->setAvailable("coherence", !coherence.curves.empty());
    primaryViews_->setAvailable("error", has_fit);
    primaryViews_->setAvailable("stability", has_fit);
    primaryViews_->setAvailable("shapes", !study.common.empty());
    primaryViews_->setAvailable("modes", has_fit && !study.model.modes.empty());
    magnitude_->setData(magnitudePlot(study, true, screenLanguage()));
    phase_->setData(phasePlot(study));
    real_->setData(realPlot(study, screenLanguage()));
    imaginary_->setData(imaginaryPlot(study));
    nyquist_->setData(nyquistPlot(study));
    if (!coherence.curves.empty()) coherence_->setData(coherence);
    if (!has_fit) return;
    error_->setData(errorPlot(study));
    stability_->setData(stabilisationPlot(study, screenLanguage()));
    if (!study.common.empty()) shapes_->setTable(shapesTable(study, screenLanguage()));
    modes_->setTable(modesTable(study));
}

void FrfViews::retranslate()
{
    primaryViews_->setTitle("magnitude", tr("Magnitude"));
    primaryViews_->setTitle("modes", tr("Modes"));
    primaryViews_->setTitle("real", tr("Real part"));
    primaryViews_->setTitle("phase", tr("Phase"));
    primaryViews_->setTitle("nyquist", tr("Nyquist"));
    primaryViews_->setTitle("imaginary", tr("Imaginary part"));
    primaryViews_->setTitle("coherence", tr("Coherence"));
    primaryViews_->setTitle("error", tr("Error of the model"));
    primaryViews_->setTitle("stability", tr("Stability of the poles"));
    primaryViews_->setTitle("shapes", tr("All responses"));
    modes_->setAccessibleName(tr("Modes"));
    shapes_->setAccessibleName(tr("All responses"));
    use_->setText(tr("Use this response"));
    use_->setToolTip(tr("Lobes of this response: as measured, or of its modal model (Use for lobes)"));
    back_->setText(tr("Back to the fit"));
    back_->setToolTip(tr("Takes the modes of the fit again in place of those changed by hand"));
    show();
}

}  // namespace lathelier::frf_panel
