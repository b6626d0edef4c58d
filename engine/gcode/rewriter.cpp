#include "engine/gcode/rewriter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
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

/// Chamfers, roundings and angles, as comma words or names.
bool shapesItsEnd(const Program& program, const Word& word)
{
    if (word.letter == 'c' || word.letter == 'r' || word.letter == 'a') return true;
    return word.letter == 0 && word.kind != WordKind::Comment &&
           shapesCorner(meaningOfName(*program.control, program.textOf(word)));
}

}  // namespace

Rewriter::Rewriter(const Program& program, const Toolpath& path, int decimals)
    : program_(program), path_(path), decimals_(decimals)
{
}

void Rewriter::refuse(std::size_t block, Text reason) const
{
    const Block& where = program_.blocks.at(block);
    throw Error(
        errors::ncBlockNotRewritable,
        {{"line", program_.lineOf(where)}, {"block", shown(program_, program_.textOf(where))}, {"reason", reason}});
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
        for (std::uint32_t i = 0; i < where.word_count; ++i)
            if (shapesItsEnd(program_, program_.words[where.first_word + i]))
                refuse(block, LT_TEXT("Engine", "a chamfer, a rounding or an angle shapes its end"));
        if (!isKnown(state.end)) refuse(block, LT_TEXT("Engine", "its position is not known"));
    } catch (const Error& error) {
        return error;
    }
    return std::nullopt;
}

int Rewriter::digitsOf(const BlockState& state, bool isX) const
{
    return decimals_ + (isX && !state.is_diameter ? 1 : 0) + (state.is_inch ? 2 : 0);
}

double Rewriter::rounded_mm(std::size_t block, double x_mm) const
{
    const BlockState& state = path_.blocks.at(block);
    const double scale = (state.is_diameter ? 2 : 1) / (state.is_inch ? mm_per_inch : 1);
    const double grid = std::pow(10.0, digitsOf(state, true));
    return std::round(x_mm * scale * grid) / grid / scale;
}

void Rewriter::setX(std::size_t block, double x_mm)
{
    const BlockState& state = path_.blocks.at(block);
    plans_[block] = {{{x_mm, state.end.z_mm}}};
}

void Rewriter::split(std::size_t block, std::vector<Point> points)
{
    if (!points.empty()) plans_[block] = {std::move(points)};
}

/// A coordinate in the format of the program, with the digits of the grid, or fewer as in the original word.
std::string Rewriter::number(std::size_t block, double value_mm, bool isX, const Word* like) const
{
    const BlockState& state = path_.blocks[block];
    const double value = value_mm * (isX && state.is_diameter ? 2 : 1) / (state.is_inch ? mm_per_inch : 1);
    std::string text = fmt::format("{:.{}f}", value, digitsOf(state, isX));
    if (text.find('.') != std::string::npos) {
        const std::size_t last = text.find_last_not_of('0');
        text.resize(last + 1);
    }
    if (text.starts_with("-") && text.find_first_of("123456789") == std::string::npos) text.erase(0, 1);
    const bool keepsPoint = program_.control->integers_count_increments || (like && like->has_point);
    if (!keepsPoint && text.ends_with('.')) text.pop_back();
    return text;
}

