// The title block of a project's reports: asked for, undone, kept for the next project, printed.
#include <QApplication>
#include <QDialogButtonBox>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <QUndoStack>

#include "app/gui/report_command.h"
#include "app/gui/title_block_dialog.h"
#include "engine/report/html.h"
#include "tests/app/window_fixture.h"
#include "widgets/core/form/form.h"

namespace lathelier {

class TitleBlockTest : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepareSettings(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void isAskedForUndoneAndKeptForTheNextProject()
    {
        fillIn({{"company", "Works 4"}, {"part", "Shaft 12"}}, QDialogButtonBox::Ok);
        const report::TitleBlock block = titleBlockOf(session_->project());
        QCOMPARE(block.part, std::string("Shaft 12"));
        QCOMPARE(block.company, std::string("Works 4"));
        session_->undoStack().undo();
        QVERIFY(session_->project().title_block.empty());
        session_->reset();
        QCOMPARE(titleBlockOf(session_->project()).company, std::string("Works 4"));
        QCOMPARE(titleBlockOf(session_->project()).part, std::string());
    }

    void theLogoIsReadMadeSmallAndPrinted()
    {
        const QString path = folder_.filePath("logo.png");
        QImage picture(2000, 500, QImage::Format_RGB32);
        picture.fill(Qt::red);
        QVERIFY(picture.save(path));
        const std::string logo = readLogo(path);
        const QImage small = QImage::fromData(QByteArray::fromBase64(QByteArray::fromStdString(logo)));
        QCOMPARE(small.width(), 640);
        QCOMPARE(small.height(), 160);
        QFile text(folder_.filePath("logo.txt"));
        QVERIFY(text.open(QIODevice::WriteOnly));
        text.write("no picture");
        text.close();
        QVERIFY_EXCEPTION_THROWN(readLogo(text.fileName()), Error);

        report::TitleBlock block;
        block.logo_png_base64 = logo;
        QVERIFY(rowsOf(block).empty());
        report::Document document;
        document.title = std::string("Report");
        setTitleBlock(document, block);
        QVERIFY(report::toHtml(document).find("data:image/png;base64," + logo) != std::string::npos);
        TitleBlockDialog dialog(block);
        QCOMPARE(dialog.block().logo_png_base64, logo);
        dialog.findChild<QPushButton*>("withoutLogo")->click();
        QVERIFY(dialog.block().logo_png_base64.empty());
    }

    void cancelChangesNothing()
    {
        fillIn({{"part", "Shaft 12"}}, QDialogButtonBox::Cancel);
        QVERIFY(session_->project().title_block.empty());
        QVERIFY(!session_->undoStack().canUndo());
    }

    void standsInTheReport()
    {
        session_->edit("block", [](project::Project& project) {
            report::TitleBlock block;
            block.drawing = "LT-0042 B";
            project.title_block = toValues(block);
            project.panels["one"].inputs["file"].path = "/measured/a.txt";
        });
        const QString project = folder_.filePath("block.lathelier");
        session_->save(project);
        auto table = panels();
        for (PanelFacts& facts : table)
            facts.report = [](const project::PanelState&, Stores&, task::Sources&, const Language&, const Progress&) {
                report::Document document;
                document.title = std::string("Report");
                return document;
            };
        const QString path = folder_.filePath("block.html");
        QCOMPARE(runReport(path, project, table), 0);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("<dd>LT-0042 B</dd>"));
    }

private:
    /// Types into the dialog and closes it.
    void fillIn(const std::map<std::string, QString>& words, QDialogButtonBox::StandardButton by)
    {
        bool seen = false;
        QTimer::singleShot(0, this, [&] {
            auto* dialog = qobject_cast<TitleBlockDialog*>(QApplication::activeModalWidget());
            seen = dialog != nullptr;
            if (!dialog) return;
            for (const auto& [key, word] : words) {
                auto* edit = qobject_cast<QLineEdit*>(dialog->findChild<Form*>()->editor(key));
                QVERIFY(edit);
                QTest::keyClicks(edit, word);
            }
            dialog->findChild<QDialogButtonBox*>()->button(by)->click();
        });
        window_->action("titleBlock")->trigger();
        QVERIFY(seen);
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::TitleBlockTest)
#include "title_block_test.moc"
