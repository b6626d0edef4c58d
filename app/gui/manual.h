// The manual: pages of Markdown out of the program's resources (resources/manual), and what is found in them.
#pragma once

#include <QString>
#include <vector>

namespace lathelier {

struct ManualPage {
    QString name;      ///< of its file, "roundness"; the page of a panel is called as the panel's id
    QString title;     ///< its first heading
    QString markdown;  ///< with unbreakable spaces before units
    QString text;      ///< as the reader sees it; its places are those of a QTextDocument of this page
};

class Manual {
public:
    static constexpr const char* indexName = "index";

    /// The pages in `language` ("pl"), each in English where that language has none: first the index, then the others
    /// in the order in which it links to them.
    explicit Manual(const QString& language);

    const std::vector<ManualPage>& pages() const { return pages_; }

    /// The index where no page is called so.
    const ManualPage& page(const QString& name) const;

private:
    std::vector<ManualPage> pages_;
};

/// Names of the pages that `markdown` links to, in its order: "roundness" for [Roundness](roundness.md).
std::vector<QString> linkedPages(const QString& markdown);

/// A piece of a text.
struct TextPlace {
    int begin = 0;
    int length = 0;
};

/// Where the words of `sought` begin a word of `text`, in order of place; nothing unless all of them do. Capitals and
/// accents make no difference, so that "okraglosc" finds "Okrągłość".
std::vector<TextPlace> findWords(const QString& text, const QString& sought);

}  // namespace lathelier
