#include "widgets/core/files/source_watch.h"

#include <algorithm>
#include <utility>

#include "engine/io/io_codes.h"
#include "engine/project/project_codes.h"

namespace lathelier {
namespace {

constexpr int turn_ms = 2000;
constexpr int poll_ms = 50;

}  // namespace

/// What the thread brings: findings by path, or notes of a comparison.
struct SourceWatch::Answer {
    Findings findings;
    Notes notes;
};

SourceWatch::SourceWatch(std::shared_ptr<Stores> stores, QObject* parent) : QObject(parent), stores_(std::move(stores))
{
    connect(&turn_, &QTimer::timeout, this, &SourceWatch::look);
    connect(&poll_, &QTimer::timeout, this, &SourceWatch::collect);
    turn_.start(turn_ms);
}

Notes SourceWatch::notesOf(const project::PanelState& state) const
{
    Notes notes;
    for (const auto& [path, finding] : findings_)
        if (std::any_of(state.inputs.begin(), state.inputs.end(),
                        [&](const auto& input) { return input.second.path == path; }))
            notes.push_back(finding.note);
    return notes;
}

void SourceWatch::compareWithSaved(const project::Project& project)
{
    comparing_ = true;
    worker_.request([project](const Progress& progress) -> std::shared_ptr<const void> {
        auto answer = std::make_shared<Answer>();
        answer->notes = project::checkSources(project, progress);
        return answer;
    });
    poll_.start(poll_ms);
}

void SourceWatch::look()
{
    if (worker_.state().busy) return;
    worker_.request([stores = stores_, known = findings_](const Progress& progress) -> std::shared_ptr<const void> {
        auto answer = std::make_shared<Answer>();
        for (const FileSeen& file : stores->seen()) {
            progress.check();
            const std::string stamp = io::fileStamp(file.path);
            if (stamp == file.stamp) continue;
            const auto before = known.find(file.path);
            if (before != known.end() && before->second.stamp == stamp) {
                answer->findings.insert(*before);
                continue;
            }
            try {
                const std::string now = io::fileSha256(file.path, progress);
                if (now != file.sha256)
                    answer->findings[file.path] = {stamp,
                                                   {notes::sourceChangedSince,
                                                    {{"path", file.path},
                                                     {"read", shortDigest(file.sha256)},
                                                     {"now", shortDigest(now)},
                                                     {"read_sha256", file.sha256},
                                                     {"now_sha256", now}}}};
            } catch (const Error& error) {
                if (error.code() == errors::fileChanged) continue;  // still being written: at the next turn
                answer->findings[file.path] = {
                    stamp,
                    {notes::sourceGone,
                     {{"path", file.path}, {"read", shortDigest(file.sha256)}, {"read_sha256", file.sha256}}}};
            }
        }
        return answer;
    });
    poll_.start(poll_ms);
}

void SourceWatch::clear()
{
    findings_.clear();
    emit changed();
}

void SourceWatch::collect()
{
    auto outcome = worker_.take();
    if (!outcome) return;
    poll_.stop();
    const bool compared = std::exchange(comparing_, false);
    const auto* value = std::get_if<std::shared_ptr<const void>>(&*outcome);
    if (!value) return;
    const auto answer = std::static_pointer_cast<const Answer>(*value);
    for (const Note& note : answer->notes) emit found(note);
    if (compared) {
        emit savedCompared();
        return;
    }
    const Findings before = std::exchange(findings_, answer->findings);
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
