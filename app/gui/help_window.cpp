#include "app/gui/help_window.h"

#include <QApplication>
#include <QEvent>
#include <QIcon>
#include <QMessageBox>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace lathelier {

HelpWindow::HelpWindow(QWidget* parent) : QDialog(parent), text_(new QTextBrowser)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(text_);
    text_->setFrameShape(QFrame::NoFrame);
    text_->document()->setDocumentMargin(20);
    resize(fontMetrics().averageCharWidth() * 85, fontMetrics().height() * 34);
    retranslate();
}

void HelpWindow::retranslate()
{
    setWindowTitle(tr("Lathelier help"));
    const QString keys = "<p style='margin: 2px'><b>%1</b> – %2</p>";
    const auto key = [&](const QString& name, const QString& what) { return keys.arg(name, what); };
    text_->setHtml(
        "<h2>" + tr("Compare a copy with its original") + "</h2><p>" +
        tr("Drop two scans on the window – the original (reference) and the copy – or open them at the "
           "left. Point clouds "
           "and meshes are read: XYZ, ASC, CSV, TXT, PTS, PLY, PCD, STL, OBJ. The answer stands in large "
           "type above the "
           "views, with its notes under it.") +
        "</p><p>" +
        tr("A positive deviation is material in excess, a negative one is missing material. State a "
           "tolerance at the left "
           "to get a verdict. Whatever you change is computed again at once; Undo takes back any step.") +
        "</p><h2>" + tr("Measure roundness and the spindle") + "</h2><p>" +
        tr("In workspace Roundness, drop a probe record (CSV, or a pair .dat and .par of L-Graph) or a "
           "measured profile. Three panels look at the same data: Roundness shows one section with its four "
           "reference circles, Trajectory how axis and tool move, Longitudinal the whole workpiece. Section, "
           "circle and filter are chosen once for all of them. The worst section is shown first.") +
        "</p><h2>" + tr("When a file is refused") + "</h2><p>" +
        tr("The message names the file, the line and column or byte, and what was expected. If the file "
           "leaves its unit or "
           "its decimal mark open, state it under the file's name at the left; the project remembers it.") +
        "</p><h2>" + tr("Reports") + "</h2><p>" +
        tr("“Report…” writes the result on screen as HTML or PDF, with method, parameters, notes and the "
           "digests of the "
           "input files. “In the report” makes it part of the project's report (File menu).") +
        "</p><h2>" + tr("Keys") + "</h2>" + key("Ctrl+O", tr("open a project or measured files")) +
        key("Ctrl+S", tr("save the project")) + key("Ctrl+Z, Ctrl+Shift+Z", tr("undo, redo")) +
        key("F5", tr("compute again")) + key("Esc", tr("stop the computation")) +
        key("F9", tr("presenter mode: larger type, thicker lines")) + key("F11", tr("full screen")) +
        key("Ctrl+Shift+P", tr("all commands, found by typing")));
}

void HelpWindow::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
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
