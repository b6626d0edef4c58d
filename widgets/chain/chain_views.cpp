#include "widgets/chain/chain_views.h"

#include <QVBoxLayout>

#include "engine/chain/dossier_report.h"
#include "widgets/core/language.h"

namespace lathelier::chain_panel {

ChainViews::ChainViews(QWidget* parent)
    : QWidget(parent),
      heroes_(new HeroViews),
      chart_(new plot::ChartView),
      rows_(new CopyTable),
      fit_(new CopyTable),
      steps_(new CopyTable),
      files_(new CopyTable),
      numbers_(new CopyTable),
      takeFit_(new QPushButton)
{
    chart_->setObjectName("proofChart");
    rows_->setObjectName("proofRows");
    fit_->setObjectName("proofFit");
    steps_->setObjectName("chainSteps");
    files_->setObjectName("chainFiles");
    numbers_->setObjectName("chainNumbers");
    takeFit_->setObjectName("takeFit");
    heroes_->add("proof", chart_);
    heroes_->add("rows", rows_);
    heroes_->add("fit", fit_);
    heroes_->add("steps", steps_);
    heroes_->add("files", files_);
    heroes_->add("numbers", numbers_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(heroes_, 1);
    layout->addWidget(takeFit_, 0, Qt::AlignRight);
    connect(takeFit_, &QPushButton::clicked, this, &ChainViews::fitWanted);
    connect(chart_, &plot::PlotWidget::notWritten, this, &ChainViews::notWritten);
    retranslate();
}

void ChainViews::setPicture(const std::shared_ptr<const ChainPicture>& picture)
{
    picture_ = picture;
    for (const char* key : {"proof", "rows"}) heroes_->setAvailable(key, picture->proof.has_value());
    heroes_->setAvailable("fit", picture->fit.has_value());
    show();
}

void ChainViews::show()
{
    takeFit_->setEnabled(picture_ && picture_->fit);
    if (!picture_) return;
    if (picture_->proof) {
        chart_->setData(plotOf(*picture_));
        rows_->setTable(chain::proofTable(*picture_->proof));
    }
    if (picture_->fit) fit_->setTable(fitTable(*picture_->fit));
    steps_->setTable(chain::stepsTable(*picture_->dossier));
    files_->setTable(chain::filesTable(*picture_->dossier));
    numbers_->setTable(chain::numbersTable(*picture_->dossier));
}

void ChainViews::showStretch(const Interval& z_mm)
{
    heroes_->setHero("proof");
    chart_->setMarker((z_mm.from + z_mm.to) / 2);
}

void ChainViews::setPresenting(bool presenting)
{
    takeFit_->setVisible(!presenting);
}

void ChainViews::retranslate()
{
    heroes_->setTitle("proof", tr("Predicted and measured"));
    heroes_->setTitle("rows", tr("Rows"));
    heroes_->setTitle("fit", tr("Fit"));
    heroes_->setTitle("steps", tr("Steps"));
    heroes_->setTitle("files", tr("Files"));
    heroes_->setTitle("numbers", tr("Numbers"));
    rows_->setAccessibleName(tr("Rows with their normalized errors"));
    fit_->setAccessibleName(tr("Stiffness and forces fitted to the copy"));
    steps_->setAccessibleName(tr("Steps of the chain"));
    files_->setAccessibleName(tr("Files of the chain"));
    numbers_->setAccessibleName(tr("Numbers and where they stand"));
    takeFit_->setText(tr("Take the fit to the machine"));
    takeFit_->setToolTip(
        tr("Stiffness and forces as fitted to the copy become a machine of the project; Deflection and the chain take "
           "them from then on. One undo step."));
    show();
}

}  // namespace lathelier::chain_panel
