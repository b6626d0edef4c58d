#include "engine/io/frf/uff_frf.h"

#include <algorithm>
#include <cmath>

#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/frf_lines.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

constexpr std::int64_t frequencyResponse = 4, coherence = 6;
constexpr std::int64_t displacement = 8, velocity = 11, acceleration = 12, force = 13;
constexpr std::int64_t timeAxis = 17;
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
    std::optional<FrfUnit> unit;    ///< nothing: none is stated
    bool is_force_assumed = false;  ///< unit stated for the motion, not for the force
    bool is_foreign = false;        ///< the stated unit is not a motion per force
};

StatedUnit uffStatedUnit(const UffFunction& function)
{
    const std::string& motion = function.ordinate.unit;
    const std::string& per = function.denominator.unit;
    if (function.denominator.type != 0 && function.denominator.type != force) return {{}, false, true};
    const auto perUnit = physicalUnit(per);
    if (!isUnstated(per) && !(perUnit && isForce(*perUnit))) return {{}, false, true};
    if (isUnstated(motion)) return {};
    const auto unit = physicalUnit(motion);
    if (!unit) return {{}, false, true};
    if (const auto whole = frfUnit(*unit)) return {whole};
    if (!isMotion(*unit)) return {{}, false, true};
    const double scale = unit->scale / (perUnit ? perUnit->scale : 1);
    const auto quantity = frfUnit(PhysicalUnit{scale, 1, unit->time, -1});
    return {quantity, !perUnit, false};
}

/// Reason why a function is not a frequency response of a motion; empty when it is.
Text whyNot(const UffFunction& function)
{
    const auto isRotation = [](std::int64_t direction) { return std::abs(direction) > 3; };
    if (function.function != frequencyResponse) return LT_TEXT("Engine", "another type of function");
    if (!function.isComplex()) return LT_TEXT("Engine", "real values");
    if (function.abscissa.type == timeAxis || !hzPerUnit(function.abscissa.unit))
        return LT_TEXT("Engine", "no axis of frequency");
    if (isRotation(function.response_direction) || isRotation(function.reference_direction))
        return LT_TEXT("Engine", "a rotation or a moment");
    const StatedUnit stated = uffStatedUnit(function);
    if (stated.is_foreign) return LT_TEXT("Engine", "no motion per force by its unit");
    if (!stated.unit && !frfQuantityOf(function.ordinate.type) && function.ordinate.type != 0)
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
        const double hz = *hzPerUnit(function.abscissa.unit);
        for (const double x : function.x) measured.frf.frequency_hz.push_back(x * hz);
        for (const std::complex<double>& y : function.y)
            measured.frf.value.push_back(y * (turns ? -unit.scale : unit.scale));
        return measured;
    }

private:
    FrfUnit unitOf(const UffSet& set) const
    {
        const UffFunction& function = *set.function;
        const StatedUnit stated = uffStatedUnit(function);
        const auto given = frfUnit(options_.frf_unit);
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
bool attach(const UffFunction& function, std::vector<MeasuredFrf>& measured)
{
    bool attached = false;
    const auto hz = hzPerUnit(function.abscissa.unit);
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

Error noResponse(const UffFile& file)
{
    std::string found;
    for (const UffSet& set : file.sets) {
        if (found.size() > 100) break;
        if (!found.empty()) found += ", ";
        found += set.type;
        if (set.function) found.append(":").append(std::to_string(set.function->function));
    }
    return Error(errors::frfNone, {{"byte", std::int64_t{0}}, {"found", found}});
}

constexpr std::int64_t linesToOrdinate = 9, linesToDenominator = 10;  ///< from the number of a set to its axes

/// Error frfUnitUnknown at a unit that is no word known, when it alone is the reason that a function is no frequency
/// response.
void throwUnknownUnit(const UffFile& file)
{
    for (const UffSet& set : file.sets) {
        if (!set.function || set.function->function != frequencyResponse || !set.function->isComplex()) continue;
        const auto check = [&set](const UffAxis& axis, std::int64_t lines, Text expected) {
            if (isUnstated(axis.unit) || physicalUnit(axis.unit)) return;
            throw Error(errors::frfUnitUnknown, {{"line", set.line + lines},
                                                 {"column", std::int64_t{1}},
                                                 {"found", axis.unit},
                                                 {"expected", expected}});
        };
        const UffAxis& per = set.function->denominator;
        check(set.function->ordinate, linesToOrdinate, LT_TEXT("Engine", "a unit such as m/s^2, g, mm or m/s"));
        if (per.type == 0 || per.type == force)
            check(per, linesToDenominator, LT_TEXT("Engine", "a unit of force such as N, kN or lbf"));
    }
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
        if (const Text reason = whyNot(*set.function); !reason.empty()) {
            findings.add(notes::frfSetsSkipped, set.line, {}, reason);
            continue;
        }
        frfs.push_back(Converter(options, findings).convert(set));
        lines.push_back(set.line);
    }
    if (frfs.empty()) {
        throwUnknownUnit(file);
        throw noResponse(file);
    }
    for (const UffSet& set : file.sets)
        if (set.function && set.function->function == coherence && !attach(*set.function, frfs))
            findings.add(notes::frfCoherenceUnused, set.line, {});
    for (std::size_t k = 0; k < frfs.size(); ++k) {
        const std::int64_t dropped = dropUnusableLines(frfs[k].frf);
        if (dropped > 0) findings.add(notes::frfLinesDropped, lines[k], {{"lines", dropped}});
        try {
            requireAscending(frfs[k].frf);
        } catch (Error& error) {
            throw error.with("line", lines[k]).with("column", std::int64_t{1});
        }
        const double active_percent = isDrivingPoint(frfs[k]) ? activeLines_percent(frfs[k].frf) : 0;
        if (active_percent > mostActive_percent)
            findings.add(notes::frfDrivingPointSign, lines[k],
                         {{"node", std::int64_t{frfs[k].response_node}}, {"percent", active_percent}});
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
