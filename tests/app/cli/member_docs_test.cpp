// Public data members of structs say what they are: in a comment behind the member, or above it or its group, or by a
// name that ends in a unit (depth_mm), which a comment would only repeat.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace lathelier::golden {
namespace {

namespace fs = std::filesystem;

constexpr double leastDocumented_percent = 95;
constexpr std::size_t mostListed = 40;

struct Count {
    std::size_t members = 0;                ///< public data members of structs
    std::vector<std::string> undocumented;  ///< those without a comment: "engine/core/scan.h:12 int x;"
};

/// A class, struct, enum, union or namespace whose brace is open.
struct Scope {
    bool is_struct = false;
    bool is_public = false;
    int depth = 0;  ///< of braces before it was opened
};

std::vector<std::string> linesOf(const fs::path& path)
{
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

std::string trimmed(const std::string& text)
{
    const std::size_t first = text.find_first_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

std::string withoutStrings(const std::string& line)
{
    static const std::regex literal(R"re("(?:[^"\\]|\\.)*")re");
    return std::regex_replace(line, literal, "\"\"");
}

/// A declaration of data in one line, without its comment: no function, no type, no constant of the class.
bool isMember(const std::string& code)
{
    static const std::regex other(R"(^(using|friend|static|typedef|enum|struct|class|template|return)\b)");
    return code.ends_with(';') && !code.starts_with('}') && !std::regex_search(code, other) &&
           code.substr(0, code.find_first_of("={")).find('(') == std::string::npos;
}

/// "double depth_mm = 0;": the name ends in a unit.
bool namesItsUnit(const std::string& code)
{
    static const std::regex unit(
        R"(_(mm|mm2|mm3|um|m|deg|rad|hz|rpm|s|ms|percent|N|N_mm|N_mm2|MPa|V|upr|bytes|px)\s*[;={,])");
    return std::regex_search(code, unit);
}

/// "CheckParameters parameters;", "std::vector<SetupPlan> setups;": the name says no more than the type, whose own
/// comment holds.
bool repeatsItsType(const std::string& code)
{
    static const std::regex declaration(R"(([A-Z]\w*)[>\s*&]*\s(\w+)\s*[;={])");
    std::smatch match;
    if (!std::regex_search(code, match, declaration)) return false;
    const auto letters = [](std::string text) {
        std::erase(text, '_');
        std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
        return text;
    };
    const std::string type = letters(match.str(1)), name = letters(match.str(2));
    return type.ends_with(name) || (type + "s").ends_with(name);
}

/// Follows braces and access through the lines of one header.
class Scopes {
public:
    bool arePublicMembersHere() const
    {
        return !open_.empty() && open_.back().is_struct && open_.back().is_public && depth_ == open_.back().depth + 1;
    }

    void take(const std::string& code)
    {
        static const std::regex opening(R"(^\s*(?:template\s*<.*>\s*)?(struct|class|enum|union|namespace)\b[^;]*$)");
        static const std::regex access(R"(^\s*(public|private|protected):)");
        const auto opened = std::count(code.begin(), code.end(), '{');
        const auto closed = std::count(code.begin(), code.end(), '}');
        std::smatch found;
        if (opened > closed && std::regex_search(code, found, opening))
            open_.push_back({found[1] == "struct", found[1] == "struct", depth_});
        if (!open_.empty() && std::regex_search(code, found, access)) open_.back().is_public = found[1] == "public";
        depth_ += static_cast<int>(opened - closed);
        while (!open_.empty() && depth_ <= open_.back().depth) open_.pop_back();
    }

private:
    std::vector<Scope> open_;  ///< the innermost last
    int depth_ = 0;
};

void countMembers(const fs::path& header, const std::string& name, Count& count)
{
    const std::vector<std::string> lines = linesOf(header);
    Scopes scopes;
    bool documentedAbove = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string line = withoutStrings(lines[i]);
        const std::string code = line.substr(0, line.find("//"));
        const std::string words = trimmed(code);
        if (scopes.arePublicMembersHere() && isMember(words)) {
            ++count.members;
            const bool goesOnBelow = i + 1 < lines.size() && trimmed(lines[i + 1]).starts_with("///<");
            if (line.find("///") == std::string::npos && !documentedAbove && !goesOnBelow && !namesItsUnit(words) &&
                !repeatsItsType(words))
                count.undocumented.push_back(name + ":" + std::to_string(i + 1) + " " + words);
        }
        scopes.take(code);
        // A comment holds for what follows it, up to the end of its declaration.
        if (trimmed(lines[i]).starts_with("///"))
            documentedAbove = true;
        else if (words.empty() || words.ends_with(';'))
            documentedAbove = false;
    }
}

Count countAll()
{
    const fs::path root = LATHELIER_SOURCE_DIR;
    std::vector<fs::path> headers;
    for (const char* folder : {"engine", "widgets"})
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
            if (entry.path().extension() == ".h") headers.push_back(entry.path());
    std::sort(headers.begin(), headers.end());
    Count count;
    for (const fs::path& header : headers) countMembers(header, fs::relative(header, root).generic_string(), count);
    return count;
}

}  // namespace

TEST(MemberDocs, PublicDataMembersTellMeaningAndUnit)
{
    const Count count = countAll();
    ASSERT_GT(count.members, 1000U);
    const double documented_percent =
        100 * (1 - static_cast<double>(count.undocumented.size()) / static_cast<double>(count.members));
    RecordProperty("members", static_cast<int>(count.members));
    std::string list;
    for (std::size_t i = 0; i < std::min(mostListed, count.undocumented.size()); ++i)
        list += count.undocumented[i] + "\n";
    EXPECT_GE(documented_percent, leastDocumented_percent)
        << count.undocumented.size() << " of " << count.members << " members have no comment:\n"
        << list;
}

}  // namespace lathelier::golden
