#include "widgets/plot/plot_canvas.h"

#include <qcustomplot.h>

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QMenu>
#include <QSaveFile>
#include <QSvgGenerator>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/plot/text_line.h"

namespace lathelier {

struct PlotCanvas::Parts {
    TextLine* title;
    TextLine* readout;
    QCPItemStraightLine* vertical;
    QCPItemStraightLine* horizontal;
    QString xTitle, yTitle;
    QPoint pressedAt;
    bool pressed = false;
    bool dragsContent = false;
    bool viewChosen = false;  ///< the user has zoomed or panned
};

PlotCanvas::PlotCanvas(QWidget* parent)
    : QWidget(parent), plot_(new QCustomPlot(this)), style_(palette(), font()), parts_(std::make_unique<Parts>())
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(plot_);
    setFocusPolicy(Qt::StrongFocus);
    plot_->setFocusProxy(this);
    plot_->setMouseTracking(true);
    plot_->setMinimumSize(40, 30);  // it cannot paint on nothing
    plot_->installEventFilter(this);
    plot_->setContextMenuPolicy(Qt::NoContextMenu);
    plot_->setPlottingHint(QCP::phFastPolylines);
    plot_->setNoAntialiasingOnDrag(true);
    plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);

    QCPLayoutGrid* grid = plot_->plotLayout();
    grid->setRowSpacing(0);
    grid->insertRow(0);
    grid->addElement(0, 0, parts_->title = new TextLine(plot_));
    parts_->readout = new TextLine(plot_);
    parts_->readout->setLayer("overlay");
    parts_->readout->coverTitle(parts_->title);
    plot_->axisRect()->insetLayout()->take(plot_->legend);
    plot_->axisRect()->setupFullAxesBox();
    plot_->legend->setFillOrder(QCPLegend::foColumnsFirst);
    plot_->legend->setBorderPen(Qt::NoPen);
    plot_->legend->setIconTextPadding(4);
    plot_->legend->setColumnSpacing(6);
    plot_->legend->setMargins(QMargins(6, 0, 6, 2));
    plot_->legend->setVisible(false);

    for (QCPItemStraightLine** line : {&parts_->vertical, &parts_->horizontal}) {
        *line = new QCPItemStraightLine(plot_);
        (*line)->setLayer("overlay");
        (*line)->setVisible(false);
        (*line)->setSelectable(false);
    }
    connect(plot_, &QCustomPlot::mousePress, this, &PlotCanvas::mousePressed);
    connect(plot_, &QCustomPlot::mouseMove, this, &PlotCanvas::mouseMoved);
    connect(plot_, &QCustomPlot::mouseRelease, this, &PlotCanvas::mouseReleased);
    connect(plot_, &QCustomPlot::mouseWheel, this, &PlotCanvas::mouseWheel);
    connect(plot_, &QCustomPlot::mouseDoubleClick, this, [this] { resetView(); });
}

PlotCanvas::~PlotCanvas() = default;

void PlotCanvas::setTitles(const QString& title, const QString& remark, const QString& x, const QString& y)
{
    parts_->title->set(title, remark);
    parts_->xTitle = x;
    parts_->yTitle = y;
    setAccessibleName(title);
}

void PlotCanvas::showLegend(bool shown)
{
    // Below the axes, so that it never covers a curve; out of the layout when empty, where it would narrow the column.
    QCPLayoutGrid* grid = plot_->plotLayout();
    const bool there = grid->hasElement(2, 0);
    if (shown && !there) {
        grid->addElement(2, 0, plot_->legend);
        grid->setRowStretchFactor(2, 0.001);
    } else if (!shown && there) {
        grid->take(plot_->legend);
        grid->simplify();
    }
    plot_->legend->setVisible(shown);
}

void PlotCanvas::leaveRoomInTitle(int pixels)
{
    parts_->title->leaveRoom(pixels);
}

void PlotCanvas::refresh(bool keepView)
{
    if (!keepView || !parts_->viewChosen) {
        parts_->viewChosen = false;
        fitRanges();
    }
    restyle(palette());
    redraw();
}

void PlotCanvas::redraw()
{
    // A hidden plot has nothing to paint on; it is drawn when it is shown.
    if (isVisible()) plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::drawOverlay()
{
    if (isVisible() && !plot_->size().isEmpty()) plot_->layer("overlay")->replot();
}

void PlotCanvas::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    fitTexts();
    redraw();
}

void PlotCanvas::resetView()
{
    parts_->viewChosen = false;
    fitRanges();
    redraw();
}

QRectF PlotCanvas::visibleRange() const
{
    const QCPRange x = plot_->xAxis->range();
    const QCPRange y = plot_->yAxis->range();
    return {x.lower, y.lower, x.size(), y.size()};
}

QPointF PlotCanvas::pixelAt(double x, double y) const
{
    return {plot_->xAxis->coordToPixel(x), plot_->yAxis->coordToPixel(y)};
}

