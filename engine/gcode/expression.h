// Macro variables and expressions: #101=[50.+2.*2.], X[#1*SIN[30]], R1=R2+2*(R3-1), IF [#1 GT 5].
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/gcode/dialect.h"

namespace lathelier::gcode {

/// Values of variables. Numbered variables are global except those local to a call (#1…#33 of Fanuc, #1…#30 of
/// LinuxCNC, named ones of LinuxCNC without a leading underscore).
class Variables {
public:
    explicit Variables(Dialect dialect) : dialect_(dialect) { calls_.emplace_back(); }

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

    Dialect dialect_;
    std::unordered_map<long, double> numbers_;
    std::unordered_map<std::string, double> names_;
    std::vector<Call> calls_;
};

/// Why an expression has no value.
struct ExpressionFailure {
    Text reason;         ///< "a division by zero"
    std::size_t at = 0;  ///< byte in the expression
};

/// Result of an expression. `value` is empty for a single vacant variable (#0 of Fanuc).
struct Computed {
    std::optional<double> value;
    bool is_incremental = false;  ///< IC(…) of Sinumerik
    bool is_absolute = false;     ///< AC(…)
    std::size_t end = 0;          ///< number of bytes parsed
};

/// The value of the expression that `text` begins with. Brackets [ ] (Sinumerik: ( )), at most 100 deep;
/// + - * / ** MOD DIV, EQ NE GT GE LT LE or == <> > < >= <=, AND OR XOR NOT; SIN COS TAN ASIN ACOS ATAN ATAN2 SQRT SQR
/// POT ABS ROUND FIX FUP LN EXP TRUNC in degrees. Truth is 1 or 0. Throws ExpressionFailure.
Computed compute(std::string_view text, const Variables& variables, Dialect dialect);

/// The number or the name of the variable that `text` begins with (#101, #[#1+2], #<name>, R5), and its end.
struct VariableName {
    long number = -1;
    std::string name;
    std::size_t end = 0;
};
VariableName variableName(std::string_view text, const Variables& variables, Dialect dialect);

}  // namespace lathelier::gcode
