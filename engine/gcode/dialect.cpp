#include "engine/gcode/dialect.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>

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

/// Score of each dialect, and the first line that indicates an unsupported control.
struct Scores {
    std::array<int, 5> of{};  ///< by Dialect
    int fanuc_b = 0;
    int fanuc_c = 0;
    int okuma = 0;
    int heidenhain = 0;
    int mazatrol = 0;
    int fagor = 0;
    std::array<long, 6> line{};  ///< first line with one of the six indications above
};

bool has(std::string_view text, std::string_view part)
{
    return text.find(part) != std::string_view::npos;
}

void addPoints(int& score, int points, Scores& scores, std::size_t which, long line)
{
    score += points;
    if (scores.line[which] == 0) scores.line[which] = line;
}

/// Scores by whole words; also applied to lines that are not plain blocks.
void scoreNames(std::string_view code, long line, Scores& scores)
{
    if (code.empty()) return;
    if (code.starts_with("BEGIN PGM") || code.starts_with("TOOL CALL") || code.starts_with("BLK FORM") ||
        code.starts_with("CYCL DEF") || code.starts_with("END PGM") || has(code, " FMAX") || has(code, "DIN/ISO"))
        addPoints(scores.heidenhain, 10, scores, 3, line);
    if ((code.front() == '$' && code.back() == '%') || has(code, "NLAP") || has(code, "NAT0") || has(code, "NOEX") ||
        has(code, "VZOF") || has(code, "CALL O") || has(code, "G140 ") || has(code, "VLMON"))
        addPoints(scores.okuma, 6, scores, 2, line);
    if (has(code, "MAZATROL") || code.starts_with("UNIT ")) addPoints(scores.mazatrol, 6, scores, 4, line);
    if (code.starts_with("%") && code.size() > 4 && has(code, ",M") && has(code, ",MX"))
        addPoints(scores.fagor, 8, scores, 5, line);
    for (const char* word :
         {"%_N_",   "DIAMON", "DIAMOF", "DIAM90", "LIMS=",    "CR=",      "MSG",       "CYCLE9", "CYCLE8",
          "T=\"",   "GOTOF",  "GOTOB",  "ENDIF",  "ENDWHILE", "DEF REAL", "=IC(",      "=AC(",   "SUPA",
          "STOPRE", "RND=",   "CHF=",   "CHR=",   "G500",     "PROC ",    "WORKPIECE("})
        if (has(code, word)) scores.of[static_cast<std::size_t>(Dialect::Sinumerik)] += 4;
    const bool isOWord = code.size() > 2 && code.front() == 'O' &&
                         (code[1] == '<' || (std::isdigit(static_cast<unsigned char>(code[1])) &&
                                             (has(code, "SUB") || has(code, "CALL") || has(code, "WHILE") ||
                                              has(code, "IF") || has(code, "REPEAT") || has(code, " DO"))));
    if (isOWord || has(code, "#<")) scores.of[static_cast<std::size_t>(Dialect::LinuxCnc)] += 8;
    if (has(code, "GOTO") && has(code, "IF[")) scores.of[static_cast<std::size_t>(Dialect::Fanuc)] += 6;
}

struct Words {
    bool g[200]{};
    bool letter[26]{};
    double value[26]{};
    std::size_t digits[26]{};

    bool hasLetter(char c) const { return letter[c - 'A']; }
    double of(char c) const { return value[c - 'A']; }
};

