// What happened between control and assistant, as the log keeps it: one JSON object a line (JSON Lines).
//   {"time": "2026-11-29T05:40:12.345Z", "event": "opened", "link": "loopback", "peer": "127.0.0.1:7660",
//    "version": "0.1", "config_sha256": "…", "is_verified": true}
//   {"time": …, "event": "exchange", "request": 7, "read": {"diameter_mm": 32, …}, "program": {…}, "state": 1,
//    "state_name": "ok", "selected_rpm": 2884.7, "n_cor_rpm": 3237, "read_back_rpm": 3237, "assumed": […],
//    "duration_ms": 12.5, "error": {…}}
//   {"time": …, "event": "refused" | "lost" | "taken" | "closed", "error": {…}}
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/input_file.h"
#include "engine/core/json.h"
#include "engine/link/assistant.h"

namespace lathelier::link {

/// One request and its answer.
struct Exchange {
    std::string time;                     ///< UTC, ISO 8601 with milliseconds, when the request was seen
    std::int64_t request = 0;             ///< its number
    ControlValues read;                   ///< with which it was answered
    Reply reply;                          ///< `state`: as it was written
    std::optional<double> written_rpm;    ///< N_cor, where it was written
    std::optional<double> read_back_rpm;  ///< what the control held then
    double duration_ms = 0;               ///< from the request seen to `answered` written
};

enum class LinkEvent { Opened, Exchanged, Refused, Lost, Taken, Closed };

/// One line of the log.
struct LogEntry {
    LinkEvent event = LinkEvent::Closed;
    std::string time;                  ///< UTC, as that of an exchange
    std::string kind;                  ///< of the link; of Opened, as what follows
    std::string peer;                  ///< Transport::peer()
    std::string config_sha256;         ///< of ASSIST.json
    bool is_verified = true;           ///< Transport::isVerified()
    std::optional<Exchange> exchange;  ///< of Exchanged
    std::optional<Error> error;        ///< of Refused, Lost and Taken
};

Json toJson(const Exchange& exchange);
Json toJson(const LogEntry& entry);

/// The exchanges of a log: what was read and what was answered. Errors malformed, keyMissing with path, line and
/// column. A last line that is torn is left out: the program was killed while it wrote it.
struct LoggedExchange {
    std::int64_t line = 0;  ///< from 1
    Exchange exchange;      ///< without `assumed` and `error`
};
struct Log {
    std::vector<LoggedExchange> exchanges;  ///< in order
    InputFile file;                         ///< they were read from
};
Log readLog(const std::string& path, const Progress& progress);

/// The same of the text of a log, without the path.
std::vector<LoggedExchange> exchangesOf(std::string_view log, const Progress& progress);

}  // namespace lathelier::link
