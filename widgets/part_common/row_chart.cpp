#include "widgets/part_common/row_chart.h"

#include <QCursor>

namespace lathelier::part_common {

void RowChart::addToMenu(QMenu& menu)
{
    const double zero_px = pixelAt(0, 0).x(), one_px = pixelAt(1, 0).x();
    const double at_px = mapFromGlobal(QCursor::pos()).x();
    emit menuOpened(&menu, (at_px - zero_px) / (one_px - zero_px));
}

}  // namespace lathelier::part_common
