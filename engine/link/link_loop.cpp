#include "engine/link/link_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <thread>

#include "engine/core/utc_time.h"
#include "engine/io/file.h"
#include "engine/link/link_codes.h"

namespace lathelier::link {
namespace {

constexpr double longestSleep_ms = 20;  // between two looks at a stop
constexpr double heldResolution = 0.5;  // what is written are whole numbers

std::int64_t nowMs()
{
    using namespace std::chrono;
    return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

/// Throws Cancelled when stopped.
void wait(double ms, const Progress& progress)
{
    const std::int64_t end = nowMs() + static_cast<std::int64_t>(std::ceil(ms));
    for (std::int64_t left = end - nowMs(); left > 0; left = end - nowMs()) {
        progress.check();
        std::this_thread::sleep_for(
            std::chrono::duration<double, std::milli>(std::min(static_cast<double>(left), longestSleep_ms)));
    }
    progress.check();
}

bool isRequest(double value)
{
    return std::isfinite(value) && value == std::floor(value) && value >= 1 && value <= static_cast<double>(mostCount);
}

/// A first number of its own for each assistant, so that two on one control notice each other.
std::int64_t firstHeartbeat()
{
    std::random_device chance;
    return std::uniform_int_distribution<std::int64_t>(1, mostCount)(chance);
}

bool isHeld(double found, double written)
{
    return std::fabs(found - written) < heldResolution;
}

bool areSame(const std::optional<Error>& a, const Error& b)
{
    return a && a->code() == b.code() && a->values() == b.values();
}

void refuse(Exchange& made, State state)
{
    made.reply.state = state;
    made.reply.n_cor_rpm.reset();
}

bool areEqual(const ControlValues& a, const ControlValues& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return x.first == y.first && (x.second == y.second || (std::isnan(x.second) && std::isnan(y.second)));
    });
}

}  // namespace

LinkLoop::LinkLoop(Transport& transport, Assistant& assistant, const LoopSettings& settings, Tell tell)
    : transport_(transport), assistant_(assistant), settings_(settings), tell_(std::move(tell))
{
}

void LinkLoop::tell(LinkEvent event, const std::optional<Error>& error)
{
    if (!tell_) return;
    LogEntry entry;
    entry.event = event;
    entry.time = utcNow();
    entry.peer = transport_.peer();
    entry.is_verified = transport_.isVerified();
    entry.error = error;
    if (event == LinkEvent::Exchanged) entry.exchange = last_;
    tell_(entry);
}

/// After a loss only where the link holds for one look at the request, or for an exchange.
void LinkLoop::tellOpened()
{
    if (isOpenTold_) return;
    isOpenTold_ = true;
    lost_.reset();
    tell(LinkEvent::Opened);
}

void LinkLoop::run(const Progress& progress)
{
    while (!progress.stopped()) {
        try {
            open(progress);
            isOpenTold_ = false;
            if (!lost_) tellOpened();
            follow(progress);
            break;
        } catch (const Cancelled&) {
            break;
        } catch (const Error& error) {
            const bool is_taken = error.code() == errors::linkTaken;
            transport_.close();
            if (!areSame(lost_, error)) tell(is_taken ? LinkEvent::Taken : LinkEvent::Lost, error);
            lost_ = error;
            if (is_taken || settings_.is_once) throw;
        }
        try {
            wait(settings_.reconnect_ms, progress);
        } catch (const Cancelled&) {
            break;
        }
    }
    if (!transport_.isOpen()) return;
    transport_.close();
    tell(LinkEvent::Closed);
}

void LinkLoop::open(const Progress& progress)
{
    transport_.open();
    if (!transport_.isExclusive()) requireAlone(progress);
    heartbeat_ = 0;
    nextBeat_ms_ = nowMs();
    notUnderstood_.reset();
    const ControlValues found = transport_.read({stateName, answeredName});
    const double answered = found.at(answeredName);
    answered_ = isRequest(answered) ? static_cast<std::int64_t>(answered) : 0;
    isIdle_ = answered == 0 && found.at(stateName) == static_cast<double>(State::Idle);
}

/// A heartbeat that goes on without this assistant is that of another one.
void LinkLoop::requireAlone(const Progress& progress)
{
    const std::int64_t end = nowMs() + static_cast<std::int64_t>(settings_.watch_ms);
    const double first = transport_.read({heartbeatName}).at(heartbeatName);
    while (nowMs() < end) {
        wait(settings_.poll_ms, progress);
        if (transport_.read({heartbeatName}).at(heartbeatName) != first)
            throw Error(errors::linkTaken, {{"peer", transport_.peer()}});
    }
}

void LinkLoop::follow(const Progress& progress)
{
    while (true) {
        progress.check();
        beat();
        const bool is_answered = poll(progress);
        tellOpened();
        if (is_answered && settings_.is_once) return;
        wait(settings_.poll_ms, progress);
    }
}

void LinkLoop::beat()
{
    if (nowMs() < nextBeat_ms_) return;
    nextBeat_ms_ = nowMs() + static_cast<std::int64_t>(settings_.heartbeat_ms);
    if (heartbeat_ == 0) {
        heartbeat_ = firstHeartbeat();
    } else {
        const double found = transport_.read({heartbeatName}).at(heartbeatName);
        if (found == 0)  // registers that are cleared
            throw Error(errors::linkLost,
                        {{"peer", transport_.peer()}, {"reason", LT_TEXT("Engine", "the control has started anew")}});
        if (found != static_cast<double>(heartbeat_)) throw Error(errors::linkTaken, {{"peer", transport_.peer()}});
        heartbeat_ = heartbeat_ % mostCount + 1;
    }
    transport_.write(heartbeatName, static_cast<double>(heartbeat_));
}

