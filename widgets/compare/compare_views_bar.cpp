// The bar above the views of a comparison, and which view is shown where.
#include <QVBoxLayout>

#include "engine/core/units.h"
#include "engine/registration/compare_plots.h"
#include "widgets/compare/compare_views_parts.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/flow_row.h"

namespace lathelier::compare_panel {
namespace {

QToolButton* choice(QButtonGroup* group, int id, QLayout* row, const char* name)
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
    auto* row = new FlowRow;
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    auto* surface = new QButtonGroup(this);
    p.overlay = choice(surface, 0, row, "overlay");
    p.deviation = choice(surface, 1, row, "deviation");
    p.deviation->setChecked(true);
    p.smooth = new QCheckBox;
    p.smooth->setObjectName("localMean");
    p.smooth->setChecked(true);  // shows the form without the scanner's noise
    row->addWidget(p.smooth);
    connect(surface, &QButtonGroup::idClicked, this, [this] { showSurface(); });
    connect(p.smooth, &QCheckBox::toggled, this, [this] { showSurface(); });

    auto* colours = new QButtonGroup(this);
    p.form = choice(colours, 0, row, "form");
    p.pass_fail = choice(colours, 1, row, "passFail");
    p.form->setChecked(true);
    connect(colours, &QButtonGroup::idToggled, this, [this](int, bool on) {
        if (!on || !parts_->outcome) return;
        showCharts();
        if (parts_->shares() || parts_->coloured_by_share)
            showSurface();
        else
            recolour(parts_->greenWithin());
    });

    p.factor_label = new QLabel;
    p.factor = new QDoubleSpinBox;
    p.factor->setObjectName("magnification");
    p.factor->setRange(1, 100000);
    p.factor->setDecimals(0);
    p.factor->setKeyboardTracking(false);
    p.factor->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    p.factor_label->setBuddy(p.factor);
    row->addWidget(p.factor_label);
    row->addWidget(p.factor);
    connect(p.factor, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double factor) {
        parts_->chosen_factor = factor;
        showSurface();
        if (parts_->hasAxis()) parts_->meridian->setData(magnifiedMeridian(parts_->result(), screenLanguage(), factor));
    });
    p.zone = new QToolButton;
    p.zone->setObjectName("drawZone");
    p.zone->setAutoRaise(true);
    p.zone->setCheckable(true);
    row->addWidget(p.zone);
    for (plot::PlotCanvas* canvas : {static_cast<plot::PlotCanvas*>(p.map), static_cast<plot::PlotCanvas*>(p.along),
                                     static_cast<plot::PlotCanvas*>(p.meridian)}) {
        connect(p.zone, &QToolButton::toggled, canvas, &plot::PlotCanvas::setDrawsStretch);
        connect(canvas, &plot::PlotCanvas::stretchDrawn, this, [this](double from_mm, double to_mm) {
            parts_->zone->setChecked(false);
            emit zoneDrawn(from_mm, to_mm);
        });
    }
    p.section = new QToolButton;
    p.section->setObjectName("roundnessOfSection");
    p.section->setAutoRaise(true);
    p.section->setEnabled(false);
    row->addWidget(p.section);
    connect(p.section, &QToolButton::clicked, this, [this] {
        if (parts_->place && parts_->place->z_mm) emit sectionRequested(*parts_->place->z_mm);
    });
    p.synthetic = new QLabel;
    p.synthetic->setObjectName("synthetic");
    p.synthetic->setFrameShape(QFrame::Box);
    p.synthetic->setMargin(2);
    row->setTrailing(p.synthetic);
}

void CompareViews::arrange()
{
    Parts& p = *parts_;
    const bool axis = !p.outcome || p.hasAxis();
    for (const char* key : {view::map, view::meridian}) p.primary_views->setAvailable(key, axis);
    p.along->setVisible(axis);
    const bool zones = p.tabs->indexOf(p.zones) >= 0;
    if (axis && !zones) {
        p.tabs->insertTab(0, p.zones, tr("Zones"));
        p.tabs->setCurrentIndex(0);
    }
    if (!axis && zones) p.tabs->removeTab(0);
    p.smooth->setVisible(!p.outcome || p.outcome->form.local_mean_mm);
    p.section->setVisible(axis);
    p.zone->setVisible(axis);
    p.zone->setEnabled(p.hasAxis());
    // Pass/fail colours require a tolerance.
    const bool limited = p.outcome && (p.result().parameters.tolerance_mm || showsShares(p.result().parameters));
    p.form->setEnabled(limited);
    p.pass_fail->setEnabled(limited);
    if (!limited && p.outcome) p.form->setChecked(true);
}

void CompareViews::retranslate()
{
    Parts& p = *parts_;
    p.primary_views->setTitle(view::part, tr("Part"));
    p.primary_views->setTitle(view::map, tr("Map"));
    p.primary_views->setTitle(view::meridian, tr("Meridian"));
    p.primary_views->setTitle(view::distribution, tr("Distribution"));
    p.primary_views->setTitle(view::tables, tr("Tables"));
    p.primary_views->setTitle(view::sizes, tr("Sizes"));
    p.sizes->setAccessibleName(tr("Sizes"));
    p.primary_views->setTitle(view::copies, tr("Copies"));
    p.copy_table->setAccessibleName(tr("Copies"));
    p.copy_table->setToolTip(tr("Double click: show this copy"));
    if (const int zones = p.tabs->indexOf(p.zones); zones >= 0) p.tabs->setTabText(zones, tr("Zones"));
    p.tabs->setTabText(p.tabs->indexOf(p.numbers), tr("Numbers"));
    p.overlay->setText(tr("Overlay"));
    p.overlay->setToolTip(tr("The original blue, the copy red"));
    p.deviation->setText(tr("Deviation"));
    p.deviation->setToolTip(tr("The copy, coloured by its distance from the original's surface"));
    p.form->setText(tr("Form"));
    p.form->setToolTip(tr("Colours of the error: red too large, blue too small"));
    p.pass_fail->setText(tr("Pass/fail"));
    p.pass_fail->setToolTip(tr("Green within the tolerance, red above it, blue below it"));
    p.smooth->setText(tr("Local mean"));
    p.smooth->setToolTip(
        tr("Each place has the mean of its surroundings, as large as it needs to be sure; grey: not sure; off: every "
           "point by itself"));
    p.factor_label->setText(tr("Error ×"));
    p.factor->setToolTip(tr("How many times larger part and meridian draw the deviation"));
    p.factor->setAccessibleName(p.factor->toolTip());
    p.zone->setText(tr("Zone"));
    p.zone->setToolTip(
        tr("Draw a zone with limits of its own: drag along the axis in the map, the deviation or the "
           "meridian. On a zone that is there: edit it."));
    p.section->setText(tr("Roundness here"));
    p.section->setToolTip(tr("Cuts the marked section out of the copy and opens it in the panel Roundness"));
    p.synthetic->setText(tr("Synthetic data"));
    p.synthetic->setToolTip(tr("These scans were computed, not measured."));
    p.synthetic->setVisible(p.outcome && p.outcome->sources.synthetic);
    p.scene->setScale({LT_TEXT("Engine", "Deviation"), unit::mm});
    if (!p.outcome) return;
    arrange();
    showCharts();
    setCopies(p.summaries);
    setPlace(p.place);
}

}  // namespace lathelier::compare_panel
