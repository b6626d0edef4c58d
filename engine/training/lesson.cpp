#include "engine/training/lesson.h"

#include <algorithm>
#include <cmath>

#include "engine/core/visible.h"
#include "engine/io/io_codes.h"
#include "engine/io/text/number.h"
#include "engine/io/text/readable_text.h"
#include "engine/io/text/text_lines.h"
#include "engine/training/lesson_check.h"

namespace lathelier::training {
namespace {

constexpr Interval settableSpeed_rpm{1, 1e5};
constexpr Interval settableDepth_mm{1e-6, 1e3};
constexpr double largestNumber = 1e9;
constexpr double largestSeed = 4294967295.0;

/// "a, b, c"
std::string list(const std::vector<std::string>& words)
{
    std::string all;
    for (const std::string& word : words) all.append(all.empty() ? "" : ", ").append(word);
    return all;
}

std::vector<std::string> exerciseKeys()
{
    std::vector<std::string> keys;
    keys.reserve(exerciseChoices().size());
    for (const FieldChoice& choice : exerciseChoices()) keys.push_back(choice.key);
    return keys;
}

std::vector<std::string> quantityKeys()
{
    std::vector<std::string> keys;
    keys.reserve(quantities<LessonState>().size());
    for (const QuantityOf<LessonState>& quantity : quantities<LessonState>()) keys.push_back(quantity.info.key);
    return keys;
}

/// Place of a word in a list; its size if absent.
std::size_t placeOf(const std::vector<std::string>& words, std::string_view word)
{
    return static_cast<std::size_t>(std::find(words.begin(), words.end(), word) - words.begin());
}

bool isKeyLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

/// The lower-case word before a colon; empty: not a directive.
std::string_view directiveOf(std::string_view line)
{
    std::size_t length = 0;
    while (length < line.size() && isKeyLetter(line[length])) ++length;
    if (length == 0 || length >= line.size() || line[length] != ':') return {};
    if (length + 1 < line.size() && !io::isBlank(line[length + 1])) return {};
    return line.substr(0, length);
}

/// Without empty lines at both ends.
std::string stripped(std::string text)
{
    const std::size_t end = text.find_last_not_of(" \t\n");
    text.resize(end == std::string::npos ? 0 : end + 1);
    std::size_t begin = 0;
    for (std::size_t i = 0; i < text.size() && (text[i] == ' ' || text[i] == '\t' || text[i] == '\n'); ++i)
        if (text[i] == '\n') begin = i + 1;
    text.erase(0, begin);
    return visible(text, true);
}

/// Reads one lesson, line by line.
class Reader {
public:
    explicit Reader(std::string_view text) : lines_(text) {}

    Lesson read()
    {
        while (lines_.next()) {
            line_ = lines_.line();
            readLine();
        }
        if (lesson_.title.empty()) throw io::malformedEnd(lines_, LT_TEXT("Engine", "a title: “# Title”"));
        if (lesson_.steps.empty()) throw io::malformedEnd(lines_, LT_TEXT("Engine", "a step: “## Heading”"));
        if (fenced_) throw io::malformedEnd(lines_, LT_TEXT("Engine", "the end of the block: “```”"));
        finishStep();
        lesson_.introduction = stripped(std::move(lesson_.introduction));
        return std::move(lesson_);
    }

private:
    [[noreturn]] void refuse(std::string_view part, const Value& expected) const
    {
        const auto offset = static_cast<std::size_t>(part.data() - line_.data());
        Value found = LT_TEXT("Engine", "the end of the line");
        if (!io::trimmed(part).empty()) found = io::excerpt(part);
        throw Error(errors::malformed, {{"line", lines_.number()},
                                        {"column", io::columnAt(line_, offset)},
                                        {"found", found},
                                        {"expected", expected}});
    }

