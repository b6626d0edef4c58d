// The languages of the manual: the folders of resources/manual.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace lathelier::golden {

inline std::vector<std::string> manualLanguages()
{
    std::vector<std::string> languages;
    for (const auto& entry : std::filesystem::directory_iterator(LATHELIER_SOURCE_DIR "/resources/manual"))
        if (entry.is_directory()) languages.push_back(entry.path().filename().string());
    std::sort(languages.begin(), languages.end());
    return languages;
}

}  // namespace lathelier::golden
