#include "engine/io/json/json_document.h"

#include <nlohmann/json.hpp>

#include "engine/core/item_numbers.h"
#include "engine/io/io_codes.h"

namespace lathelier::io {

void JsonCursor::reject(Value expected) const
{
    throw misfit(document_->text(), path_, std::move(expected));
}

JsonPlace JsonCursor::place() const
{
    return placeOf(document_->text(), path_);
}

bool JsonCursor::isNull() const
{
    return json_->is_null();
}

bool JsonCursor::isObject() const
{
    return json_->is_object();
}

bool JsonCursor::isList() const
{
    return json_->is_array();
}

std::string JsonCursor::string() const
{
    if (!json_->is_string()) reject(LT_TEXT("Engine", "a text"));
    return json_->get<std::string>();
}

double JsonCursor::number() const
{
    if (!json_->is_number()) reject(LT_TEXT("Engine", "a number"));
    return json_->get<double>();
}

std::int64_t JsonCursor::integer() const
{
    constexpr auto largest = static_cast<std::uint64_t>(INT64_MAX);
    const bool fits =
        json_->is_number_integer() && !(json_->is_number_unsigned() && json_->get<std::uint64_t>() > largest);
    if (!fits) reject(LT_TEXT("Engine", "a whole number"));
    return json_->get<std::int64_t>();
}

bool JsonCursor::flag() const
{
    if (!json_->is_boolean()) reject(LT_TEXT("Engine", "true or false"));
    return json_->get<bool>();
}

std::optional<JsonCursor> JsonCursor::member(const std::string& key) const
{
    if (!json_->is_object()) reject(LT_TEXT("Engine", "an object"));
    const auto found = json_->find(key);
    if (found == json_->end() || found->is_null()) return std::nullopt;
    return inside(key, *found);
}

JsonCursor JsonCursor::at(const std::string& key, Value expected) const
{
    if (auto found = member(key)) return *std::move(found);
    const JsonPlace here = place();
    throw Error(errors::keyMissing,
                {{"line", here.line}, {"column", here.column}, {"key", key}, {"expected", std::move(expected)}});
}

void JsonCursor::members(std::size_t most, const std::function<void(const std::string&, const JsonCursor&)>& use) const
{
    if (!json_->is_object()) reject(LT_TEXT("Engine", "an object"));
    if (json_->size() > most) reject(LT_TEXT("Engine", "fewer members"));
    for (const auto& [name, value] : json_->items()) use(name, inside(name, value));
}

void JsonCursor::items(std::size_t most, const std::function<void(const JsonCursor&)>& use) const
{
    if (!json_->is_array()) reject(LT_TEXT("Engine", "a list"));
    if (json_->size() > most) reject(LT_TEXT("Engine", "a shorter list"));
    for (std::size_t i = 0; i < json_->size(); ++i) use(inside(std::to_string(i), (*json_)[i]));
}

Value JsonCursor::value() const
{
    if (json_->is_array() && json_->size() > mostItemNumbers) reject(LT_TEXT("Engine", "a shorter list"));
    if (json_->is_number_integer()) return integer();
    Value result = valueFromJson(*json_);
    if (!json_->is_null() && std::holds_alternative<std::monostate>(result))
        reject(LT_TEXT("Engine", "a number, a text, true, false, null or a list"));
    return result;
}

Values JsonCursor::values() const
{
    Values result;
    members(mostJsonMembers,
            [&result](const std::string& name, const JsonCursor& member) { set(result, name, member.value()); });
    return result;
}

JsonCursor JsonCursor::inside(const std::string& step, const Json& json) const
{
    JsonPath path = path_;
    path.push_back(step);
    return {*document_, json, std::move(path)};
}

JsonDocument::JsonDocument(std::string text) : text_(std::move(text)), json_(std::make_unique<Json>(parseJson(text_)))
{
}

JsonDocument::~JsonDocument() = default;

JsonCursor JsonDocument::root() const
{
    return {*this, *json_, {}};
}

Json& JsonDocument::json()
{
    return *json_;
}

}  // namespace lathelier::io
