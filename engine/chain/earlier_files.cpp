#include "engine/chain/earlier_files.h"

#include <filesystem>

namespace lathelier::chain {
namespace fs = std::filesystem;
namespace {

constexpr const char* asideFolder = ".earlier";

}  // namespace

EarlierFiles::EarlierFiles(std::string folder) : folder_(std::move(folder)) {}

EarlierFiles::~EarlierFiles()
{
    std::error_code ignored;
    const fs::path folder(folder_), aside = folder / asideFolder;
    for (const std::string& name : names_) fs::rename(aside / name, folder / name, ignored);
    if (!names_.empty()) fs::remove(aside, ignored);
}

void EarlierFiles::setAside(const std::string& name)
{
    std::error_code failure;
    const fs::path folder(folder_), aside = folder / asideFolder;
    if (!fs::is_regular_file(folder / name, failure)) return;
    fs::create_directories(aside, failure);
    fs::rename(folder / name, aside / name, failure);
    if (failure)
        fs::remove(folder / name, failure);  // remaining files are those of the new run
    else
        names_.push_back(name);
}

void EarlierFiles::forget()
{
    std::error_code ignored;
    const fs::path aside = fs::path(folder_) / asideFolder;
    for (const std::string& name : names_) fs::remove(aside / name, ignored);
    if (!names_.empty()) fs::remove(aside, ignored);
    names_.clear();
}

}  // namespace lathelier::chain
