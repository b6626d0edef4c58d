// The command line of the desktop application.
#pragma once

#include <QString>
#include <QStringList>

namespace lathelier {

struct Arguments {
    QStringList files;  ///< a project, or data files for the active panel
    QString language;   ///< language; empty: from the settings
    QString report;     ///< write this file and leave; needs no display
    QString theme;      ///< of screenshots: "light", "dark"; empty: as the desktop
    QString shots;      ///< write screenshots into this folder and leave
    QString error;      ///< what is wrong with the command line; empty: nothing
    bool help = false;
    bool version = false;
};

/// `words` without the program's name.
Arguments parseArguments(const QStringList& words);

QString usage();

}  // namespace lathelier
