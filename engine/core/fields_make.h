// Makers for Field<P>, one for each type of member. Included by fields.h.
#pragma once

#include <optional>
#include <type_traits>

namespace lathelier {

template <class E>
concept Enumeration = std::is_enum_v<E>;

/// Range for numbers, inclusive.
struct Range {
    double minimum;
    double maximum;
};

/// The description of a field besides its type.
struct Label {
    Text label;             ///< FieldInfo::label: short, without the unit
    Text help;              ///< FieldInfo::help: one sentence
    Text unit = {};         ///< FieldInfo::unit; empty: none
    bool advanced = false;  ///< FieldInfo::advanced: folded away in the form
    bool required = false;  ///< FieldInfo::required: must be in a JSON file
};

namespace detail {
FieldInfo makeInfo(const char* key, FieldInfo::Kind kind, const Label& label, Range range = {0, 0});
double asDouble(const Value& value);  ///< an integer counts as a number
FieldInfo within(const FieldInfo& info, const std::string& key, Text heading, const std::string& group_key);
}  // namespace detail

template <class P>
Field<P> field(const char* key, double P::*member, Range range, const Label& label)
{
    return {detail::makeInfo(key, FieldInfo::Kind::Number, label, range),
            [member](const P& p) -> Value { return p.*member; },
            [member](P& p, const Value& v) { p.*member = detail::asDouble(v); }};
}

template <class P>
Field<P> field(const char* key, std::optional<double> P::*member, Range range, const Label& label)
{
    FieldInfo info = detail::makeInfo(key, FieldInfo::Kind::Number, label, range);
    info.optional = true;
    return {info, [member](const P& p) -> Value { return p.*member ? Value(*(p.*member)) : Value(); },
            [member](P& p, const Value& v) {
                if (std::holds_alternative<std::monostate>(v))
                    (p.*member).reset();
                else
                    p.*member = detail::asDouble(v);
            }};
}

template <class P>
Field<P> field(const char* key, int P::*member, Range range, const Label& label)
{
    return {detail::makeInfo(key, FieldInfo::Kind::Integer, label, range),
            [member](const P& p) -> Value { return std::int64_t{p.*member}; },
            [member](P& p, const Value& v) { p.*member = static_cast<int>(std::get<std::int64_t>(v)); }};
}

template <class P>
Field<P> field(const char* key, bool P::*member, const Label& label)
{
    return {detail::makeInfo(key, FieldInfo::Kind::Flag, label), [member](const P& p) -> Value { return p.*member; },
            [member](P& p, const Value& v) { p.*member = std::get<bool>(v); }};
}

template <class P>
Field<P> field(const char* key, std::string P::*member, const Label& label)
{
    return {detail::makeInfo(key, FieldInfo::Kind::Word, label), [member](const P& p) -> Value { return p.*member; },
            [member](P& p, const Value& v) { p.*member = std::get<std::string>(v); }};
}

template <class P>
Field<P> field(const char* key, std::vector<Interval> P::*member, Range range, const Label& label)
{
    return {detail::makeInfo(key, FieldInfo::Kind::Intervals, label, range),
            [member](const P& p) -> Value { return p.*member; },
            [member](P& p, const Value& v) { p.*member = std::get<std::vector<Interval>>(v); }};
}

/// An enum whose enumerators are 0, 1, 2… in the order of `choices`.
template <class P, Enumeration E>
Field<P> field(const char* key, E P::*member, const std::vector<FieldChoice>& choices, const Label& label)
{
    FieldInfo info = detail::makeInfo(key, FieldInfo::Kind::Choice, label);
    info.choices = choices;
    return {info,
            [member, choices](const P& p) -> Value { return choices.at(static_cast<std::size_t>(p.*member)).key; },
            [member, choices](P& p, const Value& v) {
                for (std::size_t i = 0; i < choices.size(); ++i)
                    if (choices[i].key == std::get<std::string>(v)) p.*member = static_cast<E>(i);
            }};
}

/// A choice held by its key, for lists that are data (libraries, controls).
template <class P>
Field<P> choice(const char* key, std::string P::*member, const std::vector<FieldChoice>& choices, const Label& label)
{
    FieldInfo info = detail::makeInfo(key, FieldInfo::Kind::Choice, label);
    info.choices = choices;
    return {info, [member](const P& p) -> Value { return p.*member; },
            [member](P& p, const Value& v) { p.*member = std::get<std::string>(v); }};
}

/// A list of structs, described like a number is: a table with a column for each field of R. `count`: how many rows.
template <class P, class R>
Field<P> rows(const char* key, std::vector<R> P::*member, Range count, const Label& label)
{
    FieldInfo info = detail::makeInfo(key, FieldInfo::Kind::Rows, label, count);
    info.columns = infos<R>();
    return {info,
            [member](const P& p) -> Value {
                Rows table;
                for (const R& item : p.*member) table.rows.push_back({toValues(item)});
                return table;
            },
            [member](P& p, const Value& v) {
                (p.*member).clear();
                if (const Rows* table = std::get_if<Rows>(&v))
                    for (const Row& row : table->rows) (p.*member).push_back(fromValues<R>(row.cells));
            }};
}

/// A field that older files state under another key.
template <class P>
Field<P> formerly(FormerKey former, Field<P> field)
{
    field.info.former.push_back(std::move(former));
    return field;
}

/// Fields of a base of P as fields of P.
template <class P, class Base>
std::vector<Field<P>> lifted(const std::vector<Field<Base>>& fields)
{
    static_assert(std::is_base_of_v<Base, P>);
    std::vector<Field<P>> result;
    result.reserve(fields.size());
    for (const Field<Base>& field : fields) result.push_back({field.info, field.get, field.set});
    return result;
}

/// The fields of a struct within P, with keys "key.…", under one heading.
template <class P, class G>
std::vector<Field<P>> group(const char* key, G P::*member, const Label& label)
{
    std::vector<Field<P>> result;
    for (const Field<G>& inner : fields<G>())
        result.push_back({detail::within(inner.info, key, label.label, {}),
                          [member, inner](const P& p) { return inner.get(p.*member); },
                          [member, inner](P& p, const Value& v) { inner.set(p.*member, v); }});
    return result;
}

/// A struct that may be absent (a tailstock or none): first the field `key`, a flag: present or absent, then its
/// fields, which are "not given" while it is not.
template <class P, class G>
std::vector<Field<P>> group(const char* key, std::optional<G> P::*member, const Label& label)
{
    std::vector<Field<P>> result;
    result.push_back({detail::makeInfo(key, FieldInfo::Kind::Group, label),
                      [member](const P& p) -> Value { return (p.*member).has_value(); },
                      [member](P& p, const Value& v) {
                          if (!std::get<bool>(v))
                              (p.*member).reset();
                          else if (!(p.*member))
                              (p.*member).emplace();
                      }});
    for (const Field<G>& inner : fields<G>())
        result.push_back({detail::within(inner.info, key, label.label, key),
                          [member, inner](const P& p) { return p.*member ? inner.get(*(p.*member)) : Value(); },
                          [member, inner](P& p, const Value& v) {
                              const bool given = !std::holds_alternative<std::monostate>(v) || inner.info.optional;
                              if (p.*member && given) inner.set(*(p.*member), v);
                          }});
    return result;
}

/// A description from single fields and groups, in order.
template <class P, class... Parts>
std::vector<Field<P>> described(Parts... parts)
{
    std::vector<Field<P>> result;
    const auto add = [&result](auto part) {
        if constexpr (std::is_same_v<decltype(part), Field<P>>)
            result.push_back(std::move(part));
        else
            for (auto& field : part) result.push_back(std::move(field));
    };
    (add(std::move(parts)), ...);
    return result;
}

}  // namespace lathelier
