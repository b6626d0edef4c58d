#include "widgets/drawing/drawing_views.h"

#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "engine/drawing/meridian_chart.h"
#include "widgets/core/language.h"
#include "widgets/drawing/dimension_edit.h"

namespace lathelier::drawing_panel {
namespace {

constexpr double shoulderDragStep_mm = 0.1;

}  // namespace

DrawingViews::DrawingViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      sheet_(new SheetView),
      meridian_(new part_common::RowChart),
      rows_(new CopyTable),
      measured_(new CopyTable),
      remarks_(new CopyTable),
      buttons_(new QWidget),
      shaft_(new QToolButton),
      fit_(new QToolButton),
      bore_(new QToolButton)
{
    sheet_->setObjectName("sheet");
    meridian_->setObjectName("meridian");
    rows_->setObjectName("rows");
    measured_->setObjectName("measured");
    remarks_->setObjectName("remarks");
    shaft_->setObjectName("useShaft");
    fit_->setObjectName("wholeSheet");
    rows_->setSelectionMode(QAbstractItemView::SingleSelection);
    primaryViews_->add("sheet", sheet_);
    primaryViews_->add("rows", rows_);
    primaryViews_->add("meridian", meridian_);
    primaryViews_->add("measured", measured_);
    primaryViews_->add("remarks", remarks_);
    remarks_->setWordWrap(true);
    auto* row = new QHBoxLayout(buttons_);
    row->setContentsMargins(0, 0, 0, 0);
    bore_->setObjectName("addBore");
    bore_->setPopupMode(QToolButton::InstantPopup);
    bore_->setMenu(new QMenu(bore_));
    for (const ShaftEnd end : {ShaftEnd::Free, ShaftEnd::Chuck})
        connect(bore_->menu()->addAction(QString()), &QAction::triggered, this, [this, end] { addBore(end); });
    row->addWidget(shaft_);
    row->addWidget(bore_);
    row->addStretch();
    row->addWidget(fit_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(buttons_);
    layout->addWidget(primaryViews_, 1);
    connect(shaft_, &QToolButton::clicked, this, &DrawingViews::shaftRequested);
    connect(fit_, &QToolButton::clicked, sheet_, &SheetView::fit);
    connect(sheet_, &SheetView::rowClicked, this,
            [this](int at) { markRow(at < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(at))); });
    connect(sheet_, &SheetView::menuRequested, this, [this](int at, double z_mm, const QPoint& global) {
        const auto index = static_cast<std::size_t>(at);
        markRow(index);
        QMenu menu(this);
        part_common::addRowVerbs(menu, at + 1, verbsOf(index, z_mm));
        menu.exec(global);
    });
    connect(sheet_, &SheetView::dimensionActivated, this, [this](int label) {
        const auto index = static_cast<std::size_t>(label);
        const drawing::DimensionTarget& target = drawing_.labels[index].target;
        sheet_->editDimension(
            index,
            target.bore ? typedBoreSize(outcome_->shaft.bores, target) : typedSize(outcome_->shaft.segments, target),
            typingHelp(target));
    });
    connect(sheet_, &SheetView::dimensionTyped, this, &DrawingViews::typeDimension);
    connect(sheet_, &SheetView::rowKeyPressed, this, &DrawingViews::pressKey);
    connect(meridian_, &plot::PlotCanvas::clicked, this, [this](double z_mm, double) { pickAt(z_mm); });
    connect(meridian_, &plot::PlotWidget::notWritten, this, &DrawingViews::notWritten);
    connect(meridian_, &plot::ChartView::handleMoved, this,
            [this](const QString& key, double z_mm, double, bool dropped) { dragShoulder(key, z_mm, dropped); });
    connect(meridian_, &part_common::RowChart::menuOpened, this, [this](QMenu* menu, double z_mm) {
        const bool here = outcome_ && z_mm >= 0 && z_mm <= outcome_->shaft.length_mm();
        if (here) pickAt(z_mm);
        if (!row_) return;
        part_common::addRowVerbs(*menu, static_cast<int>(*row_) + 1,
                                 verbsOf(*row_, here ? std::optional(z_mm) : std::nullopt));
    });
    connect(rows_, &QTableWidget::currentCellChanged, this, [this](int at) {
        const bool outside = outcome_ && at >= 0 && at < static_cast<int>(outcome_->shaft.segments.size());
        row_ = outside ? std::optional(static_cast<std::size_t>(at)) : std::nullopt;
        showMark();
    });
    rows_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    connect(rows_, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* cell) { typeBoreCell(*cell); });
    rows_->installEventFilter(this);
    rows_->viewport()->installEventFilter(this);
    meridian_->installEventFilter(this);
    retranslate();
}

void DrawingViews::setOutcome(const std::shared_ptr<const cad::DrawOutcome>& outcome)
{
    outcome_ = outcome;
    show();
}