void scoreFanucB(const Words& words, long line, Scores& scores)
{
    const bool axes = words.hasLetter('X') || words.hasLetter('Z') || words.hasLetter('U') || words.hasLetter('W');
    if (words.g[92] && words.hasLetter('S') && !axes) addPoints(scores.fanuc_b, 3, scores, 0, line);
    if ((words.g[90] || words.g[91]) && (!axes || words.g[0] || words.g[1]))
        addPoints(scores.fanuc_b, 2, scores, 0, line);
    if ((words.g[94] || words.g[95]) && !axes) addPoints(scores.fanuc_b, 1, scores, 0, line);
    if (words.g[95]) addPoints(scores.fanuc_b, 1, scores, 0, line);
    if ((words.g[70] || words.g[71]) && !axes && !words.hasLetter('P') && !words.hasLetter('D'))
        addPoints(scores.fanuc_c, 2, scores, 1, line);
    if ((words.g[20] || words.g[21]) && axes && words.hasLetter('F') && !words.g[0] && !words.g[1])
        addPoints(scores.fanuc_c, 5, scores, 1, line);
}

void scoreWords(const std::vector<LetterNumber>& signs, long line, Scores& scores)
{
    Words words;
    auto& linuxcnc = scores.of[static_cast<std::size_t>(Dialect::LinuxCnc)];
    auto& fanuc = scores.of[static_cast<std::size_t>(Dialect::Fanuc)];
    auto& haas = scores.of[static_cast<std::size_t>(Dialect::Haas)];
    for (const LetterNumber& sign : signs) {
        if (sign.letter == 'G' && sign.value >= 0 && sign.value < 200) {
            const double whole = std::floor(sign.value);
            words.g[static_cast<int>(whole)] = true;
            if (sign.value != whole && (whole == 90 || whole == 91 || whole == 43 || whole == 61 || whole == 92))
                linuxcnc += 4;
        }
        const auto at = static_cast<std::size_t>(sign.letter - 'A');
        words.letter[at] = true;
        words.value[at] = sign.value;
        words.digits[at] = sign.digits;
    }
    const bool axes = words.hasLetter('X') || words.hasLetter('Z');
    if (words.g[7] || words.g[8]) linuxcnc += 5;
    if (words.g[64] && !words.g[96]) linuxcnc += 2;
    if (words.g[33] && words.hasLetter('K')) linuxcnc += 4;
    if (words.g[96] && words.hasLetter('D')) linuxcnc += 5;
    if (words.g[43] || words.g[49]) linuxcnc += 3;
    if (words.hasLetter('T') && words.hasLetter('M') && words.of('M') == 6) linuxcnc += 3;
    if ((words.g[90] || words.g[91]) && !axes) linuxcnc += 2;
    if ((words.g[94] || words.g[95]) && !axes) linuxcnc += 1;
    if (words.hasLetter('T') && words.digits['T' - 'A'] <= 2) linuxcnc += 1;
    if (words.g[76] && words.hasLetter('J') && words.hasLetter('K')) linuxcnc += 5;
    if (words.hasLetter('T') && words.digits['T' - 'A'] >= 3) fanuc += 4;
    if (words.g[50] && words.hasLetter('S')) fanuc += 4;
    if (words.hasLetter('U') || words.hasLetter('W')) fanuc += 3;
    if (words.g[99] && !axes && !words.g[81] && !words.g[83]) fanuc += 2;
    if (words.g[76] && words.hasLetter('Q')) fanuc += 3;
    if (words.g[98] && !axes) fanuc += 1;
    if (words.g[32]) fanuc += 2;
    if (words.hasLetter('M') && (words.of('M') == 98 || words.of('M') == 99) && words.letter['M' - 'A']) fanuc += 3;
    if ((words.g[71] || words.g[72] || words.g[73]) && words.hasLetter('P') && words.hasLetter('Q') &&
        words.hasLetter('D'))
        haas += 6;
    if (words.g[76] && words.hasLetter('D') && words.hasLetter('K') && !words.hasLetter('J')) haas += 6;
    if (words.g[53] && !words.g[28]) haas += 4;
    if (words.g[154] || words.g[187] || words.g[103] || words.g[112] || words.g[199]) haas += 4;
    if (words.hasLetter('M') && (words.of('M') == 97 || words.of('M') == 24)) haas += 2;
    if (words.g[85] && words.hasLetter('N') && !axes && words.hasLetter('D'))
        addPoints(scores.okuma, 3, scores, 2, line);
    if (words.g[13] || words.g[14] || words.g[140] || words.g[141]) addPoints(scores.okuma, 3, scores, 2, line);
    scoreFanucB(words, line, scores);
}

