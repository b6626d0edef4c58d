#include "widgets/core/icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QPixmapCache>
#include <QSvgRenderer>

namespace lathelier {
namespace {

/// Renders the SVG at the asked size with `currentColor` replaced by the palette's colour.
class TextColourIcon : public QIconEngine {
public:
    explicit TextColourIcon(QString name) : name_(std::move(name)) {}

    QIconEngine* clone() const override { return new TextColourIcon(*this); }

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        QFile file(":/icons/" + name_ + ".svg");
        if (!file.open(QIODevice::ReadOnly)) return;
        const QPalette palette = QGuiApplication::palette();
        const QPalette::ColorGroup group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        const QPalette::ColorRole role = mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::WindowText;
        QByteArray svg = file.readAll();
        const QColor& colour = palette.color(group, role);
        svg.replace("currentColor", colour.name().toLatin1());
        QSvgRenderer renderer(svg);
        if (colour.alpha() == 255) return renderer.render(painter, QRectF(rect));
        // Disabled colours of the theme are fainter by their opacity alone: of the whole picture, not of each stroke.
        QPixmap whole(rect.size());
        whole.fill(Qt::transparent);
        QPainter once(&whole);
        renderer.render(&once);
        once.end();
        painter->save();
        painter->setOpacity(colour.alphaF());
        painter->drawPixmap(rect, whole);
        painter->restore();
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        const QPalette palette = QGuiApplication::palette();
        const QString key = QString("lathelier/%1/%2x%3/%4/%5")
                                .arg(name_)
                                .arg(size.width())
                                .arg(size.height())
                                .arg(mode)
                                .arg(palette.cacheKey());
        QPixmap pixmap;
        if (QPixmapCache::find(key, &pixmap)) return pixmap;
        pixmap = QPixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        painter.end();
        QPixmapCache::insert(key, pixmap);
        return pixmap;
    }

private:
    QString name_;
};

}  // namespace

QIcon icon(const QString& name)
{
    return QIcon(new TextColourIcon(name));
}

}  // namespace lathelier
