#include "engine/io/input_files.h"

#include <chrono>
#include <limits>
#include <system_error>
#include <utility>

#include "engine/core/parallel.h"

namespace lathelier::io {
namespace {

/// Reports the progress of a digest; complete at its end.
struct Passed {
    std::atomic<std::size_t>& hashed;

    void tell(std::size_t count) const
    {
        hashed = count;
        hashed.notify_all();
    }
    ~Passed() { tell(std::numeric_limits<std::size_t>::max()); }
};

bool isDeferred(const std::shared_future<std::string>& sha256)
{
    return sha256.wait_for(std::chrono::seconds(0)) == std::future_status::deferred;
}

}  // namespace

std::string_view InputFiles::open(const std::string& path, const Progress& progress)
{
    if (const auto given = given_.find(path); given != given_.end()) {
        const std::string& text = given->second;
        std::promise<std::string> digest;
        digest.set_value(io::sha256(text, progress.quiet()));
        entries_.push_back({path, static_cast<std::int64_t>(text.size()), nullptr,
                            std::make_shared<std::atomic<std::size_t>>(text.size()), digest.get_future().share()});
        return text;
    }
    auto bytes = std::make_shared<FileBytes>(path, progress);
    const std::string_view view = bytes->view();
    auto hashed = std::make_shared<std::atomic<std::size_t>>(0);
    // The lambda's copy of the pointer is released with the digest, not with the future.
    auto digest = [bytes, hashed, stop = progress.quiet()]() mutable {
        const std::shared_ptr<FileBytes> held = std::exchange(bytes, nullptr);
        const Passed passed{*hashed};  // also when cancelled, so that no one waits for ever
        return io::sha256(held->view(), stop, [&passed](std::size_t count) { passed.tell(count); });
    };
    std::shared_future<std::string> sha256;
    if (beside_ && threadsAllowed() > 1) {
        try {
            sha256 = std::async(std::launch::async, digest).share();
        } catch (const std::system_error&) {  // no further thread available: the digest is deferred
        }
    }
    if (!sha256.valid()) sha256 = std::async(std::launch::deferred, std::move(digest)).share();
    entries_.push_back(
        {path, static_cast<std::int64_t>(view.size()), std::move(bytes), std::move(hashed), std::move(sha256)});
    return view;
}

void InputFiles::release(const std::string& path, std::size_t count)
{
    for (Entry& entry : entries_) {
        if (entry.path != path || !entry.bytes) continue;
        if (isDeferred(entry.sha256)) entry.sha256.wait();
        for (std::size_t now = *entry.hashed; now < count; now = *entry.hashed) entry.hashed->wait(now);
        entry.bytes->release(count);
    }
}

void InputFiles::drop()
{
    for (Entry& entry : entries_) {
        if (isDeferred(entry.sha256)) entry.sha256.wait();
        entry.bytes.reset();
    }
}

std::vector<InputFile> InputFiles::list()
{
    std::vector<InputFile> result;
    for (const Entry& entry : entries_) result.push_back({entry.path, entry.size, entry.sha256.get()});
    return result;
}

}  // namespace lathelier::io
