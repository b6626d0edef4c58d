// Determines the kinds of opened or dropped files from their heads, in the background.
#pragma once

#include <QObject>
#include <QStringList>
#include <deque>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "engine/io/file_kind.h"
#include "widgets/core/task/task.h"

namespace lathelier {

/// An opened or dropped file.
struct FoundFile {
    std::string path;                          ///< path as given
    const io::FileKind* kind = nullptr;        ///< kind; nullptr: unknown or unreadable
    io::Likeness likeness = io::Likeness::No;  ///< confidence of the kind
};

/// Lists of files are processed and answered in order. For the GUI thread.
class KindFinder : public QObject {
    Q_OBJECT
public:
    using Done = std::function<void(const std::vector<FoundFile>&)>;

    explicit KindFinder(io::FileKinds kinds, QObject* parent = nullptr);

    /// Calls `done` with a file for each path; not before this function has returned.
    void find(const QStringList& paths, Done done);
    bool isBusy() const { return task_.isBusy(); }

private:
    void next();

    io::FileKinds kinds_;
    std::deque<std::pair<std::vector<std::string>, Done>> waiting_;
    Task task_;
};

}  // namespace lathelier
