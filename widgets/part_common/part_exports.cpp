#include "widgets/part_common/part_exports.h"

#include <QBuffer>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgRenderer>

#include "engine/drawing/drawing_svg.h"

namespace lathelier::part_common {
namespace {

constexpr int resolution_dpi = 1200;

}  // namespace

std::string toPdf(const drawing::Drawing& drawing)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    const drawing::Box sheet = drawing::sheetBox(drawing.sheet);
    const bool lies = sheet.width_mm() > sheet.height_mm();
    writer.setTitle(QString::fromStdString(drawing.title));
    writer.setCreator("Lathelier");
    writer.setResolution(resolution_dpi);
    writer.setPageLayout(
        QPageLayout(QPageSize(drawing.sheet == drawing::Sheet::A3Landscape ? QPageSize::A3 : QPageSize::A4),
                    lies ? QPageLayout::Landscape : QPageLayout::Portrait, QMarginsF()));
    QPainter painter(&writer);
    QSvgRenderer svg(QByteArray::fromStdString(drawing::toSvg(drawing)));
    svg.render(&painter, QRectF(0, 0, writer.width(), writer.height()));
    painter.end();
    return buffer.data().toStdString();
}

}  // namespace lathelier::part_common
