#include "app/gui/help_window.h"

#include <QApplication>
#include <QEvent>
#include <QFileInfo>
#include <QIcon>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QMessageBox>
#include <QPointer>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QUrl>
#include <QVBoxLayout>

namespace lathelier {
namespace {

QString screenLanguageCode()
{
    return QLocale().name().left(2);
}

/// Style missing in Markdown: table borders and padding, space above headings.
void layOut(QTextDocument& document, const QColor& line)
{
    const qreal letter = QFontMetricsF(document.defaultFont()).height();
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() < 2) continue;
        QTextBlockFormat format = block.blockFormat();
        format.setTopMargin(letter);
        QTextCursor(block).setBlockFormat(format);
    }
    for (QTextFrame* frame : document.rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (!table) continue;
        QTextTableFormat format = table->format();
        format.setBorder(1);
        format.setBorderCollapse(true);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderBrush(line);
        format.setCellSpacing(0);
        format.setCellPadding(letter / 4);
        format.setTopMargin(letter / 2);
        format.setBottomMargin(letter / 2);
        table->setFormat(format);
    }
}

}  // namespace

HelpWindow::HelpWindow(QWidget* parent)
    : QDialog(parent),
      language_(screenLanguageCode()),
      manual_(language_),
      search_(new QLineEdit),
      nothing_(new QLabel),
      pages_(new QListWidget),
      text_(new QTextBrowser)
{
    search_->setObjectName("searchManual");
    search_->setClearButtonEnabled(true);
    nothing_->setObjectName("nothingFound");
    nothing_->setWordWrap(true);
    pages_->setObjectName("manualPages");
    pages_->setFrameShape(QFrame::NoFrame);
    text_->setObjectName("manualText");
    text_->setFrameShape(QFrame::NoFrame);
    text_->setOpenLinks(false);  // the pages are no files that a browser could open

    auto* left = new QWidget;
    auto* column = new QVBoxLayout(left);
    column->addWidget(search_);
    column->addWidget(nothing_);
    column->addWidget(pages_, 1);
    auto* both = new QSplitter(Qt::Horizontal);
    both->addWidget(left);
    both->addWidget(text_);
    both->setChildrenCollapsible(false);
    both->setStretchFactor(1, 1);
    const int character = fontMetrics().averageCharWidth();
    both->setSizes({character * 30, character * 95});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(both);
    resize(character * 125, fontMetrics().height() * 38);

    connect(search_, &QLineEdit::textChanged, this, &HelpWindow::search);
    connect(search_, &QLineEdit::returnPressed, this, [this] { goToHit(hit_ + 1); });
    connect(pages_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (item) turnTo(item->data(Qt::UserRole).toString());
    });
    connect(text_, &QTextBrowser::anchorClicked, this,
            [this](const QUrl& link) { turnTo(QFileInfo(link.path()).completeBaseName()); });
    connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, search_,
            [this] { search_->setFocus(Qt::ShortcutFocusReason); });
    text_->setFocus();  // so that the keys that page and scroll do so at once
    retranslate();
}

void HelpWindow::showPage(const QString& name)
{
    search_->clear();
    turnTo(name);
}

void HelpWindow::searchFor(const QString& words)
{
    search_->setText(words);
}

void HelpWindow::turnTo(const QString& name)
{
    const ManualPage& page = manual_.page(name);
    shown_ = page.name;
    // Filled before it is shown: a document on the screen takes a second for a long page with tables.
    auto* document = new QTextDocument(text_);
    document->setDefaultFont(text_->font());
    document->setDocumentMargin(20);
    document->setMarkdown(page.markdown);
    layOut(*document, palette().color(QPalette::Mid));
    const QPointer<QTextDocument> before(text_->document());
    text_->setDocument(document);
    if (before) before->deleteLater();  // not now: the click on one of its links may have led here
    text_->verticalScrollBar()->setValue(0);
    const QSignalBlocker quiet(pages_);
    pages_->setCurrentItem(nullptr);
    for (int row = 0; row < pages_->count(); ++row)
        if (pages_->item(row)->data(Qt::UserRole).toString() == shown_) pages_->setCurrentRow(row);
    markHits();
}

