#include "engine/cad/part21.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/cad/cad_codes.h"
#include "engine/io/io_codes.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/number.h"
#include "engine/io/text/readable_text.h"

namespace lathelier::cad {
namespace {

constexpr int deepestList = 16;
constexpr int longestChain = 200;
constexpr double largestNumber = 1e100;
constexpr double largestLength = 1e9;  ///< of points, vectors, radii, in any unit
constexpr std::int64_t largestInteger = 1000000000;
/// Counts, degrees and multiplicities of splines: larger values would cause excessive memory allocation.
constexpr std::int64_t largestSplineInteger = 100000;
constexpr std::size_t mostRecords = 2000000;
constexpr int recordsBetweenChecks = 4096;

bool isLetter(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {}

    std::size_t at() const { return at_; }
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    bool ended() const { return at_ >= text_.size(); }

    /// Skips blanks and comments.
    void skip()
    {
        while (!ended()) {
            const char c = peek();
            if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
                ++at_;
            } else if (text_.substr(at_, 2) == "/*") {
                const std::size_t end = text_.find("*/", at_ + 2);
                if (end == std::string_view::npos) refuse(at_, LT_TEXT("Engine", "the end of a comment, “*/”"));
                at_ = end + 2;
            } else {
                return;
            }
        }
    }

    bool take(char wanted)
    {
        skip();
        if (peek() != wanted || ended()) return false;
        ++at_;
        return true;
    }

    void expect(char wanted, Text name)
    {
        if (!take(wanted)) refuse(at_, name);
    }

    std::string_view word()
    {
        skip();
        const std::size_t begin = at_;
        if (peek() == '!') ++at_;
        while (!ended() && (isLetter(peek()) || isDigit(peek()) || peek() == '-')) ++at_;
        return text_.substr(begin, at_ - begin);
    }

    /// Record number: the digits after "#".
    std::int64_t number()
    {
        const std::size_t begin = at_;
        std::int64_t value = 0;
        while (!ended() && isDigit(peek()) && value <= largestInteger) value = value * 10 + (text_[at_++] - '0');
        if (at_ == begin || value > largestInteger || value == 0)
            refuse(begin, LT_TEXT("Engine", "the number of a record from 1 to 1000000000"));
        return value;
    }

    void string()
    {
        const std::size_t begin = at_++;
        for (;;) {
            const std::size_t quote = text_.find('\'', at_);
            if (quote == std::string_view::npos || quote - begin > (std::size_t{1} << 20))
                refuse(begin, LT_TEXT("Engine", "the end of a text, a single quote"));
            at_ = quote + 1;
            if (peek() != '\'') return;
            ++at_;
        }
    }

    void advance() { ++at_; }
    void moveTo(std::size_t at) { at_ = at; }
    std::string_view text() const { return text_; }

    std::int64_t lineAt(std::size_t at) const
    {
        return 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    }

    [[noreturn]] void refuse(std::size_t at, Text expected) const
    {
        at = std::min(at, text_.size());
        const std::size_t before = at == 0 ? std::string_view::npos : text_.rfind('\n', at - 1);
        const std::size_t line = before == std::string_view::npos ? 0 : before + 1;
        Value found = LT_TEXT("Engine", "the end of the file");
        if (at < text_.size()) found = io::excerpt(text_.substr(at, std::min(text_.find('\n', at), at + 40) - at));
        throw Error(errors::malformed,
                    {{"line", lineAt(at)},
                     {"column",
                      io::columnAt(text_.substr(line, std::min(text_.find('\n', at), text_.size()) - line), at - line)},
                     {"found", found},
                     {"expected", expected}});
    }

private:
    std::string_view text_;
    std::size_t at_ = 0;
};

struct Reference {
    std::int64_t from = 0, to = 0;
    std::size_t at = 0;
};

class Checker {
public:
    Checker(std::string_view text, const Progress& progress) : scanner_(text), progress_(progress) {}

    Part21 check()
    {
        if (scanner_.word() != "ISO-10303-21" || !scanner_.take(';'))
            io::throwUnknownFormat(LT_TEXT("Engine", "another beginning"),
                                   LT_TEXT("Engine", "a STEP file, which begins with “ISO-10303-21;”"));
        header();
        section();
        checkReferences();
        return std::move(result_);
    }

private:
    void semicolon() { scanner_.expect(';', LT_TEXT("Engine", "a semicolon")); }

    void keyword(std::string_view wanted, Text name)
    {
        scanner_.skip();
        const std::size_t at = scanner_.at();
        if (scanner_.word() != wanted) scanner_.refuse(at, name);
    }