/// Whether a request was answered.
bool LinkLoop::poll(const Progress& progress)
{
    const double request = transport_.read({requestName}).at(requestName);
    if (request == 0) {
        notUnderstood_.reset();
        if (!isIdle_) finish(0, State::Idle);
        return false;
    }
    if (!isRequest(request)) {
        refuseRequest(request);
        return true;
    }
    if (static_cast<std::int64_t>(request) == answered_) {
        // A control that started anew between the two writes of finish() asks again under the same number.
        const bool is_cleared = transport_.read({stateName}).at(stateName) == static_cast<double>(State::Idle);
        if (!is_cleared) return false;
    }
    notUnderstood_.reset();
    return exchange(static_cast<std::int64_t>(request), progress);
}

/// A request that is no number of one cannot be answered: its state is told.
void LinkLoop::refuseRequest(double request)
{
    if (notUnderstood_ && (*notUnderstood_ == request || (std::isnan(*notUnderstood_) && std::isnan(request)))) return;
    notUnderstood_ = request;
    hold(stateName, static_cast<double>(State::NotUnderstood));
    isIdle_ = false;
    tell(LinkEvent::Refused,
         Error(errors::linkRequestNotUnderstood, {{"found", request}, {"most", std::int64_t{mostCount}}}));
}

ControlValues LinkLoop::readAll()
{
    std::vector<std::string> names;
    for (const std::string& name : readNames())
        if (transport_.offers(name)) names.push_back(name);
    return transport_.read(names);
}

/// False: the control has taken the request back; the next look takes the other one.
bool LinkLoop::exchange(std::int64_t request, const Progress& progress)
{
    const auto begin = std::chrono::steady_clock::now();
    Exchange made;
    made.time = utcNow();
    made.request = request;
    made.read = readAll();
    if (made.read.at(requestName) != static_cast<double>(request)) return false;
    const std::optional<std::string> program =
        assistant_.needsProgram(made.read) ? transport_.loadedProgram() : std::nullopt;
    made.reply = assistant_.answer(made.read, program, progress);
    if (!stillStands(made)) return false;
    if (made.reply.state == State::Ok && !write(made)) return false;
    finish(made.request, made.reply.state);
    if (made.reply.state == State::Ok && isAskedAnew(made)) {
        refuse(made, State::Changed);
        hold(stateName, static_cast<double>(State::Changed));
    }
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
    made.duration_ms = taken.count();
    last_ = std::move(made);
    tellOpened();
    tell(LinkEvent::Exchanged);
    return true;
}

/// False: the control has taken the request back. What the answer rests on and has changed refuses it.
bool LinkLoop::stillStands(Exchange& made)
{
    const ControlValues again = readAll();
    if (again.at(requestName) != static_cast<double>(made.request)) return false;
    const auto running = again.find(runningName);
    if (!areEqual(again, made.read))
        refuse(made, running != again.end() && running->second != 0 ? State::Running : State::Changed);
    else if (made.reply.program && !isLoaded(*made.reply.program))
        refuse(made, State::Changed);
    return true;
}

/// A control with one bit may have given up and asked for other values before `answered` was written. One that takes
/// the speed may start its spindle at once.
bool LinkLoop::isAskedAnew(const Exchange& made)
{
    ControlValues again = readAll();
    if (again.at(requestName) != static_cast<double>(made.request)) return false;
    if (const auto running = made.read.find(runningName); running != made.read.end())
        again[runningName] = running->second;
    return !areEqual(again, made.read);
}

bool LinkLoop::isLoaded(const ProgramBar& program)
{
    if (transport_.loadedProgram() != program.path) return false;
    try {
        return io::fileSha256(program.path) == program.sha256;
    } catch (const Error&) {
        return false;
    }
}

/// N_cor, while the state lets none hold. False: the request was taken back meanwhile.
bool LinkLoop::write(Exchange& made)
{
    hold(stateName, static_cast<double>(State::Idle));
    made.written_rpm = made.reply.n_cor_rpm;
    transport_.write(correctedName, *made.written_rpm);
    made.read_back_rpm = transport_.read({correctedName}).at(correctedName);
    if (isHeld(*made.read_back_rpm, *made.written_rpm)) return stillStands(made);
    made.reply.state = State::NotWritten;
    return true;
}

/// State first: N_cor holds from `answered` on.
void LinkLoop::finish(std::int64_t request, State state)
{
    hold(stateName, static_cast<double>(state));
    hold(answeredName, static_cast<double>(request));
    answered_ = request;
    isIdle_ = request == 0;
}

/// Written and read back: a state that the control does not keep would let an earlier N_cor hold.
void LinkLoop::hold(const char* name, double value)
{
    transport_.write(name, value);
    if (isHeld(transport_.read({name}).at(name), value)) return;
    throw Error(errors::linkLost,
                {{"peer", transport_.peer()}, {"reason", LT_TEXT("Engine", "it does not keep what is written")}});
}

Replayed replay(const std::vector<LoggedExchange>& log, Assistant& assistant, const Progress& progress)
{
    Replayed found;
    for (const LoggedExchange& logged : log) {
        const Exchange& past = logged.exchange;
        if (past.reply.state == State::Changed || past.reply.state == State::NotWritten ||
            past.reply.state == State::Running)
            continue;
        ++found.exchanges;
        const std::optional<std::string> program =
            past.reply.program ? std::optional(past.reply.program->path) : std::nullopt;
        const Reply today = assistant.answer(past.read, program, progress);
        if (today.state == past.reply.state && today.n_cor_rpm == past.reply.n_cor_rpm) continue;
        if (found.differing == 0) found.first_differing_line = logged.line;
        ++found.differing;
    }
    return found;
}

}  // namespace lathelier::link
