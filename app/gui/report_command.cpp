#include "app/gui/report_command.h"

#include <QFileInfo>
#include <algorithm>
#include <iostream>

#include "widgets/core/language.h"
#include "widgets/core/report_files.h"
#include "widgets/core/scan_store.h"

namespace lathelier {
namespace {

int exitCode(ErrorKind kind)
{
    switch (kind) {
        case ErrorKind::WrongUsage: return 2;
        case ErrorKind::InputRejected: return 3;
        case ErrorKind::NoAnswer: return 4;
    }
    return 4;
}

std::vector<std::string> reported(const Project& project)
{
    if (!project.report.empty()) return project.report;
    std::vector<std::string> all;
    for (const auto& [id, panel] : project.panels)
        if (!panel.inputs.empty()) all.push_back(id);
    return all;
}

}  // namespace

int runReport(const QString& file, const QString& project, const std::vector<PanelFacts>& panels)
{
    try {
        const ProjectFile opened = readProject(QFileInfo(project).absoluteFilePath().toStdString());
        for (const Note& note : opened.notes) std::cerr << screenText(note).toStdString() << '\n';
        ScanStore scans;
        std::vector<Document> parts;
        for (const std::string& id : reported(opened.project)) {
            const auto facts =
                std::find_if(panels.begin(), panels.end(), [&](const PanelFacts& panel) { return panel.id == id; });
            const auto state = opened.project.panels.find(id);
            if (facts != panels.end() && state != opened.project.panels.end())
                parts.push_back(facts->report(state->second, scans, screenLanguage(), {}));
        }
        if (parts.empty()) {
            std::cerr << screenText(LT_TEXT("Engine", "The project has nothing to report.")).toStdString() << '\n';
            return 4;
        }
        writeReport(file, joined(parts, QFileInfo(project).completeBaseName().toStdString()));
    } catch (const Error& error) {
        std::cerr << screenText(error).toStdString() << '\n';
        return exitCode(kind(error.code()));
    }
    std::cerr << QFileInfo(file).absoluteFilePath().toStdString() << '\n';
    return 0;
}

}  // namespace lathelier