    void header()
    {
        keyword("HEADER", LT_TEXT("Engine", "HEADER"));
        semicolon();
        for (int entries = 0;; ++entries) {
            scanner_.skip();
            const std::size_t at = scanner_.at();
            const std::string_view word = scanner_.word();
            if (word == "ENDSEC") break;
            if (word.empty() || entries > 100)
                scanner_.refuse(at, LT_TEXT("Engine", "an entry of the header or ENDSEC"));
            parameters(0, false);
            semicolon();
        }
        semicolon();
    }

    void section()
    {
        keyword("DATA", LT_TEXT("Engine", "DATA"));
        if (scanner_.take('(')) {
            scanner_.moveTo(scanner_.at() - 1);
            parameters(0, false);
        }
        semicolon();
        while (scanner_.take('#')) record();
        keyword("ENDSEC", LT_TEXT("Engine", "a record, “#…”, or ENDSEC"));
        semicolon();
        keyword("END-ISO-10303-21", LT_TEXT("Engine", "END-ISO-10303-21 after one section of data"));
        semicolon();
        scanner_.skip();
    }

    void record()
    {
        const std::size_t begin = scanner_.at() - 1;
        const std::int64_t number = scanner_.number();
        line_ += std::count(scanner_.text().begin() + static_cast<std::ptrdiff_t>(counted_),
                            scanner_.text().begin() + static_cast<std::ptrdiff_t>(begin), '\n');
        counted_ = begin;
        if (!result_.line_of_record.emplace(number, line_).second)
            scanner_.refuse(begin, LT_TEXT("Engine", "each number of a record once"));
        if (result_.line_of_record.size() > mostRecords) tooMany("records", mostRecords + 1, mostRecords);
        if (result_.line_of_record.size() % recordsBetweenChecks == 0) progress_.check();
        scanner_.expect('=', LT_TEXT("Engine", "“=” after the number of a record"));
        if (scanner_.take('(')) {  // a record of several kinds
            int kinds = 0;
            while (!scanner_.take(')')) {
                oneKind(number);
                if (++kinds > 32) scanner_.refuse(scanner_.at(), LT_TEXT("Engine", "at most 32 kinds in one record"));
            }
            if (kinds == 0) scanner_.refuse(scanner_.at() - 1, LT_TEXT("Engine", "the kind of a record"));
        } else {
            oneKind(number);
        }
        semicolon();
    }

    void oneKind(std::int64_t number)
    {
        scanner_.skip();
        const std::size_t at = scanner_.at();
        const std::string_view kind = scanner_.word();
        if (kind.empty() || kind.size() > 100) scanner_.refuse(at, LT_TEXT("Engine", "the kind of a record"));
        ++result_.count_of_kind[std::string(kind)];
        geometry_ = kind == "CARTESIAN_POINT" || kind == "VECTOR" || kind == "CIRCLE" || kind == "ELLIPSE" ||
                    kind.ends_with("_SURFACE");
        parameters(number,
                   kind.find("SPLINE") != std::string_view::npos || kind.find("BEZIER") != std::string_view::npos);
    }

    void parameters(std::int64_t owner, bool spline)
    {
        scanner_.expect('(', LT_TEXT("Engine", "“(”"));
        int depth = 1;
        bool value_due = false;  // after a comma
        bool value_read = false;
        while (depth > 0) {
            scanner_.skip();
            const char c = scanner_.peek();
            if (c == ')' && !value_due) {
                scanner_.advance();
                --depth;
                value_read = true;
            } else if (c == ',' && value_read) {
                scanner_.advance();
                value_read = false;
                value_due = true;
            } else if (!value_read) {
                value_due = false;
                if (c == '(') {
                    scanner_.advance();
                    if (++depth > deepestList)
                        scanner_.refuse(scanner_.at() - 1, LT_TEXT("Engine", "lists no deeper than 16"));
                } else {
                    value_read = value(owner, spline);
                }
            } else {
                scanner_.refuse(scanner_.at(), LT_TEXT("Engine", "a comma or “)”"));
            }
        }
    }

    /// A value that is not a list; false for the name of a typed value, whose list follows.
    bool value(std::int64_t owner, bool spline)
    {
        const std::size_t at = scanner_.at();
        const char c = scanner_.peek();
        if (scanner_.ended()) scanner_.refuse(at, LT_TEXT("Engine", "a value"));
        if (c == '\'') {
            scanner_.string();
        } else if (c == '#') {
            scanner_.advance();
            const std::int64_t to = scanner_.number();
            if (owner != 0) references_.push_back({owner, to, at});
        } else if (c == '$' || c == '*') {
            scanner_.advance();
        } else if (c == '.' || c == '"') {
            scanner_.advance();
            while (isLetter(scanner_.peek()) || isDigit(scanner_.peek())) scanner_.advance();
            if (scanner_.peek() != c) scanner_.refuse(at, LT_TEXT("Engine", "a value"));
            scanner_.advance();
        } else if (isDigit(c) || c == '-' || c == '+') {
            numberValue(spline);
        } else if (isLetter(c)) {
            scanner_.word();
            scanner_.skip();
            if (scanner_.peek() != '(') scanner_.refuse(at, LT_TEXT("Engine", "a value"));
            return false;
        } else {
            scanner_.refuse(at, LT_TEXT("Engine", "a value"));
        }
        return true;
    }