void DrawingViews::show()
{
    if (!outcome_) return;
    const Shaft& shaft = outcome_->shaft;
    drawing_ = drawingOf(*outcome_, screenLanguage());
    sheet_->setDrawing(drawing_);
    sheet_->setAccessibleName(QString::fromStdString(drawing_.title));
    std::vector<QPolygonF> contours;
    for (std::size_t i = 0; i < shaft.segments.size(); ++i) {
        QPolygonF line;
        for (const Eigen::Vector2d& point : drawing::contourOfRow(shaft, i)) line << QPointF(point.x(), point.y());
        contours.push_back(std::move(line));
    }
    sheet_->setRows(std::move(contours));
    meridian_->setData(drawing::meridianChart(shaft));
    showBoreButton();
    {
        const QSignalBlocker quiet(rows_);
        rows_->setTable(rowsTable(*outcome_, screenLanguage()));
        openBoreCells();
    }
    const report::Table measured = measuredTable(*outcome_, screenLanguage());
    primaryViews_->setAvailable("measured", !measured.rows.empty());
    measured_->setTable(measured);
    remarks_->setTable(remarksTable(*outcome_, screenLanguage()));
    remarks_->resizeRowsToContents();
    markRow(row_);
}

void DrawingViews::markRow(std::optional<std::size_t> row)
{
    if (!outcome_ || (row && *row >= outcome_->shaft.segments.size())) row.reset();
    row_ = row;
    {
        const QSignalBlocker quiet(rows_);
        if (row)
            rows_->setCurrentCell(static_cast<int>(*row), 0);
        else
            rows_->setCurrentCell(-1, -1);
    }
    showMark();
}

void DrawingViews::showMark()
{
    sheet_->markRow(row_);
    plot::PointedOut marked;
    if (outcome_ && row_)
        for (const double side : {1.0, -1.0}) {
            QPolygonF line;
            for (const Eigen::Vector2d& point : drawing::contourOfRow(outcome_->shaft, *row_))
                line << QPointF(point.x(), side * point.y());
            marked.lines.push_back(std::move(line));
        }
    meridian_->pointOut(marked);
}

void DrawingViews::pickAt(double z_mm)
{
    if (!outcome_) return;
    double from_mm = 0;
    const ShaftRows& rows = outcome_->shaft.segments;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (z_mm >= from_mm && z_mm <= from_mm + rows[i].length_mm) return markRow(i);
        from_mm += rows[i].length_mm;
    }
    markRow({});
}

void DrawingViews::markStretch(double from_mm, double to_mm)
{
    pickAt((from_mm + to_mm) / 2);
}

KeepAfter DrawingViews::keep() const
{
    return outcome_->question.lengths == drawing::LengthsFrom::Datum ? KeepAfter::Places : KeepAfter::Lengths;
}

part_common::RowVerbs DrawingViews::verbsOf(std::size_t row, std::optional<double> z_mm)
{
    part_common::RowVerbs verbs;
    if (!outcome_ || row >= outcome_->shaft.segments.size()) return verbs;
    const ShaftRows rows = outcome_->shaft.segments;
    const int number = static_cast<int>(row) + 1;
    const KeepAfter kept = keep();
    if (rows.size() > 1)
        verbs.remove = [=, this] {
            edit(tr("Delete row %1").arg(number), [=](ShaftRows all) { return deleteRow(std::move(all), row, kept); });
        };
    if (row + 1 < rows.size())
        verbs.merge = [=, this] {
            edit(tr("Merge rows %1 and %2").arg(number).arg(number + 1),
                 [=](ShaftRows all) { return mergeWithNext(std::move(all), row); });
        };
    const double length = rows[row].length_mm, start = startOf_mm(rows, row);
    double cut = z_mm ? std::round((*z_mm - start) / shoulderDragStep_mm) * shoulderDragStep_mm : length / 2;
    if (!(cut > 0 && cut < length)) cut = length / 2;
    if (length > 0)
        verbs.split = [=, this] {
            edit(tr("Split row %1").arg(number), [=](ShaftRows all) { return splitRow(std::move(all), row, cut); });
        };
    verbs.forms = {RowForm::Cylinder, RowForm::Cone,   RowForm::Chamfer,
                   RowForm::Round,    RowForm::Fillet, RowForm::Groove};
    verbs.now = part_common::formOf(rows[row]);
    if (length > 0)
        verbs.change = [=, this](RowForm form) {
            edit(tr("Make row %1 a %2").arg(number).arg(part_common::formName(form).toLower()),
                 [=](ShaftRows all) { return changeForm(std::move(all), row, form); });
        };
    if (!isCylinder(rows[row])) return verbs;
    const std::vector<std::size_t> tied = tiedTo(rows, row);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i == row || !isCylinder(rows[i]) || std::find(tied.begin(), tied.end(), i) != tied.end()) continue;
        verbs.ties.emplace_back(
            tr("row %1, ⌀ %2").arg(i + 1).arg(screenQuantity(rows[i].start_diameter_mm, millimetre, 3)), [=, this] {
                edit(tr("Row %1 as wide as row %2").arg(number).arg(i + 1),
                     [=](ShaftRows all) { return tieDiameters(std::move(all), row, i); });
            });
    }
    if (!tied.empty())
        verbs.untie = [=, this] {
            edit(tr("Free the diameter of row %1").arg(number),
                 [=](ShaftRows all) { return untieDiameter(std::move(all), row); });
        };
    return verbs;
}

