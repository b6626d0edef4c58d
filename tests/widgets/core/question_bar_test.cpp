// The bar of questions: widths, states without colour, keys; the short answers of its boxes.
#include <QApplication>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "tests/widgets/core/fake_panel.h"
#include "widgets/core/language.h"
#include "widgets/core/resources.h"
#include "widgets/core/shell/question_bar.h"

namespace lathelier {

using State = QuestionAnswer::State;

class QuestionBarTest : public QObject {
    Q_OBJECT

    Languages languages_;

    static std::vector<Question> all()
    {
        std::vector<Question> questions;
        for (const char* id : {"scan", "drawing", "machine", "speed", "program", "deflection", "copy", "proof",
                               "roundness", "photographs", "training", "series"})
            questions.push_back(questionOf(id));
        return questions;
    }
    /// Boxes lie side by side within the bar.
    static void checkPlaces(const QuestionBar& bar)
    {
        int right = 0;
        for (const Question& question : all()) {
            const QRect box = bar.box(question.id)->geometry();
            QVERIFY2(box.left() >= right, question.id.c_str());
            right = box.right() + 1;
        }
        QVERIFY(right <= bar.width());
    }

private slots:
    void initTestCase()
    {
        useResources();
        QFont usual = QApplication::font();
        usual.setPointSizeF(9.75);  // 13 pixels, as on a desktop
        QApplication::setFont(usual);
    }
    void cleanup() { languages_.use("en"); }

    void namesAreWholeAt1280_data()
    {
        QTest::addColumn<QString>("language");
        for (const char* code : {"en", "pl"}) QTest::newRow(code) << code;
    }
    void namesAreWholeAt1280()
    {
        QFETCH(QString, language);
        languages_.use(language);
        QuestionBar bar(all());
        bar.resize(1280, bar.sizeHint().height());
        bar.show();
        QVERIFY(bar.height() < 60);
        checkPlaces(bar);
        for (const Question& question : all()) {
            const QuestionBox* box = bar.box(question.id);
            QVERIFY2(!box->isCompact(), question.id.c_str());
            QVERIFY2(box->width() >= box->neededWidth(), question.id.c_str());
        }
        // The chain has room for a short answer under its names.
        QVERIFY(bar.box("scan")->width() - 10 >= bar.fontMetrics().horizontalAdvance(QString::fromUtf8("✗ 0.166 mm")));
    }

    void inANarrowWindowThoseBesideGiveWayFirst()
    {
        QuestionBar bar(all());
        bar.resize(1024, bar.sizeHint().height());
        bar.show();
        checkPlaces(bar);
        QVERIFY(!bar.box("deflection")->isCompact());
        QVERIFY(bar.box("photographs")->isCompact());
        bar.resize(bar.minimumSizeHint());
        checkPlaces(bar);
        QVERIFY(bar.box("deflection")->isCompact());
    }

    void noBoxMovesWhenAnAnswerComes()
    {
        QuestionBar bar(all());
        bar.resize(1280, bar.sizeHint().height());
        bar.show();
        const QRect before = bar.box("program")->geometry();
        bar.setAnswer("speed", {State::Answered, Verdict::Fail, QString(80, 'x'), "all of it", true});
        QCOMPARE(bar.box("program")->geometry(), before);
        QVERIFY(bar.box("speed")->toolTip().contains("all of it"));
        QVERIFY(bar.box("speed")->toolTip().contains("assumed"));
        bar.setAnswer("nonsense", {});  // ignored
    }

    /// Each state has a sign of its own, and says itself to a reader of the screen.
    void statesAreToldApartWithoutColour()
    {
        QuestionBar bar(all());
        QStringList texts, names;
        const auto say = [&](const QuestionAnswer& answer) {
            bar.setAnswer("speed", answer);
            texts << bar.box("speed")->answerText().left(1);
            names << bar.box("speed")->accessibleName();
        };
        say({});
        say({State::Computing, {}, "3640 1/min", {}, false});
        say({State::Answered, Verdict::Pass, "3640 1/min", {}, false});
        say({State::Answered, Verdict::Fail, "3640 1/min", {}, false});
        say({State::Answered, Verdict::Undecided, "3640 1/min", {}, false});
        say({State::Answered, {}, "3640 1/min", {}, false});
        say({State::Failed, {}, "no such file", {}, false});
        say({State::Outdated, Verdict::Pass, "3640 1/min", {}, false});
        say({State::Answered, {}, "3640 1/min", {}, true});
        for (QStringList* each : {&texts, &names}) {
            each->sort();
            const QStringList whole = *each;
            each->removeDuplicates();
            QCOMPARE(*each, whole);
        }
        QCOMPARE(bar.box("speed")->answerText(), QString::fromUtf8("≈ 3640 1/min"));
        QCOMPARE(bar.box("copy")->answerText(), QString::fromUtf8("○"));
    }

