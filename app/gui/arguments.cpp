#include "app/gui/arguments.h"

#include <QFileInfo>

#include "widgets/core/language.h"

namespace lathelier {

Arguments parseArguments(const QStringList& words)
{
    Arguments result;
    for (int i = 0; i < words.size(); ++i) {
        const QString& word = words[i];
        QString* value = word == "--report"     ? &result.report
                         : word == "--shots"    ? &result.shots
                         : word == "--language" ? &result.language
                         : word == "--theme"    ? &result.theme
                                                : nullptr;
        if (value && i + 1 < words.size())
            *value = words[++i];
        else if (value)
            result.error = word + " needs a value.";
        else if (word == "--help" || word == "-h")
            result.help = true;
        else if (word == "--version")
            result.version = true;
        else if (word.startsWith("--"))
            result.error = word + " is not known.";
        else
            result.files << word;
    }
    if (!result.language.isEmpty() && !Languages::codes().contains(result.language))
        result.error = "--language takes one of: " + Languages::codes().join(", ") + ".";
    if (!result.theme.isEmpty() && result.theme != "light" && result.theme != "dark")
        result.error = "--theme takes light or dark.";
    const QString suffix = QFileInfo(result.report).suffix().toLower();
    if (!result.report.isEmpty() && suffix != "pdf" && suffix != "html")
        result.error = "--report takes a file that ends in .pdf or .html.";
    if ((!result.report.isEmpty() || !result.shots.isEmpty()) && result.files.size() != 1 && result.error.isEmpty())
        result.error = "--report and --shots take one project.";
    return result;
}

QString usage()
{
    return "lathelier [FILES…|PROJECT] [--language " + Languages::codes().join('|') +
           "]\n"
           "lathelier --report FILE.pdf|FILE.html PROJECT    write the project's report, without a display\n"
           "lathelier --shots DIR [--theme light|dark] PROJECT\n"
           "                                                 write screenshots of the window and every panel\n"
           "lathelier --help | --version\n";
}

}  // namespace lathelier
