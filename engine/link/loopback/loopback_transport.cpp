#include "engine/link/loopback/loopback_transport.h"

#include <utility>  // before Boost.Asio 1.74, which uses it

#include <boost/asio.hpp>
#include <chrono>
#include <istream>

#include "engine/link/link_codes.h"
#include "engine/link/loopback/messages.h"

namespace lathelier::link {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::size_t shownAnswer = 80;  // characters of an answer that is none

class LoopbackTransport : public Transport {
public:
    LoopbackTransport(LoopbackSettings settings, double timeout_ms)
        : settings_(std::move(settings)), timeout_(static_cast<std::int64_t>(timeout_ms)), socket_(context_)
    {
    }

    void open() override;
    ControlValues read(const std::vector<std::string>& names) override;
    void write(const std::string& name, double value) override;
    bool offers(const std::string&) const override { return true; }
    std::optional<std::string> loadedProgram() override;
    void close() noexcept override;
    bool isOpen() const override { return isOpen_; }
    bool isExclusive() const override { return true; }
    std::string peer() const override { return settings_.host + ":" + std::to_string(settings_.port); }

private:
    std::string ask(Message message);
    /// What the check makes of an answer; one that it refuses ends the link with linkProtocol.
    template <class Check>
    auto checked(const std::string& answer, const Value& expected, const Check& check)
    {
        try {
            return check(answer);
        } catch (const Error&) {
            close();
            throw Error(errors::linkProtocol,
                        {{"peer", peer()}, {"found", answer.substr(0, shownAnswer)}, {"expected", expected}});
        }
    }
    error_code waitFor(const std::function<void(std::function<void(error_code)>)>& begin);
    [[noreturn]] void lose(const error_code& why);

    LoopbackSettings settings_;
    std::chrono::milliseconds timeout_;
    asio::io_context context_;
    tcp::socket socket_;
    asio::streambuf received_{longestMessage};
    std::int64_t id_ = 0;
    bool isOpen_ = false;
};

/// Begins an operation and waits for its end; one that takes too long is ended with timed_out.
error_code LoopbackTransport::waitFor(const std::function<void(std::function<void(error_code)>)>& begin)
{
    std::optional<error_code> ended;
    begin([&ended](error_code why) { ended = why; });
    context_.restart();
    context_.run_for(timeout_);
    if (ended) return *ended;
    error_code ignored;
    socket_.close(ignored);
    context_.restart();
    context_.run();
    return asio::error::timed_out;
}

void LoopbackTransport::lose(const error_code& why)
{
    close();
    throw Error(errors::linkLost, {{"peer", peer()}, {"reason", why.message()}});
}

void LoopbackTransport::open()
{
    close();
    received_.consume(received_.size());
    error_code why;
    tcp::resolver resolver(context_);
    const auto places = resolver.resolve(settings_.host, std::to_string(settings_.port), why);
    if (!why)
        why = waitFor([&](auto end) {
            asio::async_connect(socket_, places, [end](error_code code, const tcp::endpoint&) { end(code); });
        });
    if (why) {
        close();
        throw Error(errors::linkNotFound, {{"peer", peer()}, {"reason", why.message()}});
    }
    isOpen_ = true;
    error_code ignored;
    socket_.set_option(tcp::no_delay(true), ignored);
    checked(ask({0, Ask::Hello, {}, {}, 0}), LT_TEXT("Engine", "a control of version 1 of the messages"),
            [this](const std::string& answer) { requireHello(answer, id_); });
}

/// Sends the message and gives its answer. Errors as read().
std::string LoopbackTransport::ask(Message message)
{
    if (!isOpen_) lose(asio::error::not_connected);
    message.id = ++id_;
    const std::string line = lineOf(message);
    error_code why = waitFor([&](auto end) {
        asio::async_write(socket_, asio::buffer(line), [end](error_code code, std::size_t) { end(code); });
    });
    if (why) lose(why);
    why = waitFor([&](auto end) {
        asio::async_read_until(socket_, received_, '\n', [end](error_code code, std::size_t) { end(code); });
    });
    if (why == asio::error::not_found) {  // no end of the line within the longest message
        close();
        throw Error(errors::linkProtocol, {{"peer", peer()},
                                           {"found", LT_TEXT("Engine", "a longer line")},
                                           {"expected", LT_TEXT("Engine", "shorter lines")}});
    }
    if (why) lose(why);
    std::string answer;
    std::istream stream(&received_);
    std::getline(stream, answer);
    const std::string refusal = checked(answer, LT_TEXT("Engine", "a JSON object with the id of the question"),
                                        [&message](const std::string& one) { return errorFrom(one, message.id); });
    if (refusal == "taken") {
        close();
        throw Error(errors::linkTaken, {{"peer", peer()}});
    }
    if (!refusal.empty()) {
        close();
        throw Error(errors::linkProtocol, {{"peer", peer()},
                                           {"found", refusal.substr(0, shownAnswer)},
                                           {"expected", LT_TEXT("Engine", "an answer without an error")}});
    }
    return answer;
}

ControlValues LoopbackTransport::read(const std::vector<std::string>& names)
{
    return checked(ask({0, Ask::Read, names, {}, 0}), LT_TEXT("Engine", "numbers by name"),
                   [&](const std::string& answer) { return valuesFrom(answer, id_, names); });
}

void LoopbackTransport::write(const std::string& name, double value)
{
    checked(ask({0, Ask::Write, {}, name, value}), LT_TEXT("Engine", "that it was written"),
            [this](const std::string& answer) { requireWritten(answer, id_); });
}

std::optional<std::string> LoopbackTransport::loadedProgram()
{
    const std::string answer = ask({0, Ask::Program, {}, {}, 0});
    try {
        const std::string path = programFrom(answer, id_);
        return path.empty() ? std::nullopt : std::optional(path);
    } catch (const Error&) {
        return std::nullopt;
    }
}

void LoopbackTransport::close() noexcept
{
    error_code ignored;
    socket_.close(ignored);
    isOpen_ = false;
}

}  // namespace

std::unique_ptr<Transport> loopbackTransport(const LoopbackSettings& settings, double timeout_ms)
{
    return std::make_unique<LoopbackTransport>(settings, timeout_ms);
}

}  // namespace lathelier::link
