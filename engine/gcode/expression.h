// Macro variables and expressions: #101=[50.+2.*2.], X[#1*SIN[30]], R1=R2+2*(R3-1), IF [#1 GT 5].
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/core/units.h"
#include "engine/gcode/control.h"

namespace lathelier::gcode {

/// Values of variables, and how a control computes with them. Numbered variables are global except those up to
/// Arithmetic::last_local, named ones are local to a call except those with a leading underscore.
class Variables {
public:
    /// The arithmetic has to outlive the variables.
    explicit Variables(const Arithmetic& arithmetic) : arithmetic_(arithmetic) { calls_.emplace_back(); }

    const Arithmetic& arithmetic() const { return arithmetic_; }

    /// Its value, that of a variable without one included; none: vacant, or not known.
    std::optional<double> get(long number) const;
    std::optional<double> get(const std::string& name) const;
    /// Without a value of which a reader of the program knows.
    bool isUnknown(long number) const;
    bool isUnknown(const std::string& name) const;
    bool isSet(long number) const;  ///< by the program, or as the position
    /// Without a value it counts as 0, but another program may have set it.
    bool isVacant(long number) const;
    bool isSet(const std::string& name) const;
    void set(long number, std::optional<double> value);
    void set(const std::string& name, double value);
    void setUnknown(long number);  ///< computed from what is not known
    void setUnknown(const std::string& name);
    /// Of the tool, in the units of the program and as it counts X; NaN: not known.
    void setPosition(double x, double z) { x_ = x, z_ = z; }
    /// `arguments`: the variables #1… of the called program.
    void enter(std::unordered_map<long, double> arguments);
    void leave();

private:
    struct Call {
        std::unordered_map<long, double> numbers;
        std::unordered_map<std::string, double> names;
    };
    bool isLocal(long number) const;
    double positionOf(PositionValue which) const { return which == PositionValue::X ? x_ : z_; }

    const Arithmetic& arithmetic_;
    std::unordered_map<long, double> numbers_;
    std::unordered_map<std::string, double> names_;
    std::vector<Call> calls_;
    double x_ = notANumber, z_ = notANumber;
};

/// Why an expression has no value.
struct ExpressionFailure {
    Text reason;         ///< "a division by zero"
    std::size_t at = 0;  ///< byte in the expression
};

/// Result of an expression. `value` is empty for a single vacant variable (#0).
struct Computed {
    std::optional<double> value;
    bool is_incremental = false;      ///< IC(…)
    bool is_absolute = false;         ///< AC(…)
    std::string unknown;              ///< the first variable whose value is not known; empty: none
    std::vector<std::string> vacant;  ///< those that the program has not set and that count as 0
    std::size_t end = 0;              ///< number of bytes parsed
};

/// The value of the expression that `text` begins with. Brackets [ ], at most 100 deep;
/// + - * / ** MOD DIV, EQ NE GT GE LT LE or == <> > < >= <=, AND OR XOR NOT; SIN COS TAN ASIN ACOS ATAN ATAN2 SQRT SQR
/// POT ABS ROUND FIX FUP LN EXP TRUNC in degrees. Truth is 1 or 0. Throws ExpressionFailure.
Computed compute(std::string_view text, const Variables& variables);

/// The number or the name of the variable that `text` begins with (#101, #[#1+2], #<name>, R5), and its end.
struct VariableName {
    long number = -1;
    std::string name;
    std::size_t end = 0;
};
VariableName variableName(std::string_view text, const Variables& variables);

}  // namespace lathelier::gcode
