// The left column of a panel: its files and its parameters.
#pragma once

#include <QScrollArea>
#include <map>
#include <optional>

#include "engine/walk/walk.h"
#include "widgets/core/panel/panel_facts.h"

namespace lathelier {

class Form;
class InputBox;

/// Shows a PanelState and emits the changes requested by the user, which the panel applies through the session; `step`
/// names the change in the Edit menu.
class InputColumn : public QScrollArea {
    Q_OBJECT
public:
    explicit InputColumn(const PanelInputs& inputs, QWidget* parent = nullptr);

    void showState(const project::PanelState& state);

    /// The project's items for roles that accept items.
    void showItems(const project::Project& project);

    /// The inputs that come from elsewhere in the part.
    void showTaken(const std::vector<walk::Taken>& taken);

    /// Facts of the files read so far, and the file that `error` refers to.
    using Understood = std::function<QString(const InputRole&, const project::Source&)>;
    void showFacts(const Understood& understood, const std::optional<Error>& error);

    Form& form() const { return *form_; }

    /// A control of the panel between its files: above the input `role`, centred.
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

/// The source of a newly chosen file.
project::Source newSource(const QString& path);

/// "Point clouds and meshes (*.xyz *.ply);;All files (*)"; of several kinds, first all of them.
QString fileFilter(const io::FileKinds& kinds);

/// In natural order: "section2" before "section10".
QStringList counted(QStringList paths);

}  // namespace lathelier
