// FlowStyle::Structured: statements with their ends, and calls of programs by name.
#include <algorithm>
#include <cmath>

#include "engine/gcode/flow_text.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/interpreter.h"

namespace lathelier::gcode {

/// L100 P2: the program %_N_L100_SPF of the same file, twice.
void Interpreter::callByName(BlockWords& words)
{
    indexFlow();
    const Word& word = *words.word[static_cast<std::size_t>(BlockWords::slot(control_.call_letter))];
    const std::string name = capitals(program_.textOf(word));
    std::string head = control_.program_head;
    head += name;
    head += '_';
    for (const std::size_t section : sections_) {
        if (!capitals(program_.textOf(program_.blocks[section])).starts_with(head)) continue;
        return call(section + 1, std::clamp(std::lround(plain(words, 'P', 1)), 1L, 9999L), false);
    }
    error(errors::ncSubprogram, &word, {{"found", shown(program_, name)}});
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
        const auto [begin, end] = sectionOf(pc_);
        for (std::size_t b = begin; b < end; ++b)
            for (std::uint32_t i = 0; i < program_.blocks[b].word_count; ++i) {
                const Word& name = program_.words[program_.blocks[b].first_word + i];
                if (name.kind == WordKind::Name && capitals(program_.textOf(name)) == label + ":") return jump(b);
            }
        error(errors::ncSequence, nullptr, {{"found", label}});
        stop();
    };
    const auto isTrue = [&] { return compute(rest, variables_).value.value_or(0) != 0; };
    if (word == "GOTO" || word == "GOTOF" || word == "GOTOB") return goTo(rest);
    if (word == "IF") {
        const Computed condition = compute(rest, variables_);
        const std::string_view then = trimmedFront(rest.substr(std::min(condition.end, rest.size())));
        const bool holds = condition.value.value_or(0) != 0;
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
            word == "FOR" ? compute(text.substr(equals + 1), variables_).value.value_or(0) : current.value_or(0) + 1;
        if (name.number >= 0)
            variables_.set(name.number, value);
        else
            variables_.set(name.name, value);
        const bool isRepeated = value <= compute(text.substr(last + 4), variables_).value.value_or(0);
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