    [[noreturn]] void refuseRange(std::string_view part, std::string_view key, double found, Interval range) const
    {
        throw Error(errors::keyOutOfRange,
                    {{"line", lines_.number()},
                     {"column", io::columnAt(line_, static_cast<std::size_t>(part.data() - line_.data()))},
                     {"key", std::string(key)},
                     {"found", found},
                     {"minimum", range.from},
                     {"maximum", range.to}});
    }

    /// Each part without surrounding blanks; an empty part keeps its position.
    static std::string_view part(std::string_view text) { return text.empty() ? text : trimmedInPlace(text); }

    static std::string_view trimmedInPlace(std::string_view text)
    {
        const std::string_view inner = io::trimmed(text);
        return inner.empty() ? text.substr(text.size()) : inner;
    }

    void readLine()
    {
        if (line_.starts_with("```")) fenced_ = !fenced_;
        const bool text_only = fenced_ || line_.starts_with("```");
        if (!text_only) {
            if (line_.starts_with("# ")) return readTitle();
            if (line_.starts_with("## ")) return readHeading();
            if (line_ == "#" || line_ == "##") refuse(line_.substr(line_.size()), LT_TEXT("Engine", "a heading"));
            if (const std::string_view word = directiveOf(line_); !word.empty()) return readDirective(word);
        }
        const bool empty = io::trimmed(line_).empty();
        if (empty) continued_ = nullptr;
        if (lesson_.title.empty()) {
            if (!empty) refuse(line_, LT_TEXT("Engine", "a title: “# Title”"));
            return;
        }
        if (continued_) {
            continued_->append(" ").append(io::trimmed(line_));
            return;
        }
        std::string& body = lesson_.steps.empty() ? lesson_.introduction : lesson_.steps.back().body;
        body.append(line_).append("\n");
    }

    void readTitle()
    {
        if (!lesson_.title.empty()) refuse(line_, LT_TEXT("Engine", "one title only; a step begins with “## ”"));
        const std::string_view title = part(line_.substr(1));
        if (title.empty()) refuse(title, LT_TEXT("Engine", "a heading"));
        lesson_.title = visible(title);
    }

    void readHeading()
    {
        if (lesson_.title.empty()) refuse(line_, LT_TEXT("Engine", "a title: “# Title”"));
        const std::string_view heading = part(line_.substr(2));
        if (heading.empty()) refuse(heading, LT_TEXT("Engine", "a heading"));
        finishStep();
        if (lesson_.steps.size() == mostSteps) refuse(line_, LT_TEXT("Engine", "fewer steps"));
        lesson_.steps.emplace_back().heading = visible(heading);
        shown_ = set_ = false;
    }

    void finishStep()
    {
        continued_ = nullptr;
        if (lesson_.steps.empty()) return;
        Step& step = lesson_.steps.back();
        step.body = stripped(std::move(step.body));
        step.task = visible(step.task);
        step.hint = visible(step.hint);
        if (step.task.empty() && !step.checks.empty()) throw *withoutTask_;
    }

    void readDirective(std::string_view word)
    {
        static const std::vector<std::string> known{"set", "show", "task", "hint", "check"};
        const std::size_t place = placeOf(known, word);
        if (place == known.size()) refuse(word, list(known));
        if (lesson_.steps.empty()) refuse(word, LT_TEXT("Engine", "a step: “## Heading”"));
        continued_ = nullptr;
        Step& step = lesson_.steps.back();
        const std::string_view rest = part(line_.substr(word.size() + 1));
        switch (place) {
            case 0: return readSetting(word, rest, step.set);
            case 1: return readShow(word, rest, step.show);
            case 2: return readText(word, rest, step.task);
            case 3: return readText(word, rest, step.hint);
            default: readCheck(word, rest, step.checks);
        }
    }

    void readText(std::string_view word, std::string_view rest, std::string& text)
    {
        if (!text.empty()) refuse(word, LT_TEXT("Engine", "only one of its kind in a step"));
        if (rest.empty()) refuse(rest, LT_TEXT("Engine", "a text"));
        text = rest;
        continued_ = &text;
    }

