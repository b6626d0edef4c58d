// The left column of a panel: its files and its parameters.
#pragma once

#include <QScrollArea>
#include <map>
#include <optional>

#include "widgets/core/panel/panel_facts.h"

namespace lathelier {

class Form;
class InputBox;

/// Shows a PanelState and says what the user wants changed. Changes nothing by itself: the panel does, through the
/// session; `step` names the change in the Edit menu.
class InputColumn : public QScrollArea {
    Q_OBJECT
public:
    explicit InputColumn(const PanelInputs& inputs, QWidget* parent = nullptr);

    void showState(const project::PanelState& state);

    /// What the project has for roles that take items.
    void showItems(const project::Project& project);

    /// What was understood of the files so far, and which of them `error` is about.
    using Understood = std::function<QString(const InputRole&, const project::Source&)>;
    void showFacts(const Understood& understood, const std::optional<Error>& error);

    Form& form() const { return *form_; }

    /// A control that belongs to the panel, between its files: above the input `role`, in the middle.
    void insertBefore(const std::string& role, QWidget* control);

signals:
    void sourcesChosen(const lathelier::InputRole& role, const std::vector<lathelier::project::Source>& sources,
                       const QString& step);
    void parameterEdited(const std::string& key, const lathelier::Value& value, int gesture, const QString& step);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    InputBox* makeBox(const InputRole& role);
    void ask(const InputRole& role);
    void choose(const InputRole& role, const QStringList& paths);

    PanelInputs inputs_;
    project::PanelState state_;
    std::map<std::string, InputBox*> boxes_;
    Form* form_;
};

/// A source as it is when a file has just been chosen.
project::Source newSource(const QString& path);

/// "Point clouds and meshes (*.xyz *.ply);;All files (*)"; of several kinds, first all of them.
QString fileFilter(const io::FileKinds& kinds);

/// In the order a person counts them: "section2" before "section10".
QStringList counted(QStringList paths);

}  // namespace lathelier
