#include "engine/batch/results_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <nlohmann/json.hpp>
#include <system_error>

#include "engine/batch/batch_codes.h"
#include "engine/core/core_codes.h"
#include "engine/io/io_codes.h"

namespace lathelier::batch {
namespace {

constexpr std::int64_t mostShards = 1000000;
constexpr auto flushPause = std::chrono::seconds(1);

bool takeNumber(std::string_view text, std::int64_t& number)
{
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
    return problem == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::string Shard::fileName(const std::string& stem, const std::string& suffix) const
{
    return count == 1 ? stem + suffix : fmt::format("{}-{:04}-of-{:04}{}", stem, number, count, suffix);
}

Shard shardFrom(const std::string& stated)
{
    const std::size_t slash = stated.find('/');
    Shard shard;
    const bool isUnderstood = slash != std::string::npos &&
                              takeNumber(std::string_view(stated).substr(0, slash), shard.number) &&
                              takeNumber(std::string_view(stated).substr(slash + 1), shard.count);
    if (!isUnderstood || shard.count < 1 || shard.count > mostShards || shard.number < 1 || shard.number > shard.count)
        throw Error(errors::valueNotUnderstood,
                    {{"parameter", std::string("--shard")},
                     {"found", stated},
                     {"expected", LT_TEXT("Engine", "i/n with i from 1 to n, such as 3/10")}});
    return shard;
}

ResultsFile::ResultsFile(std::string path, const Json& recipe)
    : path_(std::move(path)), flushed_(std::chrono::steady_clock::now())
{
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail(errno);
    try {
        if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
            if (errno == EWOULDBLOCK) throw Error(errors::batchUnderWay, {{"path", path_}});
            fail(errno);
        }
        cutTornLine();
        if (size_ == 0) append(recipe.dump(-1, ' ', false, Json::error_handler_t::replace));
    } catch (...) {
        ::close(descriptor_);
        throw;
    }
}

ResultsFile::~ResultsFile()
{
    ::close(descriptor_);
}

void ResultsFile::append(std::string line)
{
    line += '\n';
    std::size_t done = 0;
    while (done < line.size()) {
        const ssize_t count = ::write(descriptor_, line.data() + done, line.size() - done);
        if (count >= 0) {
            done += static_cast<std::size_t>(count);
            continue;
        }
        if (errno == EINTR) continue;
        const int problem = errno;
        // Without the begun line the file is as it was; else the next writer cuts it off.
        [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, size_);
        fail(problem);
    }
    size_ += static_cast<std::int64_t>(line.size());
    isFlushed_ = false;
    if (std::chrono::steady_clock::now() - flushed_ >= flushPause) flush();
}

void ResultsFile::flush()
{
    if (isFlushed_) return;
    if (::fsync(descriptor_) != 0 && errno != EINVAL) fail(errno);  // a pipe or a device cannot be synchronised
    isFlushed_ = true;
    flushed_ = std::chrono::steady_clock::now();
}

void ResultsFile::cutTornLine()
{
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) fail(errno);
    std::array<char, 1 << 16> block{};
    for (size_ = status.st_size; size_ > 0;) {
        const auto length = std::min<std::int64_t>(size_, static_cast<std::int64_t>(block.size()));
        const ssize_t count = ::pread(descriptor_, block.data(), static_cast<std::size_t>(length), size_ - length);
        if (count != length) fail(count < 0 ? errno : EIO);
        const std::string_view read(block.data(), static_cast<std::size_t>(count));
        const std::size_t end = read.rfind('\n');
        size_ -= length;
        if (end == std::string_view::npos) continue;
        size_ += static_cast<std::int64_t>(end) + 1;
        break;
    }
    if (size_ < status.st_size && ::ftruncate(descriptor_, size_) != 0) fail(errno);
}

void ResultsFile::fail(int problem) const
{
    throw Error(errors::fileNotWritable, {{"path", path_}, {"reason", std::generic_category().message(problem)}});
}

}  // namespace lathelier::batch
