// What is said above the views: which notes are seen first, that no line is cut, that abbreviations are spelt out.
#include <QHBoxLayout>
#include <QLabel>
#include <QTest>
#include <QVBoxLayout>

#include "engine/io/io_codes.h"
#include "engine/registration/registration_codes.h"
#include "widgets/core/answer_parts.h"
#include "widgets/core/notes_label.h"

namespace lathelier {

class NotesLabelTest : public QObject {
    Q_OBJECT

    static Note note(const NoteCode& code, const char* path = nullptr)
    {
        Note result{code, {}};
        if (path) result.values = {{"path", std::string(path)}};
        return result;
    }

private slots:
    void whatConcernsTheAnswerComesFirst()
    {
        const Notes shown = arranged({note(notes::methodChosen), note(notes::syntheticData, "/a/one.ply"),
                                      note(notes::rollNotDetermined), note(notes::notDistinguishable)});
        QCOMPARE(shown.size(), std::size_t{4});
        QCOMPARE(shown[0].code, notes::notDistinguishable);
        QCOMPARE(shown[1].code, notes::syntheticData);
        QCOMPARE(shown[2].code, notes::rollNotDetermined);
        QCOMPARE(shown[3].code, notes::methodChosen);
    }

    void oneNoteForAllItsFiles()
    {
        Note other = note(notes::rowsSkipped, "/b/two.xyz");
        other.values.push_back({"count", std::int64_t{3}});
        Note more = other;
        more.values[1].second = std::int64_t{4};
        const Notes shown =
            arranged({note(notes::syntheticData, "/a/one.ply"), other, note(notes::syntheticData, "/b/two.ply"), more});
        QCOMPARE(shown.size(), std::size_t{3});  // different counts are different notes
        QCOMPARE(*find(shown[0].values, "path"), Value(std::string("one.ply, two.ply")));
    }

    void lowPanelsFoldWhatIsNoWarning()
    {
        NotesLabel label;
        Notes notes(3, note(notes::rollNotDetermined));
        for (std::size_t i = 0; i < notes.size(); ++i) notes[i].values = {{"number", static_cast<std::int64_t>(i)}};
        notes.push_back(note(notes::notDistinguishable));
        notes.push_back(note(notes::syntheticData, "/a/one.ply"));
        label.setNotes(notes);
        auto* text = label.findChild<QLabel*>("notes");
        QCOMPARE(text->text().count('\n'), 2);
        label.setRoom(300);
        QCOMPARE(text->text().count('\n'), 1);
        QCOMPARE(text->text().count(QStringLiteral("⚠")), 2);
        label.setRoom(2000);
        QCOMPARE(text->text().count('\n'), 2);
    }

    void aTextThatIsNotSeenClaimsNoRoom()
    {
        // Behind a tab a label has no width of its own yet; its guess would make the window grow.
        WrappingLabel label("x");
        label.setFixedWidth(80);
        label.say("a text that takes many lines where there is only little width for it");
        QCOMPARE(label.minimumHeight(), 0);
        label.show();
        QVERIFY(QTest::qWaitForWindowExposed(&label));
        QVERIFY(label.minimumHeight() >= 3 * label.fontMetrics().height());
    }

    void allUnfolds()
    {
        NotesLabel label;
        label.resize(900, 200);
        Notes notes(5, note(notes::rollNotDetermined));
        for (std::size_t i = 0; i < notes.size(); ++i) notes[i].values = {{"number", static_cast<std::int64_t>(i)}};
        label.setNotes(notes);
        auto* text = label.findChild<QLabel*>("notes");
        auto* fold = label.findChild<QToolButton*>("moreNotes");
        QCOMPARE(text->text().count('\n'), 2);
        QVERIFY(fold->text().contains('2'));
        fold->click();
        QCOMPARE(text->text().count('\n'), 4);
        label.setPresenting(true);
        fold->click();
        QCOMPARE(text->text().count('\n'), 1);
    }

    void headlineIsNeverCut()
    {
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* headline = new HeadlineLabel;
        auto* views = new QWidget;
        views->setMinimumHeight(300);
        layout->addWidget(headline);
        layout->addWidget(views, 1);
        window.resize(700, 420);
        window.show();
        headline->setHeadline({"RMS 0.0582 mm · mean +0.0128 mm · point to plane · 63.8 % within ±0.0525 mm", false});
        auto* text = headline->findChild<QLabel*>("headline");
        for (const double factor : {1.0, 1.5, 1.0, 2.0}) {  // as presenter mode does
            QFont font = window.font();
            font.setPointSizeF(9 * factor);
            headline->setFont(font);
            QTest::qWait(50);
            QVERIFY2(text->height() >= text->heightForWidth(text->width()),
                     qPrintable(QString("%1 of %2").arg(text->height()).arg(text->heightForWidth(text->width()))));
        }
        QCOMPARE(text->toolTip(), QString("RMS: root mean square"));
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::NotesLabelTest)
#include "notes_label_test.moc"
