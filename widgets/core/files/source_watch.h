// Watches the files read: changes by other programs are reported, and accepted only on request.
#pragma once

#include <QObject>
#include <QTimer>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/project/project.h"
#include "engine/task/stores.h"
#include "widgets/core/task/task.h"

namespace lathelier {

/// Checks the files of all stores every two seconds in a separate thread, since a file system may block.
class SourceWatch : public QObject {
    Q_OBJECT
public:
    explicit SourceWatch(std::shared_ptr<Stores> stores, QObject* parent = nullptr);

    /// Changes of the files of `state`: notes sourceChangedSince and sourceGone.
    Notes notesOf(const project::PanelState& state) const;

    /// Compares the sources of a project that was opened with the digests it was saved with; differences are reported
    /// by found().
    void compareWithSaved(const project::Project& project);

    /// Checks now, not at the next turn.
    void look();

    /// Clears the findings: the new files are being accepted.
    void clear();

signals:
    void changed();                           ///< notesOf() has changed
    void found(const lathelier::Note& note);  ///< for the message log, once for each change
    void savedCompared();                     ///< compareWithSaved() has finished

private:
    struct Finding {
        std::string stamp;  ///< stamp of the present file
        Note note;          ///< note sourceChangedSince or sourceGone
    };
    using Findings = std::map<std::string, Finding>;  ///< findings by path

    static Findings changesOf(const Stores& stores, const Findings& known, const Progress& progress);
    void take(const Findings& now);

    std::shared_ptr<Stores> stores_;
    Findings findings_;
    QTimer turn_;
    Task task_;
};

}  // namespace lathelier
