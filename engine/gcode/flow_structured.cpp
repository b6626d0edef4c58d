// FlowStyle::Structured: statements with their ends, and calls of programs by name.
#include <algorithm>
#include <cmath>

#include "engine/gcode/flow_text.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/interpreter.h"

namespace lathelier::gcode {

std::optional<std::size_t> Interpreter::programNamed(const std::string& name) const
{
    const auto found = programs_.find(name);
    return found == programs_.end() ? std::nullopt : std::optional(found->second);
}

/// NAME, NAME(40, -8), CALL "NAME": a program of the same file, by its head or its PROC.
void Interpreter::callByName(const Word& word, long repeats)
{
    const std::string_view text = program_.textOf(word);
    const std::size_t quote = text.find('"'), open = text.find('(');
    const std::string name = nameOf(quote != std::string_view::npos && quote < open ? text.substr(quote + 1) : text);
    const std::optional<std::size_t> first = programNamed(name);
    if (!first) return callMissing(&word, name);
    // Its parameters: those of a PROC in its first blocks.
    std::vector<Declared> parameters;
    for (std::size_t b = *first; b < program_.blocks.size() && b < *first + 20; ++b) {
        const FlowStatement* const at = statementOf(b);
        if (!at || at->keyword != "PROC") continue;
        const std::string_view line = program_.textOf(program_.blocks[b]);
        const std::size_t from = line.find('('), to = line.rfind(')');
        if (from != std::string_view::npos && to != std::string_view::npos && to > from)
            parameters = declaredIn(line.substr(from + 1, to - from - 1));
        break;
    }
    std::vector<std::pair<std::string, std::optional<double>>> values;
    const std::size_t close = text.rfind(')');
    const bool hasList = quote == std::string_view::npos && open != std::string_view::npos &&
                         close != std::string_view::npos && close > open;
    const std::vector<std::string_view> given =
        hasList ? splitArguments(text.substr(open + 1, close - open - 1)) : std::vector<std::string_view>{};
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        std::optional<double> value = 0;
        if (i < given.size() && !given[i].empty()) {
            const Computed found = evaluated(given[i]);
            value = found.unknown.empty() ? std::optional(found.value.value_or(0)) : std::nullopt;
        }
        values.emplace_back(parameters[i].name, value);
    }
    call(*first, repeats, true);
    for (const auto& [parameter, value] : values)
        value ? variables_.set(parameter, *value) : variables_.setUnknown(parameter);
}

/// DEF REAL A=1, B: values of the variables.
void Interpreter::declare(std::string_view list)
{
    const std::string_view rest = trimmedFront(list);
    const std::size_t type = rest.find_first_of(" \t");
    if (type == std::string_view::npos) return;
    for (const Declared& one : declaredIn(rest.substr(type))) {
        if (one.value.starts_with('"')) continue;
        Computed found;
        if (!one.value.empty()) found = evaluated(one.value);
        if (found.unknown.empty())
            variables_.set(one.name, found.value.value_or(0));
        else
            variables_.setUnknown(one.name);
    }
}

/// The block of "LABEL:" in the same program.
std::optional<std::size_t> Interpreter::labelled(std::string_view label) const
{
    const auto [begin, end] = sectionOf(pc_);
    const std::string wanted = capitals(label) + ":";
    for (std::size_t b = begin; b < end; ++b)
        for (std::uint32_t i = 0; i < program_.blocks[b].word_count; ++i) {
            const Word& name = program_.words[program_.blocks[b].first_word + i];
            if (name.kind == WordKind::Name && capitals(program_.textOf(name)) == wanted) return b;
        }
    return std::nullopt;
}

/// REPEAT AA P=3: from the label to this block; REPEAT AA BB P=3: to the block of the second label; to ENDLABEL where
/// that stands behind the first; REPEATB AA P=3: the block of the label.
void Interpreter::repeatPart(std::string_view text, const Word& word, bool is_one_block)
{
    std::vector<std::string> labels;
    long repeats = 1;
    std::string_view rest = trimmedFront(text);
    while (!rest.empty()) {
        const std::string name = nameOf(rest);
        if (name.empty()) break;
        rest = trimmedFront(rest.substr(name.size()));
        const bool isCount =
            name[0] == 'P' && (rest.starts_with('=') || (name.size() > 1 && numberIn(name) >= 0 && !labelled(name)));
        if (!isCount) {
            labels.push_back(name);
            continue;
        }
        const std::string_view value = rest.starts_with('=') ? rest.substr(1) : std::string_view(name).substr(1);
        const Computed count = evaluated(value);
        if (!count.unknown.empty()) warn(notes::ncVariableUnset, &word, {{"found", count.unknown}}, GapEffect::Moves);
        repeats = std::lround(std::clamp(count.value.value_or(0), 0.0, 1e12));
        break;
    }
    if (repeats == 0) return;
    const std::optional<std::size_t> first = labels.empty() ? std::nullopt : labelled(labels.front());
    const std::optional<std::size_t> second = labels.size() > 1 ? labelled(labels[1]) : std::nullopt;
    if (!first || (labels.size() > 1 && !second)) {
        error(errors::ncSequence, &word, {{"found", labels.empty() ? std::string("REPEAT") : labels[first ? 1 : 0]}});
        stop();
        return;
    }
    std::size_t last = is_one_block ? *first : pc_;
    if (second) {
        last = *second;
    } else if (!is_one_block) {
        const std::optional<std::size_t> end = labelled("ENDLABEL");
        if (end && *end > *first)
            last = *end;
        else if (pc_ > *first)
            last = pc_ - 1;
    }
    if (last < *first || (*first <= pc_ && pc_ <= last)) {
        error(errors::ncFlow, &word, {{"found", shownWord(word)}});
        stop();
        return;
    }
    call(*first, repeats, false);
    if (!calls_.empty()) calls_.back().last = last;
}

