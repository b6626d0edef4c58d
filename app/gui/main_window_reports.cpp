// Report files out of the window: of one panel, or of all panels in the project's report.
#include <QCoreApplication>
#include <QDate>
#include <QDesktopServices>
#include <QDir>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QProgressDialog>
#include <QToolButton>
#include <QUrl>

#include "app/gui/main_window.h"
#include "app/gui/title_block_dialog.h"
#include "app/gui/waiting.h"
#include "widgets/core/form/typing.h"
#include "widgets/core/report/report_files.h"

namespace lathelier {
namespace {

/// Waits until every panel has its answer; false when the user would not wait.
bool waitForPanels(const std::vector<PanelDock*>& docks, QWidget* window)
{
    QProgressDialog progress(MainWindow::tr("Computing what belongs in the report…"), MainWindow::tr("Cancel"), 0, 0,
                             window);
    progress.setWindowModality(Qt::WindowModal);
    for (PanelDock* dock : docks) {
        PanelBase& panel = dock->panel();
        QCoreApplication::processEvents();  // a panel made just now begins here
        while (panel.isBusy() && !progress.wasCanceled()) {
            progress.setValue(0);
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
        }
    }
    return !progress.wasCanceled();
}

}  // namespace

void MainWindow::writeProjectReport(const QString& suffix)
{
    std::vector<PanelDock*> chosen;
    for (const std::string& id : session_.project().report)
        for (PanelDock* dock : docks_)
            if (dock->facts().id == id) chosen.push_back(dock);
    if (chosen.empty() && activeDock()) chosen.push_back(activeDock());  // nothing was put in: what is on screen
    writeReport(chosen, suffix);
}

void MainWindow::writeReport(const std::vector<PanelDock*>& docks, const QString& suffix)
{
    takeOverTyping(this);
    if (!waitForPanels(docks, this)) return;
    std::vector<report::Document> parts;
    bool answered = false;
    for (PanelDock* dock : docks) {
        PanelBase& panel = dock->panel();
        auto part = panel.reportDocument();
        answered = answered || part;
        parts.push_back(
            part ? std::move(*part)
                 : partWithoutAnswer(panel.facts(), session_.panel(panel.facts().stateKey()), panel.error()));
    }
    if (!answered) {
        announce({Phrase{LT_TEXT("Engine", "There is no result to report yet."), {}}, {}});
        return;
    }
    const report::TitleBlock block = titleBlockOf(session_.project());
    const QString projectName = QFileInfo(session_.path()).completeBaseName();
    std::string otherwise = projectName.toStdString();
    if (otherwise.empty() && docks.size() == 1) otherwise = docks.front()->facts().id;
    const std::string name = reportFileName(block, otherwise, QDate::currentDate().toString(Qt::ISODate).toStdString());
    QFileDialog dialog(this, tr("Write the report"),
                       QFileInfo(session_.path()).dir().filePath(QString::fromStdString(name) + "." + suffix),
                       suffix == "pdf" ? tr("PDF (*.pdf)") : tr("HTML (*.html)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    if (dialog.exec() != QDialog::Accepted) return;
    const QString path = dialog.selectedFiles().value(0);
    std::string title = block.part.empty() ? projectName.toStdString() : block.part;
    if (title.empty()) title = tr("Report").toStdString();
    report::Document document = joined(parts, title);
    setTitleBlock(document, block);
    const Worker::Outcome outcome =
        waitFor(this, tr("Writing the report…"),
                [path, document = std::move(document)](const Progress& progress) -> std::shared_ptr<const void> {
                    lathelier::writeReport(path, document, progress);
                    return nullptr;
                });
    if (const auto* error = std::get_if<Error>(&outcome)) announce({*error, {}});
    if (!std::holds_alternative<std::shared_ptr<const void>>(outcome)) return;
    announce({Phrase{LT_TEXT("Engine", "Saved {path}."), {{"path", path.toStdString()}}}, {}});
    openSaved_->disconnect();
    connect(openSaved_, &QToolButton::clicked, this,
            [path] { QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(path).absoluteFilePath())); });
    openSaved_->show();
}

void MainWindow::askForTitleBlock()
{
    TitleBlockDialog dialog(titleBlockOf(session_.project()), this);
    if (dialog.exec() != QDialog::Accepted) return;
    const report::TitleBlock block = dialog.block();
    TitleBlockDialog::keep(block);
    session_.edit(tr("Change the title block"),
                  [&](project::Project& project) { project.title_block = toValues(block); });
}

}  // namespace lathelier
