#include "widgets/chain/chain_steps.h"

#include <QCoreApplication>
#include <QStringList>
#include <map>

#include "engine/chain/dossier_report.h"
#include "widgets/core/language.h"

namespace lathelier::chain_panel {
namespace {

constexpr std::size_t shownDigits = 12;
constexpr int mostFiles = 12;

struct StepTexts {
    Q_DECLARE_TR_FUNCTIONS(lathelier::chain_panel::StepTexts)
};

QString linesOf(const std::vector<InputFile>& files)
{
    QStringList lines;
    for (const InputFile& file : files) {
        if (lines.size() == mostFiles) {
            lines << QStringLiteral("…");
            break;
        }
        lines << QStringLiteral("  %1  %2")
                     .arg(screenFileName(QString::fromStdString(file.path)),
                          QString::fromStdString(file.sha256.substr(0, shownDigits)));
    }
    return lines.join("\n");
}

}  // namespace

QString signOf(const chain::StepStanding& standing)
{
    switch (standing.state) {
        case chain::StepState::Done:
            if (standing.isSound()) return QStringLiteral("✓");
            return *standing.verdict == Verdict::Fail ? QStringLiteral("✗") : QStringLiteral("?");
        case chain::StepState::OutOfDate: return QStringLiteral("!");
        case chain::StepState::Failed: return QStringLiteral("✗");
        case chain::StepState::NotReached: return QStringLiteral("○");
        case chain::StepState::Missing: break;
    }
    return QStringLiteral("–");
}

const char* panelOf(const std::string& step)
{
    static const std::map<std::string, const char*> all{{"recognise", "recognise"},
                                                        {"draw", "drawing"},
                                                        {"machine", "shaft"},
                                                        {"speeds", "lobes"},
                                                        {"program", "turning"},
                                                        {"deflection", "deflection"},
                                                        {"deflection_2", "deflection"},
                                                        {"corrected_check", "turning"},
                                                        {"copy", "compare"},
                                                        {"surface", "surface"}};
    const auto found = all.find(step);
    return found == all.end() ? nullptr : found->second;
}

QString aboutOf(const chain::ChainStep& step)
{
    const chain::StepStanding standing = chain::standingOf(step);
    QString about =
        screenText(chain::titleOf(step.id)) + ": " + signOf(standing) + " " + screenText(chain::nameOf(standing));
    if (step.error)
        about += "\n  " + screenText(*step.error);
    else if (step.state == chain::StepState::Failed && !step.remarks.empty())
        about += "\n  " + QString::fromStdString(step.remarks.back());
    if (!step.inputs.empty()) about += "\n" + StepTexts::tr("Takes (SHA-256):") + "\n" + linesOf(step.inputs);
    if (!step.outputs.empty()) about += "\n" + StepTexts::tr("Makes (SHA-256):") + "\n" + linesOf(step.outputs);
    return about;
}

}  // namespace lathelier::chain_panel