    void numberValue(bool spline)
    {
        const std::size_t at = scanner_.at();
        const char* const begin = scanner_.text().data() + at;
        double value = 0;
        const char* const end = io::parseNumber(begin, scanner_.text().data() + scanner_.text().size(), '.', value);
        if (end == nullptr) scanner_.refuse(at, LT_TEXT("Engine", "a number"));
        const std::string_view written(begin, static_cast<std::size_t>(end - begin));
        const bool integer = written.find_first_of(".eEdD") == std::string_view::npos;
        const double largest_real = geometry_ ? largestLength : largestNumber;
        const double largest =
            integer ? static_cast<double>(spline ? largestSplineInteger : largestInteger) : largest_real;
        if (!(std::abs(value) <= largest) || written.size() > 64)
            scanner_.refuse(
                at, integer ? LT_TEXT("Engine", "a smaller whole number") : LT_TEXT("Engine", "a smaller number"));
        scanner_.moveTo(at + written.size());
    }

    [[noreturn]] static void tooMany(const char* items, std::size_t found, std::size_t maximum)
    {
        throw Error(errors::stepTooLarge, {{"found", static_cast<std::int64_t>(found)},
                                           {"items", std::string(items)},
                                           {"maximum", static_cast<std::int64_t>(maximum)}});
    }

    /// Checks that every reference has a record, and that references are acyclic with limited depth.
    void checkReferences()
    {
        std::vector<std::int64_t> ids;
        for (const auto& [id, line] : result_.line_of_record) ids.push_back(id);
        const auto indexOf = [&](std::int64_t id) {
            const auto found = std::lower_bound(ids.begin(), ids.end(), id);
            return found != ids.end() && *found == id ? found - ids.begin() : -1;
        };
        std::vector<int> users(ids.size()), depth(ids.size());
        std::vector<std::size_t> first(ids.size() + 1);
        for (const Reference& reference : references_) {
            const auto to = indexOf(reference.to);
            if (to < 0) scanner_.refuse(reference.at, LT_TEXT("Engine", "the number of a record that is there"));
            ++users[static_cast<std::size_t>(to)];
            ++first[static_cast<std::size_t>(indexOf(reference.from)) + 1];
        }
        progress_.check();
        for (std::size_t i = 0; i < ids.size(); ++i) first[i + 1] += first[i];
        std::vector<std::size_t> used(references_.size()), next(first.begin(), first.end() - 1);
        for (const Reference& reference : references_)
            used[next[static_cast<std::size_t>(indexOf(reference.from))]++] =
                static_cast<std::size_t>(indexOf(reference.to));
        std::vector<std::size_t> ready;
        for (std::size_t i = 0; i < ids.size(); ++i)
            if (users[i] == 0) ready.push_back(i);
        std::size_t done = 0;
        for (; !ready.empty(); ++done) {
            const std::size_t i = ready.back();
            ready.pop_back();
            for (std::size_t k = first[i]; k < first[i + 1]; ++k) {
                depth[used[k]] = std::max(depth[used[k]], depth[i] + 1);
                if (--users[used[k]] == 0) ready.push_back(used[k]);
            }
        }
        const auto place = [&](std::int64_t id) {
            const auto found = std::find_if(references_.begin(), references_.end(),
                                            [&](const Reference& reference) { return reference.from == id; });
            return found == references_.end() ? std::size_t{0} : found->at;
        };
        for (std::size_t i = 0; i < ids.size(); ++i) {
            if (done < ids.size() && users[i] > 0)
                scanner_.refuse(place(ids[i]), LT_TEXT("Engine", "no ring of records that refer to each other"));
            if (depth[i] > longestChain)
                scanner_.refuse(place(ids[i]), LT_TEXT("Engine", "records no more than 200 deep"));
        }
    }

    Scanner scanner_;
    const Progress& progress_;
    Part21 result_;
    std::vector<Reference> references_;
    bool geometry_ = false;  ///< of the record that is read
    std::int64_t line_ = 1;
    std::size_t counted_ = 0;
};

}  // namespace

Part21 checkPart21(std::string_view text, const Progress& progress)
{
    if (text.empty()) throw Error(errors::fileEmpty, {});
    if (text.size() > largestStep_bytes)
        throw Error(errors::stepTooLarge, {{"found", static_cast<std::int64_t>(text.size())},
                                           {"items", std::string("bytes")},
                                           {"maximum", static_cast<std::int64_t>(largestStep_bytes)}});
    if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    return Checker(text, progress).check();
}

}  // namespace lathelier::cad
