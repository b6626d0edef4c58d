// lathelier --report: the project's report without a window.
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include "app/gui/report_command.h"
#include "engine/io/io_codes.h"
#include "tests/widgets/core/fake_panel.h"
#include "widgets/core/session.h"

namespace lathelier {

class ReportCommandTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static std::vector<PanelFacts> panels()
    {
        return {FakePanel::factsOf("one"), FakePanel::factsOf("two"), FakePanel::factsOf("round", "roundness")};
    }
    static void takeFile(project::Project& project) { project.panels["one"].inputs["file"].path = "/measured/a.txt"; }

private slots:
    void reportWithoutAWindow()
    {
        Session session;
        session.edit("open", takeFile);
        const QString project = folder_.filePath("r.lathelier");
        session.save(project);
        auto table = panels();
        for (PanelFacts& facts : table)
            facts.report = [](const project::PanelState& state, Stores&, task::Sources&, const Language&,
                              const Progress&) {
                report::Document document;
                document.title = std::string("Report of ") + state.inputs.at("file").path;
                return document;
            };
        for (const char* suffix : {"html", "pdf"}) {
            const QString path = folder_.filePath(QString("r.") + suffix);
            QCOMPARE(runReport(path, project, table), 0);
            QVERIFY(QFileInfo(path).size() > 500);
        }
        QFile pdf(folder_.filePath("r.pdf"));
        QVERIFY(pdf.open(QIODevice::ReadOnly));
        QVERIFY(pdf.read(5) == "%PDF-");
        QCOMPARE(runReport(folder_.filePath("x.html"), folder_.filePath("missing.lathelier"), table), 3);
        QCOMPARE(runReport("/nowhere/x.html", project, table), 5);
    }

    void reportNamesWhatHasNoAnswer()
    {
        Session session;
        session.edit("open", takeFile);
        session.edit("report", [](project::Project& project) {
            project.report = {"one", "two", "round"};
            lathelier::set(project.panels["two"].parameters, "factor_mm", 3.0);  // begun, without a file
        });
        const QString project = folder_.filePath("incomplete.lathelier");
        session.save(project);
        auto table = panels();
        for (PanelFacts& facts : table) {
            facts.missing = [](const project::PanelState& state) {
                return state.inputs.count("file") ? std::vector<Text>() : std::vector<Text>{Text{"Scanned file"}};
            };
            facts.report = [](const project::PanelState& state, Stores&, task::Sources&, const Language&,
                              const Progress&) {
                report::Document document;
                document.title = std::string("Report of ") + state.inputs.at("file").path;
                document.sections = {{std::string("Answered"), {}}};
                return document;
            };
        }
        const QString path = folder_.filePath("incomplete.html");
        QCOMPARE(runReport(path, project, table), 4);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray html = file.readAll();
        QVERIFY(html.contains("Answered"));
        QCOMPARE(html.count("No answer: Scanned file is missing."), 2);

        for (PanelFacts& facts : table)
            facts.report = [](const project::PanelState&, Stores&, task::Sources&, const Language&,
                              const Progress&) -> report::Document {
                throw Error(errors::fileNotFound, {{"path", std::string("gone.ply")}});
            };
        QVERIFY(QFile::remove(path));
        QCOMPARE(runReport(path, project, table), 3);
        QVERIFY(!QFile::exists(path));  // a report of nothing is none
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::ReportCommandTest)
#include "report_command_test.moc"
