#include "engine/gcode/expression.h"

namespace lathelier::gcode {

bool Variables::isLocal(long number) const
{
    return number >= 1 && number <= arithmetic_.last_local;
}

std::optional<double> Variables::get(long number) const
{
    const auto& where = isLocal(number) ? calls_.back().numbers : numbers_;
    const auto found = where.find(number);
    if (found != where.end()) return found->second;
    return std::nullopt;
}

std::optional<double> Variables::get(const std::string& name) const
{
    const auto& where = name.starts_with('_') ? names_ : calls_.back().names;
    const auto found = where.find(name);
    if (found != where.end()) return found->second;
    return std::nullopt;
}

void Variables::set(long number, std::optional<double> value)
{
    if (number == 0) return;
    auto& where = isLocal(number) ? calls_.back().numbers : numbers_;
    if (value)
        where[number] = *value;
    else
        where.erase(number);
}

void Variables::set(const std::string& name, double value)
{
    (name.starts_with('_') ? names_ : calls_.back().names)[name] = value;
}

void Variables::enter(std::unordered_map<long, double> arguments)
{
    calls_.emplace_back();
    calls_.back().numbers = std::move(arguments);
}

void Variables::leave()
{
    if (calls_.size() > 1) calls_.pop_back();
}

}  // namespace lathelier::gcode
