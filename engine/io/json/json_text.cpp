#include "engine/io/json/json_text.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "engine/core/utf8.h"
#include "engine/io/io_codes.h"

namespace lathelier::io {
namespace {

constexpr int deepest = 32;
constexpr std::size_t mostNames = 10000;  ///< in an object
constexpr std::size_t longestQuote = 40;  ///< bytes of the file quoted in a message

JsonPlace placeOfByte(std::string_view text, std::size_t byte)
{
    JsonPlace place;
    for (std::size_t i = 0; i < std::min(byte, text.size()); ++i) {
        if (text[i] == '\n') {
            ++place.line;
            place.column = 1;
        } else if (beginsCharacter(text[i])) {  // count characters, not UTF-8 bytes
            ++place.column;
        }
    }
    return place;
}

Error malformedJson(std::string_view text, std::size_t byte, Value expected)
{
    byte = std::min(byte, text.size());
    const JsonPlace place = placeOfByte(text, byte);
    const std::size_t end = std::min(text.find_first_of("\r\n", byte), text.size());
    return Error(errors::malformed, {{"line", place.line},
                                     {"column", place.column},
                                     {"found", std::string(firstBytes(text.substr(byte, end - byte), longestQuote))},
                                     {"expected", std::move(expected)}});
}

/// Walks over JSON that is known to be valid.
class Walker {
public:
    explicit Walker(std::string_view text) : text_(text) {}

    /// The first byte of the value at `path`; as far as the path exists, so a missing key gives its object.
    std::size_t find(const JsonPath& path)
    {
        skipSpace();
        for (const std::string& step : path) {
            const std::size_t object = at_;
            if (!enter(step)) return object;
        }
        return at_;
    }

private:
    bool enter(const std::string& step)
    {
        const bool array = text_[at_] == '[';
        if (!array && text_[at_] != '{') return false;
        ++at_;
        for (std::size_t index = 0;; ++index) {
            skipSpace();
            if (text_[at_] == ']' || text_[at_] == '}') return false;
            std::string name = std::to_string(index);
            if (!array) {
                const std::size_t begin = at_;
                skipString();
                name = Json::parse(text_.substr(begin, at_ - begin)).get<std::string>();
                skipSpace();
                ++at_;  // colon
                skipSpace();
            }
            if (name == step) return true;
            skipValue();
            skipSpace();
            if (text_[at_] == ',') ++at_;
        }
    }

    void skipSpace()
    {
        while (at_ < text_.size() &&
               (std::string_view(" \t\r\n\xEF\xBB\xBF").find(text_[at_]) != std::string_view::npos))
            ++at_;
    }

    void skipString()
    {
        for (++at_; text_[at_] != '"'; ++at_)
            if (text_[at_] == '\\') ++at_;
        ++at_;
    }

    void skipValue()
    {
        int depth = 0;
        do {
            const char c = text_[at_];
            if (c == '"') {
                skipString();
                continue;
            }
            if (c == '[' || c == '{') ++depth;
            if (c == ']' || c == '}') --depth;
            ++at_;
        } while (at_ < text_.size() &&
                 (depth > 0 || std::string_view(",]}").find(text_[at_]) == std::string_view::npos));
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

/// Accepts everything and records the position of the first error.
struct Listener : nlohmann::json_sax<Json> {
    std::size_t mistake = 0;
    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_object(std::size_t) override { return true; }
    bool key(string_t&) override { return true; }
    bool end_object() override { return true; }
    bool start_array(std::size_t) override { return true; }
    bool end_array() override { return true; }
    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) override
    {
        mistake = position;
        return false;
    }
};

/// A place that is refused before anything is parsed.
struct Refusal {
    std::size_t byte;
    Text expected;
};

/// Deep nesting would exhaust the stack; an object finds its names one by one, so that many take forever.
std::optional<Refusal> refusalOf(std::string_view text)
{
    int depth = 0;
    std::array<std::size_t, deepest + 1> names{};  // of the object at each level
    bool inside = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inside) {
            if (c == '\\') ++i;
            if (c == '"') inside = false;
        } else if (c == '"') {
            inside = true;
        } else if (c == '[' || c == '{') {
            if (++depth > deepest) return Refusal{i, LT_TEXT("Engine", "at most 32 levels of nesting")};
            names[static_cast<std::size_t>(depth)] = 0;
        } else if (c == ']' || c == '}') {
            depth = std::max(0, depth - 1);
        } else if (c == ':' && ++names[static_cast<std::size_t>(depth)] > mostNames) {
            return Refusal{i, LT_TEXT("Engine", "at most 10000 names in an object")};
        }
    }
    return std::nullopt;
}

}  // namespace

Json parseJson(std::string_view text)
{
    if (const auto refusal = refusalOf(text)) throw malformedJson(text, refusal->byte, refusal->expected);
    Listener listener;
    if (!Json::sax_parse(text, &listener))
        throw malformedJson(text, listener.mistake > 0 ? listener.mistake - 1 : 0, LT_TEXT("Engine", "JSON"));
    return Json::parse(text);
}

JsonPlace placeOf(std::string_view text, const JsonPath& path)
{
    return placeOfByte(text, Walker(text).find(path));
}

Error misfit(std::string_view text, const JsonPath& path, Value expected)
{
    return malformedJson(text, Walker(text).find(path), std::move(expected));
}

}  // namespace lathelier::io
