// What a panel offers of its result: exports, and everything of it as a command.
#include <QCoreApplication>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QPointer>

#include "engine/batch/recipe_file.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/report/result_json.h"
#include "widgets/core/form/form.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/form/typing.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/message_line.h"
#include "widgets/core/panel/panel_base.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/core/session.h"
#include "widgets/core/task/progress_row.h"

namespace lathelier {

std::vector<PanelExport> PanelBase::offeredExports() const
{
    if (!result_) return {};
    std::vector<PanelExport> all = exports();
    all.push_back({tr("All numbers (JSON)…"), tr("JSON (*.json)"), "json", [this](const QString& path) {
                       const auto part = reportDocument();
                       io::writeFile(path.toStdString(), part ? report::joinedResults(part->results) : std::string());
                   }});
    if (facts_.task && batch::hasVaried(*facts_.task, state_))
        all.push_back({tr("Recipe for many parts (JSON)…"), tr("JSON (*.json)"), "json", [this](const QString& path) {
                           batch::writeRecipe(path.toStdString(), batch::recipeOf(*facts_.task, state_));
                       }});
    return all;
}

void PanelBase::reportWriteFailure(const QString& path)
{
    const Error error(errors::fileNotWritable,
                      {{"path", path.toStdString()}, {"reason", LT_TEXT("Engine", "the system refused it")}});
    emit messageRaised({error, facts_.title});
}

void PanelBase::fillExportMenu()
{
    QMenu* menu = progress_->exportMenu();
    menu->clear();
    for (const PanelExport& item : offeredExports())
        menu->addAction(item.label, this, [this, item] { runExport(item); });
}

std::vector<PanelCommand> PanelBase::commands()
{
    std::vector<PanelCommand> all;
    const auto add = [&](const QString& kind, const QString& name, std::function<void()> run) {
        all.push_back({kind + QStringLiteral(" › ") + name, [alive = QPointer<PanelBase>(this), run = std::move(run)] {
                           if (alive) run();
                       }});
    };
    for (const FieldInfo& info : inputs_.fields)
        add(tr("Input"), screenText(info.label), [this, key = info.key, folded = info.advanced] {
            if (folded) column_->form().setUnfolded(true);
            QWidget* editor = column_->form().editor(key);
            if (!editor) return;
            column_->ensureWidgetVisible(editor);
            editor->setFocus(Qt::ShortcutFocusReason);
        });
    if (primaryViews_ && hasResult())
        for (const QString& key : primaryViews_->keys())
            add(tr("View"), primaryViews_->title(key), [this, key] { primaryViews_->setPrimary(key); });
    for (const PanelExport& item : offeredExports()) add(tr("Export"), item.label, [this, item] { runExport(item); });
    if (isCurrent() && !problemOf(result_.get()))
        for (const report::Finding& finding : answerOf(result_.get()).findings)
            if (!finding.offer.empty() || finding.place.isAny())
                add(tr("Finding"), QString::fromStdString(report::findingText(finding, screenLanguage())),
                    [this, finding] {
                        if (finding.offer.empty())
                            showPlace(finding.place);
                        else
                            takeOffer(finding.offer);
                    });
    return all;
}

void PanelBase::takeOffer(const Values& proposed)
{
    editState(tr("Use what the answer proposes"), [&](project::PanelState& state) {
        for (const auto& [key, value] : proposed) lathelier::set(state.parameters, key, value);
    });
}

void PanelBase::writeExport(const PanelExport& item, const QString& path) const
{
    if (!item.may_replace_input)
        for (const FileSeen& file : session_.stores().seen())
            if (QFileInfo(path) == QFileInfo(QString::fromStdString(file.path)))
                throw Error(errors::outputIsInput, {{"parameter", item.label.toStdString()}, {"file", file.path}});
    item.write(path);
}

void PanelBase::runExport(const PanelExport& item)
{
    takeOverTyping(this);
    QFileDialog dialog(this, item.label, {}, item.filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(item.suffix);
    if (dialog.exec() != QDialog::Accepted) return;
    const QString path = dialog.selectedFiles().value(0);
    // Pending input is computed first.
    const QPointer<PanelBase> alive(this);
    while (alive && isBusy()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
    if (!alive) return;
    try {
        writeExport(item, path);
        showAnswer();  // clears an earlier error
        emit messageRaised({Phrase{LT_TEXT("Engine", "Saved {path}."), {{"path", path.toStdString()}}}, facts_.title});
    } catch (const Error& error) {
        message_->setError(error);
        emit messageRaised({error, facts_.title});
    }
}

}  // namespace lathelier
