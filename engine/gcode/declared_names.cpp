#include "engine/gcode/declared_names.h"

#include <algorithm>
#include <cctype>

#include "engine/gcode/flow_text.h"

namespace lathelier::gcode {
namespace {

bool isNameCharacter(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '$';
}

std::string_view trimmed(std::string_view text)
{
    text = trimmedFront(text);
    const std::size_t to = text.find_last_not_of(" \t");
    return to == std::string_view::npos ? std::string_view() : text.substr(0, to + 1);
}

std::string_view withoutNumber(std::string_view line)
{
    line = trimmedFront(line);
    if (line.size() < 2 || (line[0] != 'N' && line[0] != 'n')) return line;
    const std::size_t to = line.find_first_not_of("0123456789", 1);
    return to == 1 || to == std::string_view::npos ? line : trimmedFront(line.substr(to));
}

}  // namespace

std::string nameOf(std::string_view word)
{
    std::size_t to = 0;
    while (to < word.size() && isNameCharacter(word[to])) ++to;
    return capitals(word.substr(0, to));
}

std::vector<std::string_view> splitArguments(std::string_view list)
{
    std::vector<std::string_view> parts;
    int depth = 0;
    bool isText = false;
    std::size_t from = 0;
    for (std::size_t at = 0; at <= list.size(); ++at) {
        const char c = at < list.size() ? list[at] : ',';
        if (c == '"') isText = !isText;
        if (isText && at < list.size()) continue;
        if (c == '(' || c == '[') ++depth;
        if (c == ')' || c == ']') --depth;
        if (at < list.size() && (c != ',' || depth > 0)) continue;
        parts.push_back(trimmed(list.substr(from, at - from)));
        from = at + 1;
    }
    return parts;
}

std::vector<Declared> declaredIn(std::string_view list)
{
    std::vector<Declared> all;
    for (const std::string_view part : splitArguments(list)) {
        const std::size_t equals = part.find('=');
        const std::string_view head = trimmed(part.substr(0, equals));
        if (head.empty() || head.back() == ']') continue;
        const std::size_t blank = head.find_last_of(" \t");  // behind the type of a parameter
        const std::string name = nameOf(blank == std::string_view::npos ? head : head.substr(blank + 1));
        if (name.empty()) continue;
        all.push_back({name, equals == std::string_view::npos ? std::string_view() : trimmed(part.substr(equals + 1))});
    }
    return all;
}

DeclaredNames declaredNames(std::string_view text, const Control& control)
{
    DeclaredNames names;
    if (control.grammar.flow != FlowStyle::Structured) return names;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        std::string_view line = withoutNumber(text.substr(at, end - at));
        at = end + 1;
        line = trimmed(line.substr(0, line.find(';')));
        if (!control.program_head.empty() &&
            capitals(line.substr(0, control.program_head.size())) == control.program_head) {
            const std::string name = nameOf(line.substr(control.program_head.size()));
            const std::size_t suffix = name.rfind('_');
            names.insert(name.substr(0, suffix));
            continue;
        }
        const std::string keyword = keywordOf(line);
        if (keyword != "DEF" && keyword != "PROC") continue;
        const std::string_view rest = trimmedFront(line.substr(keyword.size()));
        if (keyword == "DEF") {
            const std::size_t type = rest.find_first_of(" \t");
            if (type == std::string_view::npos) continue;
            for (const Declared& one : declaredIn(rest.substr(type))) names.insert(one.name);
            continue;
        }
        names.insert(nameOf(rest));
        const std::size_t open = rest.find('('), close = rest.rfind(')');
        if (open != std::string_view::npos && close != std::string_view::npos && close > open)
            for (const Declared& one : declaredIn(rest.substr(open + 1, close - open - 1))) names.insert(one.name);
    }
    return names;
}

}  // namespace lathelier::gcode
