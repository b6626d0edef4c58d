// Reports as files: whole PDF documents whose plots stay vectors.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "widgets/core/report/report_files.h"
#include "widgets/core/report/report_pdf.h"

namespace lathelier {

class ReportTest : public QObject {
    Q_OBJECT

    static int count(const std::string& pdf, const char* pattern)
    {
        const QString text = QString::fromLatin1(pdf.data(), static_cast<int>(pdf.size()));
        auto found = QRegularExpression(pattern).globalMatch(text);
        int result = 0;
        for (; found.hasNext(); found.next()) ++result;
        return result;
    }
    static int pages(const std::string& pdf) { return count(pdf, "/Type /Page\\b"); }
    static int pictures(const std::string& pdf) { return count(pdf, "/Subtype /Image"); }

    static report::Document withRows(int rows)
    {
        report::Table table;
        table.title = std::string("Table");
        table.columns = {std::string("a"), std::string("b")};
        for (int i = 0; i < rows; ++i) table.rows.push_back({Value(std::int64_t{i}), Value(i * 0.5)});
        report::Document document;
        document.title = std::string("Report");
        document.sections.push_back({std::string("Section"), {table}});
        return document;
    }

private slots:
    void shortReportIsOnePage()
    {
        const std::string pdf = toPdf(withRows(5));
        QVERIFY(pdf.starts_with("%PDF-"));
        QVERIFY(pdf.find("%%EOF") != std::string::npos);
        QCOMPARE(pages(pdf), 1);
    }

    void longTableGoesOnOverPages()
    {
        const int many = pages(toPdf(withRows(200)));
        QVERIFY(many >= 3 && many <= 10);
        QVERIFY(pages(toPdf(withRows(0))) == 1);
    }

    void plotsStayVectors()
    {
        report::Document document = withRows(2);
        report::Plot plot;
        plot.title = std::string("Plot");
        report::Curve curve;
        for (int i = 0; i < 100; ++i) {
            curve.x.push_back(i);
            curve.y.push_back(i * i);
        }
        plot.curves.push_back(curve);
        document.sections[0].blocks.push_back(plot);
        QCOMPARE(pictures(toPdf(document)), pictures(toPdf(withRows(2))));
        QVERIFY(toPdf(document).size() > toPdf(withRows(2)).size());
    }

    void suffixDecidesAndFailureLeavesNothing()
    {
        const QTemporaryDir folder;
        writeReport(folder.filePath("r.html"), withRows(1));
        writeReport(folder.filePath("r.pdf"), withRows(1));
        QFile html(folder.filePath("r.html"));
        QFile pdf(folder.filePath("r.pdf"));
        QVERIFY(html.open(QIODevice::ReadOnly) && pdf.open(QIODevice::ReadOnly));
        QVERIFY(html.readAll().contains("<html"));
        QVERIFY(pdf.readAll().startsWith("%PDF-"));
        QVERIFY_EXCEPTION_THROWN(writeReport("/nowhere/r.pdf", withRows(1)), Error);
    }

    void resultsStandBesideAsJson()
    {
        const QTemporaryDir folder;
        const auto beside = [&](const report::Document& document) {
            writeReport(folder.filePath("r.v2.html"), document);
            QFile file(folder.filePath("r.v2_result.json"));
            if (!file.open(QIODevice::ReadOnly)) return QJsonObject();
            return QJsonDocument::fromJson(file.readAll()).object();
        };
        QVERIFY(beside(withRows(1)).isEmpty());
        report::Document one = withRows(1);
        one.results = {R"({"command": "compare", "rmse_mm": 0.0125})"};
        QCOMPARE(beside(one)["rmse_mm"].toDouble(), 0.0125);
        report::Document other = withRows(2);
        other.results = {R"({"command": "roundness", "notes": []})"};
        const QJsonArray both = beside(joined({one, other}, "Both"))["results"].toArray();
        QCOMPARE(both.size(), 2);
        QCOMPARE(both[0].toObject()["rmse_mm"].toDouble(), 0.0125);
        QCOMPARE(both[1].toObject()["command"].toString(), QString("roundness"));
    }

    void partsAreJoinedInOrder()
    {
        report::Document first = withRows(1);
        report::Document second = withRows(2);
        first.inputs = {{"a", 1, "x"}, {"b", 2, "y"}};
        second.inputs = {{"b", 2, "y"}, {"c", 3, "z"}};
        second.synthetic = true;
        const report::Document both = joined({first, second}, "Both");
        QCOMPARE(both.sections.size(), std::size_t{4});  // each under its title
        QVERIFY(both.sections[0].title == first.title && both.sections[0].blocks.empty());
        QVERIFY(both.sections[2].title == second.title);
        QCOMPARE(both.inputs.size(), std::size_t{3});
        QVERIFY(both.synthetic);
        QCOMPARE(report::captionText(both.title), std::string("Both"));
        QCOMPARE(report::captionText(joined({first}, "Both").title), std::string("Report"));
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::ReportTest)
#include "report_test.moc"
