// Descriptions of parameters, read by the form, the project file, the command line, the report and the range check.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/text.h"
#include "engine/core/value.h"

namespace lathelier {

/// One choice of a Choice field.
struct FieldChoice {
    std::string key;  ///< stable, "revolution"
    Text label;       ///< shown text
};

/// An older key of a field, under which files may still state it. Read like the key of today, never written.
struct FormerKey {
    std::string key;                        ///< "lead_angle_deg"
    std::optional<double> complement = {};  ///< the value is this less what the former key states; none: the same value
    std::pair<std::string, std::string> where = {};  ///< only beside this key with this word; empty: always
    std::optional<double> blank = {};  ///< beside the former key, even of null, this value of the key of today is "not
                                       ///< stated": older writers put it there
};

/// What one parameter is, without the struct it lives in.
struct FieldInfo {
    /// Rows: a list of structs, a table in the form. Group: an optional struct; its value is a flag: present or absent.
    enum class Kind { Flag, Integer, Number, Choice, Word, Intervals, Rows, Group };

    std::string key;  ///< stable, with its unit: "tolerance_mm", within a group "chuck.radial_N_mm"; the option is
                      ///< --tolerance-mm
    Kind kind = Kind::Number;
    Text label;                        ///< short, without the unit
    Text help;                         ///< one sentence for the tooltip and --help
    Text unit;                         ///< "mm", empty when there is none
    double minimum = 0;                ///< lower end of the range, see `maximum`
    double maximum = 0;                ///< Integer, Number, the ends of Intervals, the count of Rows: inclusive range
    bool optional = false;             ///< may be "not given" (monostate)
    bool required = false;             ///< in a JSON file: a missing key is an error
    bool advanced = false;             ///< folded away in the form
    bool wraps = false;                ///< Intervals of angles: 350:10 runs through 0
    bool is_kept = false;              ///< kept in the state of a window (programs changed by hand): no option
    bool is_open = false;              ///< Choice: any other word is valid too (a name, or a file)
    std::vector<FieldChoice> choices;  ///< Choice: the values it may take, in the order of its enumerators
    std::vector<double> usual = {};    ///< Number: values of a standard, offered beside free typing
    Text group = {};                   ///< heading over the fields of one group; empty: none
    std::string group_key = {};        ///< key of the Group whose presence this field needs; empty: none
    std::vector<FieldInfo> columns = {};  ///< Rows: the fields of a row
    std::vector<FormerKey> former = {};   ///< older keys of files
};

/// One parameter of the struct P. `get` and `set` speak Value; a Choice is its key.
template <class P>
struct Field {
    FieldInfo info;  ///< key, kind, names and range
    std::function<Value(const P&)> get;
    std::function<void(P&, const Value&)> set;
};

/// The description of P: what `const std::vector<Field<P>>& fieldsOf(const P*)` gives, which stands beside each
/// parameter struct, in its namespace.
template <class P>
const std::vector<Field<P>>& fields()
{
    return fieldsOf(static_cast<const P*>(nullptr));
}

/// Throws Error valueOutOfRange or valueNotUnderstood when `value` is not valid for this field.
void check(const FieldInfo& info, const Value& value);

/// Parses text typed by a person or a script ("0.05", "auto", "10:20,30:40"; Rows: "20,30;40,25", the cells in the
/// order of the columns), decimal point only. Throws Error.
Value parse(const FieldInfo& info, const std::string& typed);

/// The infos alone, for code that builds forms and options without knowing P.
template <class P>
std::vector<FieldInfo> infos()
{
    std::vector<FieldInfo> result;
    for (const Field<P>& field : fields<P>()) result.push_back(field.info);
    return result;
}

/// All parameters by key.
template <class P>
Values toValues(const P& parameters)
{
    Values result;
    for (const Field<P>& field : fields<P>()) result.emplace_back(field.info.key, field.get(parameters));
    return result;
}

/// Is a value of the group given while the flag of the group itself is missing?
bool isImplied(const FieldInfo& group, const Values& values);

/// A field as its former key states it: range and key.
FieldInfo asFormer(const FieldInfo& info, const FormerKey& former);

/// Puts what stands under former keys under those of today, for one field. Error valueStatedTwice where both state it.
void takeFormer(const FieldInfo& info, Values& values);

/// Applies the values whose names are known and checks them; others are ignored, missing ones keep P's default. An
/// optional group is present when its own flag is true or, without the flag, when one of its values is given. Former
/// keys are known. Errors valueOutOfRange, valueNotUnderstood, valueStatedTwice.
template <class P>
P fromValues(const Values& given, P parameters = {})
{
    std::optional<Values> renamed;  // most structs have no former keys
    for (const Field<P>& field : fields<P>())
        if (!field.info.former.empty()) takeFormer(field.info, renamed ? *renamed : renamed.emplace(given));
    const Values& values = renamed ? *renamed : given;
    for (const Field<P>& field : fields<P>()) {
        if (const Value* value = find(values, field.info.key)) {
            check(field.info, *value);
            field.set(parameters, *value);
        } else if (isImplied(field.info, values)) {
            field.set(parameters, true);
        }
    }
    return parameters;
}

}  // namespace lathelier

#include "engine/core/fields_make.h"
