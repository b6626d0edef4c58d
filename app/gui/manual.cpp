#include "app/gui/manual.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QStringList>
#include <QTextDocument>
#include <algorithm>

namespace lathelier {
namespace {

constexpr const char* manualFolder = ":/manual";
constexpr const char* completeLanguage = "en";  ///< the one that has every page

/// Empty where there is none.
QString readPage(const QString& language, const QString& name)
{
    QFile file(QString("%1/%2/%3.md").arg(manualFolder, language, name));
    if (!file.open(QIODevice::ReadOnly)) return {};
    static const QRegularExpression unit("(?<=\\d) (?=(%|mm|µm|km|UPR|MiB|GiB|V|s)(?!\\w))");
    return QString::fromUtf8(file.readAll()).replace(unit, QChar(QChar::Nbsp));  // no line ends between the two
}

QString titleOf(const QString& markdown)
{
    for (const QString& line : markdown.split('\n'))
        if (line.startsWith("# ")) return line.mid(2).trimmed();
    return {};
}

QString textOf(const QString& markdown)
{
    QTextDocument document;
    document.setMarkdown(markdown);
    return document.toPlainText();
}

/// The letter without accents in lower case, one character each, so that positions are unchanged.
QChar plainLetter(QChar letter)
{
    const QString parts = letter.decomposition();
    if (!parts.isEmpty() && parts[0].isLetter()) letter = parts[0];
    letter = letter.toLower();
    return letter == QChar(0x142) ? QChar('l') : letter;  // ł is no l with an accent to Unicode
}

QString plainLetters(QString text)
{
    std::transform(text.begin(), text.end(), text.begin(), plainLetter);
    return text;
}

}  // namespace

Manual::Manual(const QString& language)
{
    QStringList names{indexName};
    const auto add = [&](const QString& name) {
        if (!names.contains(name)) names << name;
    };
    for (const QString& name : linkedPages(readPage(completeLanguage, indexName))) add(name);
    for (const QString& file : QDir(QString("%1/%2").arg(manualFolder, completeLanguage)).entryList({"*.md"}))
        add(file.chopped(3));
    for (const QString& name : names) {
        QString markdown = readPage(language, name);
        if (markdown.isEmpty()) markdown = readPage(completeLanguage, name);
        if (!markdown.isEmpty()) pages_.push_back({name, titleOf(markdown), markdown, textOf(markdown)});
    }
}

const ManualPage& Manual::page(const QString& name) const
{
    static const ManualPage none;  // a program without its resources
    const auto found =
        std::find_if(pages_.begin(), pages_.end(), [&](const ManualPage& page) { return page.name == name; });
    if (found != pages_.end()) return *found;
    return pages_.empty() ? none : pages_.front();
}

std::vector<QString> linkedPages(const QString& markdown)
{
    static const QRegularExpression link("\\]\\(([^)\\s]+)\\.md\\)");
    std::vector<QString> names;
    for (auto found = link.globalMatch(markdown); found.hasNext();) names.push_back(found.next().captured(1));
    return names;
}

std::vector<TextPlace> findWords(const QString& text, const QString& sought)
{
    const QString plain = plainLetters(text);
    std::vector<TextPlace> places;
    for (const QString& word : plainLetters(sought).simplified().split(' ', Qt::SkipEmptyParts)) {
        const std::size_t before = places.size();
        for (int at = plain.indexOf(word); at >= 0; at = plain.indexOf(word, at + 1)) {
            const bool inside = at > 0 && plain[at - 1].isLetterOrNumber() && word[0].isLetterOrNumber();
            if (!inside) places.push_back({at, word.length()});
        }
        if (places.size() == before) return {};
    }
    std::sort(places.begin(), places.end(), [](const TextPlace& a, const TextPlace& b) { return a.begin < b.begin; });
    return places;
}

}  // namespace lathelier
