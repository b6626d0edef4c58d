// Which kinds of file were opened or dropped: their heads are looked at in the background.
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

/// A file that was opened or dropped.
struct FoundFile {
    std::string path;                          ///< as it was given
    const io::FileKind* kind = nullptr;        ///< nullptr: of no kind, or not to be read
    io::Likeness likeness = io::Likeness::No;  ///< how much its head speaks for that kind
};

/// Lists of files are looked at one after another, and answered in that order. Lives in the GUI thread.
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
