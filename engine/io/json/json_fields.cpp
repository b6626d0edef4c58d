#include "engine/io/json/json_fields.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "engine/core/core_codes.h"
#include "engine/io/io_codes.h"

namespace lathelier::io {
namespace {

constexpr std::size_t mostListRows = 100000;

constexpr std::size_t mostUnknownKeys = 100;  ///< notes on unknown keys: the place of each is searched in the text

/// A key without marks and case: "lengthMm" and "length_mm" are "lengthmm".
std::string plainKey(std::string_view key)
{
    std::string plain;
    for (const char c : key)
        if (std::isalnum(static_cast<unsigned char>(c))) plain += static_cast<char>(std::tolower(c));
    return plain;
}

/// True for a key that means `key` but for its unit or its spelling: "length", "length_in" or "lengthMm" for
/// "length_mm".
bool isMisnamed(std::string_view found, std::string_view key)
{
    constexpr std::size_t shortest = 3;
    const auto stem = [](std::string_view name) { return name.substr(0, name.rfind('_')); };
    if (found.size() < shortest) return false;
    if (plainKey(found) == plainKey(key)) return true;
    return stem(key) != key && (plainKey(stem(key)) == plainKey(found) ||
                                (stem(found) != found && plainKey(stem(key)) == plainKey(stem(found))));
}

/// Reads one object, and those within it, into values by flat keys.
class FieldReader {
public:
    FieldReader(const std::vector<FieldInfo>& fields, Notes& notes) : fields_(fields), notes_(notes) {}

    Values read(const JsonCursor& object, const std::vector<std::string>& others)
    {
        readMembers(object, "", others);
        for (const FieldInfo& info : fields_) moveFormer(info);
        for (const FieldInfo& info : fields_)
            if (info.required && !find(values_, info.key) && isGroupThere(info)) missing(object, info);
        return std::move(values_);
    }

    /// A row as a list: a value for each field, in their order.
    Values readList(const JsonCursor& list)
    {
        std::size_t count = 0;
        list.items(fields_.size(), [&](const JsonCursor& item) {
            const FieldInfo& info = fields_[count++];
            set(values_, info.key, valueOf(item, info));
        });
        if (count < fields_.size()) list.reject(LT_TEXT("Engine", "a longer list"));
        return std::move(values_);
    }

private:
    bool isGroupThere(const FieldInfo& info) const
    {
        if (info.group_key.empty()) return true;
        const Value* there = find(values_, info.group_key);
        return there && *there == Value(true);
    }

    [[noreturn]] void missing(const JsonCursor& object, const FieldInfo& info) const
    {
        for (const auto& [key, member] : unknown_) {
            if (!isMisnamed(key, info.key)) continue;
            const JsonPlace at = member.place();
            throw Error(errors::keyMisnamed,
                        {{"line", at.line}, {"column", at.column}, {"found", key}, {"key", info.key}});
        }
        const JsonPlace here = object.place();
        throw Error(errors::keyMissing, {{"line", here.line},
                                         {"column", here.column},
                                         {"key", info.key},
                                         {"expected", info.label.empty() ? Value(info.key) : Value(info.label)}});
    }

    void readMembers(const JsonCursor& object, const std::string& prefix, const std::vector<std::string>& others)
    {
        object.members(mostJsonMembers, [&](const std::string& name, const JsonCursor& member) {
            const std::string key = prefix + name;
            const std::optional<FieldInfo> former = formerField(key);
            if (former) stated_.emplace_back(key, member);
            const auto info =
                std::find_if(fields_.begin(), fields_.end(), [&key](const FieldInfo& one) { return one.key == key; });
            const bool is_group = std::any_of(fields_.begin(), fields_.end(),
                                              [&key](const FieldInfo& one) { return one.key.starts_with(key + "."); });
            if (is_group) {
                const bool optional = info != fields_.end();
                if (optional) set(values_, key, !member.isNull());
                if (!(optional && member.isNull())) readMembers(member, key + ".", {});
            } else if (info != fields_.end()) {
                set(values_, key, valueOf(member, *info));
            } else if (former) {
                set(values_, key, valueOf(member, *former));
            } else if (std::find(others.begin(), others.end(), key) == others.end()) {
                unknown_.emplace_back(key, member);
                if (unknownKeys(notes_) >= mostUnknownKeys) return;
                const JsonPlace here = member.place();
                Values values{{"key", key}, {"line", here.line}, {"column", here.column}};
                const auto meant = std::find_if(fields_.begin(), fields_.end(),
                                                [&key](const FieldInfo& one) { return isMisnamed(key, one.key); });
                if (meant != fields_.end()) values.emplace_back("meant", meant->key);
                notes_.push_back({notes::unknownKey, std::move(values)});
            }
        });
    }

