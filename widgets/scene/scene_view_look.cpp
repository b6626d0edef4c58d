// Appearance of a SceneView: overlays, colours, and the image for a report.
#include <QApplication>
#include <QBuffer>
#include <QClipboard>
#include <QEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <cmath>

#include "engine/core/error.h"
#include "engine/io/file.h"
#include "widgets/core/panel/view_frame.h"
#include "widgets/plot/plot_style.h"
#include "widgets/scene/scene_parts.h"

namespace lathelier::scene {
namespace {

// A picture for paper: 170 mm wide at 270 dpi, its words as large as those of the plots.
constexpr int paperWide_px = 900;
constexpr int paperHigh_px = 420;
constexpr double paperDetail = 2;

}  // namespace

void SceneView::placeOverlays()
{
    Parts& p = *parts_;
    if (!canDraw()) return;
    const QSize room = p.canvas->size();
    p.ruler->resize(p.ruler->sizeHint());
    p.ruler->move(6, room.height() - p.ruler->height() - 4);
    p.ruler->setCamera(p.camera(), room.height());
    p.flags->setGeometry(p.canvas->rect());
    p.flags->setCamera(p.camera());
    const bool is_labelled = p.marked && !p.label->text().isEmpty() && !property(ViewFrame::smallView).toBool();
    p.label->setVisible(is_labelled);
    if (is_labelled) {
        p.label->adjustSize();
        p.label->move(room.width() - p.label->width() - 8, 8);  // the standard oblique view leaves this corner free
    }
    const auto place = p.marked ? pixelAt(*p.marked) : std::nullopt;
    p.cross->setVisible(place.has_value());
    if (place) {
        p.cross->adjustSize();
        const QPoint centre = p.canvas->mapFrom(this, place->toPoint());
        p.cross->move(centre - p.cross->rect().center());
    }
}

std::optional<QPointF> SceneView::pixelAt(const Eigen::Vector3d& place_mm) const
{
    if (!canDraw()) return std::nullopt;
    const auto place = parts_->camera().project(place_mm);
    if (!place) return std::nullopt;
    const QSize room = parts_->canvas->size();
    const QPointF inside((place->x() + 1) / 2 * room.width(), (1 - place->y()) / 2 * room.height());
    return parts_->canvas->mapTo(const_cast<SceneView*>(this), QPoint(0, 0)) + inside;
}

void SceneView::applyStyle(bool paper)
{
    Parts& p = *parts_;
    if (!canDraw()) return;
    const QColor back = paper ? QColor(Qt::white) : QWidget::palette().color(QPalette::Base);
    p.canvas->renderer().SetBackground(back.redF(), back.greenF(), back.blueF());
    const QPalette inks = paper ? plot::paperPalette() : QWidget::palette();
    const plot::PlotStyle style(inks, font());
    QFont large = font();
    large.setPointSizeF(1.6 * large.pointSizeF());
    p.cross->setFont(large);
    for (QWidget* part :
         {static_cast<QWidget*>(p.ruler), static_cast<QWidget*>(p.legend), static_cast<QWidget*>(p.flags)}) {
        QPalette palette = inks;
        palette.setColor(QPalette::WindowText, style.text);
        palette.setColor(QPalette::Window, style.background);
        part->setPalette(palette);
    }
    QPalette mark = inks;
    mark.setColor(QPalette::WindowText, style.marker);
    p.cross->setPalette(mark);
}

void SceneView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange && event->type() != QEvent::FontChange) return;
    applyStyle(false);
    render();
}

void SceneView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (canDraw() && parts_->aimed && parts_->standing) setViewpoint(*parts_->standing);
    placeOverlays();
}

QImage SceneView::paperPicture(std::optional<SceneViewpoint> viewpoint)
{
    Parts& p = *parts_;
    if (!canDraw()) return {};
    const QRect place = p.canvas->geometry();
    const QSize legend = p.legend->size();
    const bool updates = updatesEnabled();
    setUpdatesEnabled(false);
    p.canvas->resize(paperWide_px, paperHigh_px);
    p.legend->resize(p.legend->sizeHint().width(), paperHigh_px);
    endMoving();  // which sets the detail
    p.canvas->setDetail(paperDetail / p.canvas->devicePixelRatioF());
    QImage image = picture(viewpoint, true, false);
    p.canvas->setDetail(1);
    p.canvas->setGeometry(place);
    p.legend->resize(legend);
    placeOverlays();
    setUpdatesEnabled(updates);
    render();
    return image;
}

QImage SceneView::picture(std::optional<SceneViewpoint> viewpoint, bool legend, bool marks)
{
    Parts& p = *parts_;
    if (!canDraw() || p.canvas->size().isEmpty()) return {};
    const SceneCamera before = p.camera();
    const auto standing = p.standing;
    const bool legendShown = p.legend->isVisibleTo(this);
    endMoving();
    applyStyle(true);
    if (!legend) p.legend->hide();
    if (viewpoint) setViewpoint(*viewpoint);
    placeOverlays();
    const QImage drawn = p.canvas->drawNow();
    const double scale = static_cast<double>(drawn.width()) / p.canvas->width();
    const int beside = p.legend->isVisibleTo(this) ? p.legend->width() : 0;
    QImage image(static_cast<int>((p.canvas->width() + beside) * scale), drawn.height(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.drawImage(0, 0, drawn);
    painter.scale(scale, scale);
    std::vector<QWidget*> shown{p.flags, p.ruler};
    if (marks) shown.insert(shown.end(), {p.label, p.cross});
    for (QWidget* over : shown)
        if (over->isVisibleTo(p.canvas)) over->render(&painter, over->pos(), {}, QWidget::DrawChildren);
    if (beside) p.legend->render(&painter, QPoint(p.canvas->width(), 0), {}, {});
    painter.end();
    p.legend->setVisible(legendShown);
    applyStyle(false);
    p.aim(before);
    p.standing = standing;
    render();
    return image;
}

void SceneView::savePicture(const QString& path)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    picture().save(&buffer, "PNG");
    io::writeFile(path.toStdString(), std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

void SceneView::showMenu(const QPoint& place)
{
    QMenu menu(this);
    menu.addAction(tr("Copy picture"), this, [this] { QApplication::clipboard()->setImage(picture()); });
    menu.addAction(tr("Save picture…"), this, [this] {
        const QString path =
            QFileDialog::getSaveFileName(this, tr("Save picture"), tr("3-D view") + ".png", tr("Picture (*.png)"));
        if (path.isEmpty()) return;
        try {
            savePicture(path);
        } catch (const Error&) {
            emit notWritten(path);
        }
    });
    menu.addSeparator();
    menu.addAction(tr("Show all"), this, [this] { setViewpoint(SceneViewpoint::Oblique); });
    menu.exec(parts_->canvas->mapToGlobal(place));
}

}  // namespace lathelier::scene
