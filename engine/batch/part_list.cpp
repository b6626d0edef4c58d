#include "engine/batch/part_list.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "engine/batch/batch_codes.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/io/json/json_document.h"
#include "engine/io/probe/probe_reader.h"
#include "engine/project/input_key.h"

namespace lathelier::batch {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longestLine = 64 << 10;  ///< of the first line of a list
constexpr std::size_t mostFilesOfPart = 10000;

bool isFile(const fs::path& path)
{
    std::error_code unknown;
    return fs::is_regular_file(path, unknown);
}

std::string_view trimmed(std::string_view line)
{
    constexpr std::string_view blanks = " \t\r";
    const std::size_t from = line.find_first_not_of(blanks);
    return from == std::string_view::npos ? std::string_view()
                                          : line.substr(from, line.find_last_not_of(blanks) - from + 1);
}

/// Beside the list, else in the working folder; where neither exists beside the list.
std::string pathOnLine(const std::string& list, std::string_view line)
{
    const fs::path stated{std::string(line)};
    const fs::path beside = (fs::path(list).parent_path() / stated).lexically_normal();
    return !isFile(beside) && isFile(stated) ? stated.string() : beside.string();
}

bool isGroup(std::string_view line)
{
    if (!line.starts_with('{')) return false;
    const Json json = Json::parse(line, nullptr, false);
    return json.is_object() && json.size() == 1 && json.contains("inputs");
}

bool isList(const std::string& path)
{
    if (!isFile(path)) return false;
    std::string head;
    try {
        head = io::fileHead(path, longestLine);
    } catch (const Error&) {  // the part fails by it
        return false;
    }
    std::string_view rest = head;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = trimmed(rest.substr(0, end));
        if (!line.empty())
            return line.find('\0') == std::string_view::npos && (isGroup(line) || isFile(pathOnLine(path, line)));
        if (end == std::string_view::npos) return false;
        rest.remove_prefix(end + 1);
    }
    return false;
}

class PartLister {
public:
    PartLister(const Recipe& recipe, const Progress& progress) : recipe_(recipe), progress_(progress) {}

    std::vector<Part> list(const std::vector<std::string>& inputs)
    {
        for (const std::string& input : inputs) {
            std::error_code unknown;
            if (fs::is_directory(input, unknown))
                takeFolder(input);
            else if (isList(input))
                takeList(input);
            else
                takeFile(input);
        }
        return std::move(parts_);
    }

private:
    void takeFile(const std::string& path)
    {
        if (recipe_.varied.size() > 1) {
            std::string roles;
            for (const std::string& role : recipe_.varied) roles += (roles.empty() ? "" : ", ") + role;
            throw Error(errors::batchNeedsGroups, {{"path", path}, {"roles", roles}});
        }
        parts_.push_back({{{recipe_.varied.front(), path}}});
    }

    void takeFolder(const std::string& folder)
    {
        std::vector<std::string> names;
        std::error_code problem;
        for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end; entry.increment(problem)) {
            progress_.check();
            const std::string name = entry->path().filename().string();
            if (!name.starts_with('.') && isFile(entry->path())) names.push_back(name);
        }
        if (problem) throw Error(errors::fileNotReadable, {{"path", folder}, {"reason", problem.message()}});
        std::sort(names.begin(), names.end());
        for (const std::string& name : names) {
            const std::string path = (fs::path(folder) / name).string();
            const std::vector<std::string> partners = io::recordPartners(path);
            const bool isTaken = std::any_of(partners.begin(), partners.end(), [&](const std::string& partner) {
                return fs::path(partner).filename().string() < name;
            });
            if (!isTaken) takeFile(path);
        }
    }

    void takeList(const std::string& list)
    {
        const io::FileBytes bytes(list, progress_);
        std::string_view rest = bytes.view();
        for (std::int64_t number = 1; !rest.empty(); ++number) {
            progress_.check();
            const std::size_t end = rest.find('\n');
            const std::string_view line = trimmed(rest.substr(0, end));
            rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
            if (line.empty()) continue;
            try {
                if (line.starts_with('{'))
                    takeGroup(list, line);
                else
                    takeFile(pathOnLine(list, line));
            } catch (Error& error) {  // places within a line are those of a text of one line
                Values values = error.values();
                set(values, "path", list);
                set(values, "line", number);
                throw Error(error.code(), values);
            }
        }
    }

    void takeGroup(const std::string& list, std::string_view line)
    {
        const io::JsonDocument document{std::string(line)};
        const io::JsonCursor inputs =
            document.root().at("inputs", LT_TEXT("Engine", "the inputs of a part by their roles"));
        Part part;
        inputs.members(io::mostJsonMembers, [&](const std::string& role, const io::JsonCursor& member) {
            if (std::find(recipe_.varied.begin(), recipe_.varied.end(), role) == recipe_.varied.end()) {
                const io::JsonPlace here = member.place();
                throw Error(errors::recipeMemberUnknown,
                            {{"column", here.column}, {"key", role}, {"expected", expectedRoles()}});
            }
            std::size_t number = 0;
            const auto take = [&](const io::JsonCursor& path) {
                part.files.emplace_back(project::keyOf(role, ++number), pathOnLine(list, path.string()));
            };
            if (member.isList() && recipe_.task->input(role)->several)
                member.items(mostFilesOfPart, take);
            else
                take(member);
            if (number == 0) member.reject(LT_TEXT("Engine", "at least one file"));
        });
        for (const std::string& role : recipe_.varied) inputs.at(role, LT_TEXT("Engine", "the path of a file"));
        std::stable_sort(part.files.begin(), part.files.end(),
                         [&](const auto& a, const auto& b) { return placeOf(a.first) < placeOf(b.first); });
        parts_.push_back(std::move(part));
    }

    std::string expectedRoles() const
    {
        std::string roles;
        for (const std::string& role : recipe_.varied) roles += (roles.empty() ? "" : " | ") + role;
        return roles;
    }

    /// Of the role in the recipe: a group states them in any order.
    std::size_t placeOf(const std::string& key) const
    {
        std::size_t place = 0;
        while (place < recipe_.varied.size() && !project::belongsTo(key, recipe_.varied[place])) ++place;
        return place;
    }

    const Recipe& recipe_;
    const Progress& progress_;
    std::vector<Part> parts_;
};

}  // namespace

std::vector<Part> partsOf(const std::vector<std::string>& inputs, const Recipe& recipe, const Progress& progress)
{
    return PartLister(recipe, progress).list(inputs);
}

}  // namespace lathelier::batch
