// Watches the files that were read: what other programs do to them is told, and taken only when the user wants it.
#pragma once

#include <QObject>
#include <QTimer>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/project/project.h"
#include "widgets/core/files/stores.h"
#include "widgets/core/task/task.h"

namespace lathelier {

/// Looks at the files of all stores every two seconds, in a thread of its own, for a file system may hang.
class SourceWatch : public QObject {
    Q_OBJECT
public:
    explicit SourceWatch(std::shared_ptr<Stores> stores, QObject* parent = nullptr);

    /// What became of the files behind `state`: notes sourceChangedSince and sourceGone.
    Notes notesOf(const project::PanelState& state) const;

    /// Compares the sources of a project that was opened with the digests it was saved with; what differs is told by
    /// found().
    void compareWithSaved(const project::Project& project);

    /// Looks now, not at the next turn.
    void look();

    /// Forgets what it found: the new files are being taken.
    void clear();

signals:
    void changed();                           ///< notesOf() has something new
    void found(const lathelier::Note& note);  ///< for the message log, once for each change
    void savedCompared();                     ///< compareWithSaved() is through

private:
    struct Finding {
        std::string stamp;  ///< of the file that is there
        Note note;          ///< sourceChangedSince or sourceGone
    };
    using Findings = std::map<std::string, Finding>;  ///< by path

    static Findings changesOf(const Stores& stores, const Findings& known, const Progress& progress);
    void take(const Findings& now);

    std::shared_ptr<Stores> stores_;
    Findings findings_;
    QTimer turn_;
    Task task_;
};

}  // namespace lathelier
