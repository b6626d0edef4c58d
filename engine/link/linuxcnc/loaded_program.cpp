#include "engine/link/linuxcnc/loaded_program.h"

#include <utility>  // before Boost.Asio 1.74, which uses it

#include <boost/asio.hpp>
#include <chrono>
#include <functional>
#include <istream>
#include <sstream>

namespace lathelier::link {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

constexpr const char* answerWord = "PROGRAM ";
constexpr std::size_t longestAnswer = std::size_t{64} << 10;

}  // namespace

std::optional<std::string> programIn(const std::string& answer)
{
    std::istringstream lines(answer);
    for (std::string line; std::getline(lines, line);) {
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
        if (line.rfind(answerWord, 0) != 0) continue;
        const std::string path = line.substr(std::string(answerWord).size());
        return path.empty() || path == "NONE" ? std::nullopt : std::optional(path);
    }
    return std::nullopt;
}

std::optional<std::string> programOfLinuxCnc(const LinuxCncSettings& settings, double timeout_ms)
{
    asio::io_context context;
    tcp::socket socket(context);
    asio::streambuf received(longestAnswer);
    const std::string asked = "hello " + settings.program_password + " lathelier 1\r\nget program\r\nquit\r\n";
    const tcp::endpoint place(asio::ip::address_v4::loopback(), static_cast<unsigned short>(settings.program_port));
    std::string answer;
    // Lines until the one that names the program: the connection stays open after the answer.
    std::function<void(boost::system::error_code, std::size_t)> take = [&](boost::system::error_code why, std::size_t) {
        if (why) return;
        std::istream stream(&received);
        std::getline(stream, answer);
        if (answer.rfind(answerWord, 0) != 0) asio::async_read_until(socket, received, '\n', take);
    };
    socket.async_connect(place, [&](boost::system::error_code why) {
        if (why) return;
        asio::async_write(socket, asio::buffer(asked), [&](boost::system::error_code lost, std::size_t) {
            if (!lost) asio::async_read_until(socket, received, '\n', take);
        });
    });
    context.run_for(std::chrono::milliseconds(static_cast<std::int64_t>(timeout_ms)));
    boost::system::error_code ignored;
    socket.close(ignored);
    context.restart();
    context.run();
    return programIn(answer);
}

}  // namespace lathelier::link
