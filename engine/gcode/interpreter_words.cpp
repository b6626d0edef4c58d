// The words of a block: what they compute to, and by which letter or name they stand.
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/gcode/flow_text.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/interpreter.h"

namespace lathelier::gcode {

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

std::optional<double> Interpreter::valueOf(const Word& word, Computed* computed)
{
    if (word.kind == WordKind::Number) return word.value;
    const std::string_view text = program_.valueOf(word);
    try {
        Computed found = evaluated(text);
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
    if (isCalledCycle(meaning)) {
        words.called = &word;
        return;
    }
    if (isFrame(meaning)) {
        words.frame = meaning;
        return;
    }
    switch (meaning) {
        case Name::Unknown:
            if (!takeProgramName(word, words)) words.blocker = &word;
            return;
        case Name::CallText: words.called = &word; return;
        case Name::CallModal: words.is_modal_call = true; return;
        case Name::MillOn:
        case Name::MillOff: modal_.milled_by = meaning == Name::MillOn ? &word : nullptr; return;
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
    bool isWhole = true, isShared = false;
    for (std::uint32_t i = 0; i < block.word_count; ++i) {
        const Word& word = program_.words[block.first_word + i];
        if (!isShared && word.kind != WordKind::Number && word.kind != WordKind::Comment) {
            sharePosition();  // for what is computed
            isShared = true;
        }
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

}  // namespace lathelier::gcode
