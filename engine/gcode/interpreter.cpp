#include "engine/gcode/interpreter.h"

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/gcode/flow_text.h"
#include "engine/gcode/gcode_codes.h"

namespace lathelier::gcode {

Interpreter::Interpreter(Program& program, const ToolpathParameters& parameters, const ToolTable& tools,
                         const Progress& progress)
    : program_(program),
      parameters_(parameters),
      tools_(tools),
      progress_(progress),
      control_(*program.control),
      diagnostics_(program.diagnostics),
      variables_(control_.arithmetic),
      path_(result_.moves)
{
    modal_.is_diameter = control_.start.is_diameter;
    modal_.per_revolution = control_.start.is_per_revolution;
    if (control_.start.is_at_origin) modal_.at = {0, 0};
    result_.blocks.resize(program.blocks.size());
    result_.parameters = parameters;
    result_.parameters.dialect = control_.key;
    result_.parameters.control = program.control;
}

Toolpath Interpreter::run()
{
    result_.moves.reserve(std::min(program_.blocks.size() + 16, mostMoves));
    runAll();
    if (openLine_) unclosedLine();
    if (openRough_) unclosedCycle();
    if (std::all_of(program_.words.begin(), program_.words.end(),
                    [](const Word& word) { return word.kind == WordKind::Comment || word.letter == 'O'; })) {
        pc_ = 0;
        if (!program_.blocks.empty()) error(errors::ncEmpty);
    }
    path_.finish();
    drainProblems();
    if (noseUnknown_) {
        pc_ = noseUnknown_->first;
        warn(notes::noseRadiusUnknown, nullptr, {{"last", static_cast<std::int64_t>(noseUnknown_->second) + 1}});
    }
    result_.words = countWords(program_);
    result_.words_understood = countUnderstood(program_);
    result_.diagnostics = diagnostics_.sorted();
    result_.understanding = diagnostics_.understanding(result_.diagnostics);
    result_.understanding.assumed = std::move(assumed_);
    result_.has_errors = diagnostics_.hasErrors();
    return std::move(result_);
}

/// First byte of the word; without one, of the first word of the block.
std::uint32_t Interpreter::placeOf(const Word* word) const
{
    if (word) return word->begin;
    const Block& block = program_.blocks[pc_];
    return block.word_count > 0 ? program_.words[block.first_word].begin : block.begin;
}

void Interpreter::error(const ErrorCode& code, const Word* word, Values values)
{
    // Repeated errors of a block in a loop add nothing; the program is refused anyway.
    constexpr int mostRepeated = 1000;
    const std::size_t before = diagnostics_.size();
    report(program_, diagnostics_, program_.blocks[pc_], placeOf(word), code, std::move(values));
    if (diagnostics_.size() == before && ++repeatedErrors_ > mostRepeated) stop();
}

void Interpreter::warn(const NoteCode& code, const Word* word, Values values, std::optional<GapEffect> gap)
{
    report(program_, diagnostics_, program_.blocks[pc_], placeOf(word), code, std::move(values), gap);
}

/// A variable that nothing has set here is listed.
Computed Interpreter::evaluated(std::string_view text)
{
    Computed found = compute(text, variables_);
    for (const std::string& name : found.vacant)
        if (vacant_.insert(name).second) assume(name, Text{"0"});
    return found;
}

void Interpreter::assume(const std::string& what, const Text& value)
{
    LinePlace place = program_.placeOf(static_cast<std::int64_t>(pc_) + 1);
    const bool isStated = std::any_of(assumed_.begin(), assumed_.end(), [&](const Assumed& one) {
        return one.line == place.line && one.path == place.path && one.what == what;
    });
    if (!isStated) assumed_.push_back({what, text(value), std::move(place.path), place.line});
}

void Interpreter::notUnderstood(const Word* word)
{
    if (word) program_.words[static_cast<std::size_t>(word - program_.words.data())].is_understood = false;
}

void Interpreter::drainProblems()
{
    const std::size_t here = pc_;
    for (const PathProblem& problem : path_.problems) {
        pc_ = static_cast<std::size_t>(std::max<std::int64_t>(problem.line, 1) - 1);
        error(*problem.code, nullptr,
              {{problem.code == &errors::ncNoseFit ? "radius_mm" : "size_mm", problem.size_mm}});
    }
    path_.problems.clear();
    pc_ = here;
}

/// M97 P…: a subprogram within the same program.
void Interpreter::callBlock(BlockWords& words)
{
    const long number = std::lround(plain(words, 'P'));
    if (const auto found = findSequence(number, pc_))
        call(*found, std::max(std::lround(plain(words, 'L', 1)), 1L), false);
    else
        error(errors::ncSequence, nullptr, {{"found", named('N', number)}});
}

/// M99, M99 P…
void Interpreter::returnOrRepeat(BlockWords& words)
{
    const bool hasTarget = words.has('P');
    const long number = std::lround(plain(words, 'P'));
    if (!calls_.empty()) {
        returnFromCall();
        if (hasTarget)
            if (const auto found = findSequence(number, next_ > 0 ? next_ - 1 : 0)) next_ = *found;
    } else if (hasTarget) {
        const auto found = findSequence(number, pc_);
        if (found && countLoop()) jump(*found);
    } else {
        warn(notes::ncMainRepeats);
        stop();
    }
}

/// Whether a call or a return has no words beside it but those that it takes.
bool Interpreter::standsAlone(const BlockWords& words, M meaning)
{
    if (meaning != M::CallProgram && meaning != M::Return) return true;
    std::uint32_t rest = words.given;
    for (const char letter : std::string_view(meaning == M::CallProgram ? "PLNO" : "NO"))
        rest &= ~(1U << BlockWords::slot(letter));
    return rest == 0 && words.g_count == 0 && words.m_count == 1;
}

void Interpreter::takeM(BlockWords& words)
{
    takeCalls(words);
    for (int i = 0; i < words.m_count; ++i) {
        const int m = words.m[static_cast<std::size_t>(i)];
        const M meaning = meaningOfM(control_, m);
        if ((inContour_ || inFinish_) && meaning >= M::CallProgram) {
            warn(notes::ncBlockNotModelled, nullptr, {{"found", named('M', m)}}, GapEffect::Moves);
            continue;
        }
        if (control_.call_stands_alone && !standsAlone(words, meaning)) {
            warn(notes::ncBlockNotModelled, nullptr, {{"found", named('M', m)}}, GapEffect::Moves);
            continue;
        }
        if (endsNothing_ && (meaning == M::End || meaning == M::EndOrReturn)) continue;
        switch (meaning) {
            case M::EndOrReturn:
                if (calls_.empty())
                    stop();
                else
                    returnFromCall();
                break;
            case M::End: stop(); break;
            case M::CallProgram: callProgram(words, false); break;
            case M::CallBlock: callBlock(words); break;
            case M::Return: returnOrRepeat(words); break;
            default: break;
        }
    }
}

void Interpreter::checkUnused(const BlockWords& words)
{
    const std::uint32_t rest = words.given & ~words.used;
    if (rest == 0 || words.blocker || words.called) return;
    const auto shapes = [&](char letter) {  // the end of a move, on controls where it has a use there
        return hasAxes(words) && std::string_view("ACIKRcr").find(letter) != std::string_view::npos;
    };
    for (int i = 0; i < words.g_count; ++i) {
        const G g = words.g[static_cast<std::size_t>(i)];
        if (g == G::NoEffect || g == G::ReturnToLevel || g == G::NotModelled || g == G::Unknown || g == G::FixedPoint)
            return;
    }
    for (int slot = 0; slot < 28; ++slot) {
        const Word* const word = words.word[static_cast<std::size_t>(slot)];
        if ((rest >> slot & 1U) == 0 || !word || !word->is_understood) continue;
        if (meaningOfLetter(control_, word->letter) == Letter::Always) continue;
        if (words.m_count > 0 && (word->letter == 'P' || word->letter == 'Q' || word->letter == 'R')) continue;
        warn(notes::ncWordWithoutUse, word, {{"found", shownWord(*word)}},
             shapes(word->letter) ? std::optional(GapEffect::Moves) : std::nullopt);
        notUnderstood(word);
    }
}

void Interpreter::execute(std::size_t block)
{
    pc_ = block;
    next_ = block + 1;
    const Block& here = program_.blocks[block];
    if (here.word_count == 0 || here.is_malformed) return;
    BlockState& state = result_.blocks[block];
    ++state.runs;
    state.start = modal_.at;
    BlockWords words;
    if (here.has_skip && !statedSkip_) {
        statedSkip_ = true;
        assume("block_skip", LT_TEXT("Engine", "off"));
    }
    if (const Word& first = program_.words[here.first_word]; here.word_count > 1 || first.kind != WordKind::Comment) {
        if (!gather(words)) return;
        takeModes(words);
        takeSpindle(words);
        state.is_diameter = modal_.is_diameter && !(modal_.is_diameter_absolute_only && modal_.is_incremental);
        state.is_incremental = modal_.is_incremental;
        state.is_inch = modal_.is_inch;
        state.arc_is_absolute = modal_.arc_is_absolute;
        state.is_contour = state.is_contour || inContour_;
        state.shift = {0, 0};
        if (modal_.is_shifted) state.shift = modal_.whole.isStraight() ? ofWork({0, 0}) : Point{};
        updateNose();
        move(words);
        state.is_compensated = state.is_compensated || modal_.side != NoseSide::Off;
        takeM(words);
        checkUnused(words);
        for (std::uint32_t i = 0; i < here.word_count && !stopped_; ++i) {
            const Word& word = program_.words[here.first_word + i];
            if (word.kind != WordKind::Flow) continue;
            if (inContour_ || inFinish_)
                warn(notes::ncBlockNotModelled, &word, {{"found", shownWord(word)}}, GapEffect::Moves);
            else
                runStatement(word);
        }
        if (!path_.problems.empty()) drainProblems();
    }
    state.end = modal_.at;
}

Toolpath findToolpath(Program& program, const ToolpathParameters& parameters, const ToolTable& tools,
                      const Progress& progress)
{
    return Interpreter(program, parameters, tools, progress).run();
}

}  // namespace lathelier::gcode
