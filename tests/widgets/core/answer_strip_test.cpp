// What is said above the views: the answer in a strip that keeps its height, its notes as chips, what they say first.
#include <QHBoxLayout>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>

#include "engine/io/io_codes.h"
#include "engine/registration/registration_codes.h"
#include "widgets/core/panel/answer_strip.h"
#include "widgets/core/panel/message_line.h"
#include "widgets/core/panel/notes_chips.h"

namespace lathelier {

class AnswerStripTest : public QObject {
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

    /// In a window of 1280 pixels the largest type does not hold a long value with its badge.
    void thePresentedValueIsWhole()
    {
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* strip = new AnswerStrip;
        layout->addWidget(strip);
        layout->addStretch();
        window.resize(1280, 800);
        window.show();
        report::Answer answer;
        answer.quantity = Text{"Worst local deviation"};
        answer.subject = "z 141.6 mm, 180°";
        answer.value = 0.05;
        answer.expanded_uncertainty = 0.004;
        answer.unit = Text{"mm"};
        answer.is_signed = true;
        answer.upper_limit = 0.04;
        answer.lower_limit = -0.04;
        answer.verdict = Verdict::Undecided;
        answer.verdict_words = Text{"? cannot be decided: too near the tolerance"};
        strip->setPresenting(true);
        strip->setAnswer(answer);
        const auto* value = strip->findChild<QLabel*>("headline");
        const auto fits = [&] { return value->fontMetrics().horizontalAdvance(value->text()) <= value->width(); };
        QTRY_VERIFY(fits());
        const auto* verdict = strip->findChild<QLabel*>("verdict");
        QCOMPARE(verdict->text(), QString("?"));  // its words would take the room of the value
        QVERIFY(strip->text().contains("cannot be decided"));
        answer.verdict_words = Text{"? undecided"};
        strip->setAnswer(answer);
        QTRY_VERIFY(fits());
        QCOMPARE(verdict->text(), QString("? undecided"));
        QVERIFY(QFontMetrics(value->font()).height() > 56);
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

    void notesAreCountedAndOpen()
    {
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* strip = new AnswerStrip;
        layout->addWidget(strip);
        layout->addStretch(1);
        window.resize(900, 400);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        auto* warnings = strip->findChild<QToolButton*>("noteWarnings");
        auto* facts = strip->findChild<QToolButton*>("noteFacts");
        QVERIFY(!warnings->isVisible() && !facts->isVisible());
        Notes notes(3, note(notes::rollNotDetermined));
        for (std::size_t i = 0; i < notes.size(); ++i) notes[i].values = {{"number", static_cast<std::int64_t>(i)}};
        notes.push_back(note(notes::notDistinguishable));
        strip->setNotes(notes);
        QVERIFY2(facts->text().contains('3'), qPrintable(facts->text()));
        QVERIFY2(warnings->text().contains('1'), qPrintable(warnings->text()));
        QTest::mouseClick(facts, Qt::LeftButton);
        auto* text = strip->findChild<QLabel*>("notes");
        QTRY_VERIFY(text->isVisible());
        QCOMPARE(text->text().count('\n'), 3);
        QVERIFY(text->text().startsWith(QStringLiteral("⚠")));
    }

    static report::Answer made(std::optional<double> limit_um)
    {
        report::Answer answer;
        answer.quantity = std::string("RONt(MZCI)");
        answer.value = 15.3;
        answer.expanded_uncertainty = 0.2;
        answer.unit = Text{"µm"};
        answer.decimals = 1;
        answer.upper_limit = limit_um;
        if (limit_um) answer.verdict = judge(15.3, 0.2, *limit_um, DecisionRule::Guarded);
        answer.sentence = Text{"a sentence that is longer than a narrow strip has room for, and longer than that"};
        report::Place place;
        place.z_mm = Interval{98, 108};
        answer.findings = {{Text{"at {z} mm"}, {{"z", 102.5}}, Verdict::Fail, place}};
        return answer;
    }

    void theAnswerIsWhole()
    {
        AnswerStrip strip;
        strip.setAnswer(made(15));
        QCOMPARE(strip.findChild<QLabel*>("headline")->text(), QString("15.3 ± 0.2\u00A0µm"));
        QVERIFY(strip.findChild<QLabel*>("quantity")->toolTip().contains("minimum zone"));
        QVERIFY(strip.findChild<QLabel*>("verdict")->text().startsWith("✗"));
        QVERIFY(strip.text().contains("at 102.5\u00A0mm"));
        strip.setAnswer(made(15.2));
        QVERIFY(strip.findChild<QLabel*>("verdict")->text().startsWith("?"));
        strip.setAnswer(made({}));
        QCOMPARE(strip.findChild<QLabel*>("verdict")->text(), QString("no limit given"));
    }

    void theValueIsWholeBesideItsRuler()
    {
        AnswerStrip strip;
        strip.show();
        strip.setAnswer(made(15.2));
        for (int width = 1600; width >= 500; width -= 50) {
            strip.resize(width, strip.sizeHint().height());
            QTest::qWait(1);
            const auto* value = strip.findChild<QLabel*>("headline");
            if (strip.findChild<QWidget*>("ruler")->isVisible()) QVERIFY(value->width() >= value->sizeHint().width());
        }
    }

    void nothingMovesWhenTheAnswerChanges()
    {
        for (const int height : {420, 90})
            for (const int width : {420, 700, 1600}) {
                QWidget window;
                auto* layout = new QVBoxLayout(&window);
                layout->setContentsMargins(0, 0, 0, 0);
                auto* strip = new AnswerStrip;
                auto* below = new QWidget;
                below->setMinimumHeight(20);
                layout->addWidget(strip);
                layout->addWidget(below, 1);
                window.resize(width, height);
                window.show();
                QVERIFY(QTest::qWaitForWindowExposed(&window));
                const int top = below->y();
                strip->setAnswer(made(15));
                QTest::qWait(20);
                QCOMPARE(below->y(), top);
                strip->clear();
                QTest::qWait(20);
                QCOMPARE(below->y(), top);
                QVERIFY(strip->minimumSizeHint().width() < 420);
            }
    }

    void aFindingLeadsToItsPlace()
    {
        AnswerStrip strip;
        strip.setAnswer(made(15));
        std::optional<report::Place> wanted;
        connect(&strip, &AnswerStrip::placeRequested, this, [&](const report::Place& place) { wanted = place; });
        QTest::mouseClick(strip.findChild<FindingLink*>("finding1"), Qt::LeftButton);
        QVERIFY(wanted.has_value());
        QCOMPARE(wanted->z_mm->from, 98.0);
    }

    void theStripGrowsForTheLastRow()
    {
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* strip = new AnswerStrip;
        layout->addWidget(strip);
        layout->addStretch(1);
        window.resize(1280, 800);
        window.show();
        strip->setAnswer(made(15));
        const int before = strip->height();
        strip->setPresenting(true);
        QTRY_VERIFY(strip->height() > before);
        QVERIFY(QFontInfo(strip->findChild<QLabel*>("headline")->font()).pixelSize() >= 80);
        strip->setPresenting(false);
        QTRY_COMPARE(strip->height(), before);
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::AnswerStripTest)
#include "answer_strip_test.moc"
