// The loop between a control and the assistant: waits for a request, answers it, writes N_cor, state and heartbeat.
//
//  lost ◄──── any error of the transport ────┐
//   │ again after reconnect_ms               │
//   └─► opening ─► linked: poll the request ─► exchange: read, answer, read again, state 0, N_cor, read again,
//                    ▲        heartbeat                  state, answered; each is read back
//                    └──────────────────────────────────────┘
//
// Nothing but N_cor, state, answered and heartbeat is written, and N_cor only where the request and the values still
// are what was answered; they are looked at once more before the state lets it hold. A link that is cut at any moment
// leaves `answered` at another number than the request, so that the control does not take what was written; once it is
// linked again the request that stands is answered anew.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "engine/core/progress.h"
#include "engine/link/assistant.h"
#include "engine/link/exchange.h"
#include "engine/link/transport.h"

namespace lathelier::link {

struct LoopSettings {
    double poll_ms = 10;        ///< between two looks at the request
    double heartbeat_ms = 500;  ///< period of the heartbeat
    double reconnect_ms = 500;  ///< before a lost link is opened again
    double watch_ms = 2500;     ///< for the heartbeat of another assistant: 2.5 of the longest period
    bool is_once = false;       ///< ends after the first request was answered; a link that fails ends it too
};

class LinkLoop {
public:
    /// Told of every event, from the thread that runs the loop.
    using Tell = std::function<void(const LogEntry& entry)>;

    LinkLoop(Transport& transport, Assistant& assistant, const LoopSettings& settings, Tell tell);

    /// Runs until it is stopped (returns then), or, once, until a request was answered. Errors: linkTaken; once,
    /// those of the transport besides.
    void run(const Progress& progress);

    /// The last exchange; none yet, or the request was none.
    const std::optional<Exchange>& last() const { return last_; }

private:
    void open(const Progress& progress);
    void requireAlone(const Progress& progress);
    void follow(const Progress& progress);
    bool poll(const Progress& progress);
    void beat();
    bool exchange(std::int64_t request, const Progress& progress);
    void refuseRequest(double request);
    bool stillStands(Exchange& made);
    bool isLoaded(const ProgramBar& program);
    bool isAskedAnew(const Exchange& made);
    bool write(Exchange& made);
    void finish(std::int64_t request, State state);
    void hold(const char* name, double value);
    ControlValues readAll();
    void tell(LinkEvent event, const std::optional<Error>& error = {});
    void tellOpened();

    Transport& transport_;
    Assistant& assistant_;
    LoopSettings settings_;
    Tell tell_;
    std::int64_t answered_ = 0;            ///< as it stands in the control
    bool isIdle_ = false;                  ///< state and `answered` in the control are those without a request
    std::optional<double> notUnderstood_;  ///< request that is no number of a request and was told to be so
    std::int64_t heartbeat_ = 0;           ///< as it was written last; 0: not yet
    std::int64_t nextBeat_ms_ = 0;         ///< by the steady clock
    std::optional<Exchange> last_;
    std::optional<Error> lost_;  ///< that was told; a link that is opened and fails again is not told anew
    bool isOpenTold_ = false;
};

/// An exchange of a log answered again.
struct Replayed {
    std::int64_t exchanges = 0;  ///< that depend on the values alone
    std::int64_t differing = 0;  ///< answered otherwise today
    std::int64_t first_differing_line = 0;
};

/// Answers the exchanges of a log anew, without a control. Those that the control's behaviour decided (changed values,
/// a speed that was not kept) are left out. Throws Cancelled.
Replayed replay(const std::vector<LoggedExchange>& log, Assistant& assistant, const Progress& progress);

}  // namespace lathelier::link
