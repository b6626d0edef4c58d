// What the user waits for behind a dialog: a report drawn outside the GUI thread, and the stop.
#include <QApplication>
#include <QFile>
#include <QProgressDialog>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <thread>

#include "app/gui/waiting.h"
#include "engine/io/io_codes.h"
#include "widgets/core/report/report_files.h"

namespace lathelier {

class WaitingTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    Worker::Outcome writeTo(const QString& path)
    {
        report::Document document;
        document.title = std::string("Report");
        document.title_block = {{std::string("Part"), std::string("Shaft 12"), {}}};
        report::Plot plot;
        plot.curves = {{std::string("curve"), {0, 1, 2}, {0, 1, 0}}};
        document.sections = {{std::string("Section"), {plot}}};
        return waitFor(nullptr, "Writing", [path, document](const Progress& progress) -> std::shared_ptr<const void> {
            writeReport(path, document, progress);
            return nullptr;
        });
    }

private slots:
    void reportsAreWrittenOutsideTheGuiThread()
    {
        for (const QString suffix : {"pdf", "html"}) {
            const QString path = folder_.filePath("r." + suffix);
            QVERIFY(std::holds_alternative<std::shared_ptr<const void>>(writeTo(path)));
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QByteArray content = file.readAll();
            QVERIFY(suffix == "pdf" ? content.startsWith("%PDF-") && content.size() > 5000
                                    : content.contains("Shaft 12"));
        }
    }

    void whatCannotBeWrittenIsToldBack()
    {
        const Worker::Outcome outcome = writeTo("/nowhere/r.pdf");
        QVERIFY(std::get<Error>(outcome).code() == errors::fileNotWritable);
    }

    void cancelStopsTheJob()
    {
        QTimer::singleShot(100, this, [] {
            for (QWidget* widget : QApplication::topLevelWidgets())
                if (auto* dialog = qobject_cast<QProgressDialog*>(widget)) dialog->findChild<QPushButton*>()->click();
        });
        const Worker::Outcome outcome =
            waitFor(nullptr, "Endless", [](const Progress& progress) -> std::shared_ptr<const void> {
                for (;;) {
                    progress.check();
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                }
            });
        QVERIFY(std::holds_alternative<Cancelled>(outcome));
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::WaitingTest)
#include "waiting_test.moc"
