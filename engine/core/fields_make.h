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

/// What a field says of itself besides its type.
struct Label {
    Text label;
    Text help;
    Text unit = {};
    bool advanced = false;
};

namespace detail {
FieldInfo makeInfo(const char* key, FieldInfo::Kind kind, const Label& label, Range range = {0, 0});
double asDouble(const Value& value);  ///< an integer counts as a number
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

}  // namespace lathelier