    void keysGoThroughTheBoxes()
    {
        QuestionBar bar(all());
        bar.resize(1280, bar.sizeHint().height());
        bar.show();
        QVERIFY(QTest::qWaitForWindowActive(&bar));
        bar.setCurrent("scan");
        std::vector<std::string> asked;
        connect(&bar, &QuestionBar::questionRequested, [&asked](const std::string& id) { asked.push_back(id); });
        bar.box("scan")->setFocus();
        QTest::keyClick(bar.focusWidget(), Qt::Key_Right);
        QVERIFY(bar.box("drawing")->hasFocus());
        QVERIFY(bar.box("scan")->isChecked());  // looking round opens nothing
        QTest::keyClick(bar.focusWidget(), Qt::Key_Return);
        QCOMPARE(asked.size(), std::size_t{1});
        QCOMPARE(asked.back(), std::string("drawing"));
        bar.box("scan")->setFocus();
        QTest::keyClick(bar.focusWidget(), Qt::Key_Left);  // round about
        QVERIFY(bar.box("series")->hasFocus());
        QTest::keyClick(bar.focusWidget(), Qt::Key_Space);
        QCOMPARE(asked.back(), std::string("series"));
        QTest::mouseClick(bar.box("copy"), Qt::LeftButton);
        QCOMPARE(asked.back(), std::string("copy"));
        QVERIFY(bar.box("copy")->isChecked());
    }

    void answersAreShort()
    {
        report::Answer answer;
        answer.quantity = Text{"Length"};
        answer.value = 126.8412;
        answer.expanded_uncertainty = 0.08;
        answer.unit = Text{"mm"};
        answer.decimals = 1;
        answer.verdict = Verdict::Pass;
        const auto plain = [](QString text) { return text.replace(QChar(0xa0), ' ').replace(QChar(0x202f), ' '); };
        QCOMPARE(plain(shortAnswer(answer)), QString("126.8 mm"));
        const QuestionAnswer said = questionAnswer(answer);
        QVERIFY(said.state == State::Answered && said.verdict == Verdict::Pass && !said.assumed);
        QVERIFY2(plain(said.tooltip).contains(QString::fromUtf8("126.8 ± 0.1 mm")), qPrintable(said.tooltip));
        languages_.use("pl");
        QCOMPARE(plain(shortAnswer(answer)), QString("126,8 mm"));
        languages_.use("en");
        answer.value.reset();
        answer.verdict_words = Text{"✗ material stays"};
        QCOMPARE(shortAnswer(answer), QString("material stays"));  // the box draws the sign
        answer.verdict.reset();
        QCOMPARE(shortAnswer(answer), QString("Length"));
    }

    void theFirstPanelWithAResultAnswers()
    {
        QTemporaryDir folder;
        QFile file(folder.filePath("a.txt"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("1234567890");
        file.close();
        Session session;
        FakePanel first(session, "first"), second(session, "second");
        const std::vector<const PanelBase*> both{&first, &second};
        QTRY_VERIFY(!first.isBusy() && !second.isBusy());
        QVERIFY(answerOfPanels(both).state == State::Empty);
        second.openFiles({file.fileName()});
        QTRY_VERIFY(second.isCurrent());
        QVERIFY(answerOfPanels(both).state == State::Answered);
        QVERIFY(answerOfPanels(both).text.startsWith("20"));
        first.openFiles({file.fileName()});
        QTRY_VERIFY(first.isCurrent());
        second.openFiles({file.fileName()});
        QTRY_VERIFY(second.isCurrent());
        QVERIFY(QFile::remove(file.fileName()));
        first.recompute();
        QTRY_VERIFY(first.error().has_value());
        QVERIFY(answerOfPanels(both).text.startsWith("20"));
        QVERIFY(answerOfPanels({&first}).state == State::Failed);
        QVERIFY(!answerOfPanels({&first}).tooltip.isEmpty());
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::QuestionBarTest)
#include "question_bar_test.moc"
