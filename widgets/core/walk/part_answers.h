// The answers of all questions of the part, computed in the background after each change, in the order of the work.
#pragma once

#include <QObject>
#include <QTimer>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/report/document.h"
#include "engine/walk/walk.h"
#include "widgets/core/task/task.h"

namespace lathelier {

class Session;

/// A question with the panels that can answer it; the first of them that has its inputs and an answer does.
struct AskedQuestion {
    std::string id;
    std::vector<std::string> panels;
};

struct PartAnswer {
    enum class State { Missing, Computing, Answered, Failed };

    State state = State::Missing;
    std::string panel;                     ///< that answers; empty: inputs are missing
    std::optional<report::Answer> answer;  ///< the last one; while computing that of the state before
    std::optional<Error> error;            ///< where it failed
    bool is_assumed = false;               ///< it rests on something that was assumed
};

/// Panels ask the same walk: nothing is computed twice. For the GUI thread.
class PartAnswers : public QObject {
    Q_OBJECT
public:
    PartAnswers(Session& session, std::vector<AskedQuestion> questions, QObject* parent = nullptr);

    const PartAnswer& of(const std::string& question) const { return answers_.at(question); }
    bool isBusy() const { return due_.isActive() || task_.isBusy(); }

    void retranslate() { due_.start(); }

signals:
    void answered(const std::string& question);  ///< of(question) has changed

private:
    /// Filled by the thread that computes, emptied by this one.
    struct Board {
        std::mutex mutex;
        std::map<std::string, PartAnswer> done;
    };

    void mark();
    void begin();
    void read();

    Session& session_;
    std::vector<AskedQuestion> questions_;
    std::map<std::string, PartAnswer> answers_;
    std::map<std::string, std::string> digests_;  ///< of what each answer rests on
    std::shared_ptr<Board> board_;
    QTimer due_;
    Task task_;
};

}  // namespace lathelier
