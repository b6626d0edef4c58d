// The bar above the views of a comparison, and which view is shown where.
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "engine/registration/compare_plots.h"
#include "widgets/compare/compare_views_parts.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

QToolButton* choice(QButtonGroup* group, int id, QHBoxLayout* row, const char* name)
{
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setCheckable(true);
    button->setAutoRaise(true);
    group->addButton(button, id);
    row->addWidget(button);
    return button;
}

}  // namespace

void CompareViews::buildBar()
{
    Parts& p = *parts_;
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    p.viewGroup = new QButtonGroup(this);
    static constexpr std::array<const char*, viewCount> names{
        "viewAll", "viewSpace", "viewMap", "viewMeridian", "viewDistribution", "viewZones", "viewNumbers"};
    for (int id = 0; id < viewCount; ++id)
        p.views[static_cast<std::size_t>(id)] = choice(p.viewGroup, id, row, names[static_cast<std::size_t>(id)]);
    p.views[All]->setChecked(true);
    connect(p.viewGroup, &QButtonGroup::idClicked, this, [this] { arrange(); });

    row->addSpacing(12);
    auto* surface = new QButtonGroup(this);
    p.overlay = choice(surface, 0, row, "overlay");
    p.deviation = choice(surface, 1, row, "deviation");
    p.deviation->setChecked(true);
    p.smooth = new QCheckBox;
    p.smooth->setObjectName("localMean");
    row->addWidget(p.smooth);
    connect(surface, &QButtonGroup::idClicked, this, [this] { showSurface(); });
    connect(p.smooth, &QCheckBox::toggled, this, [this] { showSurface(); });

    row->addSpacing(12);
    p.factorLabel = new QLabel;
    p.factor = new QDoubleSpinBox;
    p.factor->setObjectName("magnification");
    p.factor->setRange(1, 100000);
    p.factor->setDecimals(0);
    p.factor->setKeyboardTracking(false);
    p.factor->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    p.factorLabel->setBuddy(p.factor);
    row->addWidget(p.factorLabel);
    row->addWidget(p.factor);
    connect(p.factor, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double factor) {
        parts_->chosenFactor = factor;
        if (parts_->hasAxis()) parts_->meridian->setData(magnifiedMeridian(parts_->result(), screenLanguage(), factor));
    });
    row->addStretch(1);
    p.synthetic = new QLabel;
    p.synthetic->setObjectName("synthetic");
    p.synthetic->setFrameShape(QFrame::Box);
    p.synthetic->setMargin(2);
    row->addWidget(p.synthetic);
}

void CompareViews::arrange()
{
    Parts& p = *parts_;
    const bool axis = !p.picture || p.hasAxis();
    for (const CompareView view : {Map, Profile, Zones}) p.views[view]->setVisible(axis);
    int shown = p.viewGroup->checkedId();
    if (!axis && (shown == Map || shown == Profile || shown == Zones)) {
        p.views[All]->setChecked(true);
        shown = All;
    }
    const bool all = shown == All;
    p.tabs->clear();
    p.tabs->addTab(p.histogram, p.views[Distribution]->text());
    if (axis) p.tabs->addTab(p.zones, p.views[Zones]->text());
    p.tabs->addTab(p.numbers, p.views[Numbers]->text());
    if (shown == Zones) p.tabs->setCurrentWidget(p.zones);
    if (shown == Numbers) p.tabs->setCurrentWidget(p.numbers);
    p.scene->setVisible(all || shown == Space);
    p.map->setVisible(axis && (all || shown == Map));
    p.meridian->setVisible(axis && (all || shown == Profile));
    p.tabs->setVisible(all || shown >= Distribution);
    p.tabs->tabBar()->setVisible(all);
    p.upper->setVisible(all || shown == Space || shown == Map);
    p.lower->setVisible(all || shown >= Profile);
    p.factor->setVisible(axis && (all || shown == Profile));
    p.factorLabel->setVisible(p.factor->isVisibleTo(this));
    p.smooth->setVisible(axis);
}

void CompareViews::retranslate()
{
    Parts& p = *parts_;
    const std::array<QString, viewCount> names{tr("All"),          tr("3-D"),   tr("Map"),    tr("Meridian"),
                                               tr("Distribution"), tr("Zones"), tr("Numbers")};
    for (std::size_t i = 0; i < names.size(); ++i) p.views[i]->setText(names[i]);
    p.overlay->setText(tr("Overlay"));
    p.overlay->setToolTip(tr("The original blue, the copy red"));
    p.deviation->setText(tr("Deviation"));
    p.deviation->setToolTip(tr("The copy, coloured by its distance from the original's surface"));
    p.smooth->setText(tr("Local mean"));
    p.smooth->setToolTip(tr("Each point has the mean of its surroundings, as in the map; off: every point by itself"));
    p.factorLabel->setText(tr("Error ×"));
    p.factor->setToolTip(tr("How many times larger the meridian draws the deviation"));
    p.factor->setAccessibleName(p.factor->toolTip());
    p.synthetic->setText(tr("Synthetic data"));
    p.synthetic->setToolTip(tr("These scans were computed, not measured."));
    p.synthetic->setVisible(p.picture && p.picture->synthetic);
    p.scene->setScaleTitle(tr("Deviation (mm)"));
    if (!p.picture) return;
    arrange();
    showCharts();
    setPlace(p.place);
}

}  // namespace lathelier
