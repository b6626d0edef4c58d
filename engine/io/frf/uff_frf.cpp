#include "engine/io/frf/uff_frf.h"

#include <algorithm>
#include <cmath>

#include "engine/io/frf/frf_choice.h"
#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/frf_lines.h"
#include "engine/io/frf/frf_sense.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

constexpr std::int64_t frequencyResponse = 4, coherence = 6;
constexpr std::int64_t displacement = 8, velocity = 11, acceleration = 12, force = 13;
constexpr std::int64_t timeAxis = 17, frequencyAxis = 18;
constexpr Text expectedMotion = LT_TEXT("Engine", "a unit such as m/s^2, g, mm or m/s, or that of the response stated");
constexpr Text expectedForce =
    LT_TEXT("Engine", "a unit of force such as N, kN or lbf, or that of the response stated");
constexpr Text expectedFrequency = LT_TEXT("Engine", "a unit of frequency such as Hz");
constexpr double sameFrequency = 1e-6;  ///< relative tolerance of equal frequencies
constexpr double mostActive_percent = 50;

bool isForce(const PhysicalUnit& unit)
{
    return unit.length == 0 && unit.time == 0 && unit.force == 1;
}

bool isMotion(const PhysicalUnit& unit)
{
    return unit.length == 1 && unit.force == 0 && unit.time <= 0 && unit.time >= -2;
}

std::optional<FrfQuantity> frfQuantityOf(std::int64_t ordinateType)
{
    if (ordinateType == displacement) return FrfQuantity::Receptance;
    if (ordinateType == velocity) return FrfQuantity::Mobility;
    if (ordinateType == acceleration) return FrfQuantity::Accelerance;
    return std::nullopt;
}

/// The unit stated by ordinate and denominator.
struct StatedUnit {
    std::optional<FrfUnit> unit;       ///< nothing: none is stated
    bool is_force_assumed = false;     ///< unit stated for the motion, not for the force
    bool is_foreign = false;           ///< the stated unit is not a motion per force
    const UffAxis* unknown = nullptr;  ///< axis of a motion or force whose unit is none that is known
};

StatedUnit uffStatedUnit(const UffFunction& function)
{
    const std::string& motion = function.ordinate.unit;
    const UffAxis& per = function.denominator;
    if (per.type != 0 && per.type != force) return {{}, false, true};
    const auto perUnit = physicalUnit(per.unit);
    if (!isUnstated(per.unit) && !(perUnit && isForce(*perUnit))) {
        if (!perUnit || per.type == force) return {{}, false, false, &per};
        return {{}, false, true};
    }
    if (isUnstated(motion)) return {};
    const auto unit = physicalUnit(motion);
    const bool isOfMotion = function.ordinate.type == 0 || frfQuantityOf(function.ordinate.type);
    if (!unit && isOfMotion) return {{}, false, false, &function.ordinate};
    if (!unit) return {{}, false, true};
    if (const auto whole = frfUnit(*unit)) return {whole};
    if (!isMotion(*unit)) return {{}, false, true};
    const double scale = unit->scale / (perUnit ? perUnit->scale : 1);
    const auto quantity = frfUnit(PhysicalUnit{scale, 1, unit->time, -1});
    return {quantity, !perUnit, false};
}

/// Hz per unit of the abscissa: stated, else given, else Hz; none: it is not known.
std::optional<double> hzOf(const UffAxis& abscissa, const FrfOptions& options)
{
    const auto given = hzPerUnit(options.frequency_unit);
    if (given && (isUnstated(abscissa.unit) || !hzPerUnit(abscissa.unit))) return given;
    return hzPerUnit(abscissa.unit);
}

