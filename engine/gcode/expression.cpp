#include "engine/gcode/expression.h"

#include <cctype>
#include <charconv>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::gcode {
namespace {

constexpr int deepest = 100;

/// Recursive descent over one expression; a vacant variable is an empty value until it is used.
class Parser {
public:
    Parser(std::string_view text, const Variables& variables)
        : text_(text), variables_(variables), rules_(variables.arithmetic())
    {
    }

    using Number = std::optional<double>;

    Number logical()
    {
        Number left = comparison();
        while (true) {
            if (word("AND"))
                left = combine(left, comparison(), '&');
            else if (word("XOR"))
                left = combine(left, comparison(), '^');
            else if (word("OR"))
                left = combine(left, comparison(), '|');
            else
                return left;
        }
    }

    VariableName variable()
    {
        skip();
        VariableName found;
        if (peek() == '#') {
            ++at_;
            skip();
            if (peek() == '<') {
                const std::size_t close = text_.find('>', at_);
                if (close == std::string_view::npos) fail(LT_TEXT("Engine", "a name without its end"));
                for (const char c : text_.substr(at_ + 1, close - at_ - 1))
                    if (c != ' ' && c != '\t')
                        found.name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
                at_ = close + 1;
            } else {
                const double number = operand().value_or(0);
                if (!(number >= 0 && number < 1e6)) fail(LT_TEXT("Engine", "no number of a variable"));
                found.number = std::lround(number);
            }
        } else {
            const std::size_t from = at_;
            while (at_ < text_.size() &&
                   (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_' || text_[at_] == '$'))
                found.name += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_++])));
            if (found.name.size() > 1 && found.name[0] == 'R' && found.name.size() < 6 &&
                found.name.find_first_not_of("0123456789", 1) == std::string::npos) {
                found.number = std::stol(found.name.substr(1));
                found.name.clear();
            } else if (from == at_) {
                fail(LT_TEXT("Engine", "no variable"));
            }
        }
        found.end = at_;
        return found;
    }

    bool name(const char* expected) { return word(expected); }
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    void skip()
    {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    }
    void take(char c)
    {
        skip();
        if (peek() != c) fail(LT_TEXT("Engine", "a bracket is missing"));
        ++at_;
    }
    std::size_t at() const { return at_; }
    [[noreturn]] void fail(Text reason) const { throw ExpressionFailure{reason, at_}; }