DialectFound decide(const Scores& scores, DialectFound found)
{
    const auto score = [&scores](Dialect dialect) { return scores.of[static_cast<std::size_t>(dialect)]; };
    const int fanuc = score(Dialect::Fanuc);
    const int linuxcnc = score(Dialect::LinuxCnc);
    const int sinumerik = score(Dialect::Sinumerik);
    found.dialect = Dialect::Fanuc;
    if (sinumerik > 0 && sinumerik >= fanuc && sinumerik >= linuxcnc)
        found.dialect = Dialect::Sinumerik;
    else if (linuxcnc > fanuc)
        found.dialect = Dialect::LinuxCnc;
    else if (score(Dialect::Haas) > 3)
        found.dialect = Dialect::Haas;
    const int best = std::max({fanuc, linuxcnc, sinumerik});
    const auto refuse = [&](const char* name, std::size_t which) {
        found.not_read = name;
        found.line = scores.line[which];
    };
    if (scores.heidenhain >= 10)
        refuse("Heidenhain", 3);
    else if (scores.okuma >= 6 || (scores.okuma > 0 && scores.okuma > best))
        refuse("Okuma OSP", 2);
    else if (scores.mazatrol >= 6)
        refuse("Mazatrol", 4);
    else if (scores.fagor >= 8)
        refuse("Fagor", 5);
    else if (found.dialect == Dialect::Fanuc || found.dialect == Dialect::Haas) {
        // The same letters, but G90…G99 and G70 mean something else.
        if (scores.fanuc_c >= 4)
            refuse("Fanuc (G code system C)", 1);
        else if (scores.fanuc_b >= 3)
            refuse("Fanuc (G code system B)", 0);
    }
    return found;
}

}  // namespace

const char* key(Dialect dialect)
{
    return dialectChoices()[static_cast<std::size_t>(dialect)].key.c_str();
}

const std::vector<FieldChoice>& dialectChoices()
{
    static const std::vector<FieldChoice> all{{"auto", LT_TEXT("Engine", "from the program")},
                                              {"fanuc", LT_TEXT("Engine", "Fanuc, system A")},
                                              {"haas", LT_TEXT("Engine", "Haas")},
                                              {"sinumerik", LT_TEXT("Engine", "Sinumerik")},
                                              {"linuxcnc", LT_TEXT("Engine", "LinuxCNC")}};
    return all;
}

DialectFound detectDialect(std::string_view text)
{
    DialectFound found;
    Scores scores;
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
        if (code.empty()) {
            if (whole.find(';') != std::string_view::npos) ++scores.of[static_cast<std::size_t>(Dialect::LinuxCnc)];
            continue;
        }
        // Fanuc programs have no lower case letters and no comments after a semicolon.
        const std::size_t letter = whole.find_first_not_of(" \t");
        const bool isSmall = whole[letter] >= 'a' && whole[letter] <= 'z';
        if (isSmall || (whole.find(';') != std::string_view::npos && whole.find('(') == std::string_view::npos))
            scores.of[static_cast<std::size_t>(Dialect::LinuxCnc)] += 1;
        scoreNames(code, line, scores);
        const bool isHead = code.front() == '%' || (code.front() == 'O' && code.size() > 1 &&
                                                    std::isdigit(static_cast<unsigned char>(code[1])));
        if (isFirst && isHead) found.has_head = true;
        isFirst = false;
        if (code.front() == '%') continue;
        if (letterNumbersOf(code, signs)) {
            ++found.nc_lines;
            for (const LetterNumber& sign : signs)
                found.has_codes = found.has_codes || sign.letter == 'G' || sign.letter == 'M';
            scoreWords(signs, line, scores);
        } else {
            ++found.other_lines;
        }
    }
    return decide(scores, found);
}

}  // namespace lathelier::gcode
