#include "widgets/turning/turning_exports.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMessageBox>
#include <algorithm>

#include "engine/cam/plan_codes.h"
#include "engine/cam/plan_files.h"
#include "engine/cam/plan_outcome.h"
#include "engine/gcode/toolpath_files.h"
#include "engine/io/file.h"

namespace lathelier::turning_panel {
namespace {

struct ExportWords {
    Q_DECLARE_TR_FUNCTIONS(TurningExports)
};

}  // namespace

void writePrograms(const cam::TurningOutcome& outcome, const QString& path, QWidget* parent)
{
    requireWritable(outcome);
    const std::vector<std::string> paths = cam::programPaths(path.toStdString(), outcome.programs.size());
    cam::refuseInputs(paths, outcome.sources.inputs, paths.front());
    // The dialog asked for one name, and two others are written.
    QStringList there;
    if (paths.size() > 1)
        for (const std::string& each : paths)
            if (const QFileInfo file(QString::fromStdString(each)); file.exists()) there << file.fileName();
    if (!there.isEmpty() &&
        QMessageBox::question(parent, ExportWords::tr("Programs of both clampings"),
                              ExportWords::tr("Already there: %1. Replace?").arg(there.join(", "))) != QMessageBox::Yes)
        throw Error(errors::nothingReplaced, {{"path", paths.front()}});
    cam::writePrograms(*outcome.plan, paths);
}

void writeMovesOf(const cam::SetupPlan& setup, const QString& path)
{
    std::string text;
    gcode::writeMoves(setup.check.path, [&text](std::string_view part) { text += part; });
    io::writeFile(path.toStdString(), text);
}

}  // namespace lathelier::turning_panel
