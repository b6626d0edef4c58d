// The languages of the manual, the folders of resources/manual, and what its generated pages are made of.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
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

inline std::string contentOf(const std::filesystem::path& path)
{
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Heads and sentences of a generated page in a language, key and text, from <page>_<language>.txt beside this file.
inline std::map<std::string, std::string> wordsOfPage(const std::string& page, const std::string& language)
{
    std::map<std::string, std::string> words;
    std::ifstream file(std::filesystem::path(LATHELIER_SOURCE_DIR) / "tests/app/cli" /
                       std::string(page).append("_").append(language).append(".txt"));
    for (std::string line; std::getline(file, line);)
        if (const auto equals = line.find(" = "); equals != std::string::npos)
            words[line.substr(0, equals)] = line.substr(equals + 3);
    return words;
}

}  // namespace lathelier::golden
