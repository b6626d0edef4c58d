#include "tests/app/cli/run_program.h"

#include <fcntl.h>
#include <linux/capability.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

extern char** environ;

namespace lathelier::golden {
namespace {

using Clock = std::chrono::steady_clock;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr auto longest = std::chrono::minutes(20);  // sanitized programs are ten times slower and more
#else
constexpr auto longest = std::chrono::minutes(2);
#endif

std::vector<char*> pointers(std::vector<std::string>& words)
{
    std::vector<char*> result;
    for (std::string& word : words) result.push_back(word.data());
    result.push_back(nullptr);
    return result;
}

/// Our own environment with the run's additions, which come first and so win.
std::vector<std::string> environmentOf(const Run& run)
{
    std::vector<std::string> result = run.environment;
    for (char** entry = environ; *entry; ++entry) {
        const std::string name = std::string(*entry).substr(0, std::string(*entry).find('=') + 1);
        const auto same = [&name](const std::string& ours) { return ours.compare(0, name.size(), name) == 0; };
        if (std::none_of(run.environment.begin(), run.environment.end(), same)) result.emplace_back(*entry);
    }
    return result;
}

/// Writes the file into the pipe as soon as someone reads there.
void feed(const std::string& pipe, const std::string& file, Clock::time_point deadline)
{
    int descriptor = -1;
    while (descriptor < 0 && Clock::now() < deadline) {
        descriptor = ::open(pipe.c_str(), O_WRONLY | O_NONBLOCK);
        if (descriptor < 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    if (descriptor < 0) return;
    ::fcntl(descriptor, F_SETFL, 0);
    std::ifstream stream(file, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    for (std::size_t done = 0; done < content.size();) {
        const ssize_t count = ::write(descriptor, content.data() + done, content.size() - done);
        if (count <= 0) break;
        done += static_cast<std::size_t>(count);
    }
    ::close(descriptor);
}

struct Pipe {
    Pipe()
    {
        if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
    }
    std::array<int, 2> ends{};
};

[[noreturn]] void becomeProgram(char** words, char** environment, const Run& run, int output, int errors)
{
    ::dup2(output, STDOUT_FILENO);
    ::dup2(errors, STDERR_FILENO);
    for (int descriptor = 3; descriptor < 256; ++descriptor) ::close(descriptor);
    if (run.largest_file) {
        const rlimit limit{static_cast<rlim_t>(*run.largest_file), static_cast<rlim_t>(*run.largest_file)};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    if (run.not_as_root)
        for (const int right : {CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH})
            ::prctl(PR_CAPBSET_DROP, static_cast<unsigned long>(right), 0, 0, 0);
    ::signal(SIGPIPE, SIG_DFL);
    ::execve(words[0], words, environment);
    ::_exit(127);
}

/// Gathers both streams until the program has closed them.
void gather(Pipe& output, Pipe& errors, Outcome& outcome, pid_t child, const Run& run, Clock::time_point start)
{
    std::array<pollfd, 2> watched{pollfd{output.ends[0], POLLIN, 0}, pollfd{errors.ends[0], POLLIN, 0}};
    const std::array<std::string*, 2> texts{&outcome.standard_output, &outcome.standard_error};
    bool interrupted = false;
    while (watched[0].fd >= 0 || watched[1].fd >= 0) {
        ::poll(watched.data(), watched.size(), 20);
        const auto passed = Clock::now() - start;
        if (run.interrupt_ms && !interrupted && passed >= std::chrono::milliseconds(*run.interrupt_ms)) {
            ::kill(child, SIGINT);
            interrupted = true;
        }
        if (passed > longest) ::kill(child, SIGKILL);
        for (std::size_t i = 0; i < watched.size(); ++i) {
            if (watched[i].fd < 0 || watched[i].revents == 0) continue;
            std::array<char, 65536> buffer{};
            const ssize_t count = ::read(watched[i].fd, buffer.data(), buffer.size());
            if (count > 0)
                texts[i]->append(buffer.data(), static_cast<std::size_t>(count));
            else
                watched[i].fd = -1;
        }
    }
    ::close(output.ends[0]);
    ::close(errors.ends[0]);
}

}  // namespace

Outcome runProgram(const std::string& program, const Run& run)
{
    std::vector<std::string> words{program};
    words.insert(words.end(), run.words.begin(), run.words.end());
    std::vector<std::string> environment = environmentOf(run);
    const std::vector<char*> wordPointers = pointers(words);
    const std::vector<char*> environmentPointers = pointers(environment);

    Pipe output;
    Pipe errors;
    const int target =
        run.stdout_file.empty() ? output.ends[1] : ::open(run.stdout_file.c_str(), O_WRONLY | O_CREAT, 0666);
    const auto start = Clock::now();
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0)
        becomeProgram(const_cast<char**>(wordPointers.data()), const_cast<char**>(environmentPointers.data()), run,
                      target, errors.ends[1]);
    ::close(output.ends[1]);
    ::close(errors.ends[1]);
    if (!run.stdout_file.empty()) ::close(target);
    std::thread feeder;
    if (!run.feed_pipe.empty())
        feeder = std::thread(feed, run.feed_pipe, run.feed_file, start + std::chrono::seconds(10));

    Outcome outcome;
    gather(output, errors, outcome, child, run, start);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (feeder.joinable()) feeder.join();
    if (WIFEXITED(status))
        outcome.exit_code = WEXITSTATUS(status);
    else if (WIFSIGNALED(status) && WTERMSIG(status) != SIGKILL)
        outcome.exit_code = 128 + WTERMSIG(status);
    return outcome;
}

}  // namespace lathelier::golden
