// Macro variables and expressions: #101=[50.+2.*2.], X[#1*SIN[30]], R1=R2+2*(R3-1), IF [#1 GT 5].
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/gcode/control.h"

namespace lathelier::gcode {

/// Values of variables, and how a control computes with them. Numbered variables are global except those up to
/// Arithmetic::last_local, named ones are local to a call except those with a leading underscore.
class Variables {
public:
    /// The arithmetic has to outlive the variables.
    explicit Variables(const Arithmetic& arithmetic) : arithmetic_(arithmetic) { calls_.emplace_back(); }

    const Arithmetic& arithmetic() const { return arithmetic_; }

    std::optional<double> get(long number) const;
    std::optional<double> get(const std::string& name) const;
    void set(long number, std::optional<double> value);
    void set(const std::string& name, double value);
    /// `arguments`: the variables #1… of the called program.
    void enter(std::unordered_map<long, double> arguments);
    void leave();

private:
    struct Call {
        std::unordered_map<long, double> numbers;
        std::unordered_map<std::string, double> names;
    };
    bool isLocal(long number) const;

    const Arithmetic& arithmetic_;
    std::unordered_map<long, double> numbers_;
    std::unordered_map<std::string, double> names_;
    std::vector<Call> calls_;
};

/// Why an expression has no value.
struct ExpressionFailure {
    Text reason;         ///< "a division by zero"
    std::size_t at = 0;  ///< byte in the expression
};

/// Result of an expression. `value` is empty for a single vacant variable (#0).
struct Computed {
    std::optional<double> value;
    bool is_incremental = false;  ///< IC(…)
    bool is_absolute = false;     ///< AC(…)
    std::size_t end = 0;          ///< number of bytes parsed
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
