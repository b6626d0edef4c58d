#include "app/cli/inputs.h"

namespace lathelier::cli {

std::string_view Inputs::open(const std::string& path, const Progress& progress)
{
    Entry& entry = entries_.emplace_back(Entry{path, FileBytes(path, progress), {}});
    const std::string_view view = entry.bytes.view();
    entry.sha256 = std::async(beside_ ? std::launch::async : std::launch::deferred, [view, progress] {
                       return sha256(view, progress);
                   }).share();
    return view;
}

std::vector<InputFile> Inputs::files()
{
    std::vector<InputFile> result;
    for (const Entry& entry : entries_)
        result.push_back({entry.path, static_cast<std::int64_t>(entry.bytes.view().size()), entry.sha256.get()});
    return result;
}

}  // namespace lathelier::cli
