// Descriptions of results, read by the JSON of the command line, tables on screen and in the report, and CSV, so that
// each quantity has one key, name, unit and number of decimals.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/conformity.h"
#include "engine/core/json.h"
#include "engine/core/text.h"
#include "engine/core/value.h"

namespace lathelier {

/// What one number of a result is, without the struct it lives in.
struct QuantityInfo {
    std::string key;       ///< with its unit: "RONt_um"; within a part "two_point.range_um"
    Text label = {};       ///< for tables; empty: JSON only
    Text unit = {};        ///< "µm", empty when there is none
    int decimals = 3;      ///< in tables
    bool in_json = true;   ///< false: for tables only
    bool is_part = false;  ///< an optional part; its value is a flag (absent: JSON null)
    Text heading = {};     ///< short, for the columns of tables; empty: the label
};

/// One quantity of the struct R.
template <class R>
struct QuantityOf {
    QuantityInfo info;  ///< key, name, unit and decimals
    std::function<Value(const R&)> get;
};

/// The description of R: what `const std::vector<QuantityOf<R>>& quantitiesOf(const R*)` gives, which stands beside
/// each result struct, in its namespace.
template <class R>
const std::vector<QuantityOf<R>>& quantities()
{
    return quantitiesOf(static_cast<const R*>(nullptr));
}

/// All values that JSON shows, by key.
template <class R>
Values describedValues(const R& result)
{
    Values values;
    for (const QuantityOf<R>& quantity : quantities<R>())
        if (quantity.info.in_json) values.emplace_back(quantity.info.key, quantity.get(result));
    return values;
}

/// Values by key as objects within objects: "two_point.range_um" is the member range_um of the object two_point. A
/// result as JSON is nestedJson(describedValues(result)).
Json nestedJson(const Values& values);

/// The quantity of this key. A key that R has not is std::logic_error.
template <class R>
const QuantityOf<R>& quantityOf(std::string_view key)
{
    for (const QuantityOf<R>& quantity : quantities<R>())
        if (quantity.info.key == key) return quantity;
    throw std::logic_error("no such quantity: " + std::string(key));
}

/// Presentation of a quantity in tables.
struct Look {
    Text label = {};      ///< QuantityInfo::label; empty: JSON only
    Text unit = {};       ///< QuantityInfo::unit; empty: none
    int decimals = 3;     ///< QuantityInfo::decimals, in tables
    bool in_json = true;  ///< QuantityInfo::in_json; false: for tables only
    Text heading = {};    ///< QuantityInfo::heading; empty: the label
};

namespace detail {

inline Value asValue(double v)
{
    return v;
}
inline Value asValue(bool v)
{
    return v;
}
inline Value asValue(std::string v)
{
    return v;
}
inline Value asValue(std::string_view v)
{
    return std::string(v);
}
inline Value asValue(const char* v)
{
    return std::string(v);
}
inline Value asValue(Text v)
{
    return v;
}
inline Value asValue(std::vector<double> v)
{
    return v;
}
inline Value asValue(Rows v)
{
    return v;
}
inline Value asValue(Value v)
{
    return v;
}
inline Value asValue(const Eigen::Vector2d& v)
{
    return std::vector<double>(v.begin(), v.end());
}
inline Value asValue(const Eigen::Vector3d& v)
{
    return std::vector<double>(v.begin(), v.end());
}
template <std::integral I>
requires(!std::same_as<I, bool>) Value asValue(I v)
{
    return static_cast<std::int64_t>(v);
}
template <std::integral I>
requires(!std::same_as<I, bool>) Value asValue(const std::vector<I>& v)
{
    return std::vector<std::int64_t>(v.begin(), v.end());
}
template <class T>
Value asValue(const std::optional<T>& v)
{
    return v ? asValue(*v) : Value();
}

QuantityInfo within(const QuantityInfo& info, const std::string& part);

}  // namespace detail

/// `get`: a member, or a function of the result.
template <class R, class Get>
QuantityOf<R> quantity(const char* key, Get get, const Look& look = {})
{
    return {{key, look.label, look.unit, look.decimals, look.in_json, false, look.heading},
            [get](const R& result) -> Value { return detail::asValue(std::invoke(get, result)); }};
}

/// The quantities of a struct within R, with keys "key.…".
template <class R, class P>
std::vector<QuantityOf<R>> part(const char* key, P R::*member)
{
    std::vector<QuantityOf<R>> result;
    for (const QuantityOf<P>& inner : quantities<P>())
        result.push_back({detail::within(inner.info, key),
                          [member, get = inner.get](const R& whole) { return get(whole.*member); }});
    return result;
}

/// The same with their own keys, as members of R itself.
template <class R, class P>
std::vector<QuantityOf<R>> included(P R::*member)
{
    std::vector<QuantityOf<R>> result;
    for (const QuantityOf<P>& inner : quantities<P>())
        result.push_back({inner.info, [member, get = inner.get](const R& whole) { return get(whole.*member); }});
    return result;
}

/// The same for an optional struct: null in JSON when absent.
template <class R, class P>
std::vector<QuantityOf<R>> part(const char* key, std::optional<P> R::*member)
{
    std::vector<QuantityOf<R>> result;
    result.push_back(
        {{key, {}, {}, 0, true, true, {}}, [member](const R& whole) -> Value { return (whole.*member).has_value(); }});
    for (const QuantityOf<P>& inner : quantities<P>())
        result.push_back({detail::within(inner.info, key), [member, get = inner.get](const R& whole) {
                              return whole.*member ? get(*(whole.*member)) : Value();
                          }});
    return result;
}

/// A list of structs: an array of objects in JSON.
template <class P>
Rows listed(const std::vector<P>& items)
{
    Rows rows;
    for (const P& item : items) rows.rows.push_back({describedValues(item)});
    return rows;
}

/// The verdict of a result as JSON has it; not given when there was none to make.
template <class R>
Value verdictKey(const R& result)
{
    return result.verdict ? Value(std::string(key(*result.verdict))) : Value();
}

/// The verdict of a result for the cells of tables; not given when there was none to make.
template <class R>
Value verdictName(const R& result)
{
    return result.verdict ? Value(shortName(*result.verdict)) : Value();
}

/// A description from single quantities and parts, in order.
template <class R, class... Parts>
std::vector<QuantityOf<R>> describedBy(Parts... parts)
{
    std::vector<QuantityOf<R>> result;
    const auto add = [&result](auto part) {
        if constexpr (std::is_same_v<decltype(part), QuantityOf<R>>)
            result.push_back(std::move(part));
        else
            for (auto& quantity : part) result.push_back(std::move(quantity));
    };
    (add(std::move(parts)), ...);
    return result;
}

}  // namespace lathelier