    /// The parts between commas; refuses superfluous ones.
    template <class Take>
    void eachPart(std::string_view rest, const Take& take)
    {
        while (true) {
            const std::size_t comma = std::min(rest.find(','), rest.size());
            take(part(rest.substr(0, comma)));
            if (comma == rest.size()) return;
            rest.remove_prefix(comma + 1);
        }
    }

    void readShow(std::string_view word, std::string_view rest, std::vector<View>& show)
    {
        if (shown_) refuse(word, LT_TEXT("Engine", "only one of its kind in a step"));
        shown_ = true;
        const std::vector<std::string> known = wordsOf("view");
        eachPart(rest, [&](std::string_view view) {
            const std::size_t place = placeOf(known, view);
            if (place == known.size()) refuse(view, list(known));
            if (std::find(show.begin(), show.end(), static_cast<View>(place)) != show.end())
                refuse(view, LT_TEXT("Engine", "each only once"));
            show.push_back(static_cast<View>(place));
        });
    }

    void readSetting(std::string_view word, std::string_view rest, Setting& set)
    {
        if (set_) refuse(word, LT_TEXT("Engine", "only one of its kind in a step"));
        set_ = true;
        std::string_view seed;
        eachPart(rest, [&](std::string_view pair) {
            const std::size_t equals = pair.find('=');
            if (equals == std::string_view::npos) refuse(pair, LT_TEXT("Engine", "“key = value”"));
            const std::string_view key = part(pair.substr(0, equals)), value = part(pair.substr(equals + 1));
            if (key == "seed") seed = value;
            setOne(key, value, set);
        });
        if (set.seed && !set.exercise) refuse(seed, LT_TEXT("Engine", "an exercise with the seed"));
    }

    void setOne(std::string_view key, std::string_view value, Setting& set) const
    {
        const auto once = [&](bool given) {
            if (given) refuse(key, LT_TEXT("Engine", "each only once"));
        };
        if (key == "scenario") {
            once(!set.scenario.empty());
            set.scenario = wordsOf("scenario")[wordAmong(wordsOf("scenario"), value)];
        } else if (key == "relation") {
            once(set.relation.has_value());
            set.relation = static_cast<stability::SpeedRelation>(wordAmong(wordsOf("relation"), value));
        } else if (key == "speed_rpm") {
            once(set.speed_rpm.has_value());
            set.speed_rpm = numberWithin(key, value, settableSpeed_rpm);
        } else if (key == "depth_mm") {
            once(set.depth_mm.has_value());
            set.depth_mm = numberWithin(key, value, settableDepth_mm);
        } else if (key == "exercise") {
            once(set.exercise.has_value());
            set.exercise = static_cast<ExerciseKind>(wordAmong(exerciseKeys(), value));
        } else if (key == "seed") {
            once(set.seed.has_value());
            if (!io::wholeInteger(value)) refuse(value, LT_TEXT("Engine", "a whole number"));
            set.seed = static_cast<std::uint32_t>(numberWithin(key, value, {0, largestSeed}));
        } else {
            refuse(key, "scenario, speed_rpm, depth_mm, relation, exercise, seed");
        }
    }

    std::size_t wordAmong(const std::vector<std::string>& known, std::string_view word) const
    {
        const std::size_t place = placeOf(known, word);
        if (place == known.size()) refuse(word, list(known));
        return place;
    }

    double numberIn(std::string_view word) const
    {
        const std::optional<double> number = io::wholeNumber(word, '.');
        if (!number) refuse(word, LT_TEXT("Engine", "a number with a decimal point"));
        return *number;
    }

    double numberWithin(std::string_view key, std::string_view word, const Interval& range) const
    {
        const double number = numberIn(word);
        if (!(number >= range.from && number <= range.to)) refuseRange(word, key, number, range);
        return number;
    }

