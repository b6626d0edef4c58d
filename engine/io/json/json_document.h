// A JSON document whose values know their place: whatever does not fit is refused with line and column.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "engine/io/json/json_text.h"

namespace lathelier::io {

class JsonDocument;

/// Of one object.
inline constexpr std::size_t mostJsonMembers = 1000;

/// A value of a document together with the way to it. Lives no longer than the document.
class JsonCursor {
public:
    /// Error malformed: the value here is not what is expected.
    [[noreturn]] void reject(Value expected) const;
    JsonPlace place() const;  ///< of the value here

    bool isNull() const;
    bool isObject() const;
    bool isList() const;
    std::string string() const;  ///< Error malformed for what is no text; so with the others
    double number() const;
    std::int64_t integer() const;
    bool flag() const;

    /// A member of the object here; none when it is missing or null.
    std::optional<JsonCursor> member(const std::string& key) const;
    /// The same where it has to be there. Error keyMissing with `expected`.
    JsonCursor at(const std::string& key, Value expected) const;

    /// Calls use(key, value) for each member of the object here, at most `most` of them.
    void members(std::size_t most, const std::function<void(const std::string&, const JsonCursor&)>& use) const;
    /// Calls use(item) for each item of the list here, at most `most` of them.
    void items(std::size_t most, const std::function<void(const JsonCursor&)>& use) const;

    /// The value here as one Value. Error malformed for what has none: objects, mixed lists, more than 10 000 items.
    Value value() const;
    /// The members of the object here, at most mostJsonMembers.
    Values values() const;

private:
    friend class JsonDocument;
    JsonCursor(const JsonDocument& document, const Json& json, JsonPath path)
        : document_(&document), json_(&json), path_(std::move(path))
    {
    }
    JsonCursor inside(const std::string& step, const Json& json) const;

    const JsonDocument* document_;
    const Json* json_;
    JsonPath path_;
};

/// JSON with its text. Error malformed (line, column) where it is no JSON, or nests deeper than 32.
class JsonDocument {
public:
    explicit JsonDocument(std::string text);
    ~JsonDocument();
    JsonDocument(const JsonDocument&) = delete;
    JsonDocument& operator=(const JsonDocument&) = delete;

    JsonCursor root() const;
    Json& json();  ///< for migrations: places are those of the text as it was read
    const std::string& text() const { return text_; }

private:
    std::string text_;
    std::unique_ptr<Json> json_;
};

}  // namespace lathelier::io
