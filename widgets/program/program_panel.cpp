#include "widgets/program/program_panel.h"

#include <QFileDialog>
#include <QFileInfo>

#include "engine/io/file.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/session.h"
#include "widgets/program/program_views.h"
#include "widgets/program_common/program_editor.h"

namespace lathelier::program_panel {
namespace {

using deflection::ToolpathQuestion;
using gcode::draftsKey;
using gcode::ProgramDraft;
using gcode::programRole;

const std::vector<std::string> roles{programRole, deflection::setupRole, deflection::stockRole};

PanelInputs panelInputs()
{
    return inputsOf(deflection::toolpathTask(), roles, {"changed_z_zero_mm", "dialect", "integer_words"}, false,
                    LT_TEXT("Engine",
                            "Drop an NC program here: its path, its remarks and its time follow. With a "
                            "set-up (SETUP.json) it is checked against the stock."));
}

void forgetDraft(ToolpathQuestion& question, const ProgramOutcome& outcome)
{
    std::erase_if(question.drafts,
                  [&](const ProgramDraft& draft) { return isOf(draft, outcome.file, outcome.sha256); });
}

}  // namespace

PanelFacts programPanelFacts()
{
    PanelFacts facts =
        deflection_common::turningFacts(factsOf(deflection::toolpathTask(), "program", "program", roles, {}));
    facts.answer = answeredBy(deflection::answerToolpath);
    facts.make = [](Session& session) -> PanelBase* { return new ProgramPanel(session); };
    return facts;
}

ProgramPanel::ProgramPanel(Session& owner, QWidget* parent)
    : TurningPanel(owner, programPanelFacts(), panelInputs(), parent), views_(new ProgramViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &ProgramViews::edited, this, &ProgramPanel::keepDraft);
    connect(views_, &ProgramViews::saveRequested, this, &ProgramPanel::askAndSave);
    connect(views_, &ProgramViews::discardRequested, this,
            [this] { setDraft(tr("Discard the changes of the program"), std::nullopt); });
    connect(views_, &ProgramViews::notWritten, this, &ProgramPanel::reportWriteFailure);
}

/// Pending input is kept; else the text follows the project, including undo.
void ProgramPanel::showResult(const std::shared_ptr<const ProgramOutcome>& outcome)
{
    const auto source = state().inputs.find(programRole);
    const bool is_asked = source != state().inputs.end() && source->second.item == outcome->item &&
                          (!outcome->item.empty() || source->second.path == outcome->file);
    const auto asked = fromValues<ToolpathQuestion>(state().parameters);
    const ProgramDraft* draft = draftOf(asked.drafts, outcome->file, outcome->sha256);
    const bool is_newest = draft ? outcome->isDraft() && draft->text == outcome->text : !outcome->isDraft();
    views_->setOutcome(outcome, is_asked && is_newest && !views_->editor()->isTyping());
}

void ProgramPanel::keepDraft()
{
    const auto outcome = result();
    if (!outcome) return;
    const std::string text = views_->editor()->program().toStdString();
    if (text == outcome->file_text)
        setDraft(tr("Edit the program"), std::nullopt);
    else
        setDraft(tr("Edit the program"), text);
}

void ProgramPanel::setDraft(const QString& step, const std::optional<std::string>& utf8)
{
    const auto outcome = result();
    if (!outcome) return;
    editState(
        step,
        [&](project::PanelState& state) {
            auto question = fromValues<ToolpathQuestion>(state.parameters);
            forgetDraft(question, *outcome);
            if (utf8) question.drafts.push_back({outcome->file, outcome->sha256, *utf8});
            lathelier::set(state.parameters, draftsKey, *lathelier::find(toValues(question), draftsKey));
        },
        utf8 ? "program.text" : QString());
}

void ProgramPanel::saveTo(const QString& path)
{
    views_->editor()->takeOver();
    const auto outcome = result();
    if (!outcome) return;
    const std::string text = views_->editor()->program().toStdString();
    // The bytes of the file decide whether it is Latin-1.
    const auto file =
        session().stores().of<task::CacheOf<gcode::ProgramInput>>()->known(state().inputs.at(programRole));
    io::writeFile(path.toStdString(), gcode::bytesOf(text, file ? file->file.text : std::string()));
    const bool is_same = QFileInfo(path) == QFileInfo(QString::fromStdString(outcome->file));
    editState(tr("Save the program"), [&](project::PanelState& state) {
        auto question = fromValues<ToolpathQuestion>(state.parameters);
        forgetDraft(question, *outcome);
        lathelier::set(state.parameters, draftsKey, *lathelier::find(toValues(question), draftsKey));
        if (!is_same) state.inputs[programRole] = newSource(path);
    });
    if (is_same) session().takeNewFiles();
}

/// With a new name; the dialog confirms overwriting.
void ProgramPanel::askAndSave()
{
    const auto outcome = result();
    if (!outcome) return;
    const QFileInfo file(QString::fromStdString(outcome->file));
    QFileDialog dialog(this, tr("Save the program"), file.dir().path(),
                       tr("NC program (*.nc *.ngc *.mpf *.tap);;All files (*)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(file.suffix());
    dialog.selectFile(tr("%1 changed").arg(file.completeBaseName()).replace(' ', '_') + '.' + file.suffix());
    if (dialog.exec() != QDialog::Accepted) return;
    const QString path = dialog.selectedFiles().value(0);
    try {
        saveTo(path);
        emit messageRaised({Phrase{LT_TEXT("Engine", "Saved {path}."), {{"path", path.toStdString()}}}, facts().title});
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

std::vector<PanelExport> ProgramPanel::exports() const
{
    if (!result()) return {};
    std::vector<PanelExport> all = TurningPanel::exports();
    auto* panel = const_cast<ProgramPanel*>(this);  // saving changes the project, like the button
    all.insert(all.begin(), {tr("Program as it stands here…"), tr("NC program (*.nc *.ngc *.mpf *.tap)"), "nc",
                             [panel](const QString& path) { panel->saveTo(path); }, true});
    return all;
}

void ProgramPanel::showPlace(const report::Place& place)
{
    if (!place.line) return;
    views_->primaryViews()->setPrimary("program");
    views_->goToLine(*place.line);
}

void ProgramPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::program_panel
