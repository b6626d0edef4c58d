#include "widgets/core/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <atomic>

#include "engine/core/units.h"
#include "engine/core/visible.h"
#include "widgets/core/resources.h"

namespace lathelier {
namespace {

QLocale plainLocale()
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale;
}

std::atomic<ScreenUnits> chosenUnits{ScreenUnits{}};  // atomic, since reports are made in worker threads

ShownUnit lengthUnit()
{
    if (screenUnits().length == ScreenUnits::Length::Inch) return {LT_TEXT("Engine", "in"), 1 / mm_per_inch, 2};
    return {};
}

ShownUnit formUnit()
{
    switch (screenUnits().form) {
        case ScreenUnits::Form::Millimetre: return {unit::mm, 1e-3, 3};
        case ScreenUnits::Form::Microinch: return {LT_TEXT("Engine", "µin"), 1e3 / mm_per_inch, -1};
        case ScreenUnits::Form::Micrometre: break;
    }
    return {};
}

QString qtTranslations()
{
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
    return QLibraryInfo::path(QLibraryInfo::TranslationsPath);
#else
    return QLibraryInfo::location(QLibraryInfo::TranslationsPath);
#endif
}

}  // namespace

Language screenLanguage()
{
    return {[](const char* english) { return QCoreApplication::translate("Engine", english).toStdString(); },
            [](double value) { return plainLocale().toString(value, 'g', 6).toStdString(); },
            [](double value, int decimals) { return plainLocale().toString(value, 'f', decimals).toStdString(); },
            lengthUnit(), formUnit()};
}

QString screenText(Text english)
{
    return QString::fromStdString(text(english, screenLanguage()));
}
QString screenText(const Value& value)
{
    return QString::fromStdString(text(value, screenLanguage()));
}
QString screenFileName(const QString& path)
{
    return QString::fromStdString(visible(QFileInfo(path).fileName().toStdString()));
}
QString screenText(const Error& error)
{
    const QString sentence = QString::fromStdString(text(error, screenLanguage()));
    // of an earlier question, on which this one rests (engine/part)
    const Value* const place = find(error.values(), "of_place");
    const auto* const title = place ? std::get_if<Text>(place) : nullptr;
    return title ? screenText(*title) + QStringLiteral(": ") + sentence : sentence;
}
QString screenText(const Note& note)
{
    return QString::fromStdString(text(note, screenLanguage()));
}

QString screenNumber(double value, int decimals)
{
    return QString::fromStdString(fixed(value, decimals, screenLanguage()));
}

QString screenQuantity(double value, Text unit, int decimals, bool plus)
{
    const QString sign = plus && value > 0 ? QStringLiteral("+") : QString();
    return sign + screenNumber(value, unit, decimals) + ' ' + screenUnit(unit);
}

QString screenNumber(double value, Text unit, int decimals)
{
    return QString::fromStdString(shownNumber(value, unit, decimals, screenLanguage()));
}

QString screenUnit(Text unit)
{
    return screenText(shownUnit(unit, screenLanguage()).unit);
}

double screenFactor(Text unit)
{
    return shownUnit(unit, screenLanguage()).factor;
}

ScreenUnits screenUnits()
{
    return chosenUnits.load();
}

void setScreenUnits(const ScreenUnits& units)
{
    if (units == screenUnits()) return;
    chosenUnits = units;
    QEvent changed(QEvent::LanguageChange);
    if (QCoreApplication::instance()) QCoreApplication::sendEvent(QCoreApplication::instance(), &changed);
}

Languages::Languages(QObject* parent) : QObject(parent) {}
Languages::~Languages() = default;

QStringList Languages::codes()
{
    useResources();
    QStringList found;
    for (const QString& file : QDir(":/translations").entryList({"lathelier_*.qm"}, QDir::Files, QDir::Name))
        found << file.section('_', 1).section('.', 0, 0);
    found.removeAll("en");
    found.prepend("en");
    return found;
}

QString Languages::name(const QString& code)
{
    constexpr const char* context = "Languages";
    constexpr auto english = QT_TRANSLATE_NOOP("Languages", "English");
    QTranslator translator;
    if (!translator.load("lathelier_" + code, ":/translations")) return code;
    const QString own = translator.translate(context, english);
    return own.isEmpty() ? QString(english) : own;
}

QString Languages::systemCode()
{
    for (const QString& wanted : QLocale::system().uiLanguages())
        if (codes().contains(wanted.left(2))) return wanted.left(2);
    return "en";
}

void Languages::use(const QString& code)
{
    const QString chosen = codes().contains(code) ? code : systemCode();
    if (chosen == current_) return;
    current_ = chosen;

    // The locale is set first, since widgets use it while they retranslate.
    const QLocale system = QLocale::system();
    const QLocale own(chosen);
    QLocale::setDefault(system.language() == own.language() ? system : own);

    translators_.clear();
    const auto install = [&](const QString& file, const QString& folder) {
        auto translator = std::make_unique<QTranslator>();
        if (!translator->load(file, folder)) return;
        QCoreApplication::installTranslator(translator.get());
        translators_.push_back(std::move(translator));
    };
    install("qtbase_" + chosen, qtTranslations());
    install("lathelier_" + chosen, ":/translations");
}

}  // namespace lathelier
