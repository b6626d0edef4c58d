// The left column of a panel: its files and its parameters.
#pragma once

#include <QScrollArea>
#include <map>
#include <optional>

#include "engine/walk/walk.h"
#include "widgets/core/panel/panel_facts.h"

class QToolButton;

namespace lathelier {

class Form;
class InputBox;

/// Shows a PanelState and emits the changes requested by the user, which the panel applies through the session; `step`
/// names the change in the Edit menu. Optional inputs that are not given have no place of their own: one button offers
/// them.
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
    void filesChosen(const lathelier::InputRole& role, const QStringList& paths);
    void sourcesChosen(const lathelier::InputRole& role, const std::vector<lathelier::project::Source>& sources,
                       const QString& step);
    void parameterEdited(const std::string& key, const lathelier::Value& value, int gesture, const QString& step);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    InputBox* makeBox(const InputRole& role);
    bool hasPlace(const InputRole& role) const;
    void showPlaces();
    void fillAddMenu();
    void retranslate();
    void use(const InputRole& role, const QString& item);
    void ask(const InputRole& role);
    void choose(const InputRole& role, const QStringList& paths);

    PanelInputs inputs_;
    project::PanelState state_;
    std::map<std::string, InputBox*> boxes_;
    std::map<std::string, QStringList> items_;  ///< of the project, by role
    QToolButton* add_;
    Form* form_;
};

/// The source of a newly chosen file.
project::Source newSource(const QString& path);

/// "Point clouds and meshes (*.xyz *.ply);;All files (*)"; of several kinds, first all of them.
QString fileFilter(const io::FileKinds& kinds);

/// In natural order: "section2" before "section10".
QStringList counted(QStringList paths);

}  // namespace lathelier
