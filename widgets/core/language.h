// The language of the screen: translation of the engine's texts, numbers in the user's locale, switching at run time.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <vector>

#include "engine/core/texts.h"

class QTranslator;

namespace lathelier {

/// Units in which the window shows lengths, fields included. Files and the command line keep the engine's.
struct ScreenUnits {
    enum class Length { Millimetre, Inch } length = Length::Millimetre;  ///< unit of lengths given in mm by the engine
    enum class Form {
        Micrometre,
        Millimetre,
        Microinch
    } form = Form::Micrometre;  ///< unit of lengths given in µm by
                                ///< the engine
    friend bool operator==(const ScreenUnits&, const ScreenUnits&) = default;
};

ScreenUnits screenUnits();

/// All widgets receive QEvent::LanguageChange and update shown lengths.
void setScreenUnits(const ScreenUnits& units);

/// The engine's texts in the language of the screen (context "Engine"), numbers by QLocale().
Language screenLanguage();

QString screenText(Text english);
QString screenText(const Value& value);
QString screenText(const Error& error);
QString screenText(const Note& note);

/// The name of the file at `path` without its folder, with bidirectional and invisible characters made visible.
QString screenFileName(const QString& path);

/// `value` with `decimals` places in the user's locale, without group separators; empty for NaN or none.
QString screenNumber(double value, int decimals);

/// `value`, which the engine gives in `unit` with so many decimals, as it is shown: "+0.050 mm". `plus`: the sign of a
/// positive value is written too.
QString screenQuantity(double value, Text unit, int decimals, bool plus = false);

/// The same without the unit.
QString screenNumber(double value, Text unit, int decimals);

/// The display unit of `unit`.
QString screenUnit(Text unit);

/// Shown value / value in the engine's `unit`.
double screenFactor(Text unit);

/// Installs translators. Changing the language sends QEvent::LanguageChange to every widget.
class Languages : public QObject {
    Q_OBJECT
public:
    explicit Languages(QObject* parent = nullptr);
    ~Languages() override;

    static QStringList codes();                ///< the languages that ship, those of translations/: English first
    static QString name(const QString& code);  ///< in the language itself: "Polski"
    static QString systemCode();               ///< of codes(), the one the system asks for, else "en"

    /// Takes `code` of codes(); empty means the system's. Sets the default QLocale too: the system's locale when it has
    /// that language (to keep its number format), else that of the language.
    void use(const QString& code);
    QString current() const { return current_; }

private:
    std::vector<std::unique_ptr<QTranslator>> translators_;
    QString current_;
};

}  // namespace lathelier