    static std::size_t unknownKeys(const Notes& notes)
    {
        return static_cast<std::size_t>(std::count_if(
            notes.begin(), notes.end(), [](const Note& note) { return note.code == lathelier::notes::unknownKey; }));
    }

    std::optional<FieldInfo> formerField(const std::string& key) const
    {
        for (const FieldInfo& info : fields_)
            for (const FormerKey& former : info.former)
                if (former.key == key) return asFormer(info, former);
        return {};
    }

    void moveFormer(const FieldInfo& info)
    {
        try {
            takeFormer(info, values_);
        } catch (Error& error) {
            const Value* former = find(error.values(), "former");
            for (const auto& [key, member] : stated_) {
                if (!former || !(*former == Value(key))) continue;
                const JsonPlace here = member.place();
                error.with("line", here.line).with("column", here.column);
            }
            throw;
        }
    }

    Value valueOf(const JsonCursor& member, const FieldInfo& info)
    {
        Value value = typed(member, info);
        try {
            check(info, value);
        } catch (Error& error) {
            if (!(error.code() == errors::valueOutOfRange)) member.reject(expectedOf(error));
            const JsonPlace here = member.place();
            Values values = error.values();
            set(values, "key", info.key);
            set(values, "line", here.line);
            set(values, "column", here.column);
            throw Error(errors::keyOutOfRange, values);
        }
        return value;
    }

    static Value expectedOf(const Error& error)
    {
        const Value* expected = find(error.values(), "expected");
        return expected ? *expected : Value();
    }

    Value typed(const JsonCursor& member, const FieldInfo& info)
    {
        if (member.isNull()) return {};
        switch (info.kind) {
            case FieldInfo::Kind::Flag:
            case FieldInfo::Kind::Group: return member.flag();
            case FieldInfo::Kind::Integer: return member.integer();
            case FieldInfo::Kind::Number: return member.number();
            case FieldInfo::Kind::Choice:
            case FieldInfo::Kind::Word: return member.string();
            case FieldInfo::Kind::Intervals: return member.value();
            case FieldInfo::Kind::Rows: break;
        }
        Rows rows;
        member.items(mostListRows, [&](const JsonCursor& item) {
            FieldReader reader(info.columns, notes_);
            rows.rows.push_back({item.isList() ? reader.readList(item) : reader.read(item, {})});
        });
        return rows;
    }

    const std::vector<FieldInfo>& fields_;
    Notes& notes_;
    Values values_;
    std::vector<std::pair<std::string, JsonCursor>> stated_;   ///< members with former keys
    std::vector<std::pair<std::string, JsonCursor>> unknown_;  ///< members with keys of no field
};

Json valueAsJson(const FieldInfo& info, const Value& value)
{
    if (info.kind != FieldInfo::Kind::Rows) return toJson(value);
    Json list = Json::array();
    if (const Rows* rows = std::get_if<Rows>(&value))
        for (const Row& row : rows->rows) list.push_back(objectOf(info.columns, row.cells));
    return list;
}

}  // namespace

Values valuesOf(const JsonCursor& object, const std::vector<FieldInfo>& fields, Notes& notes,
                const std::vector<std::string>& others)
{
    return FieldReader(fields, notes).read(object, others);
}

Json objectOf(const std::vector<FieldInfo>& fields, const Values& values)
{
    Json result = Json::object();
    for (const FieldInfo& info : fields) {
        const Value* value = find(values, info.key);
        if (!value) continue;
        if (!info.group_key.empty()) {
            const Value* there = find(values, info.group_key);
            if (!there || !(*there == Value(true))) continue;
        }
        Json* place = &result;
        std::size_t from = 0;
        for (std::size_t dot = info.key.find('.'); dot != std::string::npos; dot = info.key.find('.', from)) {
            place = &(*place)[info.key.substr(from, dot - from)];
            from = dot + 1;
        }
        Json& member = (*place)[info.key.substr(from)];
        if (info.kind == FieldInfo::Kind::Group)
            member = *value == Value(true) ? Json::object() : Json(nullptr);
        else
            member = valueAsJson(info, *value);
    }
    return result;
}

}  // namespace lathelier::io
