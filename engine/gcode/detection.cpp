#include "engine/gcode/detection.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "engine/gcode/controls/controls.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::gcode {
namespace {

constexpr long mostLines = 2000;

/// A letter with its number, parsed without the full grammar.
struct LetterNumber {
    char letter = 0;
    double value = 0;
    std::size_t digits = 0;  ///< before the point
};

/// The text of a line in capitals without comments in brackets.
std::string codeOf(std::string_view line)
{
    std::string code;
    int depth = 0;
    for (const char c : line) {
        if (c == ';' && depth == 0) break;
        if (c == '(') ++depth;
        if (depth == 0) code += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        if (c == ')' && depth > 0) --depth;
    }
    return std::string(io::trimmed(code));
}

bool isNumberPart(char c)
{
    return std::isdigit(static_cast<unsigned char>(c)) || c == '.' || c == '+' || c == '-';
}

/// Parses the words of a block; false if the line is not a block.
bool letterNumbersOf(std::string_view code, std::vector<LetterNumber>& signs)
{
    signs.clear();
    for (std::size_t i = 0; i < code.size();) {
        const char c = code[i];
        if (io::isBlank(c) || c == ',' || c == '/') {
            ++i;
            continue;
        }
        if (c == '#' || c == '[') return !signs.empty() || c == '#';
        if (!std::isalpha(static_cast<unsigned char>(c))) return false;
        LetterNumber sign{c, 0, 0};
        ++i;
        while (i < code.size() && code[i] == ' ') ++i;
        if (i < code.size() && (code[i] == '#' || code[i] == '[' || code[i] == '=')) {
            signs.push_back(sign);
            while (i < code.size() && code[i] != ' ') ++i;
            continue;
        }
        const std::size_t from = i;
        while (i < code.size() && isNumberPart(code[i])) ++i;
        if (i == from) return false;
        const std::string number(code.substr(from, i - from));
        sign.value = std::strtod(number.c_str(), nullptr);
        sign.digits = number.find_first_not_of("0123456789");
        if (sign.digits == std::string::npos) sign.digits = number.size();
        signs.push_back(sign);
    }
    return !signs.empty();
}

bool isPart(std::string_view text, std::string_view part)
{
    for (std::size_t i = 0; i < part.size(); ++i)
        if (part[i] == '?' ? !std::isdigit(static_cast<unsigned char>(text[i])) : text[i] != part[i]) return false;
    return true;
}

/// Place of a part without * in a text; npos: nowhere.
std::size_t findPart(std::string_view text, std::string_view part)
{
    if (part.find('?') == std::string_view::npos) return text.find(part);
    for (std::size_t at = 0; at + part.size() <= text.size(); ++at)
        if (isPart(text.substr(at), part)) return at;
    return std::string_view::npos;
}

/// Does the whole text match a pattern of TextSign?
bool matchesPattern(std::string_view text, std::string_view pattern)
{
    std::size_t star = pattern.find('*');
    if (star == std::string_view::npos) return text.size() == pattern.size() && isPart(text, pattern);
    if (text.size() < star || !isPart(text, pattern.substr(0, star))) return false;
    text.remove_prefix(star);
    while (true) {
        pattern.remove_prefix(star + 1);
        star = pattern.find('*');
        const std::string_view part = pattern.substr(0, star);
        if (star == std::string_view::npos)
            return text.size() >= part.size() && isPart(text.substr(text.size() - part.size()), part);
        const std::size_t at = findPart(text, part);
        if (at == std::string_view::npos) return false;
        text.remove_prefix(at + part.size());
    }
}

/// The words of a block as the conditions of BlockSign ask for them.
class BlockFacts {
public:
    explicit BlockFacts(const std::vector<LetterNumber>& signs) : signs_(signs)
    {
        for (const LetterNumber& sign : signs) {
            if (sign.letter == 'G' && sign.value >= 0 && sign.value < 200)
                g_[static_cast<std::size_t>(sign.value)] = true;
            letters_[static_cast<std::size_t>(sign.letter - 'A')] = true;
            if (sign.letter == 'M') m_ = sign.value;
            if (sign.letter == 'T') toolDigits_ = sign.digits;
        }
    }

