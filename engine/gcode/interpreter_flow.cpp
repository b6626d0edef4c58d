// Jumps, loops and subprograms, with their limits.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "engine/gcode/flow_text.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/interpreter.h"

namespace lathelier::gcode {

/// Index of program starts, block numbers and statements; built on first use.
void Interpreter::indexFlow()
{
    if (isIndexed_) return;
    isIndexed_ = true;
    statementAt_.assign(program_.blocks.size(), std::string::npos);
    sections_.push_back(0);
    auto part = program_.parts.begin();
    for (std::size_t b = 0; b < program_.blocks.size(); ++b) {
        for (; part != program_.parts.end() && part->first_block == b; ++part) sections_.push_back(b);
        const Block& block = program_.blocks[b];
        for (std::uint32_t i = 0; i < block.word_count; ++i) {
            const Word& word = program_.words[block.first_word + i];
            if (word.letter == 'N' && word.kind == WordKind::Number) sequences_[std::lround(word.value)].push_back(b);
            if (word.letter == 'O' && word.kind == WordKind::Number && b > 0) sections_.push_back(b);
            if (word.kind == WordKind::Comment && i == 0 && !control_.program_head.empty() &&
                program_.textOf(word).starts_with(control_.program_head) && b > 0)
                sections_.push_back(b);
            if (word.kind != WordKind::Flow) continue;
            FlowStatement found;
            found.block = b;
            found.rest = word.begin;
            if (word.letter == 'O') {
                found.label = capitals(program_.textOf(word).substr(0, word.value_begin - word.begin));
                std::erase_if(found.label, [](char c) { return c == ' ' || c == '\t'; });
                found.rest = word.value_begin;
            }
            const std::size_t end = word.begin + word.length;
            found.keyword = keywordOf(std::string_view(program_.text).substr(found.rest, end - found.rest));
            found.rest += found.keyword.size();
            if (found.keyword == "PROC")
                programs_.emplace(
                    nameOf(trimmedFront(std::string_view(program_.text).substr(found.rest, end - found.rest))), b);
            statementAt_[b] = statements_.size();
            statements_.push_back(std::move(found));
        }
        const std::string_view head = program_.textOf(block);
        if (!control_.program_head.empty() && head.starts_with(control_.program_head)) {
            const std::string name = nameOf(head.substr(control_.program_head.size()));
            programs_.emplace(name.substr(0, name.rfind('_')), b + 1);
        }
    }
    for (const PartPlace& named : program_.parts) programs_.emplace(named.name, named.first_block);
    checkPairs();
}

/// Statements without the one that ends or begins them.
void Interpreter::checkPairs()
{
    struct Open {
        std::string keyword;  ///< that its end asks for
        long label;
        std::size_t block;
        std::string shown;
    };
    std::vector<Open> open;
    const auto unmatched = [&](std::size_t block, const std::string& keyword) {
        pc_ = block;
        error(errors::ncFlow, nullptr, {{"found", keyword}});
    };
    const auto textOf = [&](const FlowStatement& at) {
        const Block& block = program_.blocks[at.block];
        return std::string_view(program_.text).substr(at.rest, block.begin + block.length - at.rest);
    };
    const auto close = [&](const FlowStatement& at, std::initializer_list<const char*> opens, long label) {
        for (std::size_t i = open.size(); i-- > 0;) {
            const bool isIt = std::find(opens.begin(), opens.end(), open[i].keyword) != opens.end();
            if (!isIt || open[i].label != label) continue;
            for (std::size_t k = i + 1; k < open.size(); ++k) unmatched(open[k].block, open[k].shown);
            open.resize(i);
            return;
        }
        unmatched(at.block, at.keyword);
    };
    const std::size_t here = pc_;
    if (control_.grammar.flow == FlowStyle::Labelled) return;
    const bool isMacro = control_.grammar.flow == FlowStyle::Macro;
    std::size_t section = 0;
    for (const FlowStatement& at : statements_) {
        const std::size_t of = sectionOf(at.block).first;
        if (of != section) {
            for (const Open& one : open) unmatched(one.block, one.shown);
            open.clear();
            section = of;
        }
        const std::string& word = at.keyword;
        if (isMacro) {
            const std::string_view rest = textOf(at);
            const std::size_t where = capitals(rest).rfind("DO");
            if (word == "DO" || (word == "WHILE" && where != std::string::npos))
                open.push_back({"DO", numberIn(word == "DO" ? rest : rest.substr(where)), at.block, word});
            if (word == "END") close(at, {"DO"}, numberIn(rest));
            continue;
        }
        const std::string text = capitals(program_.textOf(program_.blocks[at.block]));
        const bool repeatsPart =
            word == "REPEAT" && !trimmedFront(textOf(at)).empty() && trimmedFront(textOf(at)).front() != ';';
        if (word == "WHILE" || word == "LOOP" || word == "FOR" || (word == "REPEAT" && !repeatsPart) ||
            (word == "IF" && text.find("GOTO") == std::string::npos))
            open.push_back({word, 0, at.block, word});
        if (word == "ENDWHILE") close(at, {"WHILE"}, 0);
        if (word == "ENDLOOP") close(at, {"LOOP"}, 0);
        if (word == "ENDFOR") close(at, {"FOR"}, 0);
        if (word == "UNTIL") close(at, {"REPEAT"}, 0);
        if (word == "ENDIF") close(at, {"IF"}, 0);
    }
    for (const Open& one : open) unmatched(one.block, one.shown);
    pc_ = here;
}

/// The value of a condition. One that needs what is not known counts as not fulfilled, and which way the program goes
/// is a gap.
bool Interpreter::condition(std::string_view text, std::size_t* end)
{
    const Computed found = evaluated(text);
    if (end) *end = found.end;
    if (found.unknown.empty()) return found.value.value_or(0) != 0;
    warn(notes::ncVariableUnset, nullptr, {{"found", found.unknown}}, GapEffect::Moves);
    return false;
}

std::pair<std::size_t, std::size_t> Interpreter::sectionOf(std::size_t block) const
{
    const auto after = std::upper_bound(sections_.begin(), sections_.end(), block);
    const std::size_t end = after == sections_.end() ? program_.blocks.size() : *after;
    return {after == sections_.begin() ? 0 : *(after - 1), end};
}

std::optional<std::size_t> Interpreter::findSequence(long number, std::size_t from) const
{
    const auto found = sequences_.find(number);
    if (found == sequences_.end()) return std::nullopt;
    const auto [begin, end] = sectionOf(from);
    std::optional<std::size_t> best;
    for (const std::size_t block : found->second) {
        if (block < begin || block >= end) continue;
        if (!best || (*best < from && block >= from)) best = block;  // forward first, then from the beginning
    }
    return best;
}

const Interpreter::FlowStatement* Interpreter::statementOf(std::size_t block) const
{
    return block < statementAt_.size() && statementAt_[block] != std::string::npos ? &statements_[statementAt_[block]]
                                                                                   : nullptr;
}

bool Interpreter::countLoop()
{
    if (++loops_ <= mostLoops) return true;
    error(errors::ncLoops, nullptr, {{"most", mostLoops}});
    stop();
    return false;
}

void Interpreter::jump(std::size_t to)
{
    if (to <= pc_ && !countLoop()) return;
    next_ = to;
}

void Interpreter::call(std::size_t first, long repeats, bool withVariables, std::unordered_map<long, double> arguments)
{
    if (calls_.size() >= deepestCalls) {
        error(errors::ncNesting, nullptr, {{"most", std::int64_t{deepestCalls}}});
        stop();
        return;
    }
    if (!countLoop()) return;
    calls_.push_back({next_, first, repeats, withVariables, open_.size()});
    if (withVariables) variables_.enter(std::move(arguments));
    next_ = first;
}

void Interpreter::returnFromCall()
{
    CallFrame& frame = calls_.back();
    open_.resize(std::min(open_.size(), frame.loops));
    if (--frame.repeats > 0) {
        if (countLoop()) next_ = frame.first;
        return;
    }
    next_ = frame.back;
    if (frame.has_variables) variables_.leave();
    calls_.pop_back();
    if (modalCall_ && calls_.size() < modalCall_->running) modalCall_->running = 0;
    // The call may have been the last block of a repeated part.
    if (!calls_.empty() && calls_.back().last != std::string::npos && next_ == calls_.back().last + 1) returnFromCall();
}

/// M98 P…, G65 P…
void Interpreter::callProgram(BlockWords& words, bool isMacro)
{
    indexFlow();
    const double given = plain(words, 'P', -1);
    long number = std::lround(std::clamp(given, -1.0, 1e12));
    long repeats = std::lround(std::clamp(plain(words, 'L', 1), 0.0, 1e6));
    if (!isMacro && number > 9999 && control_.call_holds_repeats) {
        repeats *= number / 10000;
        number %= 10000;
    }
    if (repeats == 0) return;
    std::optional<std::size_t> found;
    for (const std::size_t section : sections_) {
        const Word* const head = program_.wordOf(program_.blocks[section], 'O');
        std::size_t first = section;
        bool isIt = head && std::lround(head->value) == number;
        if (section == 0 && !isIt)  // the number of the first program may follow comments
            for (std::size_t b = 0; b < program_.blocks.size() && b < 50 && !isIt; ++b)
                if (const Word* o = program_.wordOf(program_.blocks[b], 'O'); o && std::lround(o->value) == number) {
                    isIt = true;
                    first = b;
                }
        if (!isIt) continue;
        found = first;
        break;
    }
    if (!found) found = programNamed(named('O', number));  // a file of this name
    if (!found) return callMissing(words.word['P' - 'A'], named('O', number));
    call(*found, repeats, isMacro, isMacro ? argumentsOf(words) : std::unordered_map<long, double>{});
}

/// G65 A… B…: #1, #2….
std::unordered_map<long, double> Interpreter::argumentsOf(BlockWords& words)
{
    std::unordered_map<long, double> arguments;
    static constexpr int numberOf[26] = {1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                         0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
    for (int slot = 0; slot < 26; ++slot) {
        if ((words.given >> slot & 1U) == 0 || numberOf[slot] == 0) continue;
        arguments[numberOf[slot]] = words.value[static_cast<std::size_t>(slot)];
        words.used |= 1U << slot;
        if (const Word* word = words.word[static_cast<std::size_t>(slot)])
            program_.words[static_cast<std::size_t>(word - program_.words.data())].is_understood = true;
    }
    return arguments;
}

/// A program that is not in the file: what it does is not known.
void Interpreter::callMissing(const Word* word, const std::string& name)
{
    if (result_.missing.size() < mostMissing &&
        std::find(result_.missing.begin(), result_.missing.end(), name) == result_.missing.end())
        result_.missing.push_back(name);
    notUnderstood(word);
    warn(notes::ncSubprogramMissing, word, {{"found", shown(program_, name)}}, GapEffect::Moves);
    modal_.at = {};
}

void Interpreter::runAll()
{
    indexFlow();
    const bool hasSections = sections_.size() > 1;
    bool hasRun = false;
    std::size_t pc = 0;
    std::int64_t executed = 0;
    const auto most = static_cast<std::int64_t>(program_.blocks.size()) + parameters_.most_blocks_run;
    while (!stopped_) {
        const bool isEnd = pc >= program_.blocks.size();
        const bool isNext = !isEnd && hasSections && hasRun && pc > 0 &&
                            std::binary_search(sections_.begin() + 1, sections_.end(), pc) && next_ == pc_ + 1;
        const bool isBehindPart = !calls_.empty() && next_ == pc_ + 1 && calls_.back().last != std::string::npos &&
                                  pc == calls_.back().last + 1;
        if (isBehindPart || isEnd || (isNext && !(calls_.size() && calls_.back().first == pc))) {
            if (calls_.empty()) break;
            returnFromCall();  // a subprogram without end statement
            pc = next_;
            pc_ = pc > 0 ? pc - 1 : 0;
            next_ = pc_;
            continue;
        }
        execute(pc);
        for (const Word *word = program_.words.data() + program_.blocks[pc].first_word,
                        *end = word + program_.blocks[pc].word_count;
             word != end && !hasRun; ++word)
            hasRun = word->kind != WordKind::Comment && word->letter != 'O';
        if (result_.moves.size() > mostMoves) {
            error(errors::ncMoves, nullptr, {{"most", static_cast<std::int64_t>(mostMoves)}});
            break;
        }
        if (executed > most) {
            error(errors::ncBlocksRun, nullptr, {{"most", most}});
            break;
        }
        if ((++executed & 4095) == 0) progress_.check();
        pc = next_;
    }
}

void Interpreter::runStatement(const Word& word)
{
    const FlowStatement* const at = statementOf(pc_);
    if (!at) return;
    try {
        switch (control_.grammar.flow) {
            case FlowStyle::Macro: runMacro(word); break;
            case FlowStyle::Labelled: runLabelled(*at); break;
            case FlowStyle::Structured: runStructured(*at); break;
        }
    } catch (const ExpressionFailure& failure) {
        error(errors::ncExpression, &word, {{"found", shownWord(word)}, {"reason", failure.reason}});
    }
}

/// The statement that closes or opens statements_[index], respecting nesting.
std::size_t Interpreter::matching(std::size_t index, const char* open, const char* close, int step) const
{
    int depth = 0;
    for (auto i = static_cast<std::ptrdiff_t>(index); i >= 0 && i < static_cast<std::ptrdiff_t>(statements_.size());
         i += step) {
        const FlowStatement& here = statements_[static_cast<std::size_t>(i)];
        if (here.keyword == open) ++depth;
        if (here.keyword == close && --depth == 0) return static_cast<std::size_t>(i);
    }
    return std::string::npos;
}

}  // namespace lathelier::gcode
