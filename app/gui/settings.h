// The user's settings, kept between runs.
#pragma once

#include <QString>
#include <QStringList>
#include <array>

#include "engine/core/conformity.h"
#include "widgets/core/language.h"

namespace lathelier {

struct Settings {
    QString language;             ///< "en", "pl"; empty: the system's
    QString theme;                ///< "light", "dark"; empty: the system's
    int presenter_percent = 150;  ///< type size in presenter mode
    QString decision = {};        ///< key of the decision rule that new evaluations begin with; empty: simple
    ScreenUnits units = {};       ///< in which lengths are shown
};

/// The rules that new evaluations may begin with.
inline constexpr std::array decisionRules{DecisionRule::Simple, DecisionRule::Guarded};

/// Keys of the units in the settings: "mm", "in"; "um", "mm", "uin".
QString unitKey(ScreenUnits::Length unit);
QString unitKey(ScreenUnits::Form unit);

Settings readSettings();
void writeSettings(const Settings& settings);

/// Project files, newest first, at most ten.
QStringList recentFiles();
void addRecentFile(const QString& path);

}  // namespace lathelier