void HelpWindow::search()
{
    listPages();
    // The page shown stays while it has what is sought; else the first that has it comes.
    if (pages_->currentItem() || pages_->count() == 0)
        markHits();
    else
        turnTo(pages_->item(0)->data(Qt::UserRole).toString());
}

/// All pages, or those in which the search finds something, with how often it does.
void HelpWindow::listPages()
{
    const QSignalBlocker quiet(pages_);
    pages_->clear();
    const bool all = search_->text().trimmed().isEmpty();
    for (const ManualPage& page : manual_.pages()) {
        const std::size_t hits = all ? 0 : findWords(page.text, search_->text()).size();
        if (!all && hits == 0) continue;
        auto* item = new QListWidgetItem(all ? page.title : QString("%1 (%2)").arg(page.title).arg(hits), pages_);
        item->setData(Qt::UserRole, page.name);
        if (page.name == shown_) pages_->setCurrentItem(item);
    }
    nothing_->setVisible(pages_->count() == 0);
}

void HelpWindow::markHits()
{
    hits_ = findWords(manual_.page(shown_).text, search_->text());
    QColor colour = palette().color(QPalette::Highlight);
    colour.setAlphaF(0.35);
    QList<QTextEdit::ExtraSelection> marks;
    for (const TextPlace& place : hits_) {
        marks << QTextEdit::ExtraSelection{cursorOn(place), {}};
        marks.back().format.setBackground(colour);
    }
    text_->setExtraSelections(marks);
    goToHit(0);
}

/// Brings a hit into sight and selects it; behind the last one comes the first. Without hits nothing is selected.
void HelpWindow::goToHit(std::size_t hit)
{
    hit_ = hits_.empty() ? 0 : hit % hits_.size();
    text_->setTextCursor(hits_.empty() ? QTextCursor(text_->document()) : cursorOn(hits_[hit_]));
    text_->ensureCursorVisible();
}

QTextCursor HelpWindow::cursorOn(const TextPlace& place) const
{
    QTextCursor cursor(text_->document());
    cursor.setPosition(place.begin);
    cursor.setPosition(place.begin + place.length, QTextCursor::KeepAnchor);
    return cursor;
}

void HelpWindow::retranslate()
{
    setWindowTitle(tr("Lathelier help"));
    search_->setPlaceholderText(tr("Search the manual"));
    search_->setAccessibleName(search_->placeholderText());
    search_->setToolTip(tr("Words that a page has to have, all of them; Enter goes to the next place"));
    nothing_->setText(tr("No page has all of these words."));
    pages_->setAccessibleName(tr("Pages of the manual"));
    text_->setAccessibleName(tr("Page of the manual"));
    if (language_ != screenLanguageCode()) {
        language_ = screenLanguageCode();
        manual_ = Manual(language_);
    }
    listPages();
    turnTo(shown_);
}

void HelpWindow::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
    if (event->type() == QEvent::PaletteChange) turnTo(shown_);  // links and lines keep the colours they were made with
}

void showAbout(QWidget* parent)
{
    QMessageBox box(parent);
    box.setWindowTitle(HelpWindow::tr("About Lathelier"));
    box.setIconPixmap(QApplication::windowIcon().pixmap(64, 64));
    box.setText("<h3>Lathelier " + QApplication::applicationVersion() + "</h3>");
    box.setInformativeText(
        HelpWindow::tr("A desktop workbench for turning shops: scan, predict, cut without chatter, measure, "
                       "prove.\n\nFree software under the GNU General Public License, version 3 or later. "
                       "It works offline; your files stay with you."));
    box.exec();
}

}  // namespace lathelier
