// A JSON document with the source location of each value, for errors with line and column.
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

/// Largest number of members of one object.
inline constexpr std::size_t mostJsonMembers = 1000;

/// A value of a document with its path. Must not outlive the document.
class JsonCursor {
public:
    /// Throws malformed: the value is not what is expected.
    [[noreturn]] void reject(Value expected) const;
    JsonPlace place() const;  ///< location of the value

    bool isNull() const;
    bool isObject() const;
    bool isList() const;
    std::string string() const;  ///< Error malformed when it is not a string; likewise the other accessors
    double number() const;
    std::int64_t integer() const;
    bool flag() const;

    /// A member of this object; none when missing or null.
    std::optional<JsonCursor> member(const std::string& key) const;
    /// The same for a required member. Error keyMissing with `expected`.
    JsonCursor at(const std::string& key, Value expected) const;

    /// Calls use(key, value) for each member of this object, at most `most` of them.
    void members(std::size_t most, const std::function<void(const std::string&, const JsonCursor&)>& use) const;
    /// Calls use(item) for each item of this list, at most `most` of them.
    void items(std::size_t most, const std::function<void(const JsonCursor&)>& use) const;

    /// This value as one Value. Error malformed for objects, mixed lists and more than 10 000 items.
    Value value() const;
    /// The members of this object, at most mostJsonMembers.
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

/// JSON with its text. Error malformed (line, column) where it is not JSON, or nests deeper than 32.
class JsonDocument {
public:
    explicit JsonDocument(std::string text);
    ~JsonDocument();
    JsonDocument(const JsonDocument&) = delete;
    JsonDocument& operator=(const JsonDocument&) = delete;

    JsonCursor root() const;
    Json& json();  ///< for migrations: locations refer to the original text
    const std::string& text() const { return text_; }

private:
    std::string text_;
    std::unique_ptr<Json> json_;
};

}  // namespace lathelier::io
