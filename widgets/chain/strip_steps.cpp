#include "widgets/chain/strip_steps.h"

#include <QCoreApplication>
#include <QStringList>

#include "engine/chain/dossier_report.h"
#include "widgets/chain/step_tile.h"
#include "widgets/core/language.h"

namespace lathelier::chain_panel {
namespace {

constexpr std::size_t shownDigits = 12;
constexpr int mostFiles = 12;

struct StripTexts {
    Q_DECLARE_TR_FUNCTIONS(lathelier::chain_panel::StripTexts)
};

/// The worst represents a group.
int weight(const chain::StepStanding& standing)
{
    switch (standing.state) {
        case chain::StepState::Failed: return 6;
        case chain::StepState::OutOfDate: return 5;
        case chain::StepState::NotReached: return 4;
        case chain::StepState::Missing: return 3;
        case chain::StepState::Done: break;
    }
    if (standing.isSound()) return 0;
    return *standing.verdict == Verdict::Fail ? 2 : 1;
}

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

const std::vector<StripStep>& stripSteps()
{
    static const std::vector<StripStep> all{
        {"scan", LT_TEXT("Engine", "Scan"), "recognise", {"recognise"}},
        {"drawing", LT_TEXT("Engine", "Drawing"), "drawing", {"draw"}},
        {"machine", LT_TEXT("Engine", "Machine"), "shaft", {"machine"}},
        {"speeds", LT_TEXT("Engine", "Speeds"), "lobes", {"speeds"}},
        {"program", LT_TEXT("Engine", "Program"), "turning", {"program"}},
        {"deflection",
         LT_TEXT("Engine", "Deflection"),
         "deflection",
         {"deflection", "deflection_2", "corrected_check"}},
        {"copy", LT_TEXT("Engine", "Copy"), "compare", {"copy"}},
        {"proof", LT_TEXT("Engine", "Proof"), chain::chainKey, {"proof", "surface"}}};
    return all;
}

chain::StepStanding standingOf(const StripStep& step, const chain::Dossier& dossier)
{
    const chain::ChainStep* const first = dossier.step(step.of_chain.front());
    chain::StepStanding worst = first ? chain::standingOf(*first) : chain::StepStanding{};
    for (const char* id : step.of_chain) {
        const chain::ChainStep* const further = dossier.step(id);
        // An optional chain step that is not given does not count.
        if (further && further->state != chain::StepState::Missing &&
            weight(chain::standingOf(*further)) > weight(worst))
            worst = chain::standingOf(*further);
    }
    return worst;
}

QString aboutOf(const StripStep& step, const chain::Dossier& dossier)
{
    QStringList parts;
    for (const char* id : step.of_chain) {
        const chain::ChainStep* const found = dossier.step(id);
        if (!found) continue;
        QString part = screenText(chain::titleOf(id)) + ": " + signOf(chain::standingOf(*found)) + " " +
                       wordOf(chain::standingOf(*found));
        if (found->error)
            part += "\n  " + screenText(*found->error);
        else if (found->state == chain::StepState::Failed && !found->remarks.empty())
            part += "\n  " + QString::fromStdString(found->remarks.back());
        if (!found->inputs.empty()) part += "\n" + StripTexts::tr("Takes (SHA-256):") + "\n" + linesOf(found->inputs);
        if (!found->outputs.empty()) part += "\n" + StripTexts::tr("Makes (SHA-256):") + "\n" + linesOf(found->outputs);
        parts << part;
    }
    return parts.join("\n\n");
}

}  // namespace lathelier::chain_panel
