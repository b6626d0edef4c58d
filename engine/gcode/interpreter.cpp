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
    result_.words = countWords(program_);
    result_.words_understood = countUnderstood(program_);
    result_.diagnostics = diagnostics_.sorted();
    result_.understanding = diagnostics_.understanding();
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

void Interpreter::assume(const char* what, const Text& value)
{
    assumed_.push_back({what, text(value), {}, static_cast<std::int64_t>(pc_) + 1});
}

/// A value that the program does not give: an error where it would be a coordinate.
void Interpreter::reportUnknown(const Word& word, const std::string& variable)
{
    constexpr std::string_view switches = "FSTND";
    notUnderstood(&word);
    if (switches.find(word.letter) != std::string_view::npos)
        warn(notes::ncVariableUnset, &word, {{"found", variable}}, GapEffect::Measures);
    else
        error(errors::ncVariableUnknown, &word, {{"word", shownWord(word)}, {"found", variable}});
}

/// The position as the variables that hold it count it.
void Interpreter::sharePosition()
{
    const Point at = ofProgram(modal_.at);
    const double unit = modal_.is_inch ? mm_per_inch : 1;
    const bool isDiameter = modal_.is_diameter && !control_.arithmetic.position_is_radius;
    variables_.setPosition(at.x_mm * (isDiameter ? 2 : 1) / unit, at.z_mm / unit);
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

std::optional<double> Interpreter::valueOf(const Word& word, Computed* computed)
{
    if (word.kind == WordKind::Number) return word.value;
    const std::string_view text = program_.valueOf(word);
    try {
        Computed found = compute(text, variables_);
        if (found.end < text.size())
            throw ExpressionFailure{LT_TEXT("Engine", "something is left behind it"), found.end};
        if (computed) *computed = found;
        if (!found.unknown.empty() && !computed) return std::nullopt;
        return found.value;
    } catch (const ExpressionFailure& failure) {
        Word at = word;
        at.begin = word.value_begin + static_cast<std::uint32_t>(std::min(failure.at, text.size()));
        error(errors::ncExpression, &at, {{"found", shown(program_, text)}, {"reason", failure.reason}});
    }
    return std::nullopt;
}

/// #101=…, R1=…
void Interpreter::assign(const Word& word)
{
    Computed computed;
    const auto value = valueOf(word, &computed);
    const std::string_view text = program_.textOf(word);
    try {
        const VariableName name = variableName(text, variables_);
        if (name.number == control_.arithmetic.alarm) {
            error(errors::ncAlarm, &word, {{"found", shown(program_, program_.textOf(program_.blocks[pc_]))}});
            stop();
        }
        if (!computed.unknown.empty())
            name.number >= 0 ? variables_.setUnknown(name.number) : variables_.setUnknown(name.name);
        else if (name.number >= 0)
            variables_.set(name.number, value);
        else
            variables_.set(name.name, value.value_or(0));
    } catch (const ExpressionFailure& failure) {
        error(errors::ncExpression, &word, {{"found", shown(program_, text)}, {"reason", failure.reason}});
    }
}

/// A program or a variable that the program declares; false: neither.
bool Interpreter::takeProgramName(const Word& word, BlockWords& words)
{
    const std::string name = nameOf(program_.textOf(word));
    if (!program_.names.contains(name)) return false;
    const bool isValue = word.kind == WordKind::Expression || word.kind == WordKind::Number;
    if (!isValue) {
        words.called = &word;
        return true;
    }
    Computed computed;
    const std::optional<double> value = valueOf(word, &computed);
    if (computed.unknown.empty())
        variables_.set(name, value.value_or(0));
    else
        variables_.setUnknown(name);
    return true;
}

void Interpreter::takeName(const Word& word, BlockWords& words)
{
    if (program_.textOf(word).ends_with(':')) return;
    const Name meaning = meaningOfName(control_, program_.textOf(word));
    if (isFrame(meaning)) {
        words.frame = meaning;
        return;
    }
    switch (meaning) {
        case Name::Unknown:
            if (!takeProgramName(word, words)) words.blocker = &word;
            return;
        case Name::CallText: words.called = &word; return;
        case Name::MillOn:
        case Name::MillOff:
            words.mill = meaning;
            modal_.milled_by = meaning == Name::MillOn ? &word : nullptr;
            return;
        case Name::DiameterOn:
        case Name::DiameterOff:
        case Name::DiameterAbsolute:
            modal_.is_diameter = meaning != Name::DiameterOff;
            modal_.is_diameter_absolute_only = meaning == Name::DiameterAbsolute;
            statedDiameter_ = true;
            return;
        case Name::MachineMove: words.is_machine = true; return;
        case Name::ArcThrough: modal_.motion = G::ArcThrough; return;
        case Name::AxisPoint: words.has_axis_point = true; return;
        case Name::Uncomputed: return;
        default: break;
    }
    if (word.kind != WordKind::Expression && word.kind != WordKind::Number) return;
    const double value = valueOf(word).value_or(notANumber);
    const double length_mm = value * (modal_.is_inch ? mm_per_inch : 1);
    switch (meaning) {
        case Name::SpeedLimit: modal_.limit_rpm = value; break;
        case Name::Speed: modal_.speed = value; break;
        case Name::RoundModal: modal_.round_mm = length_mm; break;
        case Name::EndAngle:
        case Name::RotateAngle:
        case Name::ArcAngle: words.named[static_cast<std::size_t>(meaning)] = value; break;
        case Name::ArcRadius:
        case Name::ArcMiddleX:
        case Name::ArcMiddleZ:
        case Name::ChamferChord:
        case Name::ChamferLeg:
        case Name::Round: words.named[static_cast<std::size_t>(meaning)] = length_mm; break;
        default: break;
    }
}

/// The words of the block by letter. False if the block cannot be executed.
bool Interpreter::gather(BlockWords& words)
{
    const Block& block = program_.blocks[pc_];
    bool isWhole = true;
    for (std::uint32_t i = 0; i < block.word_count; ++i) {
        const Word& word = program_.words[block.first_word + i];
        switch (word.kind) {
            case WordKind::Comment: continue;
            case WordKind::Bad: return false;
            case WordKind::Flow: continue;
            case WordKind::Assignment: assign(word); continue;
            case WordKind::Name:
            case WordKind::Call: takeName(word, words); continue;
            default: break;
        }
        if (word.letter == 0) {
            takeName(word, words);
            continue;
        }
        if (!program_.names.empty() && word.value_begin > word.begin + 1 &&
            program_.names.contains(std::string_view(&word.letter, 1)) && takeProgramName(word, words))
            continue;
        if (word.letter == 'T' && control_.tools_have_names &&
            program_.valueOf(word).find('"') != std::string_view::npos) {
            const std::string_view name = program_.valueOf(word);
            const std::size_t digit = name.find_first_of("0123456789");
            modal_.tool = digit == std::string_view::npos ? 0 : std::atoi(std::string(name.substr(digit, 6)).c_str());
            continue;
        }
        Computed computed;
        std::optional<double> value = word.value;
        if (word.kind == WordKind::Expression) {
            const auto before = diagnostics_.hasErrors();
            value = valueOf(word, &computed);
            if (!computed.unknown.empty()) {
                reportUnknown(word, computed.unknown);
                continue;
            }
            if (!value) {
                isWhole = isWhole && before == diagnostics_.hasErrors();
                continue;  // a vacant variable: the word is ignored
            }
        }
        if (word.letter == 'G') {
            const auto code10 = static_cast<int>(std::lround(std::clamp(*value, -1.0, 1e6) * 10));
            const G meaning = meaningOfG(control_, code10);
            if (word.kind == WordKind::Expression && (meaning == G::Unknown || meaning == G::NotModelled)) {
                warn(notes::ncWordUnknown, &word, {{"found", shownWord(word)}}, GapEffect::Moves);
                notUnderstood(&word);
            }
            if (words.g_count < static_cast<int>(words.g.size())) {
                const auto at = static_cast<std::size_t>(words.g_count++);
                words.g[at] = meaning;
                words.g10[at] = code10;
                words.g_word[at] = &word;
            }
        } else if (word.letter == 'M') {
            const M meaning = meaningOfM(control_, static_cast<int>(std::clamp(*value, -1.0, 1e6)));
            if (meaning == M::NotModelled || meaning == M::Unknown) words.unknown_m = &word;
            if (meaning == M::Spindle) modal_.held_by = nullptr;
            if (words.m_count < static_cast<int>(words.m.size()))
                words.m[static_cast<std::size_t>(words.m_count++)] = static_cast<int>(std::clamp(*value, -1.0, 1e6));
        } else {
            const int slot = BlockWords::slot(word.letter);
            if ((words.given >> slot & 1U) != 0) {
                if (control_.refuses_conflicts)
                    error(errors::ncGroups, &word, {{"found", shownWord(word)}});
                else
                    warn(notes::ncWordRepeated, &word, {{"found", shownWord(word)}});
            }
            words.given |= 1U << slot;
            if (meaningOfLetter(control_, word.letter) != Letter::Unknown) words.known |= 1U << slot;
            if (computed.is_incremental) words.incremental |= 1U << slot;
            if (computed.is_absolute) words.absolute |= 1U << slot;
            words.value[static_cast<std::size_t>(slot)] = *value;
            words.word[static_cast<std::size_t>(slot)] = &word;
        }
    }
    if (words.unknown_m && (hasAxes(words) || words.has('P'))) words.blocker = words.unknown_m;
    return isWhole;
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

void Interpreter::takeM(BlockWords& words)
{
    if (control_.call_letter != 0 && words.has(control_.call_letter)) callByLetter(words);
    if (words.called) callByName(*words.called, std::clamp(std::lround(plain(words, 'P', 1)), 1L, 9999L));
    for (int i = 0; i < words.m_count; ++i) {
        const int m = words.m[static_cast<std::size_t>(i)];
        const M meaning = meaningOfM(control_, m);
        if ((inContour_ || inFinish_) && meaning >= M::CallProgram) {
            warn(notes::ncBlockNotModelled, nullptr, {{"found", named('M', m)}}, GapEffect::Moves);
            continue;
        }
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
    if (const Word& first = program_.words[here.first_word]; here.word_count > 1 || first.kind != WordKind::Comment) {
        sharePosition();
        if (!gather(words)) return;
        takeModes(words);
        takeSpindle(words);
        state.is_diameter = modal_.is_diameter && !(modal_.is_diameter_absolute_only && modal_.is_incremental);
        state.is_incremental = modal_.is_incremental;
        state.is_inch = modal_.is_inch;
        state.arc_is_absolute = modal_.arc_is_absolute;
        state.is_contour = state.is_contour || inContour_;
        state.shift = modal_.frame.isStraight() ? ofWork({0, 0}) : Point{};
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
