// The manual: that every panel has its page in every language, that its links lead somewhere, and the window it is read
// in, driven as a user does.
#include <QAction>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>
#include <algorithm>

#include "app/gui/help_window.h"
#include "app/gui/main_window.h"
#include "app/gui/panels.h"
#include "tests/app/window_fixture.h"
#include "widgets/core/language.h"

namespace lathelier {

class HelpWindowTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    Languages languages_;
    std::unique_ptr<HelpWindow> window_;

    template <class Part>
    Part& part(const char* name) const
    {
        return *window_->findChild<Part*>(name);
    }
    QStringList listed() const
    {
        QStringList names;
        const auto& pages = part<QListWidget>("manualPages");
        for (int row = 0; row < pages.count(); ++row) names << pages.item(row)->data(Qt::UserRole).toString();
        return names;
    }
    QString shownText() const { return part<QTextBrowser>("manualText").toPlainText(); }
    void search(const QString& words) { part<QLineEdit>("searchManual").setText(words); }

    /// What the marks in the page shown stand on.
    QStringList marked() const
    {
        QStringList words;
        for (const auto& mark : part<QTextBrowser>("manualText").extraSelections()) words << mark.cursor.selectedText();
        return words;
    }

private slots:
    void initTestCase() { useSettingsOf(folder_.path()); }
    void init()
    {
        languages_.use("en");
        window_ = std::make_unique<HelpWindow>();
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    }
    void cleanup() { window_.reset(); }

    void everyPanelHasItsPageInEveryLanguage()
    {
        for (const QString& language : Languages::codes())
            for (const PanelFacts& panel : panelTable()) {
                const QString name = QString::fromStdString(panel.id);
                QVERIFY2(QFile::exists(":/manual/" + language + "/" + name + ".md"), qPrintable(language + " " + name));
                QVERIFY(!Manual(language).page(name).title.isEmpty());
            }
    }

    void everyLanguageHasTheSamePages()
    {
        const QStringList english = QDir(":/manual/en").entryList();
        QVERIFY(english.size() >= 7);
        for (const QString& language : Languages::codes()) QCOMPARE(QDir(":/manual/" + language).entryList(), english);
    }

    void everyLinkLeadsToAPage()
    {
        for (const QString& language : Languages::codes()) {
            const Manual manual(language);
            for (const ManualPage& page : manual.pages())
                for (const QString& link : linkedPages(page.markdown))
                    QVERIFY2(manual.page(link).name == link, qPrintable(language + " " + page.name + " → " + link));
            // No page is out of reach of a reader who begins with the index.
            const std::vector<QString> fromIndex = linkedPages(manual.page("index").markdown);
            for (const ManualPage& page : manual.pages())
                QVERIFY2(page.name == "index" || std::count(fromIndex.begin(), fromIndex.end(), page.name) > 0,
                         qPrintable(page.name));
        }
    }

    void aClickOnALinkTurnsToItsPage()
    {
        window_->showPage("index");
        emit part<QTextBrowser>("manualText").anchorClicked(QUrl("trajectory.md"));
        QCOMPARE(window_->page(), QString("trajectory"));
        QVERIFY(shownText().startsWith("Trajectory"));
        QCOMPARE(part<QListWidget>("manualPages").currentItem()->text(), QString("Trajectory"));
    }

    void aClickInTheListTurnsToItsPage()
    {
        auto& pages = part<QListWidget>("manualPages");
        QCOMPARE(listed().front(), QString("index"));
        pages.setCurrentRow(listed().indexOf("formats"));
        QCOMPARE(window_->page(), QString("formats"));
        QVERIFY(shownText().startsWith("File formats"));
    }

    void anUnknownPageFallsBackToTheIndex()
    {
        window_->showPage("roundness");
        QCOMPARE(window_->page(), QString("roundness"));
        window_->showPage("no such panel");
        QCOMPARE(window_->page(), QString("index"));
    }

    void searchFindsTheOnePageThatHasTheWord()
    {
        window_->showPage("compare");
        search("limacon");  // as on a keyboard without ç
        QCOMPARE(listed(), QStringList("roundness"));
        QCOMPARE(window_->page(), QString("roundness"));
        QCOMPARE(marked(), QStringList("limaçon"));
        search({});
        QCOMPARE(listed().size(), static_cast<int>(Manual("en").pages().size()));
        QVERIFY(marked().isEmpty());
        QCOMPARE(window_->page(), QString("roundness"));
    }

    void searchWantsAllWordsAndMarksThem()
    {
        window_->showPage("compare");
        search("MZCI limaçon");
        QCOMPARE(listed(), QStringList("roundness"));
        QVERIFY(marked().contains("MZCI") && marked().contains("limaçon"));
        search("MZCI no-such-word");
        QVERIFY(listed().isEmpty());
        QVERIFY(part<QLabel>("nothingFound").isVisible());
        QVERIFY(marked().isEmpty());
    }

    void enterGoesFromHitToHit()
    {
        window_->showPage("roundness");
        search("RONt");
        const auto place = [&] { return part<QTextBrowser>("manualText").textCursor().selectionStart(); };
        const int first = place();
        QTest::keyClick(&part<QLineEdit>("searchManual"), Qt::Key_Return);
        QVERIFY(place() > first);
        QCOMPARE(part<QTextBrowser>("manualText").textCursor().selectedText(), QString("RONt"));
        for (int more = 1; more < marked().size(); ++more)
            QTest::keyClick(&part<QLineEdit>("searchManual"), Qt::Key_Return);
        QCOMPARE(place(), first);  // all round
    }

    void showPageEndsASearch()
    {
        search("limacon");
        window_->showPage("formats");
        QVERIFY(part<QLineEdit>("searchManual").text().isEmpty());
        QCOMPARE(window_->page(), QString("formats"));
        QCOMPARE(listed().size(), static_cast<int>(Manual("en").pages().size()));
    }

    void theLanguageOfTheWindowIsThatOfThePage()
    {
        window_->showPage("roundness");
        const QString english = shownText();
        languages_.use("pl");
        QTRY_VERIFY(shownText().startsWith("Okrągłość"));
        QCOMPARE(window_->page(), QString("roundness"));
        QCOMPARE(window_->windowTitle(), QString("Pomoc programu Lathelier"));
        QCOMPARE(part<QListWidget>("manualPages").currentItem()->text(), QString("Okrągłość"));
        search("okraglosc");
        QVERIFY(listed().contains("roundness"));
        search({});
        languages_.use("en");
        QTRY_COMPARE(shownText(), english);
    }

    void theHelpKeyOpensThePageOfTheActivePanel()
    {
        Session session;
        MainWindow window(session, languages_, {FakePanel::factsOf("longitudinal", "roundness")});
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        window.action("help")->trigger();
        const auto* help = window.findChild<HelpWindow*>();
        QVERIFY(help && help->isVisible());
        QCOMPARE(help->page(), QString("longitudinal"));
        window.activeDock()->hide();
        window.action("help")->trigger();
        QCOMPARE(help->page(), QString("index"));
    }

    void aLanguageWithoutPagesShowsTheEnglishOnes()
    {
        const Manual other("xx");
        QCOMPARE(other.pages().size(), Manual("en").pages().size());
        QCOMPARE(other.page("compare").title, QString("Compare"));
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::HelpWindowTest)
#include "help_window_test.moc"