/// Reason why a function is not a frequency response of a motion; empty when it is.
Text whyNot(const UffFunction& function, const FrfOptions& options)
{
    const auto isRotation = [](std::int64_t direction) { return std::abs(direction) > 3; };
    if (function.function != frequencyResponse) return LT_TEXT("Engine", "another type of function");
    if (!function.isComplex()) return LT_TEXT("Engine", "real values");
    if (function.abscissa.type == timeAxis || !hzOf(function.abscissa, options))
        return LT_TEXT("Engine", "no axis of frequency");
    if (isRotation(function.response_direction) || isRotation(function.reference_direction))
        return LT_TEXT("Engine", "a rotation or a moment");
    const StatedUnit stated = uffStatedUnit(function);
    if (stated.is_foreign) return LT_TEXT("Engine", "no motion per force by its unit");
    if (stated.unknown && !frfUnit(options.frf_unit)) return LT_TEXT("Engine", "a unit that is not known");
    if (!stated.unit && !stated.unknown && !frfQuantityOf(function.ordinate.type) && function.ordinate.type != 0)
        return LT_TEXT("Engine", "no motion by its kind");
    if (function.x.empty()) return LT_TEXT("Engine", "no points");
    return {};
}

/// Counts one note per code and reason.
class Findings {
public:
    void add(const NoteCode& code, std::int64_t line, Values values, Text reason = {})
    {
        for (auto& [note, why, count] : found_)
            if (note.code == code && why == reason) {
                set(note.values, "count", ++count);
                return;
            }
        set(values, "line", line);
        set(values, "count", std::int64_t{1});
        if (!reason.empty()) set(values, "reason", reason);
        found_.push_back({{code, std::move(values)}, reason, 1});
    }

    void moveTo(Notes& notes)
    {
        for (auto& finding : found_) notes.push_back(std::move(finding.note));
    }

private:
    struct Finding {
        Note note;
        Text reason;
        std::int64_t count;
    };
    std::vector<Finding> found_;
};

/// Quantity named by a label.
std::optional<FrfQuantity> labelled(const UffFunction& function)
{
    const std::string label = lowerCase(function.ordinate.label);
    for (const FrfQuantity quantity : {FrfQuantity::Receptance, FrfQuantity::Mobility, FrfQuantity::Accelerance})
        if (label.find(quantityName(quantity)) != std::string::npos) return quantity;
    return frfQuantityOf(function.ordinate.type);
}

class Converter {
public:
    Converter(const FrfOptions& options, Findings& findings) : options_(options), findings_(findings) {}

    MeasuredFrf convert(const UffSet& set) const
    {
        const UffFunction& function = *set.function;
        const FrfUnit unit = unitOf(set);
        MeasuredFrf measured;
        measured.response_node = static_cast<int>(function.response_node);
        measured.response_direction = static_cast<int>(std::abs(function.response_direction));
        measured.reference_node = static_cast<int>(function.reference_node);
        measured.reference_direction = static_cast<int>(std::abs(function.reference_direction));
        measured.frf.name = isUnstated(function.id[0]) ? std::string() : function.id[0];
        measured.frf.quantity = unit.quantity;
        const bool turns = (function.response_direction < 0) != (function.reference_direction < 0);
        const double hz = frequencyUnitOf(set);
        for (const double x : function.x) measured.frf.frequency_hz.push_back(x * hz);
        for (const std::complex<double>& y : function.y)
            measured.frf.value.push_back(y * (turns ? -unit.scale : unit.scale));
        return measured;
    }

private:
    /// Hz per unit; whyNot() has found that there is one.
    double frequencyUnitOf(const UffSet& set) const
    {
        const UffAxis& axis = set.function->abscissa;
        const auto given = hzPerUnit(options_.frequency_unit), stated = hzPerUnit(axis.unit);
        const std::string key = frequencyUnitKey(options_.frequency_unit);
        if (given && !stated) findings_.add(notes::frfUnitReplaced, axis.line, {{"unit", axis.unit}, {"given", key}});
        if (given && stated && *given != *stated && !isUnstated(axis.unit))
            findings_.add(notes::frfUnitNotUsed, axis.line, {{"unit", axis.unit}, {"given", key}});
        return *hzOf(axis, options_);
    }