private:
    static double plain(const Number& number) { return number.value_or(0); }

    static Number combine(const Number& a, const Number& b, char with)
    {
        const double x = plain(a), y = plain(b);
        const bool areBits = x == std::floor(x) && y == std::floor(y) && std::abs(x) < 2e9 && std::abs(y) < 2e9;
        if (areBits) {
            const auto m = static_cast<long>(x), n = static_cast<long>(y);
            return static_cast<double>(with == '&' ? (m & n) : with == '|' ? (m | n) : (m ^ n));
        }
        const bool m = x != 0, n = y != 0;
        return (with == '&' ? (m && n) : with == '|' ? (m || n) : (m != n)) ? 1.0 : 0.0;
    }

    Number comparison()
    {
        Number left = sum();
        while (true) {
            if (word("EQ") || sign("=="))
                left = left.has_value() == isGiven(left, sum()) && same_ ? 1.0 : 0.0;
            else if (word("NE") || sign("<>"))
                left = left.has_value() == isGiven(left, sum()) && same_ ? 0.0 : 1.0;
            else if (word("GE") || sign(">="))
                left = plain(left) >= plain(sum()) ? 1.0 : 0.0;
            else if (word("LE") || sign("<="))
                left = plain(left) <= plain(sum()) ? 1.0 : 0.0;
            else if (word("GT") || sign(">"))
                left = plain(left) > plain(sum()) ? 1.0 : 0.0;
            else if (word("LT") || sign("<"))
                left = plain(left) < plain(sum()) ? 1.0 : 0.0;
            else
                return left;
        }
    }

    /// True if the right operand has a value; stores the equality of both in same_.
    bool isGiven(const Number& left, const Number& right)
    {
        same_ = plain(left) == plain(right);
        return right.has_value();
    }

    Number sum()
    {
        Number left = product();
        while (true) {
            if (sign("+"))
                left = plain(left) + plain(product());
            else if (sign("-"))
                left = plain(left) - plain(product());
            else
                return left;
        }
    }

    double divisor()
    {
        const double value = plain(power());
        if (value == 0) fail(LT_TEXT("Engine", "a division by zero"));
        return value;
    }

    Number product()
    {
        Number left = power();
        while (true) {
            skip();
            if (peek() == '*' && text_.substr(at_, 2) != "**") {
                ++at_;
                left = plain(left) * plain(power());
            } else if (sign("/")) {
                left = plain(left) / divisor();
            } else if (word("MOD")) {
                const double by = divisor();
                const double rest = std::fmod(plain(left), by);
                left = rest < 0 && rules_.modulo_is_positive ? rest + std::abs(by) : rest;
            } else if (word("DIV")) {
                left = std::trunc(plain(left) / divisor());
            } else {
                return left;
            }
        }
    }

    Number power()
    {
        Number left = operand();
        while (sign("**")) left = checked(std::pow(plain(left), plain(operand())));
        return left;
    }

    double checked(double value) const
    {
        if (!std::isfinite(value)) fail(LT_TEXT("Engine", "it has no finite value"));
        return value;
    }

    class Depth {
    public:
        explicit Depth(Parser& parser) : parser_(parser)
        {
            if (++parser_.depth_ > deepest) parser_.fail(LT_TEXT("Engine", "brackets nested too deep"));
        }
        ~Depth() { --parser_.depth_; }

    private:
        Parser& parser_;
    };

    Number bracket()
    {
        const char close = peek() == '[' ? ']' : ')';
        ++at_;
        const Number value = logical();
        take(close);
        return value;
    }

    Number operand()
    {
        const Depth depth(*this);
        skip();
        const char c = peek();
        if (c == '-') {
            ++at_;
            return -plain(operand());
        }
        if (c == '+') {
            ++at_;
            return operand();
        }
        if (c == '[' || (c == '(' && rules_.has_parentheses)) return bracket();
        if (std::isdigit(static_cast<unsigned char>(c)) || c == '.') {
            double value = 0;
            std::size_t end = at_;
            while (end < text_.size() && (std::isdigit(static_cast<unsigned char>(text_[end])) || text_[end] == '.'))
                ++end;
            const auto [rest, problem] =
                std::from_chars(text_.data() + at_, text_.data() + end, value, std::chars_format::fixed);
            if (problem != std::errc()) fail(LT_TEXT("Engine", "no number"));
            at_ = static_cast<std::size_t>(rest - text_.data());
            return value;
        }
        if (c == '#') return read(variable());
        if (std::isalpha(static_cast<unsigned char>(c)) || c == '$') return named();
        fail(LT_TEXT("Engine", "a value is missing"));
    }

    Number read(const VariableName& found)
    {
        const bool isNumber = found.number >= 0;
        const auto shown = [&] {
            return isNumber
                       ? std::string(1, rules_.has_named_variables ? 'R' : '#').append(std::to_string(found.number))
                       : found.name;
        };
        if (unknown.empty() && (isNumber ? variables_.isUnknown(found.number) : variables_.isUnknown(found.name)))
            unknown = shown();
        if (isNumber && variables_.isVacant(found.number)) vacant.push_back(shown());
        return isNumber ? variables_.get(found.number) : variables_.get(found.name);
    }

    Number named()
    {
        for (const char* unary :
             {"ASIN", "ACOS", "ATAN2", "ATAN", "SIN", "COS",    "TAN", "SQRT", "SQR", "POT", "ABS", "ROUND",
              "FIX",  "FUP",  "TRUNC", "LN",   "EXP", "EXISTS", "BIN", "BCD",  "NOT", "IC",  "AC",  "DC"}) {
            const std::size_t before = at_;
            if (!word(unary)) continue;
            skip();
            if (std::string_view(unary) == "NOT") return plain(operand()) == 0 ? 1.0 : 0.0;
            if (peek() == '[' || peek() == '(') return function(unary);
            at_ = before;
        }
        if (!rules_.has_named_variables) fail(LT_TEXT("Engine", "an unknown function"));
        if (word("TRUE")) return 1.0;
        if (word("FALSE")) return 0.0;
        return read(variable());
    }

    Number function(std::string_view which)
    {
        const char close = peek() == '[' ? ']' : ')';
        const std::size_t argument = at_ + 1;
        if (which == "EXISTS") {
            ++at_;
            const VariableName found = variable();
            take(close);
            return (found.number >= 0 ? variables_.isSet(found.number) : variables_.isSet(found.name)) ? 1.0 : 0.0;
        }
        ++at_;
        const double x = plain(logical());
        skip();
        if (which == "ATAN2") {
            take(',');
            const double y = plain(logical());
            take(close);
            return std::atan2(x, y) / rad_per_deg;
        }
        if (which == "ATAN" && peek() == ',') {  // ATAN[a,b]
            ++at_;
            const double y = plain(logical());
            take(close);
            return std::atan2(x, y) / rad_per_deg;
        }
        take(close);
        if (which == "ATAN") {
            skip();
            if (peek() != '/' || at_ + 1 >= text_.size() || text_.find_first_of("[(", at_) == std::string_view::npos)
                return std::atan(x) / rad_per_deg;
            ++at_;
            skip();
            if (peek() != '[') fail(LT_TEXT("Engine", "a bracket is missing"));
            return std::atan2(x, plain(bracket())) / rad_per_deg;
        }
        if (which == "IC") is_incremental = true;
        if (which == "AC") is_absolute = true;
        if (which == "SQRT" && x < 0)
            throw ExpressionFailure{LT_TEXT("Engine", "the root of a negative number"), argument};
        return checked(ofOne(which, x));
    }

    static double ofOne(std::string_view which, double x)
    {
        if (which == "SIN") return std::sin(x * rad_per_deg);
        if (which == "COS") return std::cos(x * rad_per_deg);
        if (which == "TAN") return std::tan(x * rad_per_deg);
        if (which == "ASIN") return std::asin(x) / rad_per_deg;
        if (which == "ACOS") return std::acos(x) / rad_per_deg;
        if (which == "SQRT") return std::sqrt(x);
        if (which == "SQR" || which == "POT") return x * x;
        if (which == "ABS") return std::abs(x);
        if (which == "ROUND") return std::round(x);
        if (which == "FIX") return std::floor(x);
        if (which == "FUP") return std::ceil(x);
        if (which == "TRUNC") return std::trunc(x);
        if (which == "LN") return std::log(x);
        if (which == "EXP") return std::exp(x);
        return x;
    }

    bool word(std::string_view expected)
    {
        skip();
        if (text_.size() - at_ < expected.size()) return false;
        for (std::size_t i = 0; i < expected.size(); ++i)
            if (std::toupper(static_cast<unsigned char>(text_[at_ + i])) != expected[i]) return false;
        const char next = at_ + expected.size() < text_.size() ? text_[at_ + expected.size()] : ' ';
        if (std::isalpha(static_cast<unsigned char>(next)) || next == '_' ||
            (rules_.has_named_variables && std::isdigit(static_cast<unsigned char>(next))))
            return false;
        at_ += expected.size();
        return true;
    }

    bool sign(std::string_view expected)
    {
        skip();
        if (text_.substr(at_, expected.size()) != expected) return false;
        if (expected.size() == 1 && (expected == "<" || expected == ">") && !rules_.has_comparison_signs) return false;
        at_ += expected.size();
        return true;
    }

    std::string_view text_;
    const Variables& variables_;
    const Arithmetic& rules_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool same_ = false;

public:
    bool is_incremental = false;
    bool is_absolute = false;
    std::string unknown;
    std::vector<std::string> vacant;
};

}  // namespace

Computed compute(std::string_view text, const Variables& variables)
{
    Parser parser(text, variables);
    Computed result;
    result.value = parser.logical();
    result.is_incremental = parser.is_incremental;
    result.is_absolute = parser.is_absolute;
    result.unknown = std::move(parser.unknown);
    result.vacant = std::move(parser.vacant);
    parser.skip();
    result.end = parser.at();
    return result;
}

VariableName variableName(std::string_view text, const Variables& variables)
{
    return Parser(text, variables).variable();
}

}  // namespace lathelier::gcode
