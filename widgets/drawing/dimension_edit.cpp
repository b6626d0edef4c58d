#include "widgets/drawing/dimension_edit.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"
#include "engine/core/units.h"

namespace lathelier::drawing_panel {
namespace {

using Of = drawing::DimensionTarget::Of;

constexpr double steepCone_deg = 10;  // cones steeper than this are dimensioned by their full angle, as in the drawing
constexpr int typedDecimals = 6;

struct DimensionEdit {
    Q_DECLARE_TR_FUNCTIONS(lathelier::drawing_panel::DimensionEdit)
};

QString number(double value)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    QString text = locale.toString(value, 'f', typedDecimals);
    while (text.endsWith('0')) text.chop(1);
    if (!text.isEmpty() && !text.back().isDigit()) text.chop(1);
    return text;
}

std::vector<double> numbersIn(const QString& typed)
{
    static const QRegularExpression one(R"([-−]?\d+(?:[.,]\d+)?|[-−]?[.,]\d+)");
    std::vector<double> all;
    for (auto found = one.globalMatch(typed); found.hasNext();) {
        QString text = found.next().captured();
        text.replace(',', '.').replace(QChar(0x2212), '-');
        all.push_back(text.toDouble());
    }
    return all;
}

double angle_deg(const ShaftSegment& row)
{
    return std::atan2(std::abs(row.end_diameter_mm - row.start_diameter_mm) / 2, row.length_mm) * deg_per_rad;
}

double lengthOf(const ShaftRows& rows, const std::vector<std::size_t>& numbers)
{
    double sum = 0;
    for (const std::size_t row : numbers) sum += rows[row].length_mm;
    return sum;
}

double bottomOf(const ShaftRows& rows, const std::vector<std::size_t>& numbers)
{
    double bottom = rows[numbers.front()].start_diameter_mm;
    for (const std::size_t row : numbers)
        bottom = std::min({bottom, rows[row].start_diameter_mm, rows[row].end_diameter_mm});
    return bottom;
}

}  // namespace

QString typedSize(const ShaftRows& rows, const drawing::DimensionTarget& target)
{
    const ShaftSegment& row = rows[target.rows.front()];
    switch (target.of) {
        case Of::Diameter: return number(row.start_diameter_mm);
        case Of::Length: return number(lengthOf(rows, target.rows));
        case Of::ArcRadius: return number(std::abs(row.arc_radius_mm.value_or(0)));
        case Of::Chamfer: return QString("%1 × %2").arg(number(row.length_mm), number(angle_deg(row)));
        case Of::Groove:
            return QString("%1 × %2").arg(number(lengthOf(rows, target.rows)), number(bottomOf(rows, target.rows)));
        case Of::Taper:
            if (angle_deg(row) >= steepCone_deg) return number(2 * angle_deg(row));
            return QString("1:%1").arg(number(row.length_mm / std::abs(row.end_diameter_mm - row.start_diameter_mm)));
        case Of::None: break;
    }
    return {};
}

QString typedBoreSize(const std::vector<ShaftBore>& bores, const drawing::DimensionTarget& target)
{
    const std::vector<BoreSegment>& rows = bores.at(*target.bore).segments;
    if (target.of == Of::Diameter) return number(rows.at(target.rows.front()).start_diameter_mm);
    double depth_mm = 0;
    for (std::size_t i = 0; i <= target.rows.back(); ++i) depth_mm += rows.at(i).length_mm;
    return number(depth_mm);
}

std::optional<double> typedNumber(const QString& typed)
{
    const std::vector<double> given = numbersIn(typed);
    return given.size() == 1 ? std::optional(given.front()) : std::nullopt;
}

QString typingHelp(const drawing::DimensionTarget& target)
{
    switch (target.of) {
        case Of::Diameter: return DimensionEdit::tr("Diameter in mm");
        case Of::Length: return DimensionEdit::tr("Length in mm");
        case Of::ArcRadius: return DimensionEdit::tr("Radius in mm");
        case Of::Chamfer: return DimensionEdit::tr("Leg in mm × angle in degrees; the leg alone keeps the angle");
        case Of::Groove: return DimensionEdit::tr("Width × diameter of the bottom in mm; the width alone keeps it");
        case Of::Taper: return DimensionEdit::tr("1:10, or the whole angle in degrees");
        case Of::None: break;
    }
    return {};
}

ShaftRows withTypedSize(ShaftRows rows, const drawing::DimensionTarget& target, const QString& typed, KeepAfter keep)
{
    const std::vector<double> given = numbersIn(typed);
    const bool pair = target.of == Of::Chamfer || target.of == Of::Groove || target.of == Of::Taper;
    if (given.empty() || given.size() > (pair ? 2U : 1U))
        throw Error(errors::valueNotUnderstood, {{"parameter", DimensionEdit::tr("Dimension").toStdString()},
                                                 {"found", typed.toStdString()},
                                                 {"expected", typingHelp(target).toStdString()}});
    const std::size_t first = target.rows.front(), last = target.rows.back();
    switch (target.of) {
        case Of::Diameter:
            for (const std::size_t row : target.rows) rows = setDiameter(std::move(rows), row, given[0]);
            return rows;
        case Of::Length:
            return first == 0 ? moveShoulder(std::move(rows), last, given[0], keep)
                              : setLength(std::move(rows), first, last, given[0], keep);
        case Of::ArcRadius: return setArcRadius(std::move(rows), first, given[0]);
        case Of::Chamfer: {
            const double angle = given.size() > 1 ? given[1] : angle_deg(rows[first]);
            return setChamfer(std::move(rows), first, given[0], angle);
        }
        case Of::Groove: {
            const double bottom = given.size() > 1 ? given[1] : bottomOf(rows, target.rows);
            return setGroove(std::move(rows), first, last, given[0], bottom);
        }
        case Of::Taper: {
            const double half = given.size() > 1 ? std::atan2(given[0] / 2, given[1]) * deg_per_rad : given[0] / 2;
            return setConeAngle(std::move(rows), first, half);
        }
        case Of::None: break;
    }
    return rows;
}

QString stepOf(const drawing::DimensionTarget& target)
{
    const int row = static_cast<int>(target.rows.front()) + 1;
    switch (target.of) {
        case Of::Diameter: return DimensionEdit::tr("Change the diameter of row %1").arg(row);
        case Of::Length: return DimensionEdit::tr("Change a length");
        case Of::ArcRadius: return DimensionEdit::tr("Change the radius of row %1").arg(row);
        case Of::Chamfer: return DimensionEdit::tr("Change the chamfer of row %1").arg(row);
        case Of::Groove: return DimensionEdit::tr("Change the groove of row %1").arg(row);
        case Of::Taper: return DimensionEdit::tr("Change the angle of row %1").arg(row);
        case Of::None: break;
    }
    return {};
}

}  // namespace lathelier::drawing_panel