    FrfUnit unitOf(const UffSet& set) const
    {
        const UffFunction& function = *set.function;
        const StatedUnit stated = uffStatedUnit(function);
        const auto given = frfUnit(options_.frf_unit);
        if (stated.unknown) {
            findings_.add(notes::frfUnitReplaced, stated.unknown->line,
                          {{"unit", stated.unknown->unit}, {"given", frfUnitKey(options_.frf_unit)}});
            return *given;
        }
        if (stated.unit) {
            if (stated.is_force_assumed) findings_.add(notes::frfForceAssumed, set.line, {});
            const auto label = labelled(function);
            if (label && *label != stated.unit->quantity)
                findings_.add(notes::frfLabelContradictsUnit, set.line,
                              {{"label", function.ordinate.label},
                               {"unit", function.ordinate.unit},
                               {"quantity", quantityName(stated.unit->quantity)}});
            if (given && (given->quantity != stated.unit->quantity || given->scale != stated.unit->scale))
                findings_.add(notes::frfUnitNotUsed, set.line,
                              {{"unit", function.ordinate.unit}, {"given", frfUnitKey(options_.frf_unit)}});
            return *stated.unit;
        }
        const auto quantity = frfQuantityOf(function.ordinate.type);
        if (function.units && quantity)
            return {*quantity, 1000 / function.units->length_per_metre * function.units->force_per_newton};
        if (given) return *given;
        throw Error(errors::frfUnitMissing,
                    {{"line", set.line},
                     {"column", std::int64_t{1}},
                     {"found", function.ordinate.unit},
                     {"expected", LT_TEXT("Engine", "a unit of motion and force for the ordinate, or a set 164")}});
    }

    const FrfOptions& options_;
    Findings& findings_;
};

bool isSamePair(const UffFunction& function, const MeasuredFrf& measured)
{
    return function.response_node == measured.response_node && function.reference_node == measured.reference_node &&
           std::abs(function.response_direction) == measured.response_direction &&
           std::abs(function.reference_direction) == measured.reference_direction;
}

/// Attaches γ² of the same pair and lines to the response.
bool attach(const UffFunction& function, std::vector<MeasuredFrf>& measured, const FrfOptions& options)
{
    bool attached = false;
    const auto hz = hzOf(function.abscissa, options);
    for (MeasuredFrf& one : measured) {
        const std::vector<double>& lines = one.frf.frequency_hz;
        if (!hz || !isSamePair(function, one) || lines.size() != function.x.size()) continue;
        const bool same = std::equal(lines.begin(), lines.end(), function.x.begin(), [&hz](double a, double b) {
            return std::abs(a - b * *hz) <= sameFrequency * std::abs(a);
        });
        if (!same) continue;
        one.frf.coherence.clear();
        for (const std::complex<double>& y : function.y)
            one.frf.coherence.push_back(std::isfinite(y.real()) ? std::clamp(y.real(), 0.0, 1.0) : 0);
        attached = true;
    }
    return attached;
}

/// Where a unit that is not known is the reason that a function is no frequency response, frfUnitUnknown at that unit;
/// else frfNone, with the reason at the first response, or with what the file holds.
Error noResponse(const UffFile& file, const FrfOptions& options)
{
    std::string found;
    std::optional<Error> reason;
    for (const UffSet& set : file.sets) {
        if (found.size() < 100) found += (found.empty() ? "" : ", ") + set.type;
        if (!set.function) continue;
        if (found.size() < 100) found.append(":").append(std::to_string(set.function->function));
        const UffFunction& function = *set.function;
        if (function.function != frequencyResponse) continue;
        const UffAxis* unknown = hzOf(function.abscissa, options) ? uffStatedUnit(function).unknown : nullptr;
        if (function.abscissa.type == frequencyAxis && !hzOf(function.abscissa, options)) unknown = &function.abscissa;
        if (!function.isComplex()) unknown = nullptr;
        if (unknown)
            return Error(errors::frfUnitUnknown, {{"line", unknown->line},
                                                  {"column", unknown->unit_column},
                                                  {"byte", unknown->byte + unknown->unit_column - 1},
                                                  {"found", unknown->unit},
                                                  {"expected", unknown == &function.abscissa      ? expectedFrequency
                                                               : unknown == &function.denominator ? expectedForce
                                                                                                  : expectedMotion}});
        if (!reason)
            reason = Error(errors::frfNone,
                           {{"line", set.line}, {"column", std::int64_t{1}}, {"found", whyNot(function, options)}});
    }
    return reason ? *reason : Error(errors::frfNone, {{"byte", std::int64_t{0}}, {"found", found}});
}

