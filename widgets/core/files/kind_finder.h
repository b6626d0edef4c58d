// Determines the kinds of opened or dropped files from their heads, in the background.
#pragma once

#include <QObject>
#include <QStringList>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/io/file_kind.h"
#include "widgets/core/task/task.h"

namespace lathelier {

/// An opened or dropped file.
struct FoundFile {
    std::string path;                          ///< path as given
    const io::FileKind* kind = nullptr;        ///< kind; nullptr: unknown or unreadable
    io::Likeness likeness = io::Likeness::No;  ///< confidence of the kind
    std::optional<Error> error = {};           ///< why it cannot be read
};

/// Why a file is not taken: it cannot be read, or is of none of the kinds (error fileOfOtherKind). Without kinds every
/// file is taken.
std::optional<Error> refusalOf(const FoundFile& file, const io::FileKinds& kinds);

/// Lists of files are processed and answered in order. For the GUI thread.
class KindFinder : public QObject {
    Q_OBJECT
public:
    using Done = std::function<void(const std::vector<FoundFile>&)>;

    explicit KindFinder(io::FileKinds kinds, QObject* parent = nullptr);

    /// Calls `done` with a file for each path; not before this function has returned. `kinds`: those looked for in
    /// place of all.
    void find(const QStringList& paths, Done done, const io::FileKinds& kinds = {});
    bool isBusy() const { return task_.isBusy(); }

private:
    void next();

    io::FileKinds kinds_;
    struct Asked {
        std::vector<std::string> paths;
        io::FileKinds kinds;
        Done done;
    };
    std::deque<Asked> waiting_;
    Task task_;
};

}  // namespace lathelier
