#include "app/gui/settings.h"

#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <initializer_list>

#include "engine/core/conformity.h"

namespace lathelier {
namespace {

constexpr int recentCount = 10;

/// The unit of this key; the engine's for another.
template <class Unit>
Unit unitOf(const QString& key, std::initializer_list<Unit> units)
{
    for (const Unit unit : units)
        if (unitKey(unit) == key) return unit;
    return *units.begin();
}

}  // namespace

QString unitKey(ScreenUnits::Length unit)
{
    return unit == ScreenUnits::Length::Inch ? QStringLiteral("in") : QStringLiteral("mm");
}

QString unitKey(ScreenUnits::Form unit)
{
    switch (unit) {
        case ScreenUnits::Form::Millimetre: return QStringLiteral("mm");
        case ScreenUnits::Form::Microinch: return QStringLiteral("uin");
        case ScreenUnits::Form::Micrometre: break;
    }
    return QStringLiteral("um");
}

Settings readSettings()
{
    const QSettings stored;
    Settings result;
    result.language = stored.value("language").toString();
    result.theme = stored.value("theme").toString();
    result.presenter_percent =
        std::clamp(stored.value("presenter_percent", result.presenter_percent).toInt(), 100, 300);
    const QString decision = stored.value("decision").toString();
    for (const DecisionRule rule : decisionRules)
        if (decision.toStdString() == key(rule)) result.decision = decision;
    using Length = ScreenUnits::Length;
    using FormUnit = ScreenUnits::Form;
    result.units.length = unitOf(stored.value("length_unit").toString(), {Length::Millimetre, Length::Inch});
    result.units.form =
        unitOf(stored.value("form_unit").toString(), {FormUnit::Micrometre, FormUnit::Millimetre, FormUnit::Microinch});
    return result;
}

void writeSettings(const Settings& settings)
{
    QSettings stored;
    stored.setValue("language", settings.language);
    stored.setValue("theme", settings.theme);
    stored.setValue("presenter_percent", settings.presenter_percent);
    stored.setValue("decision", settings.decision);
    stored.setValue("length_unit", unitKey(settings.units.length));
    stored.setValue("form_unit", unitKey(settings.units.form));
}

QStringList recentFiles()
{
    return QSettings().value("recent").toStringList();
}

void addRecentFile(const QString& path)
{
    QStringList files = recentFiles();
    const QString whole = QFileInfo(path).absoluteFilePath();
    files.removeAll(whole);
    files.prepend(whole);
    QSettings().setValue("recent", QStringList(files.mid(0, recentCount)));
}

}  // namespace lathelier