QString PlotCanvas::readout() const
{
    return parts_->readout->text();
}

void PlotCanvas::restyle(const QPalette& palette)
{
    style_ = PlotStyle(palette, font());
    QFont bold = font();
    bold.setBold(true);
    parts_->title->setLook(bold, style_.text, Qt::AlignLeft);
    parts_->readout->setLook(font(), style_.text, Qt::AlignLeft);
    parts_->readout->setBackground(style_.background);
    plot_->setBackground(style_.background);
    QLocale spoken = locale();
    spoken.setNumberOptions(QLocale::OmitGroupSeparator);
    plot_->setLocale(spoken);
    for (QCPAxisRect* rect : plot_->axisRects())
        for (QCPAxis* axis : rect->axes()) {
            axis->setLabelFont(font());
            axis->setTickLabelFont(font());
            axis->setLabelColor(style_.text);
            axis->setTickLabelColor(style_.text);
            axis->setNumberFormat("g");
            for (auto set : {&QCPAxis::setBasePen, &QCPAxis::setTickPen, &QCPAxis::setSubTickPen})
                (axis->*set)(QPen(style_.text, 1));
            axis->grid()->setPen(QPen(style_.grid, 1));
            axis->grid()->setZeroLinePen(QPen(style_.text, 1));
        }
    for (QCPItemStraightLine* line : {parts_->vertical, parts_->horizontal})
        line->setPen(QPen(style_.text, 1, Qt::DotLine));
    plot_->legend->setFont(font());
    const int line = QFontMetrics(font()).height();
    plot_->legend->setIconSize(3 * line / 2, 3 * line / 4);
    plot_->legend->setTextColor(style_.text);
    plot_->legend->setBrush(style_.background);
    fitTexts();
    applyStyle();
}

void PlotCanvas::fitTexts()
{
    const QFontMetrics metrics(font());
    const auto fit = [&](QCPAxis* axis, const QString& title, int length, int tickLength) {
        axis->setLabel(metrics.elidedText(title, Qt::ElideRight, std::max(length, metrics.height() * 2)));
        axis->ticker()->setTickCount(std::clamp(length / std::max(tickLength, 1), 2, 9));
    };
    const int height = metrics.height();
    fit(plot_->xAxis, parts_->xTitle, width() - 6 * height - besideAxes(), 5 * height);
    fit(plot_->yAxis, parts_->yTitle, this->height() - 6 * height, 2 * height);
    int widest = 1;
    for (QCPLayoutElement* item : plot_->legend->elements(false))
        if (item) widest = std::max(widest, item->minimumOuterSizeHint().width() + plot_->legend->columnSpacing());
    plot_->legend->setWrap(std::max(1, (width() - 20) / widest));
    plot_->legend->setFillOrder(QCPLegend::foColumnsFirst, true);  // puts what is there already into the new columns
}

void PlotCanvas::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    switch (event->type()) {
        case QEvent::PaletteChange:
        case QEvent::FontChange:
        case QEvent::StyleChange:
        case QEvent::LocaleChange:
            restyle(palette());
            redraw();
            break;
        default: break;
    }
}

void PlotCanvas::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitTexts();
    redraw();  // the plot itself was resized before this event, with the old texts
}

bool PlotCanvas::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Leave) hideCrosshair();
    return QWidget::eventFilter(watched, event);
}

void PlotCanvas::hideCrosshair()
{
    parts_->vertical->setVisible(false);
    parts_->horizontal->setVisible(false);
    parts_->readout->set({});
    drawOverlay();
}

void PlotCanvas::mousePressed(QMouseEvent* event)
{
    setFocus(Qt::MouseFocusReason);
    if (event->button() != Qt::LeftButton) return;
    parts_->pressed = true;
    parts_->pressedAt = event->pos();
    parts_->dragsContent = beginDrag(event->pos());
    plot_->setInteraction(QCP::iRangeDrag, !parts_->dragsContent);
}

void PlotCanvas::mouseMoved(QMouseEvent* event)
{
    const double x = plot_->xAxis->pixelToCoord(event->pos().x());
    const double y = plot_->yAxis->pixelToCoord(event->pos().y());
    if (parts_->dragsContent) return continueDrag(x, y);
    if (parts_->pressed && (event->pos() - parts_->pressedAt).manhattanLength() > 3) parts_->viewChosen = true;
    if (!plot_->axisRect()->rect().contains(event->pos())) return hideCrosshair();
    Qt::CursorShape shape = Qt::CrossCursor;
    isHandle(event->pos(), shape);
    plot_->setCursor(shape);
    parts_->vertical->point1->setCoords(x, y);
    parts_->vertical->point2->setCoords(x, y + 1);
    parts_->horizontal->point1->setCoords(x, y);
    parts_->horizontal->point2->setCoords(x + 1, y);
    parts_->vertical->setVisible(true);
    parts_->horizontal->setVisible(true);
    parts_->readout->set(readoutAt(x, y));
    drawOverlay();
}

