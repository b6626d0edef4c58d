#include "engine/gcode/block_scanner.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>

#include "engine/gcode/gcode_codes.h"

namespace lathelier::gcode {
namespace {

bool isAlpha(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}
bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}
bool isNameCharacter(char c)
{
    return isAlpha(c) || isDigit(c) || c == '_' || c == '$';
}
bool isSpace(char c)
{
    return c == ' ' || c == '\t' || c == '\f' || c == '\v' || c == '\0' || c == '\x1A' || c == '\x7F';
}
char capital(char c)
{
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

bool startsWith(std::string_view text, std::string_view word)
{
    if (text.size() < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (capital(text[i]) != word[i]) return false;
    return true;
}

/// Is the text words of a block, letters with numbers, and nothing else?
bool isBlockText(std::string_view text)
{
    std::size_t at = 0;
    const auto skip = [&](std::string_view of) {
        const std::size_t from = at;
        while (at < text.size() && of.find(text[at]) != std::string_view::npos) ++at;
        return at > from;
    };
    bool hasWords = false;
    for (skip(" \t;"); at < text.size() && text[at] != '('; skip(" \t;")) {
        if (!isAlpha(text[at++])) return false;
        skip("+-");
        if (!skip("0123456789.")) return false;
        hasWords = true;
    }
    return hasWords;
}

}  // namespace

BlockScanner::BlockScanner(Program& program)
    : program_(program), text_(program.text), grammar_(program.control->grammar)
{
}

Word& BlockScanner::add(std::size_t from, std::size_t to, WordKind kind, char letter)
{
    Word word;
    word.begin = static_cast<std::uint32_t>(from);
    word.length = static_cast<std::uint32_t>(to - from);
    word.value_begin = word.begin;
    word.kind = kind;
    word.letter = letter;
    program_.words.push_back(word);
    at_ = to;
    return program_.words.back();
}

/// Does the rest of the block read as plain words: several letters in a row, and no number behind them?
bool BlockScanner::isPlainText(std::size_t at) const
{
    constexpr std::ptrdiff_t word = 4;
    const auto begin = text_.begin() + static_cast<std::ptrdiff_t>(at),
               end = text_.begin() + static_cast<std::ptrdiff_t>(end_);
    const auto letters = std::find_if_not(begin, end, isAlpha) - begin;
    return letters >= word || (letters > 1 && std::find_if(begin, end, isDigit) == end);
}

void BlockScanner::fail(const ErrorCode& code, std::size_t at, std::size_t to)
{
    if (&code == &errors::ncNumberMissing && isPlainText(at)) to = endOfCode(at);
    block_->is_malformed = true;
    report(program_, program_.diagnostics, *block_, static_cast<std::uint32_t>(at), code,
           {{"found", shown(program_, std::string_view(text_).substr(at, to - at))}});
    add(at, to, WordKind::Bad).is_understood = false;
}

std::size_t BlockScanner::skipBlanks(std::size_t at) const
{
    while (at < end_ && isSpace(text_[at])) ++at;
    return at;
}

void BlockScanner::scan(Block& block)
{
    block_ = &block;
    block.first_word = static_cast<std::uint32_t>(program_.words.size());
    at_ = block.begin;
    end_ = block.begin + block.length;
    if (at_ == 0 && std::string_view(text_).starts_with("\xEF\xBB\xBF")) at_ = 3;
    at_ = skipBlanks(at_);
    if (at_ < end_ && text_[at_] == '%') {  // ends of the tape, and the name of a Sinumerik program
        add(at_, end_, WordKind::Comment);
        block.word_count = 1;
        return;
    }
    if (at_ < end_ && text_[at_] == '/') {
        block.has_skip = true;
        ++at_;
        if (at_ < end_ && isDigit(text_[at_]) && at_ + 1 < end_ && !isDigit(text_[at_ + 1])) ++at_;
    }
    while ((at_ = skipBlanks(at_)) < end_) scanWord();
    block.word_count = static_cast<std::uint32_t>(program_.words.size()) - block.first_word;
}

void BlockScanner::scanComment()
{
    const std::size_t from = at_;
    if (text_[at_] == ';') {
        const std::string_view behind = std::string_view(text_).substr(from + 1, end_ - from - 1);
        if (grammar_.is_iso_code && program_.words.size() > block_->first_word && isBlockText(behind))
            report(program_, program_.diagnostics, *block_, static_cast<std::uint32_t>(from), notes::ncBlockNotModelled,
                   {{"found", shown(program_, behind)}}, GapEffect::Moves);
        add(from, end_, WordKind::Comment);
        return;
    }
    const std::size_t close = text_.find(')', at_);
    if (close >= end_) {
        fail(errors::ncCommentOpen, from, end_);
        return;
    }
    add(from, close + 1, WordKind::Comment);
}

void BlockScanner::scanWord()
{
    const std::size_t from = at_;
    const char c = text_[from];
    if (c == ';' || (c == '(' && grammar_.has_bracket_comments)) {
        scanComment();
    } else if (c == ':' && grammar_.is_iso_code && block_->first_word == program_.words.size() && from + 1 < end_ &&
               isDigit(text_[from + 1])) {
        scanAddress('O', from + 1);
    } else if (c == '#') {
        scanVariable();
    } else if (isAlpha(c)) {
        const char next = from + 1 < end_ ? text_[from + 1] : ' ';
        if (grammar_.flow == FlowStyle::Labelled) {
            if (scanLabelled(from)) return;
        } else if ((isAlpha(next) || next == '_') && scanStatement(from)) {
            return;
        }
        if (grammar_.has_names && (isAlpha(next) || next == '_' || next == ':')) {
            scanName(from);
        } else if (grammar_.has_names && isDigit(next)) {
            std::size_t to = from + 1;
            while (to < end_ && isDigit(text_[to])) ++to;
            const std::size_t after = skipBlanks(to);
            const bool isExtended =
                after < end_ && text_[after] == '=' && (after + 1 >= end_ || text_[after + 1] != '=');
            const bool isLabel = after < end_ && text_[after] == ':';
            if (isExtended || isLabel)
                scanName(from);
            else
                scanAddress(capital(c), from + 1);
        } else {
            scanAddress(capital(c), from + 1);
        }
    } else if (c == ',' && grammar_.has_comma_words) {
        const std::size_t at = skipBlanks(from + 1);
        if (at < end_ && isAlpha(text_[at])) {
            scanAddress(static_cast<char>(capital(text_[at]) - 'A' + 'a'), at + 1);
            Word& word = program_.words.back();
            word.length += word.begin - static_cast<std::uint32_t>(from);
            word.begin = static_cast<std::uint32_t>(from);
        } else {
            fail(errors::ncCharacter, from, from + 1);
        }
    } else {
        std::size_t to = from + 1;
        while (to < end_ && !isAlpha(text_[to]) && !isSpace(text_[to]) && text_[to] != '(' && text_[to] != '#') ++to;
        fail(errors::ncCharacter, from, to);
    }
}

/// Offset behind one value: a number, a bracket, a variable, a function of a bracket.
std::size_t BlockScanner::afterValue(std::size_t at) const
{
    at = skipBlanks(at);
    while (at < end_ && (text_[at] == '-' || text_[at] == '+')) at = skipBlanks(at + 1);
    while (at < end_ && text_[at] == '#') at = skipBlanks(at + 1);
    if (at < end_ && text_[at] == '<') {
        while (at < end_ && text_[at] != '>') ++at;
        return at < end_ ? at + 1 : at;
    }
    const std::size_t word = at;
    while (at < end_ && isAlpha(text_[at])) ++at;
    if (at != word) at = skipBlanks(at);
    if (at < end_ && text_[at] == '[') {
        int depth = 0;
        for (; at < end_; ++at) {
            if (text_[at] == '[') ++depth;
            if (text_[at] == ']' && --depth == 0) {
                ++at;
                break;
            }
        }
        if (at > word && at < end_ && text_[at] == '/' && text_.compare(word, 4, "ATAN") == 0)
            return afterValue(at + 1);
        return at;
    }
    while (at < end_ && (isDigit(text_[at]) || text_[at] == '.')) ++at;
    return at;
}

/// Behind the value of a name: up to the next blank outside brackets that is not adjacent to an operator.
std::size_t BlockScanner::afterExpression(std::size_t at) const
{
    constexpr std::string_view operators = "+-*/=<>,(";
    int depth = 0;
    at = skipBlanks(at);
    bool inText = false;
    bool wantsOperand = true;
    for (; at < end_; ++at) {
        const char c = text_[at];
        if (c == '"') inText = !inText;
        if (inText) continue;
        if (c == ';') break;
        if (c == '(') ++depth;
        if (c == ')' && --depth < 0) break;
        if (!isSpace(c)) {
            wantsOperand = operators.find(c) != std::string_view::npos;
            continue;
        }
        const std::size_t next = skipBlanks(at);
        if (depth > 0 || wantsOperand) continue;
        if (next >= end_ || std::string_view("+-*/").find(text_[next]) == std::string_view::npos) break;
    }
    while (at > 0 && isSpace(text_[at - 1])) --at;
    return at;
}

std::size_t BlockScanner::endOfCode(std::size_t at) const
{
    while (at < end_ && text_[at] != '(' && text_[at] != ';') ++at;
    while (at > 0 && isSpace(text_[at - 1])) --at;
    return at;
}

void BlockScanner::scanAddress(char letter, std::size_t from)
{
    const std::size_t begin = from - 1;
    std::size_t at = skipBlanks(from);
    if (grammar_.has_names && at < end_ && text_[at] == '=') {
        const std::size_t value = skipBlanks(at + 1);
        const std::size_t to = afterExpression(value);
        if (to <= value) return fail(errors::ncNumberMissing, begin, to > begin ? to : begin + 1);
        Word& word = add(begin, to, WordKind::Expression, letter);
        word.value_begin = static_cast<std::uint32_t>(value);
        const auto [rest, problem] = std::from_chars(text_.data() + value, text_.data() + to, word.value);
        if (problem == std::errc() && rest == text_.data() + to) word.kind = WordKind::Number;
        return;
    }
    const std::size_t value = at;
    const bool hasPlus = at < end_ && text_[at] == '+';
    std::size_t digits = at;
    if (digits < end_ && (text_[digits] == '+' || text_[digits] == '-')) ++digits;
    digits = skipBlanks(digits);
    if (digits < end_ &&
        (isDigit(text_[digits]) || (text_[digits] == '.' && digits + 1 < end_ && isDigit(text_[digits + 1])))) {
        std::size_t to = digits;
        bool hasPoint = false;
        while (to < end_ && (isDigit(text_[to]) || (text_[to] == '.' && !hasPoint))) hasPoint |= text_[to++] == '.';
        double number = 0;
        std::from_chars(text_.data() + digits, text_.data() + to, number);
        Word& word = add(begin, to, WordKind::Number, letter);
        word.value_begin = static_cast<std::uint32_t>(value);
        word.value = digits > value && !hasPlus ? -number : number;
        word.has_point = hasPoint;
        if (at_ < end_ && text_[at_] == '.') {  // 1.2.3
            program_.words.pop_back();
            while (to < end_ && (isDigit(text_[to]) || text_[to] == '.')) ++to;
            fail(errors::ncNumberMissing, begin, to);
        }
        return;
    }
    const bool canCompute = digits < end_ && (text_[digits] == '#' || text_[digits] == '[' || isAlpha(text_[digits]));
    if (grammar_.has_number_sign && canCompute && (!isAlpha(text_[digits]) || grammar_.has_open_functions)) {
        const std::size_t to = afterValue(value);
        const bool isFunction = isAlpha(text_[digits]) && text_.find('[', digits) < to;
        if (!isAlpha(text_[digits]) || isFunction) {
            add(begin, to, WordKind::Expression, letter).value_begin = static_cast<std::uint32_t>(value);
            return;
        }
    }
    fail(errors::ncNumberMissing, begin, begin + 1);
}

void BlockScanner::scanVariable()
{
    const std::size_t from = at_;
    std::size_t at = afterValue(from);
    const std::size_t equals = skipBlanks(at);
    if (!grammar_.has_number_sign || equals >= end_ || text_[equals] != '=')
        return fail(errors::ncCharacter, from, std::max(at, from + 1));
    const std::size_t value = skipBlanks(equals + 1);
    const std::size_t to = grammar_.assigns_many ? afterValue(value) : endOfCode(value);
    if (to <= value) return fail(errors::ncNumberMissing, from, equals + 1);
    add(from, to, WordKind::Assignment, '#').value_begin = static_cast<std::uint32_t>(value);
}

/// o100 while […]: a label and a statement, which takes the rest of the block.
bool BlockScanner::scanLabelled(std::size_t from)
{
    if (capital(text_[from]) != 'O') return false;
    std::size_t at = skipBlanks(from + 1);
    if (at < end_ && text_[at] == '<')
        while (at < end_ && text_[at] != '>') ++at;
    else if (at < end_ && text_[at] == '#')
        at = afterValue(at);
    else
        while (at < end_ && isDigit(text_[at])) ++at;
    if (at < end_ && text_[at] == '>') ++at;
    const std::size_t word = skipBlanks(at);
    if (word >= end_ || !isAlpha(text_[word])) return false;
    add(from, endOfCode(word), WordKind::Flow, 'O').value_begin = static_cast<std::uint32_t>(word);
    return true;
}

/// IF, WHILE, GOTO…: a statement takes the rest of the block.
bool BlockScanner::scanStatement(std::size_t from)
{
    const std::string_view rest = std::string_view(text_).substr(from, end_ - from);
    const auto matches = [&](const std::string& name) {
        if (!startsWith(rest, name)) return false;
        const char next = rest.size() > name.size() ? rest[name.size()] : ' ';
        return grammar_.has_names ? !isNameCharacter(next) : !isAlpha(next);
    };
    if (std::none_of(grammar_.statements.begin(), grammar_.statements.end(), matches)) return false;
    std::size_t to = end_;
    if (grammar_.has_bracket_comments)
        to = endOfCode(from);
    else {
        to = std::min(text_.find(';', from), end_);
        while (to > from && isSpace(text_[to - 1])) --to;
    }
    add(from, to, WordKind::Flow);
    return true;
}

/// NAME, NAME=value, NAME(arguments), NAME:
void BlockScanner::scanName(std::size_t from)
{
    std::size_t at = from;
    while (at < end_ && isNameCharacter(text_[at])) ++at;
    const std::size_t after = skipBlanks(at);
    if (after < end_ && text_[after] == '[') {  // an index, as in $P_UIFR[1,X,TR]=…
        const std::size_t close = text_.find(']', after);
        at = close < end_ ? close + 1 : end_;
    }
    const std::size_t sign = skipBlanks(at);
    if (sign < end_ && text_[sign] == '=') {
        const std::size_t value = skipBlanks(sign + 1);
        const std::size_t to = afterExpression(value);
        if (to <= value) return fail(errors::ncNumberMissing, from, sign + 1);
        const bool isVariable = capital(text_[from]) == 'R' && at > from + 1 && isDigit(text_[from + 1]);
        Word& word =
            add(from, to, isVariable ? WordKind::Assignment : WordKind::Expression, isVariable ? 'R' : char{0});
        word.value_begin = static_cast<std::uint32_t>(value);
    } else if (sign < end_ && text_[sign] == '(') {
        add(from, std::max(afterExpression(sign), sign + 1), WordKind::Call).value_begin =
            static_cast<std::uint32_t>(sign);
    } else if (sign < end_ && text_[sign] == '"') {  // CALL "NAME"
        const std::size_t close = text_.find('"', sign + 1);
        add(from, close < end_ ? close + 1 : end_, WordKind::Call).value_begin = static_cast<std::uint32_t>(sign);
    } else if (sign < end_ && text_[sign] == ':') {
        add(from, sign + 1, WordKind::Name);
    } else {
        add(from, at, WordKind::Name);
    }
}

}  // namespace lathelier::gcode
