#include "widgets/compare/place_words.h"

#include <QStringList>

#include "widgets/compare/compare_views.h"
#include "widgets/core/language.h"

namespace lathelier::compare_panel {

QString valueWords(const std::optional<double>& value_mm)
{
    return value_mm ? screenQuantity(*value_mm, millimetre, 3, true) : CompareViews::tr("left out");
}

QString flagWords(const cad::CompareFlag& flag)
{
    const QString value = valueWords(flag.value_mm);
    return flag.limit_mm ? CompareViews::tr("%1 (limit %2)").arg(value, screenNumber(*flag.limit_mm, millimetre, 3))
                         : value;
}

QString placeWords(const cad::ComparePlace& place)
{
    if (place.z_mm && place.angle_deg)
        return QString("z %1  ·  %2°")
            .arg(screenQuantity(*place.z_mm, millimetre, 1), screenNumber(*place.angle_deg, 0));
    return QString("%1 · %2 · %3")
        .arg(screenNumber(place.reference_mm.x(), millimetre, 1), screenNumber(place.reference_mm.y(), millimetre, 1),
             screenQuantity(place.reference_mm.z(), millimetre, 1));
}

QString allWords(const cad::ComparePlace& place)
{
    QStringList lines;
    if (place.deviation_mm)
        lines << CompareViews::tr("deviation %1").arg(valueWords(place.deviation_mm));
    else if (place.point || place.surface)
        lines << CompareViews::tr("this point was left out");
    if (place.local_mean_mm) lines << CompareViews::tr("mean around it %1").arg(valueWords(place.local_mean_mm));
    if (place.z_mm && place.angle_deg)
        lines << CompareViews::tr("along the axis %1, angle %2°")
                     .arg(screenQuantity(*place.z_mm, millimetre, 2), screenNumber(*place.angle_deg, 1));
    lines << QString("X %1   Y %2   Z %3")
                 .arg(screenNumber(place.reference_mm.x(), millimetre, 3),
                      screenNumber(place.reference_mm.y(), millimetre, 3),
                      screenQuantity(place.reference_mm.z(), millimetre, 3));
    return lines.join('\n');
}

}  // namespace lathelier::compare_panel