void PlotCanvas::mouseReleased(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !parts_->pressed) return;
    parts_->pressed = false;
    plot_->setInteraction(QCP::iRangeDrag, true);
    if (parts_->dragsContent) {
        parts_->dragsContent = false;
        return endDrag();
    }
    const bool still = (event->pos() - parts_->pressedAt).manhattanLength() <= 3;
    if (still && plot_->axisRect()->rect().contains(event->pos()))
        emit clicked(plot_->xAxis->pixelToCoord(event->pos().x()), plot_->yAxis->pixelToCoord(event->pos().y()));
}

void PlotCanvas::mouseWheel(QWheelEvent* event)
{
    // Over the numbers of one axis the wheel zooms this axis alone.
    const QRect inner = plot_->axisRect()->rect();
    const QPointF place = event->position();
    Qt::Orientations zoom = Qt::Horizontal | Qt::Vertical;
    if (place.y() > inner.bottom())
        zoom = Qt::Horizontal;
    else if (place.x() < inner.left())
        zoom = Qt::Vertical;
    plot_->axisRect()->setRangeZoom(zoom);
    parts_->viewChosen = true;
}

void PlotCanvas::keyPressEvent(QKeyEvent* event)
{
    const auto pan = [&](QCPAxis* axis, double share) { axis->moveRange(share * axis->range().size()); };
    const auto zoom = [&](double factor) {
        plot_->xAxis->scaleRange(factor);
        plot_->yAxis->scaleRange(factor);
    };
    switch (event->key()) {
        case Qt::Key_Left: pan(plot_->xAxis, -0.1); break;
        case Qt::Key_Right: pan(plot_->xAxis, 0.1); break;
        case Qt::Key_Up: pan(plot_->yAxis, 0.1); break;
        case Qt::Key_Down: pan(plot_->yAxis, -0.1); break;
        case Qt::Key_Plus: zoom(0.8); break;
        case Qt::Key_Minus: zoom(1.25); break;
        case Qt::Key_Home: return resetView();
        default: return QWidget::keyPressEvent(event);
    }
    parts_->viewChosen = true;
    plot_->replot();
}

void PlotCanvas::contextMenuEvent(QContextMenuEvent* event)
{
    QMenu menu(this);
    fillMenu(menu);
    menu.exec(event->globalPos());
}

void PlotCanvas::fillMenu(QMenu& menu)
{
    menu.addAction(tr("Copy picture"), this, [this] { QApplication::clipboard()->setImage(picture()); });
    menu.addAction(tr("Save picture…"), this, &PlotCanvas::askAndSavePicture);
    menu.addAction(tr("Save data as CSV…"), this, &PlotCanvas::askAndSaveData);
    menu.addSeparator();
    menu.addAction(tr("Show all"), this, &PlotCanvas::resetView);
}

void PlotCanvas::askAndSavePicture()
{
    const QString path = QFileDialog::getSaveFileName(this, tr("Save picture"), accessibleName() + ".svg",
                                                      tr("Scalable picture (*.svg);;PDF (*.pdf);;Picture (*.png)"));
    if (!path.isEmpty() && !savePicture(path)) emit notWritten(path);
}

void PlotCanvas::askAndSaveData()
{
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save data"), accessibleName() + ".csv", tr("Table (*.csv)"));
    if (!path.isEmpty() && !saveData(path)) emit notWritten(path);
}

QImage PlotCanvas::picture(double scale)
{
    hideCrosshair();
    restyle(paperPalette());
    const QImage image = plot_->toPixmap(width(), height(), scale).toImage();
    restyle(palette());
    redraw();
    return image;
}

bool PlotCanvas::savePicture(const QString& path)
{
    if (path.endsWith(".png", Qt::CaseInsensitive)) return picture().save(path);
    hideCrosshair();
    restyle(paperPalette());
    bool done = false;
    if (path.endsWith(".pdf", Qt::CaseInsensitive)) {
        done = plot_->savePdf(path, width(), height(), QCP::epAllowCosmetic, {}, accessibleName());
    } else {
        QSvgGenerator generator;
        generator.setFileName(path);
        generator.setTitle(accessibleName());
        generator.setSize(size());
        generator.setViewBox(rect());
        QCPPainter painter;
        done = painter.begin(&generator);
        if (done) {
            painter.setMode(QCPPainter::pmVectorized);
            plot_->toPainter(&painter, width(), height());
            done = painter.end();
        }
    }
    restyle(palette());
    redraw();
    return done;
}

bool PlotCanvas::saveData(const QString& path) const
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return false;
    file.write(csv().toUtf8());
    return file.commit();
}

}  // namespace lathelier
