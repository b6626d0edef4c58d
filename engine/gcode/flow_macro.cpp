// FlowStyle::Macro: IF, WHILE, GOTO.
#include <algorithm>
#include <cmath>

#include "engine/gcode/flow_text.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/interpreter.h"

namespace lathelier::gcode {

void Interpreter::runMacro(const Word& word)
{
    const FlowStatement& at = *statementOf(pc_);
    const std::string_view all(program_.text);
    std::string_view rest = all.substr(at.rest, word.begin + word.length - at.rest);
    std::string keyword = at.keyword;
    const auto goTo = [&](std::string_view text) {
        const Computed number = evaluated(text);
        const long wanted = std::lround(std::clamp(number.value.value_or(-1), -1.0, 1e9));
        const auto found = findSequence(wanted, pc_);
        if (found)
            jump(*found);
        else {
            error(errors::ncSequence, &word, {{"found", named('N', wanted)}});
            stop();
        }
    };
    const auto labelOf = [](const FlowStatement& statement, std::string_view text) {  // of DO and WHILE…DO
        const std::size_t where = capitals(text).rfind("DO");
        return statement.keyword == "END" || where == std::string::npos ? numberIn(text) : numberIn(text.substr(where));
    };
    const auto textOf = [&](const FlowStatement& statement) {
        const Block& block = program_.blocks[statement.block];
        return all.substr(statement.rest, block.begin + block.length - statement.rest);
    };
    if (keyword == "GOTO") return goTo(rest);
    if (keyword == "IF") {
        std::size_t end = 0;
        const bool holds = condition(rest, &end);
        rest = trimmedFront(rest.substr(std::min(end, rest.size())));
        const std::string then = keywordOf(rest);
        if (then != "GOTO" && then != "THEN") {
            error(errors::ncFlow, &word, {{"found", shownWord(word)}});
            return;
        }
        if (!holds) return;
        if (then == "GOTO") return goTo(rest.substr(4));
        Word assignment = word;
        rest = trimmedFront(rest.substr(4));
        assignment.begin = static_cast<std::uint32_t>(rest.data() - program_.text.data());
        assignment.length = static_cast<std::uint32_t>(rest.size());
        const std::size_t equals = rest.find('=');
        if (equals == std::string_view::npos) return error(errors::ncFlow, &word, {{"found", shownWord(word)}});
        assignment.value_begin = assignment.begin + static_cast<std::uint32_t>(equals) + 1;
        assignment.kind = WordKind::Assignment;
        return assign(assignment);
    }
    const std::size_t index = statementAt_[pc_];
    const long label = labelOf(at, rest);
    if (keyword == "WHILE" || keyword == "DO") {
        if (keyword == "DO" || condition(rest)) return;
        for (std::size_t i = index + 1; i < statements_.size(); ++i)
            if (statements_[i].keyword == "END" && numberIn(textOf(statements_[i])) == label) {
                next_ = statements_[i].block + 1;
                return;
            }
    } else if (keyword == "END") {
        for (std::size_t i = index; i-- > 0;)
            if ((statements_[i].keyword == "WHILE" || statements_[i].keyword == "DO") &&
                labelOf(statements_[i], textOf(statements_[i])) == label)
                return jump(statements_[i].block);
    }
    error(errors::ncFlow, &word, {{"found", shownWord(word)}});
    stop();
}

}  // namespace lathelier::gcode
