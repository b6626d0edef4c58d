// Standard output as a pipe that is slow, full or does not block, and the stop while it is written to.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/scratch_folder.h"

namespace lathelier::golden {
namespace {

using namespace std::chrono_literals;

/// A run whose standard output is a pipe that does not block; nobody reads until read() is called.
class PipedRun {
public:
    explicit PipedRun(const std::vector<std::string>& words)
    {
        if (::pipe(ends_.data()) != 0) throw std::runtime_error("no pipe");
        process_ = ::fork();
        if (process_ == 0) {
            ::fcntl(ends_[1], F_SETFL, O_NONBLOCK);
            ::dup2(ends_[1], STDOUT_FILENO);
            ::close(ends_[0]);
            std::vector<std::string> all{LATHELIER_CLI};
            all.insert(all.end(), words.begin(), words.end());
            std::vector<char*> pointers;
            for (std::string& word : all) pointers.push_back(word.data());
            pointers.push_back(nullptr);
            ::execv(LATHELIER_CLI, pointers.data());
            ::_exit(127);
        }
        ::close(ends_[1]);
    }
    ~PipedRun()
    {
        ::close(ends_[0]);
        if (process_ > 0) {
            ::kill(process_, SIGKILL);
            ::waitpid(process_, nullptr, 0);
        }
    }
    PipedRun(const PipedRun&) = delete;
    PipedRun& operator=(const PipedRun&) = delete;

    std::string read() const
    {
        std::string text;
        std::array<char, 65536> step{};
        for (;;) {
            const ssize_t count = ::read(ends_[0], step.data(), step.size());
            if (count <= 0) return text;
            text.append(step.data(), static_cast<std::size_t>(count));
        }
    }

    /// Waits until the pipe is full: the program can write no more.
    void waitUntilFull() const
    {
        int before = -1, bytes = 0;
        for (int tries = 0; tries < 300 && (bytes == 0 || bytes != before); ++tries) {
            before = bytes;
            std::this_thread::sleep_for(200ms);
            ::ioctl(ends_[0], FIONREAD, &bytes);
        }
        ASSERT_GT(bytes, 0);
    }

    void signal(int number) const { ::kill(process_, number); }

    int wait()
    {
        int status = 0;
        ::waitpid(process_, &status, 0);
        process_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

private:
    std::array<int, 2> ends_{};
    pid_t process_ = -1;
};

/// The probe record of the sample: its JSON is a million bytes, more than a pipe holds.
class Streams : public ::testing::Test {
protected:
    static void SetUpTestSuite()
    {
        folder_.emplace();
        const std::string command = std::string(LATHELIER_CLI) + " sample " + folder_->string() + " --quiet";
        ASSERT_EQ(std::system(command.c_str()), 0);
    }
    static void TearDownTestSuite() { folder_.reset(); }

    static std::vector<std::string> words()
    {
        return {"trajectory", (*folder_ / "probe_record.csv").string(), "--json", "-", "--quiet"};
    }

    static inline std::optional<ScratchFolder> folder_;
};

TEST_F(Streams, AStandardOutputThatDoesNotBlockIsWrittenWhole)
{
    PipedRun run(words());
    run.waitUntilFull();
    const std::string text = run.read();
    EXPECT_EQ(run.wait(), 0);
    EXPECT_GT(text.size(), 200'000u);
    EXPECT_TRUE(nlohmann::json::accept(text));
}

TEST_F(Streams, AStopEndsTheWaitForAReader)
{
    PipedRun run(words());
    run.waitUntilFull();
    run.signal(SIGINT);
    EXPECT_EQ(run.wait(), 130);
}

}  // namespace
}  // namespace lathelier::golden