/// What the circle of the strongest resonance says of the sign and the sense of time of a driving point.
void judgeDrivingPoint(const MeasuredFrf& measured, std::int64_t line, Findings& findings)
{
    const FrfSense sense = senseOf(measured.frf);
    const Values values{{"response", responseName(measured)}, {"frequency_hz", sense.frequency_hz}};
    if (sense.is_conjugated.value_or(false)) findings.add(notes::frfConjugated, line, values);
    if (sense.is_turned.value_or(false)) findings.add(notes::frfTurned, line, values);
    const double active_percent = activeLines_percent(measured.frf);
    if (!sense.is_conjugated && active_percent > mostActive_percent)
        findings.add(notes::frfDrivingPointSign, line,
                     {{"node", std::int64_t{measured.response_node}}, {"percent", active_percent}});
}

Value firstOrLast(const UffFunction& function, bool last)
{
    const std::complex<double>& y = last ? function.y.back() : function.y.front();
    if (function.isComplex()) return std::vector<double>{y.real(), y.imag()};
    return y.real();
}

}  // namespace

std::vector<MeasuredFrf> uffFrfs(const UffFile& file, const FrfOptions& options, Notes& notes)
{
    std::vector<MeasuredFrf> frfs;
    std::vector<std::int64_t> lines;
    Findings findings;
    for (const UffSet& set : file.sets) {
        if (!set.function || set.function->function == coherence) continue;
        if (const Text reason = whyNot(*set.function, options); !reason.empty()) {
            findings.add(notes::frfSetsSkipped, set.line, {}, reason);
            continue;
        }
        frfs.push_back(Converter(options, findings).convert(set));
        lines.push_back(set.line);
    }
    if (frfs.empty()) throw noResponse(file, options);
    for (const UffSet& set : file.sets)
        if (set.function && set.function->function == coherence && !attach(*set.function, frfs, options))
            findings.add(notes::frfCoherenceUnused, set.line, {});
    for (std::size_t k = 0; k < frfs.size(); ++k) {
        const std::int64_t dropped = dropUnusableLines(frfs[k].frf);
        if (dropped > 0) findings.add(notes::frfLinesDropped, lines[k], {{"lines", dropped}});
        try {
            requireAscending(frfs[k].frf);
        } catch (Error& error) {
            throw error.with("line", lines[k]).with("column", std::int64_t{1});
        }
        if (isDrivingPoint(frfs[k])) judgeDrivingPoint(frfs[k], lines[k], findings);
    }
    findings.moveTo(notes);
    return frfs;
}

std::string uffOrdinate(const UffFunction& function)
{
    if (function.function != frequencyResponse) return "other";
    const StatedUnit stated = uffStatedUnit(function);
    if (stated.is_foreign) return "other";
    if (stated.unit) return quantityName(stated.unit->quantity);
    const auto quantity = frfQuantityOf(function.ordinate.type);
    return quantity ? quantityName(*quantity) : "other";
}

Row uffFacts(const UffSet& set)
{
    Values cells{{"type", set.type}, {"line", set.line}};
    if (!set.function) return {cells};
    const UffFunction& function = *set.function;
    const auto word = [](const std::string& text) { return text.empty() ? Value() : Value(text); };
    cells.insert(cells.end(), {{"function", function.function},
                               {"ordinate", uffOrdinate(function)},
                               {"unit", word(function.ordinate.unit)},
                               {"denominator_unit", word(function.denominator.unit)},
                               {"points", static_cast<std::int64_t>(function.x.size())},
                               {"x_first", function.x.empty() ? Value() : Value(function.x.front())},
                               {"x_last", function.x.empty() ? Value() : Value(function.x.back())},
                               {"y_first", function.y.empty() ? Value() : firstOrLast(function, false)},
                               {"y_last", function.y.empty() ? Value() : firstOrLast(function, true)},
                               {"even", function.is_even},
                               {"data_type", std::int64_t{function.data_type}},
                               {"response_node", function.response_node},
                               {"response_direction", function.response_direction},
                               {"reference_node", function.reference_node},
                               {"reference_direction", function.reference_direction},
                               {"name", word(function.id[0])}});
    return {cells};
}

}  // namespace lathelier::io
