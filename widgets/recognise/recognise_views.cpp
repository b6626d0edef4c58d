#include "widgets/recognise/recognise_views.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "engine/features/report/recognition_plots.h"
#include "engine/features/report/recognition_quantities.h"
#include "engine/features/report/recognition_report.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/flow_row.h"
#include "widgets/core/panel/view_frame.h"

namespace lathelier::recognise_panel {
namespace {

constexpr double beyondChart_um = 1e6;  ///< larger than any shown residual

}  // namespace

RecogniseViews::RecogniseViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      charts_(new QSplitter(Qt::Vertical)),
      meridian_(new part_common::RowChart),
      residuals_(new part_common::RowChart),
      rows_(new RowsView),
      scene_(new scene::SceneView),
      steps_(new CopyTable),
      beside_(new QLabel),
      numbers_(new CopyTable),
      shaft_(new QToolButton),
      found_(new QToolButton),
      synthetic_(new QLabel)
{
    meridian_->setObjectName("meridian");
    residuals_->setObjectName("residuals");
    scene_->setObjectName("scene");
    steps_->setObjectName("steps");
    beside_->setObjectName("beside");
    numbers_->setObjectName("numbers");
    residuals_->followX(meridian_);
    residuals_->setProperty(ViewFrame::onlyLarge, true);  // hidden when small, in favour of the shape
    charts_->setChildrenCollapsible(false);
    charts_->addWidget(meridian_);
    charts_->addWidget(residuals_);
    charts_->setStretchFactor(0, 3);
    charts_->setStretchFactor(1, 2);
    auto* table = new QWidget;
    auto* inside = new QVBoxLayout(table);
    inside->setContentsMargins(0, 0, 0, 0);
    inside->addWidget(steps_, 1);
    beside_->setWordWrap(true);
    beside_->setProperty(ViewFrame::onlyLarge, true);
    inside->addWidget(beside_);
    primaryViews_->add("meridian", charts_);
    primaryViews_->add("rows", rows_);
    primaryViews_->add("part", scene_);
    primaryViews_->add("steps", table);
    primaryViews_->add("tables", numbers_);
    synthetic_->setFrameShape(QFrame::Box);
    synthetic_->setMargin(2);
    synthetic_->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* bar = new FlowRow;
    shaft_->setObjectName("useShaft");
    bar->addWidget(shaft_);
    found_->setObjectName("asFound");
    bar->addWidget(found_);
    found_->hide();
    connect(found_, &QToolButton::clicked, this, &RecogniseViews::foundRequested);
    bar->setTrailing(synthetic_);
    layout->addLayout(bar);
    layout->addWidget(primaryViews_, 1);

    for (part_common::RowChart* chart : {meridian_, residuals_}) {
        connect(chart, &part_common::RowChart::menuOpened, this, &RecogniseViews::openChartMenu);
        chart->installEventFilter(this);
        connect(chart, &plot::PlotCanvas::clicked, this, [this](double z_mm, double) { pickAt(z_mm); });
        connect(chart, &plot::PlotCanvas::notWritten, this, &RecogniseViews::notWritten);
    }
    connect(scene_, &scene::SceneView::pointPicked, this, [this](int object, qint64 point) {
        const Scan& scan = *scene_->objects()[static_cast<std::size_t>(object)].scan;
        pickAt((outcome_->result->part_T_scan * scan.points_mm[static_cast<std::size_t>(point)]).z());
    });
    connect(shaft_, &QToolButton::clicked, this, &RecogniseViews::shaftRequested);
    connect(scene_, &scene::SceneView::notWritten, this, &RecogniseViews::notWritten);
    connect(rows_, &RowsView::rowPointedAt, this, [this](int row) {
        row_ = row >= 0 ? std::optional(static_cast<std::size_t>(row)) : std::nullopt;
        pointOut(row_);
    });
    rows_->table()->installEventFilter(this);
    rows_->table()->viewport()->installEventFilter(this);
    connect(steps_, &QTableWidget::currentCellChanged, this, [this](int step) {
        if (!outcome_ || step < 0 || step >= static_cast<int>(outcome_->steps.size())) return;
        const ShaftStep& at = outcome_->steps[static_cast<std::size_t>(step)];
        pickAt((at.z_start_mm + at.z_end_mm) / 2);
    });
    retranslate();
}

void RecogniseViews::setOutcome(const std::shared_ptr<const cad::RecognizeOutcome>& outcome)
{
    const bool new_rows = !outcome_ || outcome_->result != outcome->result;
    outcome_ = outcome;
    if (new_rows) {
        row_.reset();
        showScan();
    }
    show();
    markRow(row_);
}

void RecogniseViews::show()
{
    if (!outcome_) return;
    const features::Recognition& result = *outcome_->result;
    meridian_->setData(meridianPlot(result, screenLanguage()));
    residuals_->setData(residualPlot(result));
    rows_->setOutcome(outcome_);
    {
        const QSignalBlocker quiet(steps_);
        steps_->setTable(features::stepsTable(outcome_->steps));
    }
    QStringList beside;
    double z_mm = 0;
    for (std::size_t i = 0; i < outcome_->shaft.segments.size(); ++i) {
        const ShaftSegment& rowSegment = outcome_->shaft.segments[i];
        const double from_mm = z_mm;
        z_mm += rowSegment.length_mm;
        if (std::find(outcome_->beside.begin(), outcome_->beside.end(), i) == outcome_->beside.end()) continue;
        const features::RowKind kind = rowSegment.arc_radius_mm ? features::RowKind::Arc : features::RowKind::Cone;
        const QString name =
            rowSegment.role.empty() ? screenText(kindName(kind)) : screenText(features::roleName(rowSegment.role));
        beside << tr("row %1: %2, z %3-%4")
                      .arg(i + 1)
                      .arg(name, screenNumber(from_mm, millimetre, 1), screenQuantity(z_mm, millimetre, 1));
    }
    beside_->setText(beside.isEmpty() ? tr("All rows are in this table.")
                                      : tr("Not in this table: %1").arg(beside.join("; ")));
    numbers_->setQuantities(recognitionReport(result, outcome_->steps, outcome_->sources.inputs, screenLanguage()));
    synthetic_->setVisible(outcome_->sources.synthetic);
    found_->setVisible(!outcome_->changes.empty());
}

part_common::RowVerbs RecogniseViews::verbsOf(std::size_t row, std::optional<double> z_mm)
{
    part_common::RowVerbs verbs;
    if (!outcome_ || row >= outcome_->result->segments.size()) return verbs;
    if (outcome_->result->parameters.method != features::RecognitionMethod::Robust) return verbs;
    using What = features::RowChange::What;
    const auto& rows = outcome_->result->segments;
    const int number = static_cast<int>(row) + 1;
    const auto ask = [this, number](const QString& step, What what, double at_mm = 0) {
        return [=, this] { emit changeRequested(step, {what, number, at_mm}); };
    };
    if (rows.size() > 1) verbs.remove = ask(tr("Delete row %1").arg(number), What::Delete);
    if (row + 1 < rows.size()) verbs.merge = ask(tr("Merge rows %1 and %2").arg(number).arg(number + 1), What::Merge);
    const double from = rows[row].z_start_mm, to = rows[row].z_end_mm;
    double cut = z_mm.value_or((from + to) / 2);
    if (!(cut > from && cut < to)) cut = (from + to) / 2;
    verbs.split = ask(tr("Split row %1").arg(number), What::Split, std::round(cut * 1e3) / 1e3);
    verbs.forms = {RowForm::Cylinder, RowForm::Cone, RowForm::Round, RowForm::Fillet};
    const bool arc = rows[row].kind == features::RowKind::Arc;
    verbs.now = arc ? *rows[row].arc_radius_mm > 0 ? RowForm::Round : RowForm::Fillet
                : rows[row].kind == features::RowKind::Cylinder ? RowForm::Cylinder
                                                                : RowForm::Cone;
    verbs.change = [=, this](RowForm form) {
        const What what = form == RowForm::Cylinder ? What::Cylinder
                          : form == RowForm::Cone   ? What::Cone
                          : form == RowForm::Round  ? What::Round
                                                    : What::Fillet;
        emit changeRequested(tr("Make row %1 a %2").arg(number).arg(part_common::formName(form).toLower()),
                             {what, number, 0});
    };
    return verbs;
}

void RecogniseViews::openChartMenu(QMenu* menu, double z_mm)
{
    if (!outcome_ || outcome_->result->ends.empty()) return;
    const bool here = z_mm >= 0 && z_mm <= outcome_->result->ends.back().z_mm;
    if (here) pickAt(z_mm);
    if (row_)
        part_common::addRowVerbs(*menu, static_cast<int>(*row_) + 1,
                                 verbsOf(*row_, here ? std::optional(z_mm) : std::nullopt));
}

/// Keys of rows in charts and table; the table's context menu.
bool RecogniseViews::eventFilter(QObject* watched, QEvent* event)
{
    CopyTable* const table = rows_->table();
    if (event->type() == QEvent::KeyPress && watched != table->viewport() && row_ &&
        part_common::pressRowKey(*static_cast<QKeyEvent*>(event), verbsOf(*row_)))
        return true;
    if (event->type() == QEvent::ContextMenu && watched == table->viewport()) {
        const auto* const request = static_cast<QContextMenuEvent*>(event);
        const bool by_key = request->reason() == QContextMenuEvent::Keyboard;
        const int row = by_key ? table->currentRow() : table->rowAt(request->pos().y());
        if (outcome_ && row >= 0 && row < static_cast<int>(outcome_->result->segments.size())) {
            QMenu menu(this);
            part_common::addRowVerbs(menu, row + 1, verbsOf(static_cast<std::size_t>(row)));
            menu.addSeparator();
            menu.addAction(CopyTable::tr("Copy"), this, [table] { table->copyToClipboard(); });
            menu.exec(request->globalPos());
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

/// In the colours of the meridian.
void RecogniseViews::showScan()
{
    if (!outcome_) return;
    const features::Recognition& result = *outcome_->result;
    const std::array<QString, 4> names{screenText(kindName(features::RowKind::Cylinder)),
                                       screenText(kindName(features::RowKind::Cone)),
                                       screenText(kindName(features::RowKind::Arc)), tr("on no row")};
    std::vector<scene::SceneObject> objects;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const ScanPtr& scan = outcome_->by_kind[i];
        if (!scan || (scan->isMesh() ? scan->triangles.empty() : scan->points_mm.empty())) continue;
        scene::SceneObject object;
        object.name = names[i];
        object.scan = scan;
        const report::ChartColour colour =
            i < 3 ? report::ChartColour(static_cast<int>(i)) : report::ChartColour(report::ColourRole::Neutral);
        object.colour = plot::toQt(report::colourOf(colour));
        objects.push_back(std::move(object));
    }
    scene_->setLongAxis(scene::SceneAxis{result.axis_point_mm, result.axis_direction});
    scene_->setObjects(std::move(objects));
    const double end_mm = result.ends.empty() ? 0 : result.ends.back().z_mm;
    scene_->setOutline({{result.axis_point_mm - 0.05 * end_mm * result.axis_direction,
                         result.axis_point_mm + 1.05 * end_mm * result.axis_direction}});
}

void RecogniseViews::pickAt(double z_mm)
{
    if (!outcome_) return;
    const auto& rows = outcome_->result->segments;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (z_mm >= rows[i].z_start_mm && z_mm <= rows[i].z_end_mm) return markRow(i);
    markRow({});
}

void RecogniseViews::markRow(std::optional<std::size_t> row)
{
    if (!outcome_ || (row && *row >= outcome_->result->segments.size())) row.reset();
    row_ = row;
    rows_->markRow(row);
    pointOut(row);
}

void RecogniseViews::markStretch(double from_mm, double to_mm)
{
    pickAt((from_mm + to_mm) / 2);
    if (row_) return;
    plot::PointedOut stretch;
    stretch.shapes = {QPolygonF(QRectF(QPointF(from_mm, -beyondChart_um), QPointF(to_mm, beyondChart_um)))};
    meridian_->pointOut(stretch);
    residuals_->pointOut(stretch);
}

void RecogniseViews::pointOut(std::optional<std::size_t> row)
{
    plot::PointedOut contour, stretch;
    if (!outcome_ || !row || *row >= outcome_->result->segments.size()) {
        meridian_->pointOut(contour);
        residuals_->pointOut(stretch);
        return scene_->setMarker({});
    }
    const features::RecognizedRow& marked = outcome_->result->segments[*row];
    for (const double sign : {1.0, -1.0}) {
        QPolygonF line;
        for (const Eigen::Vector2d& point : features::contourOf(marked)) line << QPointF(point.x(), sign * point.y());
        contour.lines.push_back(std::move(line));
    }
    stretch.shapes = {
        QPolygonF(QRectF(QPointF(marked.z_start_mm, -beyondChart_um), QPointF(marked.z_end_mm, beyondChart_um)))};
    meridian_->pointOut(contour);
    residuals_->pointOut(stretch);
    const double z_mm = (marked.z_start_mm + marked.z_end_mm) / 2;
    const double radius_mm = (marked.start_diameter_mm + marked.end_diameter_mm) / 4;
    scene_->setMarker(outcome_->result->part_T_scan.inverse() * Eigen::Vector3d(0, radius_mm, z_mm),
                      tr("row %1: ⌀ %2").arg(*row + 1).arg(screenQuantity(marked.start_diameter_mm, millimetre, 3)));
}

Values RecogniseViews::view() const
{
    Values kept;
    if (std::vector<double> camera = scene_->view(); !camera.empty()) kept.emplace_back("camera", std::move(camera));
    return kept;
}

void RecogniseViews::restoreView(const Values& kept)
{
    if (const Value* camera = lathelier::find(kept, "camera"))
        if (const auto* numbers = std::get_if<std::vector<double>>(camera)) scene_->setView(*numbers);
}

void RecogniseViews::retranslate()
{
    primaryViews_->setTitle("meridian", tr("Meridian"));
    primaryViews_->setTitle("rows", tr("Rows"));
    primaryViews_->setTitle("part", tr("Part"));
    primaryViews_->setTitle("steps", tr("Table as published"));
    primaryViews_->setTitle("tables", tr("Numbers"));
    steps_->setAccessibleName(tr("Table as published"));
    numbers_->setAccessibleName(tr("Numbers"));
    synthetic_->setText(tr("Synthetic data"));
    synthetic_->setToolTip(tr("These points were computed, not measured."));
    shaft_->setText(tr("Use this shaft"));
    shaft_->setToolTip(tr("Keep it in the project, where other panels take it as an input"));
    found_->setText(tr("As recognised"));
    found_->setToolTip(tr("Takes back all changes of the rows"));
    rows_->retranslate();
    showScan();
    show();
    pointOut(row_);
}

}  // namespace lathelier::recognise_panel
