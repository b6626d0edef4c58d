// Autosave and recovery: unsaved work is kept aside while the program runs, and found again after a crash.
#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <QStringList>
#include <memory>
#include <vector>

#include "widgets/core/session.h"

namespace lathelier {

/// Unsaved work of a run that did not end properly.
struct LostWork {
    QString file;                 ///< the project as it was kept aside
    QString original;             ///< the project file it belongs to; empty: it had none
    std::string original_sha256;  ///< of that file when the work on it began
    QDateTime kept;               ///< when it was kept aside last
    QStringList files;            ///< names of the input files it works on
};

/// The place of this run's unsaved work inside `folder`. The files of a run are locked while it lives; files without a
/// running owner are lost work.
class Recovery {
public:
    explicit Recovery(const QString& folder);
    ~Recovery();

    /// Keeps the session's state when it is modified, forgets it when it is not. Throws Error.
    void keep(const Session& session);
    void forget();

    /// This run ends now: what is kept stays for the next one.
    void leave();

    std::vector<LostWork> lostWork() const;
    static void discard(const LostWork& work);

private:
    QString folder_;
    QString file_;
    std::unique_ptr<QLockFile> lock_;
};

}  // namespace lathelier