/// The text of the block with its end at `to`, coming from `from`.
std::string Rewriter::firstText(std::size_t block, const Point& from, const Point& to, bool isSplit) const
{
    const Block& where = program_.blocks[block];
    const BlockState& state = path_.blocks[block];
    const std::string_view text = program_.textOf(where);
    const std::string& all = program_.text;
    std::vector<Edit> edits;
    const Word* x = program_.wordOf(where, 'X');
    const Word* z = program_.wordOf(where, 'Z');
    const Word* u = incrementOf(program_, where, 'U');
    const Word* w = incrementOf(program_, where, 'W');
    const auto replace = [&](const Word& word, const std::string& value) {
        edits.push_back({word.value_begin, word.begin + word.length - word.value_begin, value});
    };
    if (u)
        replace(*u, number(block, to.x_mm - from.x_mm, true, u));
    else if (x)
        replace(*x, number(block, state.is_incremental ? to.x_mm - from.x_mm : to.x_mm, true, x));
    if (z && isSplit) replace(*z, number(block, state.is_incremental ? to.z_mm - from.z_mm : to.z_mm, false, z));
    if (w && isSplit) replace(*w, number(block, to.z_mm - from.z_mm, false, w));
    if (!x && !u && std::abs(to.x_mm - from.x_mm) > 1e-9) {
        const Word* before = z ? z : w;
        if (!before) refuse(block, LT_TEXT("Engine", "it has no place for an X word"));
        const std::string value = state.is_incremental ? number(block, to.x_mm - from.x_mm, true, before)
                                                       : number(block, to.x_mm, true, before);
        edits.push_back({before->begin, 0, "X" + value + " "});
    }
    if (!z && !w && isSplit && std::abs(to.z_mm - from.z_mm) > 1e-9) {
        const Word* behind = x ? x : u;
        if (!behind) refuse(block, LT_TEXT("Engine", "it has no place for a Z word"));
        edits.push_back({behind->begin + behind->length, 0,
                         " Z" + number(block, state.is_incremental ? to.z_mm - from.z_mm : to.z_mm, false, behind)});
    }
    if (isSplit && state.kind == MoveKind::Arc) {  // the arc becomes straight
        const Word* g = motionWord(program_, where);
        if (!g) refuse(block, LT_TEXT("Engine", "it is an arc without its own G word"));
        edits.push_back({g->begin, g->length, "G1"});
        for (std::uint32_t i = 0; i < where.word_count; ++i) {
            const Word& word = program_.words[where.first_word + i];
            const bool isShape = word.letter == 'I' || word.letter == 'K' || word.letter == 'R' ||
                                 (word.letter == 0 && word.kind != WordKind::Comment &&
                                  meaningOfName(*program_.control, program_.textOf(word)) == Name::ArcRadius);
            if (!isShape) continue;
            std::size_t begin = word.begin;  // with the blanks before it
            while (begin > where.begin && all[begin - 1] == ' ') --begin;
            edits.push_back({begin, word.begin + word.length - begin, ""});
        }
    }
    return applied(text, where.begin, std::move(edits));
}

RewrittenProgram Rewriter::write() const
{
    for (const auto& [block, plan] : plans_)
        if (auto error = refusal(block)) throw Error(*error);
    RewrittenProgram result;
    result.text.reserve(program_.text.size() + 1024);
    const std::string& all = program_.text;
    std::size_t copied = 0;
    // Original and new position after the last block that moves X.
    double change_mm = 0;
    bool isAfterArc = false;  // an arc was replaced by lines: a following modal arc would become a line
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
            const std::vector<Point>& points = plan->second.points;
            const bool isSplit = points.size() > 1 || state.kind == MoveKind::Arc;
            Point from{state.start.x_mm + change_mm, state.start.z_mm};
            texts.push_back(firstText(b, from, points.front(), isSplit));
            from = {rounded_mm(b, points.front().x_mm), points.front().z_mm};
            for (std::size_t k = 1; k < points.size(); ++k) {
                const bool g91 = state.is_incremental;
                texts.push_back(
                    fmt::format("X{} Z{}", number(b, g91 ? points[k].x_mm - from.x_mm : points[k].x_mm, true, nullptr),
                                number(b, g91 ? points[k].z_mm - from.z_mm : points[k].z_mm, false, nullptr)));
                from = {rounded_mm(b, points[k].x_mm), points[k].z_mm};
            }
            change_mm = rounded_mm(b, points.back().x_mm) - state.end.x_mm;
            isAfterArc = isSplit && state.kind == MoveKind::Arc;
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
                texts.push_back(firstText(b, {state.start.x_mm + change_mm, state.start.z_mm}, state.end, false));
                change_mm = 0;
            } else if (isMove || (state.is_cycle && hasMotion)) {
                change_mm = 0;
            }
        }
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
    return result;
}

}  // namespace lathelier::gcode
