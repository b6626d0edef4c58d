// The manual on the screen (F1): its pages at the left, a search over all of them above. And the About box.
#pragma once

#include <QDialog>

#include "app/gui/manual.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QTextBrowser;
class QTextCursor;

namespace lathelier {

class HelpWindow : public QDialog {
    Q_OBJECT
public:
    explicit HelpWindow(QWidget* parent = nullptr);

    /// Shows the page about a panel (by the panel's id) or any other, the index where there is none; ends a search.
    void showPage(const QString& name);

    void searchFor(const QString& words);  ///< as typed into the search

    /// The name of the page that is shown.
    QString page() const { return shown_; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void turnTo(const QString& name);
    void search();
    void listPages();
    void markHits();
    void goToHit(std::size_t hit);
    QTextCursor cursorOn(const TextPlace& place) const;

    QString language_;  ///< of manual_
    Manual manual_;
    QString shown_ = Manual::indexName;
    std::vector<TextPlace> hits_;  ///< of the search, in the page shown
    std::size_t hit_ = 0;          ///< the one that was gone to
    QLineEdit* search_;
    QLabel* nothing_;
    QListWidget* pages_;
    QTextBrowser* text_;
};

void showAbout(QWidget* parent);

}  // namespace lathelier
