#include "app/gui/report_command.h"

#include <QFileInfo>
#include <algorithm>
#include <iostream>

#include "widgets/core/language.h"
#include "widgets/core/report_files.h"
#include "widgets/core/stores.h"

namespace lathelier {
namespace {

int exitCode(ErrorKind kind)
{
    switch (kind) {
        case ErrorKind::WrongUsage: return 2;
        case ErrorKind::InputRejected: return 3;
        case ErrorKind::NoAnswer: return 4;
        case ErrorKind::OutputFailed: return 5;
    }
    return 4;
}

/// Ids of panels: those the user put into the report, else all that have something to work on.
std::vector<std::string> reported(const Project& project, const std::vector<PanelFacts>& panels)
{
    if (!project.report.empty()) return project.report;
    std::vector<std::string> all;
    for (const PanelFacts& facts : panels) {
        const auto state = project.panels.find(facts.stateKey());
        if (state != project.panels.end() && hasWork(facts, state->second)) all.push_back(facts.id);
    }
    return all;
}

}  // namespace

int runReport(const QString& file, const QString& project, const std::vector<PanelFacts>& panels)
{
    try {
        const ProjectFile opened = readProject(QFileInfo(project).absoluteFilePath().toStdString());
        for (const Note& note : opened.notes) std::cerr << screenText(note).toStdString() << '\n';
        Stores stores;
        std::vector<Document> parts;
        for (const std::string& id : reported(opened.project, panels)) {
            const auto facts =
                std::find_if(panels.begin(), panels.end(), [&](const PanelFacts& panel) { return panel.id == id; });
            if (facts == panels.end()) continue;
            const auto state = opened.project.panels.find(facts->stateKey());
            if (state != opened.project.panels.end())
                parts.push_back(facts->report(state->second, stores, screenLanguage(), {}));
        }
        if (parts.empty()) {
            std::cerr << screenText(LT_TEXT("Engine", "The project has nothing to report.")).toStdString() << '\n';
            return 4;
        }
        writeReport(file, joined(parts, QFileInfo(project).completeBaseName().toStdString()));
    } catch (const Error& error) {
        std::cerr << screenText(error).toStdString() << '\n';
        return exitCode(error.code().kind);
    }
    std::cerr << QFileInfo(file).absoluteFilePath().toStdString() << '\n';
    return 0;
}

}  // namespace lathelier
