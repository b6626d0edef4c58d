#include "engine/gcode/rewriter.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/core/units.h"
#include "engine/gcode/changeable_words.h"
#include "engine/gcode/gcode_codes.h"

namespace lathelier::gcode {
namespace {

/// The G word of a motion in a block, nullptr where it is modal.
const Word* motionWord(const Program& program, const Block& block)
{
    for (std::uint32_t i = 0; i < block.word_count; ++i) {
        const Word& word = program.words[block.first_word + i];
        if (word.letter == 'G' && word.kind == WordKind::Number && word.value >= 0 && word.value <= 3 &&
            word.value == std::floor(word.value))
            return &word;
    }
    return nullptr;
}

/// A replacement of bytes within a block.
struct Edit {
    std::size_t begin = 0;
    std::size_t length = 0;
    std::string text;
};

std::string applied(std::string_view text, std::size_t offset, std::vector<Edit> edits)
{
    std::sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
    std::string result;
    std::size_t at = 0;
    for (const Edit& edit : edits) {
        result += text.substr(at, edit.begin - offset - at);
        result += edit.text;
        at = edit.begin - offset + edit.length;
    }
    result += text.substr(at);
    return result;
}

/// The word U or W of a block where that is an increment; else nullptr.
const Word* incrementOf(const Program& program, const Block& block, char letter)
{
    return program.control->increments_are_letters ? program.wordOf(block, letter) : nullptr;
}

bool movesX(const Program& program, const Block& block)
{
    return program.wordOf(block, 'X') || incrementOf(program, block, 'U');
}

/// The program as a control runs it that skips the blocks behind "/"; lines keep their numbers.
std::string withoutSkipped(const Program& program)
{
    std::string result;
    std::size_t copied = 0;
    for (const Block& block : program.blocks) {
        if (!block.has_skip) continue;
        result += std::string_view(program.text).substr(copied, block.begin - copied);
        copied = block.begin + block.length;
    }
    return result += std::string_view(program.text).substr(copied);
}

char inCaseOf(char letter, char like)
{
    return like >= 'a' && like <= 'z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

}  // namespace

Rewriter::Rewriter(const Program& program, const Toolpath& path, int decimals)
    : program_(program), path_(path), decimals_(decimals)
{
    std::int64_t apart = 0, together = 0, ended = 0, blocks = 0;
    for (const Block& block : program.blocks) {
        const Word* before = nullptr;
        bool isEnded = false;
        for (std::uint32_t i = 0; i < block.word_count; ++i) {
            const Word& word = program.words[block.first_word + i];
            if (word.kind == WordKind::Comment) {
                isEnded = isEnded || program.text[word.begin] == ';';
                continue;
            }
            if (before) ++(before->begin + before->length < word.begin ? apart : together);
            before = &word;
        }
        if (!before) continue;
        ++blocks;
        if (isEnded) ++ended;
    }
    style_ = {together <= apart, 2 * ended >= blocks && ended > 0};
}

void Rewriter::refuse(std::size_t block, Text reason, const Word* word) const
{
    const Block& where = program_.blocks.at(block);
    Error error(errors::ncBlockNotRewritable,
                {{"line", program_.lineOf(where)},
                 {"block", shown(program_, program_.textOf(where))},
                 {"word", word ? Value(shown(program_, program_.textOf(*word))) : Value()},
                 {"reason", reason}});
    if (word) error.with("column", program_.columnOf(where, word->begin));
    throw error;
}

void Rewriter::checkWords(std::size_t block) const
{
    const Block& where = program_.blocks.at(block);
    const BlockState& state = path_.blocks.at(block);
    const Text shape = LT_TEXT("Engine", "a chamfer, a rounding or an angle shapes its end");
    for (std::uint32_t i = 0; i < where.word_count; ++i)
        if (shapesItsEnd(program_, program_.words[where.first_word + i])) refuse(block, shape);
    for (std::uint32_t i = 0; i < where.word_count; ++i)
        if (const Word& word = program_.words[where.first_word + i]; !isHarmless(program_, word, state))
            refuse(block, LT_TEXT("Engine", "may shape its end or its path"), &word);
    if (state.is_shaped) refuse(block, shape);
}

std::optional<Error> Rewriter::refusalOfWords(std::size_t block) const
{
    try {
        checkWords(block);
    } catch (const Error& error) {
        return error;
    }
    return std::nullopt;
}

std::optional<Error> Rewriter::refusal(std::size_t block) const
{
    try {
        const BlockState& state = path_.blocks.at(block);
        if (state.is_compensated) refuse(block, LT_TEXT("Engine", "nose radius compensation is active"));
        if (state.is_contour) refuse(block, LT_TEXT("Engine", "it belongs to the contour of a cycle"));
        if (state.is_cycle) refuse(block, LT_TEXT("Engine", "a cycle makes its moves"));
        if (state.runs > 1) refuse(block, LT_TEXT("Engine", "it is run more than once"));
        if (state.runs == 0) refuse(block, LT_TEXT("Engine", "it is never run"));
        const Block& where = program_.blocks[block];
        for (const char letter : {'X', 'U', 'Z', 'W'})
            if (const Word* word = program_.wordOf(where, letter); word && word->kind == WordKind::Expression)
                refuse(block, LT_TEXT("Engine", "its position is computed"));
        checkWords(block);
        if (!isKnown(state.end)) refuse(block, LT_TEXT("Engine", "its position is not known"));
        if (!isKnown(state.shift)) refuse(block, LT_TEXT("Engine", "its coordinates are turned, scaled or mirrored"));
    } catch (const Error& error) {
        return error;
    }
    return std::nullopt;
}

int Rewriter::digitsOf(const BlockState& state, bool isX) const
{
    return decimals_ + (isX && !state.is_diameter ? 1 : 0) + (state.is_inch ? 1 : 0);
}

double Rewriter::rounded_mm(std::size_t block, double x_mm) const
{
    return rounded(block, {x_mm, 0}).x_mm;
}

Point Rewriter::rounded(std::size_t block, const Point& point) const
{
    const BlockState& state = path_.blocks.at(block);
    const auto onGrid = [&](double value_mm, bool isX) {
        const double scale = (isX && state.is_diameter ? 2 : 1) / (state.is_inch ? mm_per_inch : 1);
        const double grid = std::pow(10.0, digitsOf(state, isX));
        const double shift_mm = isX ? state.shift.x_mm : state.shift.z_mm;
        return std::round((value_mm - shift_mm) * scale * grid) / grid / scale + shift_mm;
    };
    return {onGrid(point.x_mm, true), onGrid(point.z_mm, false)};
}

void Rewriter::setX(std::size_t block, double x_mm)
{
    const BlockState& state = path_.blocks.at(block);
    plans_[block] = {{{x_mm, state.end.z_mm}, {}}};
}

void Rewriter::split(std::size_t block, std::vector<PathPart> parts)
{
    if (!parts.empty()) plans_[block] = std::move(parts);
}

std::string Rewriter::formatted(double value, int digits, bool keepsPoint) const
{
    std::string text = fmt::format("{:.{}f}", value, digits);
    if (text.find('.') != std::string::npos) {
        const std::size_t last = text.find_last_not_of('0');
        text.resize(last + 1);
    }
    if (text.starts_with("-") && text.find_first_of("123456789") == std::string::npos) text.erase(0, 1);
    if (!keepsPoint && !program_.control->integers_count_increments && text.ends_with('.')) text.pop_back();
    return text;
}

/// A coordinate in the format of the program, with the digits of the grid, or fewer as in the original word.
std::string Rewriter::number(std::size_t block, double value_mm, bool isX, const Word* like) const
{
    const BlockState& state = path_.blocks[block];
    const double value = value_mm * (isX && state.is_diameter ? 2 : 1) / (state.is_inch ? mm_per_inch : 1);
    return formatted(value, digitsOf(state, isX), like && like->has_point);
}

/// The value of I or K.
std::string Rewriter::centreNumber(std::size_t block, double centre_mm, double from_mm, bool isX,
                                   const Word* like) const
{
    const BlockState& state = path_.blocks[block];
    if (state.arc_is_absolute) return number(block, centre_mm - (isX ? state.shift.x_mm : state.shift.z_mm), isX, like);
    return formatted((centre_mm - from_mm) / (state.is_inch ? mm_per_inch : 1), digitsOf(state, false),
                     like && like->has_point);
}

/// A block of one word is written as most blocks are.
Rewriter::Style Rewriter::styleOf(const Block& block) const
{
    Style style = style_;
    const Word* before = nullptr;
    for (std::uint32_t i = 0; i < block.word_count; ++i) {
        const Word& word = program_.words[block.first_word + i];
        if (word.kind == WordKind::Comment) continue;
        if (before) style.has_blanks = before->begin + before->length < word.begin;
        before = &word;
    }
    return style;
}

/// The text of the block with its end at `to`, coming from `from`.
std::string Rewriter::firstText(std::size_t block, const Point& from, const PathPart& to, bool isSplit) const
{
    const Block& where = program_.blocks[block];
    const BlockState& state = path_.blocks[block];
    const std::string_view text = program_.textOf(where);
    const std::string& all = program_.text;
    const std::string gap = styleOf(where).has_blanks ? " " : "";
    std::vector<Edit> edits;
    const Word* x = program_.wordOf(where, 'X');
    const Word* z = program_.wordOf(where, 'Z');
    const Word* u = incrementOf(program_, where, 'U');
    const Word* w = incrementOf(program_, where, 'W');
    const double dx_mm = to.end.x_mm - from.x_mm, dz_mm = to.end.z_mm - from.z_mm;
    const auto replace = [&](const Word& word, const std::string& value) {
        edits.push_back({word.value_begin, word.begin + word.length - word.value_begin, value});
    };
    const auto letter = [&](char capital, const Word& like) {
        return std::string(1, inCaseOf(capital, all[like.begin]));
    };
    if (u)
        replace(*u, number(block, dx_mm, true, u));
    else if (x)
        replace(*x, number(block, state.is_incremental ? dx_mm : to.end.x_mm - state.shift.x_mm, true, x));
    if (z && isSplit)
        replace(*z, number(block, state.is_incremental ? dz_mm : to.end.z_mm - state.shift.z_mm, false, z));
    if (w && isSplit) replace(*w, number(block, dz_mm, false, w));
    if (!x && !u && std::abs(dx_mm) > 1e-9) {
        const Word* before = z ? z : w;
        if (!before) refuse(block, LT_TEXT("Engine", "it has no place for an X word"));
        const std::string value =
            number(block, state.is_incremental ? dx_mm : to.end.x_mm - state.shift.x_mm, true, before);
        edits.push_back({before->begin, 0, letter('X', *before) + value + gap});
    }
    if (!z && !w && isSplit && std::abs(dz_mm) > 1e-9) {
        const Word* behind = x ? x : u;
        if (!behind) refuse(block, LT_TEXT("Engine", "it has no place for a Z word"));
        edits.push_back(
            {behind->begin + behind->length, 0,
             gap + letter('Z', *behind) +
                 number(block, state.is_incremental ? dz_mm : to.end.z_mm - state.shift.z_mm, false, behind)});
    }
    if (!isSplit || state.kind != MoveKind::Arc) return applied(text, where.begin, std::move(edits));
    const Word* r = radiusWord(program_, where);
    if (to.centre) {
        const auto same = [](double a, double b) { return std::abs(a - b) < 1e-9; };
        if (r) {
            double stated = r->value;
            const std::string_view value = program_.valueOf(*r);
            const auto [end, problem] = std::from_chars(value.data(), value.data() + value.size(), stated);
            if (r->kind != WordKind::Number && (problem != std::errc() || end != value.data() + value.size()))
                refuse(block, LT_TEXT("Engine", "its radius is computed"));
            if (stated < 0) refuse(block, LT_TEXT("Engine", "it is an arc of more than half a circle"));
            const double radius_mm = std::hypot(to.centre->x_mm - from.x_mm, to.centre->z_mm - from.z_mm);
            replace(*r, formatted(radius_mm / (state.is_inch ? mm_per_inch : 1), digitsOf(state, false),
                                  value.find('.') != std::string_view::npos));
            return applied(text, where.begin, std::move(edits));
        }
        const Word* i = program_.wordOf(where, 'I');
        const Word* k = program_.wordOf(where, 'K');
        if (!i && !k) refuse(block, LT_TEXT("Engine", "neither a radius nor a centre states its arc"));
        for (const Word* word : {i, k})
            if (word && word->kind == WordKind::Expression) refuse(block, LT_TEXT("Engine", "its centre is computed"));
        const std::string iText = centreNumber(block, to.centre->x_mm, from.x_mm, true, i ? i : k);
        const std::string kText = centreNumber(block, to.centre->z_mm, from.z_mm, false, k ? k : i);
        if (i) replace(*i, iText);
        if (k) replace(*k, kText);
        if (!i && !same(to.centre->x_mm, from.x_mm)) edits.push_back({k->begin, 0, letter('I', *k) + iText + gap});
        if (!k && !same(to.centre->z_mm, from.z_mm))
            edits.push_back({i->begin + i->length, 0, gap + letter('K', *i) + kText});
        return applied(text, where.begin, std::move(edits));
    }
    const Word* g = motionWord(program_, where);  // the arc becomes straight
    if (!g) refuse(block, LT_TEXT("Engine", "it is an arc without its own G word"));
    replace(*g, all[g->value_begin] == '0' ? "01" : "1");
    for (std::uint32_t i = 0; i < where.word_count; ++i) {
        const Word& word = program_.words[where.first_word + i];
        if (word.letter != 'I' && word.letter != 'K' && !isRadius(program_, word)) continue;
        std::size_t begin = word.begin;  // with the blanks before it
        while (begin > where.begin && all[begin - 1] == ' ') --begin;
        edits.push_back({begin, word.begin + word.length - begin, ""});
    }
    return applied(text, where.begin, std::move(edits));
}

/// A block behind the first one of a split block.
std::string Rewriter::addedText(std::size_t block, const Point& from, const PathPart& to, bool wasArc) const
{
    const Block& where = program_.blocks[block];
    const BlockState& state = path_.blocks[block];
    const Style style = styleOf(where);
    const std::string& all = program_.text;
    const Word& first = program_.words[where.first_word];
    const char like = all[first.begin];
    const auto letter = [&](char capital) { return std::string(1, inCaseOf(capital, like)); };
    const double dx_mm = to.end.x_mm - from.x_mm, dz_mm = to.end.z_mm - from.z_mm;
    std::vector<std::string> words;
    if (to.centre.has_value() != wasArc) {
        const Word* g = motionWord(program_, where);
        if (!g) refuse(block, LT_TEXT("Engine", "it is an arc without its own G word"));
        const char* line = all[g->value_begin] == '0' ? "01" : "1";
        words.push_back(letter('G') + (to.centre ? std::string(program_.valueOf(*g)) : line));
    }
    words.push_back(letter('X') +
                    number(block, state.is_incremental ? dx_mm : to.end.x_mm - state.shift.x_mm, true, nullptr));
    words.push_back(letter('Z') +
                    number(block, state.is_incremental ? dz_mm : to.end.z_mm - state.shift.z_mm, false, nullptr));
    if (to.centre) {
        if (const Word* r = radiusWord(program_, where)) {
            const double radius_mm = std::hypot(to.centre->x_mm - from.x_mm, to.centre->z_mm - from.z_mm);
            const std::string_view head = std::string_view(all).substr(r->begin, r->value_begin - r->begin);
            words.push_back(std::string(head) + formatted(radius_mm / (state.is_inch ? mm_per_inch : 1),
                                                          digitsOf(state, false), r->has_point));
        } else {
            words.push_back(letter('I') + centreNumber(block, to.centre->x_mm, from.x_mm, true, nullptr));
            words.push_back(letter('K') + centreNumber(block, to.centre->z_mm, from.z_mm, false, nullptr));
        }
    }
    std::string made(std::string_view(all).substr(where.begin, first.begin - where.begin));
    for (std::size_t i = 0; i < words.size(); ++i) made += (i > 0 && style.has_blanks ? " " : "") + words[i];
    for (std::uint32_t i = 0; i < where.word_count; ++i) {
        const Word& word = program_.words[where.first_word + i];
        if (word.kind != WordKind::Comment || all[word.begin] != ';') continue;
        const bool isBare = program_.textOf(word).find_first_not_of("; \t") == std::string_view::npos;
        std::size_t blank = word.begin;
        while (blank > where.begin && all[blank - 1] == ' ') --blank;
        if (isBare || style.ends_blocks) made += all.substr(blank, word.begin - blank) + ";";
        break;
    }
    return made;
}

RewrittenProgram Rewriter::write() const
{
    Written result = written();
    const bool maySkip = std::any_of(program_.blocks.begin(), program_.blocks.end(),
                                     [](const Block& block) { return block.has_skip && block.word_count > 0; });
    if (maySkip && !plans_.empty()) checkSkipped(result);
    return std::move(result.program);
}

/// With the blocks behind "/" skipped every other block has to end where it ended, or at the same corrected place.
void Rewriter::checkSkipped(const Written& written) const
{
    const Text reason = LT_TEXT("Engine", "where the blocks behind “/” are skipped it begins or ends elsewhere");
    const auto run = [&](const Program& program) {
        Program left = readProgram(withoutSkipped(program), program_.control);
        return findToolpath(left, path_.parameters);
    };
    const Toolpath before = run(program_);
    if (before.has_errors) return;  // it cannot be run that way
    const Toolpath after = run(readProgram(written.program.text, program_.control));
    const auto same = [](double a, double b) { return std::abs(a - b) < 1e-6; };
    for (std::size_t b = 0; b < program_.blocks.size(); ++b) {
        const BlockState& was = before.blocks[b];
        if (program_.blocks[b].has_skip || was.runs == 0) continue;
        const BlockState& is = after.blocks.at(written.last_line[b]);
        if (isKnown(was.end) != isKnown(is.end)) refuse(b, reason);
        const auto plan = plans_.find(b);
        const Point& start = path_.blocks[b].start;
        if (plan != plans_.end() && plan->second.size() > 1 &&
            !(same(was.start.x_mm, start.x_mm) && same(was.start.z_mm, start.z_mm)))
            refuse(b, reason);
        if (!isKnown(was.end)) continue;
        const double change_mm = is.end.x_mm - was.end.x_mm;
        if (!same(is.end.z_mm, was.end.z_mm) || !(same(change_mm, 0) || same(change_mm, written.change_mm[b])))
            refuse(b, reason);
    }
}

Rewriter::Written Rewriter::written() const
{
    for (const auto& [block, parts] : plans_) {
        if (auto error = refusal(block)) throw Error(*error);
        const Block& where = program_.blocks[block];
        for (std::uint32_t i = 0; i < where.word_count && parts.size() > 1; ++i)
            if (const Word& word = program_.words[where.first_word + i]; stops(*program_.control, word))
                refuse(block, LT_TEXT("Engine", "would stop it before its end"), &word);
    }
    Written made;
    RewrittenProgram& result = made.program;
    result.text.reserve(program_.text.size() + 1024);
    made.change_mm.reserve(program_.blocks.size());
    made.last_line.reserve(program_.blocks.size());
    const std::string& all = program_.text;
    std::size_t copied = 0;
    // Original and new position after the last block that moves X.
    double change_mm = 0;
    bool isAfterArc = false;  // an arc ends in a line: a following modal arc would become a line
    std::string lineEnd = "\n";
    for (std::size_t b = 0; b < program_.blocks.size(); ++b) {
        const Block& block = program_.blocks[b];
        const std::size_t end = block.begin + block.length;
        const std::size_t next = b + 1 < program_.blocks.size() ? program_.blocks[b + 1].begin : all.size();
        if (next > end) lineEnd = all.substr(end, next - end);
        const BlockState& state = path_.blocks[b];
        const auto plan = plans_.find(b);
        const bool isMove = state.runs > 0 && (movesX(program_, block) || plan != plans_.end());
        std::vector<std::string> texts;
        if (plan != plans_.end()) {
            const std::vector<PathPart>& parts = plan->second;
            const bool isSplit = parts.size() > 1 || state.kind == MoveKind::Arc;
            Point from{state.start.x_mm + change_mm, state.start.z_mm};
            texts.push_back(firstText(b, from, parts.front(), isSplit));
            for (std::size_t k = 1; k < parts.size(); ++k) {
                from = rounded(b, parts[k - 1].end);
                const bool wasArc = state.kind == MoveKind::Arc && parts[k - 1].centre;
                texts.push_back(addedText(b, from, parts[k], wasArc));
            }
            change_mm = rounded_mm(b, parts.back().end.x_mm) - state.end.x_mm;
            isAfterArc = state.kind == MoveKind::Arc && !parts.back().centre;
        } else if (state.runs > 0) {
            const bool isChanged = std::abs(change_mm) > 1e-9;
            const bool hasMotion = program_.wordOf(block, 'X') || program_.wordOf(block, 'Z') ||
                                   program_.wordOf(block, 'U') || program_.wordOf(block, 'W');
            if (isAfterArc && hasMotion && state.kind == MoveKind::Arc && !motionWord(program_, block))
                refuse(b, LT_TEXT("Engine", "it is an arc without its own G word, behind one that became straight"));
            if (hasMotion && motionWord(program_, block)) isAfterArc = false;
            if (isChanged && state.kind == MoveKind::Arc && hasMotion)
                refuse(b, LT_TEXT("Engine", "it is an arc that begins at a changed X"));
            const bool counts =
                incrementOf(program_, block, 'U') || (state.is_incremental && program_.wordOf(block, 'X'));
            if (isChanged && counts && hasMotion && isKnown(state.end)) {
                if (auto error = refusal(b)) throw Error(*error);
                texts.push_back(firstText(b, {state.start.x_mm + change_mm, state.start.z_mm}, {state.end, {}}, false));
                change_mm = 0;
            } else if (isMove || (state.is_cycle && hasMotion)) {
                change_mm = 0;
            }
        }
        made.change_mm.push_back(change_mm);
        made.last_line.push_back(b + static_cast<std::size_t>(result.blocks_added) +
                                 (texts.empty() ? 0 : texts.size() - 1));
        if (texts.empty() || (texts.size() == 1 && texts.front() == program_.textOf(block))) continue;
        result.text += std::string_view(all).substr(copied, block.begin - copied);
        copied = end;
        const std::string before(program_.textOf(block));
        if (texts.front() != before) {
            ++result.blocks_changed;
            result.changes.push_back({program_.lineOf(block), before, texts.front(), 0});
        }
        for (std::size_t k = 0; k < texts.size(); ++k) {
            if (k > 0) {
                result.text += lineEnd;
                ++result.blocks_added;
                result.changes.push_back({program_.lineOf(block), std::nullopt, texts[k], k});
            }
            result.text += texts[k];
        }
    }
    result.text += std::string_view(all).substr(copied);
    return made;
}

}  // namespace lathelier::gcode