void DrawingViews::typeDimension(int label, const QString& text)
{
    if (!outcome_ || label < 0 || label >= static_cast<int>(drawing_.labels.size())) return;
    const drawing::DimensionTarget target = drawing_.labels[static_cast<std::size_t>(label)].target;
    if (target.bore) return typeBore(target, text);
    const KeepAfter kept = keep();
    edit(stepOf(target), [=](ShaftRows all) {
        // Unchanged values keep full precision.
        if (typedSize(all, target) == text) return all;
        return withTypedSize(std::move(all), target, text, kept);
    });
}

void DrawingViews::dragShoulder(const QString& key, double z_mm, bool dropped)
{
    const auto row = drawing::rowOfShoulder(key.toStdString());
    if (!outcome_ || !row || *row >= outcome_->shaft.segments.size()) return;
    if (!dragged_) dragged_ = outcome_->shaft.segments;
    const double rounded_mm = std::round(z_mm / shoulderDragStep_mm) * shoulderDragStep_mm;
    const KeepAfter kept = keep();
    emit editRequested(
        tr("Move the shoulder behind row %1").arg(*row + 1),
        [before = *dragged_, row = *row, rounded_mm, kept](ShaftRows now) {
            try {
                return moveShoulder(before, row, rounded_mm, kept);
            } catch (const Error&) {  // beyond the next shoulder: keeps the last valid position
                return now;
            }
        },
        QString("drawing/shoulder/%1").arg(drags_));
    if (!dropped) return;
    dragged_.reset();
    ++drags_;
}

void DrawingViews::pressKey(QKeyEvent* event)
{
    if (row_ && part_common::pressRowKey(*event, verbsOf(*row_))) return event->accept();
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_F2;
    if (!row_ || !enter || primaryViews_->primary() != "sheet") return;
    for (std::size_t i = 0; i < drawing_.labels.size(); ++i) {
        const drawing::DimensionTarget& target = drawing_.labels[i].target;
        if (target.bore || target.of == drawing::DimensionTarget::Of::None ||
            target.of == drawing::DimensionTarget::Of::Length)
            continue;
        if (std::find(target.rows.begin(), target.rows.end(), *row_) == target.rows.end()) continue;
        emit sheet_->dimensionActivated(static_cast<int>(i));
        return event->accept();
    }
}

void DrawingViews::openTableMenu(int row, const QPoint& global)
{
    QMenu menu(this);
    if (boreAt(row))
        addBoreVerbs(menu, row);
    else
        part_common::addRowVerbs(menu, row + 1, verbsOf(static_cast<std::size_t>(row)));
    menu.addSeparator();
    menu.addAction(CopyTable::tr("Copy"), this, [this] { rows_->copyToClipboard(); });
    menu.exec(global);
}

/// Keys and menus of rows in the table and in the meridian; the sheet emits signals for them.
bool DrawingViews::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress && (watched == rows_ || watched == meridian_)) {
        auto* const key = static_cast<QKeyEvent*>(event);
        if (row_ && part_common::pressRowKey(*key, verbsOf(*row_))) return true;
        const auto bore = watched == rows_ ? boreAt(rows_->currentRow()) : std::nullopt;
        if (bore && key->key() == Qt::Key_Delete) {
            deleteBore(*bore);
            return true;
        }
    }
    if (event->type() == QEvent::ContextMenu && watched == rows_->viewport()) {
        const auto* const request = static_cast<QContextMenuEvent*>(event);
        const bool by_key = request->reason() == QContextMenuEvent::Keyboard;
        const int row = by_key ? rows_->currentRow() : rows_->rowAt(request->pos().y());
        if (outcome_ && row >= 0 && (boreAt(row) || row < static_cast<int>(outcome_->shaft.segments.size()))) {
            openTableMenu(row, request->globalPos());
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void DrawingViews::setPresenting(bool presenting)
{
    buttons_->setVisible(!presenting);
}

void DrawingViews::retranslate()
{
    primaryViews_->setTitle("sheet", tr("Drawing"));
    primaryViews_->setTitle("rows", tr("Rows"));
    primaryViews_->setTitle("meridian", tr("Meridian"));
    primaryViews_->setTitle("measured", tr("Measured − nominal"));
    primaryViews_->setTitle("remarks", tr("Remarks"));
    rows_->setAccessibleName(tr("Rows"));
    measured_->setAccessibleName(tr("Measured − nominal"));
    remarks_->setAccessibleName(tr("Remarks"));
    shaft_->setText(tr("Use this shaft"));
    shaft_->setToolTip(tr("Keep it in the project, where other panels take it as an input"));
    bore_->setText(tr("Add a bore"));
    showBoreButton();
    bore_->menu()->actions().value(0)->setText(tr("From the free end"));
    bore_->menu()->actions().value(1)->setText(tr("From the chuck end"));
    fit_->setText(tr("Whole sheet"));
    fit_->setToolTip(
        tr("The wheel enlarges the drawing, dragging moves it. A click lights a row, a double click on a dimension "
           "changes it, the right button shows what can be done with a row."));
    show();
}

}  // namespace lathelier::drawing_panel