void Interpreter::runStructured(const FlowStatement& at)
{
    const Block& block = program_.blocks[at.block];
    std::string_view rest = std::string_view(program_.text).substr(at.rest, block.begin + block.length - at.rest);
    if (const std::size_t comment = rest.find(';'); comment != std::string_view::npos) rest = rest.substr(0, comment);
    const std::size_t index = statementAt_[at.block];
    const std::string& word = at.keyword;
    const auto to = [&](std::size_t found, std::size_t behind) {
        if (found == std::string::npos) {
            error(errors::ncFlow, nullptr, {{"found", word}});
            stop();
        } else {
            const std::size_t target = statements_[found].block + behind;
            if (target <= pc_)
                jump(target);
            else
                next_ = target;
        }
    };
    const auto goTo = [&](std::string_view target) {
        target = trimmedFront(target);
        const std::string label = capitals(target.substr(0, target.find_first_of(" \t")));
        if (label.size() > 1 && label[0] == 'N' && label.find_first_not_of("0123456789", 1) == std::string::npos)
            if (const auto found = findSequence(std::atol(label.c_str() + 1), pc_)) return jump(*found);
        if (const auto found = labelled(label)) return jump(*found);
        error(errors::ncSequence, nullptr, {{"found", label}});
        stop();
    };
    const auto isTrue = [&] { return condition(rest); };
    const Word& statement = program_.words[block.first_word];
    if (word == "DEF") return declare(rest);
    if (word == "REPEATB") return repeatPart(rest, statement, true);
    if (word == "REPEAT" && !nameOf(trimmedFront(rest)).empty()) return repeatPart(rest, statement, false);
    if (word == "GOTO" || word == "GOTOF" || word == "GOTOB") return goTo(rest);
    if (word == "IF") {
        std::size_t behind = 0;
        const bool holds = condition(rest, &behind);
        const std::string_view then = trimmedFront(rest.substr(std::min(behind, rest.size())));
        if (then.starts_with("GOTO") || then.starts_with("goto")) {
            if (holds) goTo(then.substr(keywordOf(then).size()));
            return;
        }
        if (holds) return;
        int depth = 0;
        for (std::size_t i = index + 1; i < statements_.size(); ++i) {
            const FlowStatement& other = statements_[i];
            const Block& place = program_.blocks[other.block];
            const bool isJump = capitals(program_.textOf(place)).find("GOTO") != std::string::npos;
            if (other.keyword == "IF" && !isJump) ++depth;
            if (depth == 0 && (other.keyword == "ELSE" || other.keyword == "ENDIF")) return to(i, 1);
            if (other.keyword == "ENDIF") --depth;
        }
        return to(std::string::npos, 0);
    }
    if (word == "ELSE") {
        int depth = 0;
        for (std::size_t i = index + 1; i < statements_.size(); ++i) {
            const bool isJump =
                capitals(program_.textOf(program_.blocks[statements_[i].block])).find("GOTO") != std::string::npos;
            if (statements_[i].keyword == "IF" && !isJump) ++depth;
            if (statements_[i].keyword == "ENDIF" && depth-- == 0) return to(i, 1);
        }
        return to(std::string::npos, 0);
    }
    if (word == "WHILE" && !isTrue()) return to(matching(index, "WHILE", "ENDWHILE", 1), 1);
    if (word == "ENDWHILE") return to(matching(index, "ENDWHILE", "WHILE", -1), 0);
    if (word == "ENDLOOP") return to(matching(index, "ENDLOOP", "LOOP", -1), 0);
    if (word == "UNTIL" && !isTrue()) return to(matching(index, "UNTIL", "REPEAT", -1), 1);
    if (word == "FOR" || word == "ENDFOR") {
        const std::size_t head = word == "FOR" ? index : matching(index, "ENDFOR", "FOR", -1);
        if (head == std::string::npos) return to(head, 0);
        const FlowStatement& start = statements_[head];
        const Block& place = program_.blocks[start.block];
        const std::string_view text =
            std::string_view(program_.text).substr(start.rest, place.begin + place.length - start.rest);
        const VariableName name = variableName(text, variables_);
        const std::size_t equals = text.find('=');
        const std::size_t last = capitals(text).find(" TO ");
        if (equals == std::string_view::npos || last == std::string::npos) return to(std::string::npos, 0);
        const auto current = name.number >= 0 ? variables_.get(name.number) : variables_.get(name.name);
        const double value =
            word == "FOR" ? evaluated(text.substr(equals + 1)).value.value_or(0) : current.value_or(0) + 1;
        if (name.number >= 0)
            variables_.set(name.number, value);
        else
            variables_.set(name.name, value);
        const bool isRepeated = value <= evaluated(text.substr(last + 4)).value.value_or(0);
        if (word == "ENDFOR") return isRepeated ? jump(start.block + 1) : void();
        if (!isRepeated) to(matching(index, "FOR", "ENDFOR", 1), 1);
        return;
    }
    if (word == "RET") {
        if (calls_.empty())
            stop();
        else
            returnFromCall();
    }
}

}  // namespace lathelier::gcode
