// Projects as files: new, open, save, recent, the sample, unsaved work after a crash.
#pragma once

#include <QObject>
#include <QTimer>
#include <QWidget>

#include "app/gui/recovery.h"
#include "widgets/core/panel/message.h"
#include "widgets/core/session.h"

namespace lathelier {

/// The file commands of a window. Asks before unsaved work is lost; says everything else by messageRaised.
class ProjectFiles : public QObject {
    Q_OBJECT
public:
    /// `recoveryFolder` empty: nothing is kept aside (screenshots, reports).
    ProjectFiles(Session& session, const QString& recoveryFolder, QWidget* window);

    void startNew();
    void open(const QString& path);  ///< asks about unsaved work first
    bool save();                     ///< asks for a name when there is none; false: not saved
    bool saveAs();
    void saveRecipe(const project::PartInputs& part_inputs);  ///< asks for a name
    void openSample();                                        ///< makes it when it is not there yet

    /// True when nothing is lost by going on: saved, or the user said so.
    bool mayLeave();

    /// Unsaved work of a run that ended unexpectedly: opened or thrown away as the user says.
    void offerLostWork();

    void
    keepAside();  ///< what is done a second after each change: a copy for the next start, should this run not end well

    /// The program ends without a question (logout, shutdown): unsaved work is kept for the next start.
    void leaveWithoutAsking();

    static bool isProject(const QString& path);
    static QString filter();  ///< for file dialogs

signals:
    void messageRaised(const lathelier::Message& message);
    void recentChanged();

private:
    enum class Overtaken { OtherName, Replace, Stay };

    bool write(const QString& path);
    Overtaken askOvertaken(const QString& path);
    QString makeSample();

    Session& session_;
    QWidget* window_;
    std::unique_ptr<Recovery> recovery_;
    QTimer keeping_;  ///< since the first change that is not kept yet
};

}  // namespace lathelier
