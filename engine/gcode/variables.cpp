#include <cmath>

#include "engine/gcode/expression.h"

namespace lathelier::gcode {

bool Variables::isLocal(long number) const
{
    return number >= 1 && number <= arithmetic_.last_local;
}

std::optional<double> Variables::get(long number) const
{
    if (const auto found = arithmetic_.position_numbers.find(number); found != arithmetic_.position_numbers.end()) {
        const double value = positionOf(found->second);
        return std::isnan(value) ? std::nullopt : std::optional<double>(value);
    }
    const auto& where = isLocal(number) ? calls_.back().numbers : numbers_;
    const auto found = where.find(number);
    if (found != where.end()) return std::isnan(found->second) ? std::nullopt : std::optional<double>(found->second);
    return number > 0 && number <= arithmetic_.last_zero ? std::optional<double>(0) : std::nullopt;
}

std::optional<double> Variables::get(const std::string& name) const
{
    if (const auto found = arithmetic_.position_names.find(name); found != arithmetic_.position_names.end()) {
        const double value = positionOf(found->second);
        return std::isnan(value) ? std::nullopt : std::optional<double>(value);
    }
    const auto& where = name.starts_with('_') ? names_ : calls_.back().names;
    const auto found = where.find(name);
    if (found != where.end() && !std::isnan(found->second)) return found->second;
    return std::nullopt;
}

bool Variables::isSet(long number) const
{
    if (arithmetic_.position_numbers.contains(number)) return true;
    return (isLocal(number) ? calls_.back().numbers : numbers_).contains(number);
}

bool Variables::isSet(const std::string& name) const
{
    if (arithmetic_.position_names.contains(name)) return true;
    return (name.starts_with('_') ? names_ : calls_.back().names).contains(name);
}

bool Variables::isVacant(long number) const
{
    const bool is_of_program = !isLocal(number) || calls_.size() == 1;  // no argument that a call leaves out
    return number > 0 && number <= arithmetic_.last_zero && is_of_program && !isSet(number);
}

bool Variables::isUnknown(long number) const
{
    if (number == 0 || get(number)) return false;
    return isSet(number) || number > arithmetic_.last_vacant;
}

bool Variables::isUnknown(const std::string& name) const
{
    return !get(name);
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

void Variables::setUnknown(long number)
{
    set(number, notANumber);
}

void Variables::setUnknown(const std::string& name)
{
    set(name, notANumber);
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
