#include "engine/gcode/detection.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>

#include "engine/gcode/controls/controls.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::gcode {
namespace {

constexpr long mostLines = 2000;

/// A letter with its number, parsed without the full grammar.
struct LetterNumber {
    char letter = 0;  ///< small in a comma word
    double value = 0;
    std::size_t digits = 0;  ///< before the point
};

/// A line in capitals.
struct Line {
    std::string code;                  ///< without comments
    std::vector<std::string> remarks;  ///< what stands between brackets
};

Line lineOf(std::string_view text)
{
    Line line;
    std::string remark;
    int depth = 0;
    for (const char c : text) {
        if (c == ';' && depth == 0) break;
        if (c == '(' && depth++ == 0) continue;
        if (c == ')' && depth > 0 && --depth == 0) {
            line.remarks.emplace_back(io::trimmed(remark));
            remark.clear();
            continue;
        }
        (depth == 0 ? line.code : remark) += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    line.code = std::string(io::trimmed(line.code));
    return line;
}

bool isNumberPart(char c)
{
    return std::isdigit(static_cast<unsigned char>(c)) || c == '.' || c == '+' || c == '-';
}

/// Parses the words of a block; false if the line is not a block.
bool letterNumbersOf(std::string_view code, std::vector<LetterNumber>& signs)
{
    signs.clear();
    bool isBehindComma = false;
    for (std::size_t i = 0; i < code.size();) {
        char c = code[i];
        if (io::isBlank(c) || c == ',' || c == '/') {
            isBehindComma = c == ',' || (isBehindComma && c != '/');
            ++i;
            continue;
        }
        if (c == '#' || c == '[') return !signs.empty() || c == '#';
        if (c == ':' && i == 0) c = 'O';  // of ISO code
        if (!std::isalpha(static_cast<unsigned char>(c))) return false;
        LetterNumber sign{isBehindComma ? static_cast<char>(c - 'A' + 'a') : c, 0, 0};
        isBehindComma = false;
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
            letters_[slotOf(sign.letter)] = true;
            if (sign.letter == 'M') m_ = sign.value;
            if (sign.letter == 'T') toolDigits_ = sign.digits;
        }
    }

    bool has(char letter) const { return letters_[slotOf(letter)]; }

    bool holds(const BlockSign& sign) const
    {
        const auto hasLetter = [this](char letter) { return has(letter); };
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
    static std::size_t slotOf(char letter)
    {
        return static_cast<std::size_t>(letter >= 'a' ? letter - 'a' + 26 : letter - 'A');
    }
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
    std::array<bool, 52> letters_{};
    std::optional<double> m_;
    std::size_t toolDigits_ = 0;
};

/// Points of one control.
struct ControlScore {
    ControlPtr control;
    int points = 0;
    long line = 0;                           ///< first one with points
    std::map<const void*, long> shown = {};  ///< signs that the program shows, with their first lines

    const Evidence& evidence() const { return control->evidence; }
    bool isBase() const { return evidence().variant_of.empty(); }
    bool isCertain() const { return evidence().certain > 0 && points >= evidence().certain; }

    template <class Sign, class Condition>
    void look(const std::vector<Sign>& signs, long at, const Condition& holds)
    {
        for (const Sign& sign : signs)
            if (!shown.contains(&sign) && holds(sign)) add(sign, at);
    }

    template <class Sign>
    void add(const Sign& sign, long at)
    {
        shown.emplace(&sign, at);
        if (sign.points > 0 && line == 0) line = at;
        points += sign.points;
    }
};

using ControlScores = std::vector<ControlScore>;

auto matchesAny(std::string_view text)
{
    return [text](const TextSign& sign) {
        return std::any_of(sign.lines.begin(), sign.lines.end(),
                           [text](const std::string& pattern) { return matchesPattern(text, pattern); });
    };
}

void scoreLine(const Line& text, long line, ControlScores& scores)
{
    for (ControlScore& score : scores) {
        score.look(score.evidence().texts, line, matchesAny(text.code));
        for (const std::string& remark : text.remarks) score.look(score.evidence().remarks, line, matchesAny(remark));
    }
}

void scoreBlock(const BlockFacts& block, long line, ControlScores& scores)
{
    for (ControlScore& score : scores) {
        score.look(score.evidence().blocks, line, [&block](const BlockSign& sign) { return block.holds(sign); });
        for (const ProgramSign& program : score.evidence().programs)
            for (const BlockSign& sign : program.blocks)
                if (!score.shown.contains(&sign) && block.holds(sign)) score.shown.emplace(&sign, line);
    }
}

/// The signs that the whole program shows.
void scoreProgram(std::string_view name, ControlScores& scores)
{
    std::string capitals(name);
    for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    for (ControlScore& score : scores) {
        for (const ProgramSign& sign : score.evidence().programs) {
            long last = 0;
            const bool isWhole = std::all_of(sign.blocks.begin(), sign.blocks.end(), [&](const BlockSign& block) {
                const auto found = score.shown.find(&block);
                if (found != score.shown.end()) last = std::max(last, found->second);
                return found != score.shown.end();
            });
            if (isWhole) score.add(sign, last);
        }
        score.look(score.evidence().names, 0, matchesAny(capitals));
    }
}

/// Points of a control with those of its variants that speak for it.
int pointsOf(const ControlScore& base, const ControlScores& scores)
{
    if (base.points <= 0) return base.points;
    int most = 0;
    for (const ControlScore& score : scores)
        if (score.evidence().speaks_for_base && score.evidence().variant_of == base.control->key)
            most = std::max(most, score.points);
    return base.points + most;
}

/// The variant that is told, or the control itself.
const ControlScore& variantOf(const ControlScore& base, const ControlScores& scores)
{
    const ControlScore* best = nullptr;
    for (const ControlScore& score : scores) {
        if (score.evidence().variant_of != base.control->key || !score.isCertain()) continue;
        const int more = best ? score.points - best->points : 1;
        if (more > 0 || (more == 0 && score.evidence().rank > best->evidence().rank)) best = &score;
    }
    return best ? *best : base;
}

void choose(const ControlScores& scores, ControlFound& found)
{
    const ControlScore* best = nullptr;
    const ControlScore* rival = nullptr;
    for (const ControlScore& score : scores) {
        if (!score.isBase() || !score.isCertain()) continue;
        best = &score;
        break;
    }
    const bool isCertain = best != nullptr;
    for (const ControlScore& score : scores) {
        if (isCertain || !score.isBase() || score.points <= 0) continue;
        const int more = best ? pointsOf(score, scores) - pointsOf(*best, scores) : 1;
        if (more < 0) continue;
        const bool isBetter = more > 0 || score.evidence().rank > best->evidence().rank;
        rival = more > 0 ? nullptr : isBetter ? best : &score;
        if (isBetter) best = &score;
    }
    const ControlScore& told = variantOf(best ? *best : scores.front(), scores);
    found.control = told.control;
    found.line = told.line;
    if (!rival) return;
    const ControlScore& other = variantOf(*rival, scores);
    if (told.control->is_read && other.control->is_read) found.rival = other.control;
}

}  // namespace

ControlFound detectControl(std::string_view text, std::string_view name)
{
    ControlFound found;
    ControlScores scores;
    for (const ControlPtr& control : allControls()) scores.push_back({control});
    std::vector<LetterNumber> signs;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    bool isFirst = true;
    std::size_t at = 0;
    for (long line = 1; at < text.size() && line <= mostLines; ++line) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        const Line whole = lineOf(text.substr(at, std::min<std::size_t>(end - at, 4096)));
        const std::string& code = whole.code;
        at = end < text.size() && text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n' ? end + 2
                                                                                                      : end + 1;
        scoreLine(whole, line, scores);
        if (code.empty()) continue;
        const bool isNumber = (code.front() == 'O' || code.front() == ':') && code.size() > 1 &&
                              std::isdigit(static_cast<unsigned char>(code[1]));
        if (isFirst && (isNumber || code.front() == '%')) found.has_head = true;
        isFirst = false;
        if (code.front() == '%') continue;
        if (letterNumbersOf(code, signs)) {
            ++found.nc_lines;
            for (const LetterNumber& sign : signs)
                found.has_codes = found.has_codes || sign.letter == 'G' || sign.letter == 'M';
            const BlockFacts block(signs);
            for (const char letter : {'X', 'Z', 'U', 'W'}) found.has_axes = found.has_axes || block.has(letter);
            scoreBlock(block, line, scores);
        } else {
            ++found.other_lines;
        }
    }
    scoreProgram(name, scores);
    choose(scores, found);
    return found;
}

}  // namespace lathelier::gcode
