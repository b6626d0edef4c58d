#include "engine/link/loopback/simulated_control.h"

#include <utility>  // before Boost.Asio 1.74, which uses it

#include <algorithm>
#include <boost/asio.hpp>
#include <istream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/core/error.h"
#include "engine/core/json.h"
#include "engine/link/link_codes.h"
#include "engine/link/loopback/messages.h"

namespace lathelier::link {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

bool isWritable(const std::string& name)
{
    return std::find(writtenNames().begin(), writtenNames().end(), name) != writtenNames().end();
}

}  // namespace

struct SimulatedControl::Server {
    /// The link to one assistant.
    struct Session : std::enable_shared_from_this<Session> {
        Session(tcp::socket taken, Server& of) : socket(std::move(taken)), server(of) {}
        void listen();
        void answer(const std::string& line);
        void end();
        bool isClosed();

        tcp::socket socket;
        Server& server;
        asio::streambuf received{longestMessage};
        std::string sent;
        bool is_refused = false;
    };

    Server(int port, std::function<void()> told) : acceptor(context), changed(std::move(told))
    {
        const tcp::endpoint place(asio::ip::address_v4::loopback(), static_cast<unsigned short>(port));
        error_code why;
        acceptor.open(place.protocol(), why);
        if (!why) acceptor.set_option(tcp::acceptor::reuse_address(true), why);
        if (!why) acceptor.bind(place, why);
        if (!why) acceptor.listen(asio::socket_base::max_listen_connections, why);
        if (why) throw Error(errors::linkPortNotFree, {{"port", std::int64_t{port}}, {"reason", why.message()}});
        for (const auto* names : {&readNames(), &writtenNames()})
            for (const std::string& name : *names) values[name] = 0;
        accept();
        thread = std::thread([this] { context.run(); });
    }
    ~Server()
    {
        context.stop();
        thread.join();
    }
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    void accept()
    {
        acceptor.async_accept([this](error_code why, tcp::socket socket) {
            if (why) return;
            const auto session = std::make_shared<Session>(std::move(socket), *this);
            error_code ignored;
            session->socket.set_option(tcp::no_delay(true), ignored);
            // The end of an earlier link may still wait to be read.
            if (const auto earlier = linked.lock(); earlier && earlier->isClosed()) earlier->end();
            {
                const std::lock_guard lock(mutex);
                session->is_refused = !linked.expired();
                if (!session->is_refused) linked = session;
            }
            session->listen();
            tell();
            accept();
        });
    }
    Json replyTo(const Message& message, bool is_refused);
    std::optional<Fault> faultNow();
    void tell() const
    {
        if (changed) changed();
    }

    asio::io_context context;
    tcp::acceptor acceptor;
    std::function<void()> changed;
    mutable std::mutex mutex;
    ControlValues values;
    std::string program;
    std::weak_ptr<Session> linked;
    std::optional<std::pair<std::int64_t, Fault>> fault;  ///< after so many answers
    std::thread thread;
};

void SimulatedControl::Server::Session::listen()
{
    auto self = shared_from_this();
    asio::async_read_until(socket, received, '\n', [self](error_code why, std::size_t) {
        if (why) return self->end();
        std::string line;
        std::istream stream(&self->received);
        std::getline(stream, line);
        self->answer(line);
    });
}

bool SimulatedControl::Server::Session::isClosed()
{
    error_code why;
    char sign = 0;
    socket.non_blocking(true, why);
    socket.receive(asio::buffer(&sign, 1), tcp::socket::message_peek, why);
    return why && why != asio::error::would_block;
}

void SimulatedControl::Server::Session::end()
{
    error_code ignored;
    socket.close(ignored);
    {
        const std::lock_guard lock(server.mutex);
        if (server.linked.lock().get() == this) server.linked.reset();
    }
    server.tell();
}

void SimulatedControl::Server::Session::answer(const std::string& line)
{
    Json reply;
    try {
        reply = server.replyTo(messageFrom(line), is_refused);
    } catch (const Error&) {
        reply = {{"id", nullptr}, {"error", "not_understood"}};
    }
    sent = reply.dump(-1, ' ', false, Json::error_handler_t::replace).append("\n");
    if (const auto wrong = server.faultNow()) {
        if (*wrong == Fault::Cut) return end();
        if (*wrong == Fault::Silence) return listen();
        if (*wrong == Fault::Garbage) sent = "\x01\xff{\"id\": 1e999, [\n";
        if (*wrong == Fault::WrongId) sent = "{\"id\": -7, \"values\": {\"request\": 1}, \"written\": true}\n";
    }
    auto self = shared_from_this();
    asio::async_write(socket, asio::buffer(sent), [self](error_code why, std::size_t) {
        if (why) return self->end();
        self->server.tell();
        self->listen();
    });
}

std::optional<SimulatedControl::Fault> SimulatedControl::Server::faultNow()
{
    const std::lock_guard lock(mutex);
    if (!fault || fault->first-- > 0) return std::nullopt;
    return std::exchange(fault, std::nullopt)->second;
}

Json SimulatedControl::Server::replyTo(const Message& message, bool is_refused)
{
    const std::lock_guard lock(mutex);
    Json reply{{"id", message.id}};
    if (is_refused) return reply.update({{"error", "taken"}}), reply;
    switch (message.ask) {
        case Ask::Hello: reply.update({{"control", "lathelier-simulator"}, {"version", messageVersion}}); break;
        case Ask::Read:
            reply["values"] = Json::object();
            for (const std::string& name : message.names) {
                const auto found = values.find(name);
                if (found != values.end()) reply["values"][name] = found->second;
            }
            break;
        case Ask::Write:
            if (isWritable(message.name)) {
                values[message.name] = message.value;
                reply["written"] = true;
            } else {
                reply["error"] = "not_allowed";
            }
            break;
        case Ask::Program: reply["program"] = program.empty() ? Json() : Json(program); break;
    }
    return reply;
}

SimulatedControl::SimulatedControl(int port, std::function<void()> changed)
    : server_(std::make_unique<Server>(port, std::move(changed)))
{
}

SimulatedControl::~SimulatedControl() = default;

int SimulatedControl::port() const
{
    return server_->acceptor.local_endpoint().port();
}

ControlValues SimulatedControl::values() const
{
    const std::lock_guard lock(server_->mutex);
    return server_->values;
}

void SimulatedControl::set(const std::string& name, double value)
{
    const std::lock_guard lock(server_->mutex);
    server_->values[name] = value;
}

void SimulatedControl::setProgram(const std::string& path)
{
    const std::lock_guard lock(server_->mutex);
    server_->program = path;
}

std::int64_t SimulatedControl::request()
{
    const std::lock_guard lock(server_->mutex);
    const auto last = static_cast<std::int64_t>(server_->values[requestName]);
    const std::int64_t next = last % mostCount + 1;
    server_->values[requestName] = static_cast<double>(next);
    return next;
}

std::optional<double> SimulatedControl::correctedRpm() const
{
    const ControlValues now = values();
    if (now.at(requestName) == 0 || now.at(answeredName) != now.at(requestName)) return std::nullopt;
    if (now.at(stateName) != static_cast<double>(State::Ok)) return std::nullopt;
    return now.at(correctedName);
}

bool SimulatedControl::isLinked() const
{
    const std::lock_guard lock(server_->mutex);
    return !server_->linked.expired();
}

void SimulatedControl::failAfter(std::int64_t answers, Fault fault)
{
    const std::lock_guard lock(server_->mutex);
    server_->fault = std::pair{answers, fault};
}

}  // namespace lathelier::link
