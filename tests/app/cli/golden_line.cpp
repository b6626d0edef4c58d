#include "tests/app/cli/golden_line.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace lathelier::golden {
namespace {

void applyDirective(Line& line, const std::vector<std::string>& words)
{
    const auto argument = [&](std::size_t i) -> const std::string& {
        if (i >= words.size()) throw std::runtime_error(line.name + ": a directive lacks an argument");
        return words[i];
    };
    const std::string& name = argument(0);
    if (name == "env")
        line.run.environment.push_back(argument(1));
    else if (name == "stdout")
        line.run.stdout_file = argument(1);
    else if (name == "interrupt")
        line.run.interrupt_ms = std::stoi(argument(1));
    else if (name == "limit")
        line.run.largest_file = std::stol(argument(1));
    else if (name == "not-root")
        line.run.not_as_root = true;
    else if (name == "feed") {
        line.run.feed_pipe = argument(1);
        line.run.feed_file = argument(2);
    } else
        throw std::runtime_error(line.name + ": no directive " + name);
}

std::string withoutOuterBlanks(const std::string& text)
{
    const std::size_t begin = text.find_first_not_of(' ');
    return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

}  // namespace

std::vector<std::string> split(const std::string& text)
{
    std::vector<std::string> words;
    bool quoted = false;
    bool open = false;
    for (const char c : text) {
        if (c == ' ' && !quoted) {
            open = false;
            continue;
        }
        if (!open) words.emplace_back();
        open = true;
        if (c == '"')
            quoted = !quoted;
        else
            words.back() += c;
    }
    return words;
}

std::string replaced(std::string text, const std::string& name, const std::string& value)
{
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + value.size()))
        text.replace(at, name.size(), value);
    return text;
}

std::vector<Line> readLines(const std::string& path)
{
    std::vector<Line> lines;
    std::ifstream file(path);
    int number = 0;
    for (std::string source; std::getline(file, source);) {
        ++number;
        if (source.empty() || source[0] == '#') continue;
        Line line;
        line.name = std::filesystem::path(path).filename().string() + ":" + std::to_string(number);
        line.source = source;
        std::string rest = source;
        while (rest[0] == '[') {
            const std::size_t close = rest.find(']');
            if (close == std::string::npos) throw std::runtime_error(line.name + ": ] is missing");
            applyDirective(line, split(rest.substr(1, close - 1)));
            rest = withoutOuterBlanks(rest.substr(close + 1));
        }
        const std::size_t arrow = rest.find("=> ");
        if (arrow == std::string::npos) throw std::runtime_error(line.name + ": => is missing");
        line.run.words = split(rest.substr(0, arrow));
        for (auto joint = std::find(line.run.words.begin(), line.run.words.end(), "&&"); joint != line.run.words.end();
             joint = std::find(line.run.words.begin(), line.run.words.end(), "&&")) {
            line.before.emplace_back(line.run.words.begin(), joint);
            line.run.words.erase(line.run.words.begin(), joint + 1);
        }
        std::size_t used = 0;
        line.exit_code = std::stoi(rest.substr(arrow + 3), &used);
        rest = rest.substr(arrow + 3 + used);
        while (!rest.empty()) {
            const std::size_t bar = rest.find(" | ");
            if (bar == std::string::npos) break;
            rest = rest.substr(bar + 3);
            line.expectations.push_back(withoutOuterBlanks(rest.substr(0, rest.find(" | "))));
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace lathelier::golden