    void readCheck(std::string_view word, std::string_view rest, std::vector<Check>& checks)
    {
        if (checks.size() == mostChecks) refuse(word, LT_TEXT("Engine", "fewer checks"));
        Check check;
        std::size_t length = 0;
        while (length < rest.size() && isKeyLetter(rest[length])) ++length;
        const std::string_view key = length > 0 ? rest.substr(0, length) : rest;
        if (!findQuantity(key)) refuse(key, list(quantityKeys()));
        check.quantity = key;
        const std::string_view sign_on = part(rest.substr(length));
        const std::size_t sign_length = std::min(sign_on.find_first_not_of("<>=!"), sign_on.size());
        const std::string_view sign = sign_on.substr(0, sign_length), value = part(sign_on.substr(sign_length));
        const std::size_t place = placeOf(comparisonSigns(), sign);
        if (place == comparisonSigns().size()) refuse(sign_on, "< <= > >= = !=");
        check.comparison = static_cast<Comparison>(place);
        if (const std::vector<std::string> words = wordsOf(key); !words.empty()) {
            if (check.comparison != Comparison::Equal && check.comparison != Comparison::Different)
                refuse(sign, "= !=");
            check.word = words[wordAmong(words, value)];
        } else {
            readValue(value, check);
        }
        if (checks.empty() && lesson_.steps.back().task.empty()) rememberPlace(word);
        checks.push_back(std::move(check));
    }

    /// "1.2", "limit_mm", "1.5 * minimum_depth_mm"
    void readValue(std::string_view value, Check& check) const
    {
        const std::size_t times = value.find('*');
        std::string_view factor = part(value.substr(0, std::min(times, value.size()))), other;
        if (times != std::string_view::npos) {
            other = part(value.substr(times + 1));
        } else if (!value.empty() && value.front() >= 'a' && value.front() <= 'z') {
            other = value;
            factor = {};
        }
        if (!factor.empty() || other.empty()) {
            check.number = numberIn(factor);
            if (!(std::abs(check.number) <= largestNumber))
                refuseRange(factor, check.quantity, check.number, {-largestNumber, largestNumber});
        }
        if (times == std::string_view::npos && other.empty()) return;
        if (!findQuantity(other) || !wordsOf(other).empty())
            refuse(other, LT_TEXT("Engine", "a number with a decimal point, or a quantity that is one"));
        check.other = other;
    }

    /// Remembers the position of a check whose step has no task yet.
    void rememberPlace(std::string_view word)
    {
        try {
            refuse(word, LT_TEXT("Engine", "a task beside the check: “task: …”"));
        } catch (const Error& error) {
            withoutTask_ = error;
        }
    }

    io::Lines lines_;
    std::string_view line_;
    Lesson lesson_;
    bool fenced_ = false;  ///< within a block of code
    bool shown_ = false, set_ = false;
    std::string* continued_ = nullptr;  ///< text continued by the next line
    std::optional<Error> withoutTask_;  ///< of the first check before a task
};

}  // namespace

Lesson readLesson(std::string_view bytes, const std::string& name)
{
    try {
        const Text expected = LT_TEXT("Engine", "a lesson in Markdown");
        if (bytes.size() > largestLesson_bytes)
            throw Error(errors::malformed, {{"line", std::int64_t{1}},
                                            {"column", std::int64_t{1}},
                                            {"found", static_cast<std::int64_t>(bytes.size())},
                                            {"expected", LT_TEXT("Engine", "a lesson of at most 1 MiB")}});
        const io::DecodedText text = io::readableText(bytes, io::Encoding::Auto, expected, {});
        if (io::trimmed(text.view()).empty()) throw Error(errors::fileEmpty, {});
        return Reader(text.view()).read();
    } catch (Error& error) {
        error.with("path", name);
        throw;
    }
}

}  // namespace lathelier::training
