// The arguments of a cycle that is called by its name, CYCLE97(1.5, , 0, -20): by their place, from 0. Internal to the
// room.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gcode/expression.h"

namespace lathelier::gcode {

class CycleArguments {
public:
    /// `call`: with its name and brackets. Throws ExpressionFailure.
    CycleArguments(std::string_view call, const Variables& variables);

    bool has(std::size_t at) const { return at < values_.size() && values_[at].has_value(); }
    /// 0 where it is left out.
    double number(std::size_t at) const { return has(at) ? *values_[at] : 0; }
    /// A text in quotes, without them; empty: none.
    const std::string& text(std::size_t at) const;
    /// Is one at this place or behind it given and not 0?
    bool hasMore(std::size_t from) const;
    /// A variable to which the program gives no value; empty: none.
    const std::string& unknown() const { return unknown_; }
    /// Is one of these negative?
    bool isNegative(std::initializer_list<std::size_t> places) const;

private:
    std::vector<std::optional<double>> values_;
    std::vector<std::string> texts_;
    std::string unknown_;
};

}  // namespace lathelier::gcode
