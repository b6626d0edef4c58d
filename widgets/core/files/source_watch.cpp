#include "widgets/core/files/source_watch.h"

#include <algorithm>
#include <utility>

#include "engine/io/io_codes.h"
#include "engine/project/project_codes.h"

namespace lathelier {
namespace {

constexpr int turn_ms = 2000;

}  // namespace

SourceWatch::SourceWatch(std::shared_ptr<Stores> stores, QObject* parent) : QObject(parent), stores_(std::move(stores))
{
    connect(&turn_, &QTimer::timeout, this, &SourceWatch::look);
    turn_.start(turn_ms);
}

Notes SourceWatch::notesOf(const project::PanelState& state) const
{
    Notes notes;
    for (const auto& item : findings_)
        if (std::any_of(state.inputs.begin(), state.inputs.end(),
                        [&](const auto& input) { return input.second.path == item.first; }))
            notes.push_back(item.second.note);
    return notes;
}

void SourceWatch::compareWithSaved(const project::Project& project)
{
    task_.compute<Notes>([project](const Progress& progress) { return project::checkSources(project, progress); },
                         [this](const Notes& notes) {
                             for (const Note& note : notes) emit found(note);
                             emit savedCompared();
                         },
                         [](const Error&) {});
}

void SourceWatch::look()
{
    if (task_.isBusy()) return;
    task_.compute<Findings>(
        [stores = stores_, known = findings_](const Progress& progress) { return changesOf(*stores, known, progress); },
        [this](const Findings& now) { take(now); }, [](const Error&) {});
}

/// Findings for the changed files; `known` findings of unchanged files are reused.
SourceWatch::Findings SourceWatch::changesOf(const Stores& stores, const Findings& known, const Progress& progress)
{
    Findings findings;
    for (const FileSeen& file : stores.seen()) {
        progress.check();
        const std::string stamp = io::fileStamp(file.path);
        if (stamp == file.stamp) continue;
        const auto before = known.find(file.path);
        if (before != known.end() && before->second.stamp == stamp) {
            findings.insert(*before);
            continue;
        }
        try {
            const std::string now = io::fileSha256(file.path, progress);
            if (now != file.sha256)
                findings[file.path] = {stamp,
                                       {notes::sourceChangedSince,
                                        {{"path", file.path},
                                         {"read", shortDigest(file.sha256)},
                                         {"now", shortDigest(now)},
                                         {"read_sha256", file.sha256},
                                         {"now_sha256", now}}}};
        } catch (const Error& error) {
            if (error.code() == errors::fileChanged) continue;  // still being written: checked at the next turn
            findings[file.path] = {
                stamp,
                {notes::sourceGone,
                 {{"path", file.path}, {"read", shortDigest(file.sha256)}, {"read_sha256", file.sha256}}}};
        }
    }
    return findings;
}

void SourceWatch::clear()
{
    findings_.clear();
    emit changed();
}

void SourceWatch::take(const Findings& now)
{
    const Findings before = std::exchange(findings_, now);
    bool differs = before.size() != findings_.size();
    for (const auto& [path, finding] : findings_) {
        const auto earlier = before.find(path);
        if (earlier != before.end() && earlier->second.stamp == finding.stamp) continue;
        differs = true;
        emit found(finding.note);
    }
    if (differs) emit changed();
}

}  // namespace lathelier
