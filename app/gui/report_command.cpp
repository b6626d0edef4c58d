#include "app/gui/report_command.h"

#include <QFileInfo>
#include <algorithm>
#include <iostream>

#include "app/gui/shop_choice.h"
#include "engine/core/failure.h"
#include "engine/report/title_block.h"
#include "engine/task/stores.h"
#include "engine/walk/shop_supply.h"
#include "engine/walk/walk.h"
#include "widgets/core/language.h"
#include "widgets/core/report/report_files.h"

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
std::vector<std::string> reported(const project::Project& project, const std::vector<PanelFacts>& panels)
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
    int code = 0;
    const auto say = [](const QString& text) { std::cerr << text.toStdString() << '\n'; };
    const auto refuse = [&](const Error& error) {
        say(screenText(error));
        if (code == 0) code = exitCode(error.code().kind);
    };
    try {
        const project::Project opened =
            project::readProject(QFileInfo(project).absoluteFilePath().toStdString()).project;
        for (const Note& note : project::checkSources(opened)) say(screenText(note));
        const auto stores = std::make_shared<Stores>();
        const walk::Walk walk(opened, placesOf(panels), walk::supplyOf(shopOf(opened)), stores);
        std::vector<report::Document> parts;
        bool answered = false;
        for (const std::string& id : reported(opened, panels)) {
            const auto facts =
                std::find_if(panels.begin(), panels.end(), [&](const PanelFacts& panel) { return panel.id == id; });
            if (facts == panels.end()) continue;
            const project::PanelState state =
                walk.place(id) ? walk.promised(id) : project::resolved(opened, facts->stateKey());
            if (facts->missing && !facts->missing(state).empty()) {
                parts.push_back(partWithoutAnswer(*facts, state, {}));
                say(screenText(facts->title));
                for (const report::Block& block : parts.back().sections.front().blocks)
                    if (const auto* words = std::get_if<report::Paragraph>(&block))
                        say("  " + QString::fromStdString(fill(screenText(words->pattern).toStdString(), words->values,
                                                               screenLanguage())));
                if (code == 0) code = exitCode(ErrorKind::NoAnswer);
                continue;
            }
            try {
                task::Sources sources;
                const project::PanelState asked = walk.place(id) ? walk.complete(id, sources.notes, {}) : state;
                parts.push_back(facts->report(asked, *stores, sources, screenLanguage(), {}));
                answered = true;
            } catch (const std::exception& failure) {  // the other panels are reported all the same
                parts.push_back(partWithoutAnswer(*facts, state, toError(failure)));
                refuse(toError(failure));
            }
        }
        if (!answered) {
            say(screenText(LT_TEXT("Engine", "The project has nothing to report.")));
            return code == 0 ? exitCode(ErrorKind::NoAnswer) : code;
        }
        const auto block = fromValues<report::TitleBlock>(opened.title_block);
        report::Document document =
            joined(parts, block.part.empty() ? QFileInfo(project).completeBaseName().toStdString() : block.part);
        setTitleBlock(document, block);
        writeReport(file, std::move(document));
    } catch (const std::exception& failure) {
        code = 0;  // that nothing was written matters more than what is missing in it
        refuse(toError(failure));
        return code;
    }
    say(QFileInfo(file).absoluteFilePath());
    return code;
}

}  // namespace lathelier
