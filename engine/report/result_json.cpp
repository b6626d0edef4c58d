#include "engine/report/result_json.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "engine/core/version.h"
#include "engine/core/visible.h"

namespace lathelier::report {
namespace {

constexpr std::size_t stepSize = std::size_t{1} << 16;

/// Buffers text and passes it on in chunks.
class Sink {
public:
    explicit Sink(const std::function<void(std::string_view)>& append) : append_(append) {}

    Sink& operator+=(std::string_view text)
    {
        buffer_ += text;
        if (buffer_.size() >= stepSize) flush();
        return *this;
    }

    void flush()
    {
        append_(buffer_);
        buffer_.clear();
    }

private:
    const std::function<void(std::string_view)>& append_;
    std::string buffer_;
};

/// Bidirectional and invisible control characters are escaped, which leaves the JSON value unchanged.
std::string scalar(const Json& json)
{
    const auto dumped = [&json](bool asciiOnly) {
        return json.dump(-1, ' ', asciiOnly, Json::error_handler_t::replace);
    };
    std::string text = dumped(false);
    return json.is_string() && visible(text) != text ? dumped(true) : text;
}

bool isFlat(const Json& array)
{
    return std::none_of(array.begin(), array.end(), [](const Json& item) { return item.is_structured(); });
}

/// Short nested arrays of numbers also stay on one line.
bool isShort(const Json& array)
{
    return std::all_of(array.begin(), array.end(), [](const Json& item) { return item.is_array() && isFlat(item); });
}

/// An array on one line.
void writeFlat(const Json& array, Sink& out)
{
    out += "[";
    bool first = true;
    for (const Json& item : array) {
        if (!first) out += ", ";
        first = false;
        if (item.is_array())
            writeFlat(item, out);
        else
            out += scalar(item);
    }
    out += "]";
}

void write(const Json& json, const std::string& indent, Sink& out)
{
    if (!json.is_structured() || json.empty()) {
        out += scalar(json);
        return;
    }
    if (json.is_array() && (isFlat(json) || isShort(json))) return writeFlat(json, out);
    const std::string inner = indent + "  ";
    out += json.is_array() ? "[\n" : "{\n";
    std::size_t left = json.size();
    for (auto item = json.begin(); item != json.end(); ++item) {
        out += inner;
        if (json.is_object()) out += scalar(item.key()) + ": ";
        write(*item, inner, out);
        out += --left > 0 ? ",\n" : "\n";
    }
    out += indent + (json.is_array() ? "]" : "}");
}

}  // namespace

Json resultHead(const std::string& command, const std::vector<InputFile>& inputs, const Values& parameters)
{
    Json head{{"command", command}, {"version", programVersion}, {"inputs", Json::array()}};
    for (const InputFile& file : inputs)
        head["inputs"].push_back({{"path", file.path}, {"bytes", file.bytes}, {"sha256", file.sha256}});
    head["parameters"] = toJson(parameters);
    return head;
}

void addRemarks(Json& result, const Understanding& understanding, const std::vector<Error>& errors, const Notes& notes)
{
    if (!understanding.isWhole()) result["verdict"] = key(Verdict::Undecided);
    result["understanding"] = toJson(understanding);
    Json all = toJson(notes);
    if (!errors.empty()) {
        result["error"] = toJson(errors.front());
        // Scripts that collect notes find why there is no answer beside the others.
        if (errors.front().code().kind == ErrorKind::NoAnswer) all.push_back(result["error"]);
    }
    if (errors.size() > 1)
        for (const Error& error : errors) result["errors"].push_back(toJson(error));
    result["notes"] = std::move(all);
}

Json wholeResult(const std::string& command, const std::vector<InputFile>& inputs, const Values& parameters,
                 const Json& result, const Notes& notes)
{
    Json whole = resultHead(command, inputs, parameters);
    whole.update(result);
    addRemarks(whole, understandingOf(notes), {}, notes);
    return whole;
}

void writeText(const Json& json, const std::function<void(std::string_view)>& append)
{
    Sink sink(append);
    write(json, "", sink);
    sink += "\n";
    sink.flush();
}

std::string toText(const Json& json)
{
    std::string result;
    writeText(json, [&result](std::string_view step) { result += step; });
    return result;
}

std::string joinedResults(const std::vector<std::string>& results)
{
    if (results.empty()) return {};
    if (results.size() == 1) return results.front();
    Json whole{{"results", Json::array()}};
    for (const std::string& result : results) whole["results"].push_back(Json::parse(result));
    return toText(whole);
}

}  // namespace lathelier::report
