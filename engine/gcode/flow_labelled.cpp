// FlowStyle::Labelled: O words.
#include <algorithm>
#include <cmath>

#include "engine/gcode/flow_text.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/interpreter.h"

namespace lathelier::gcode {

void Interpreter::runLabelled(const FlowStatement& at)
{
    const Block& block = program_.blocks[at.block];
    const std::string_view rest = std::string_view(program_.text).substr(at.rest, block.begin + block.length - at.rest);
    const std::size_t index = statementAt_[at.block];
    const auto unmatched = [&] {
        error(errors::ncFlow, nullptr, {{"found", at.label + " " + at.keyword}});
        stop();
    };
    const auto find = [&](std::initializer_list<const char*> words, bool isForward) -> const FlowStatement* {
        for (std::size_t i = isForward ? index + 1 : index; isForward ? i < statements_.size() : i-- > 0;
             i += isForward ? 1 : 0) {
            const FlowStatement& other = statements_[i];
            if (other.label != at.label) continue;
            for (const char* word : words)
                if (other.keyword == word) return &other;
        }
        return nullptr;
    };
    const auto isTrue = [&] { return condition(rest); };
    const std::string& word = at.keyword;
    if (word == "SUB") {
        if (const FlowStatement* end = find({"ENDSUB"}, true))
            next_ = end->block + 1;
        else
            unmatched();
    } else if (word == "CALL") {
        for (const FlowStatement& sub : statements_) {
            if (sub.keyword != "SUB" || sub.label != at.label) continue;
            std::unordered_map<long, double> arguments;
            std::string_view list = trimmedFront(rest);
            for (long n = 1; n <= 30 && list.starts_with('['); ++n) {
                const Computed value = evaluated(list);
                arguments[n] = value.value.value_or(0);
                if (value.end == 0) break;
                list = trimmedFront(list.substr(value.end));
            }
            return call(sub.block + 1, 1, true, std::move(arguments));
        }
        callMissing(nullptr, at.label);
    } else if (word == "ENDSUB" || word == "RETURN") {
        if (calls_.empty())
            unmatched();
        else
            returnFromCall();
    } else if (word == "IF") {
        if (isTrue()) return;
        const FlowStatement* other = find({"ELSEIF", "ELSE", "ENDIF"}, true);
        if (!other) return unmatched();
        // The condition of ELSEIF is evaluated at its block; ELSE and ENDIF have no effect.
        const FlowStatement* here = other;
        while (here && here->keyword == "ELSEIF") {
            const Block& place = program_.blocks[here->block];
            const std::string_view text =
                std::string_view(program_.text).substr(here->rest, place.begin + place.length - here->rest);
            if (condition(text)) break;
            const std::size_t from = statementAt_[here->block];
            here = nullptr;
            for (std::size_t i = from + 1; i < statements_.size() && !here; ++i)
                if (statements_[i].label == at.label &&
                    (statements_[i].keyword == "ELSEIF" || statements_[i].keyword == "ELSE" ||
                     statements_[i].keyword == "ENDIF"))
                    here = &statements_[i];
        }
        if (here)
            next_ = here->block + 1;
        else
            unmatched();
    } else if (word == "ELSE" || word == "ELSEIF") {
        if (const FlowStatement* end = find({"ENDIF"}, true))
            next_ = end->block + 1;
        else
            unmatched();
    } else if (word == "WHILE") {
        const FlowStatement* const start = find({"DO", "ENDWHILE"}, false);
        if (start && start->keyword == "DO") {  // do … while
            if (isTrue()) jump(start->block + 1);
            return;
        }
        if (isTrue()) return;
        if (const FlowStatement* end = find({"ENDWHILE"}, true))
            next_ = end->block + 1;
        else
            unmatched();
    } else if (word == "ENDWHILE") {
        if (const FlowStatement* start = find({"WHILE"}, false))
            jump(start->block);
        else
            unmatched();
    } else if (word == "REPEAT") {
        const double count = std::floor(evaluated(rest).value.value_or(0));
        if (count >= 1) {
            open_.push_back({at.block, count});
            return;
        }
        if (const FlowStatement* end = find({"ENDREPEAT"}, true))
            next_ = end->block + 1;
        else
            unmatched();
    } else if (word == "ENDREPEAT") {
        const FlowStatement* start = find({"REPEAT"}, false);
        if (!start) return unmatched();
        while (!open_.empty() && open_.back().head != start->block) open_.pop_back();
        if (!open_.empty() && --open_.back().left >= 1) return jump(start->block + 1);
        if (!open_.empty()) open_.pop_back();
    } else if (word == "BREAK" || word == "CONTINUE") {
        const FlowStatement* end = find({"ENDWHILE", "ENDREPEAT", "WHILE"}, true);
        if (end)
            next_ = end->block + (word == "BREAK" ? 1 : 0);
        else
            unmatched();
    } else if (word != "DO" && word != "ENDIF") {
        error(errors::ncFlow, nullptr, {{"found", at.label + " " + word}});
    }
}

}  // namespace lathelier::gcode