    bool holds(const BlockSign& sign) const
    {
        const auto hasLetter = [this](char letter) { return letters_[static_cast<std::size_t>(letter - 'A')]; };
        const auto any = [&](const std::string& of) { return std::any_of(of.begin(), of.end(), hasLetter); };
        const bool hasLetters = std::all_of(sign.letters.begin(), sign.letters.end(), hasLetter) &&
                                (sign.one_of.empty() || any(sign.one_of)) && !any(sign.none_of);
        if (!hasLetters || hasAnyG(sign.no_g)) return false;
        if ((!sign.g.empty() && !hasAnyG(sign.g)) || (!sign.also_g.empty() && !hasAnyG(sign.also_g))) return false;
        if (!sign.exact.empty() && !hasExactG(sign.exact)) return false;
        const auto isLastM = [this](int m) { return m_ == m; };
        if (!sign.m.empty() && std::none_of(sign.m.begin(), sign.m.end(), isLastM)) return false;
        if (sign.least_digits > 0 && !(toolDigits_ >= sign.least_digits)) return false;
        return sign.most_digits == 0 || toolDigits_ <= sign.most_digits;
    }

private:
    bool hasAnyG(const std::vector<int>& codes) const
    {
        return std::any_of(codes.begin(), codes.end(), [this](int code) { return g_[static_cast<std::size_t>(code)]; });
    }
    bool hasExactG(const std::vector<double>& codes) const
    {
        return std::any_of(signs_.begin(), signs_.end(), [&codes](const LetterNumber& sign) {
            return sign.letter == 'G' && std::find(codes.begin(), codes.end(), sign.value) != codes.end();
        });
    }

    const std::vector<LetterNumber>& signs_;
    std::array<bool, 200> g_{};
    std::array<bool, 26> letters_{};
    std::optional<double> m_;
    std::size_t toolDigits_ = 0;
};

/// Points of one control.
struct ControlScore {
    ControlPtr control;
    int points = 0;
    long line = 0;  ///< first one with points

    const Evidence& evidence() const { return control->evidence; }
    bool isCertain() const { return evidence().certain > 0 && points >= evidence().certain; }
    void add(int more, long at)
    {
        if (more > 0 && line == 0) line = at;
        points += more;
    }
};

using ControlScores = std::vector<ControlScore>;

ControlScore& bestScore(ControlScores& scores)
{
    for (ControlScore& score : scores)
        if (score.isCertain() && score.evidence().variant_of.empty()) return score;
    ControlScore* best = &scores.front();
    for (ControlScore& score : scores) {
        if (!score.evidence().variant_of.empty() || score.points == 0) continue;
        const int more = score.points - best->points;
        if (more > 0 || (more == 0 && score.evidence().rank > best->evidence().rank)) best = &score;
    }
    ControlScore* variant = nullptr;
    for (ControlScore& score : scores) {
        if (score.evidence().variant_of != best->control->key || !score.isCertain()) continue;
        if (!variant || score.evidence().rank > variant->evidence().rank) variant = &score;
    }
    return variant ? *variant : *best;
}

void scoreTexts(std::string_view code, long line, ControlScores& scores)
{
    for (ControlScore& score : scores)
        for (const TextSign& sign : score.evidence().texts) {
            const auto matches = [code](const std::string& pattern) { return matchesPattern(code, pattern); };
            if (std::any_of(sign.lines.begin(), sign.lines.end(), matches)) score.add(sign.points, line);
        }
}

void scoreBlock(const std::vector<LetterNumber>& signs, long line, ControlScores& scores)
{
    const BlockFacts block(signs);
    for (ControlScore& score : scores)
        for (const BlockSign& sign : score.evidence().blocks)
            if (block.holds(sign)) score.add(sign.points, line);
}

}  // namespace

ControlFound detectControl(std::string_view text)
{
    ControlFound found;
    ControlScores scores;
    for (const ControlPtr& control : allControls()) scores.push_back({control});
    const auto scoreCasual = [&scores](long line) {
        for (ControlScore& score : scores) score.add(score.evidence().casual_line, line);
    };
    std::vector<LetterNumber> signs;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    bool isFirst = true;
    std::size_t at = 0;
    for (long line = 1; at < text.size() && line <= mostLines; ++line) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        const std::string_view whole = text.substr(at, std::min<std::size_t>(end - at, 4096));
        at = end < text.size() && text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n' ? end + 2
                                                                                                      : end + 1;
        const std::string code = codeOf(whole);
        const bool hasSemicolon = whole.find(';') != std::string_view::npos;
        if (code.empty()) {
            if (hasSemicolon) scoreCasual(line);
            continue;
        }
        const std::size_t letter = whole.find_first_not_of(" \t");
        const bool isSmall = whole[letter] >= 'a' && whole[letter] <= 'z';
        if (isSmall || (hasSemicolon && whole.find('(') == std::string_view::npos)) scoreCasual(line);
        scoreTexts(code, line, scores);
        const bool isHead = code.front() == '%' || (code.front() == 'O' && code.size() > 1 &&
                                                    std::isdigit(static_cast<unsigned char>(code[1])));
        if (isFirst && isHead) found.has_head = true;
        isFirst = false;
        if (code.front() == '%') continue;
        if (letterNumbersOf(code, signs)) {
            ++found.nc_lines;
            for (const LetterNumber& sign : signs)
                found.has_codes = found.has_codes || sign.letter == 'G' || sign.letter == 'M';
            scoreBlock(signs, line, scores);
        } else {
            ++found.other_lines;
        }
    }
    const ControlScore& best = bestScore(scores);
    found.control = best.control;
    found.line = best.line;
    return found;
}

}  // namespace lathelier::gcode
