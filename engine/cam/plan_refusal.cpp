#include "engine/cam/plan_refusal.h"

#include <algorithm>

#include "engine/cam/check/check_quantities.h"
#include "engine/cam/plan_codes.h"

namespace lathelier::cam {
namespace {

constexpr const char* stopBlock = "M0 M30";  // a control either stops and ends here or rejects the block

const Operation* movesAt(const SetupPlan& setup, std::int64_t line)
{
    const PlannedOperation* operation = operationAt(setup, line);
    if (!operation) return nullptr;
    const auto index = static_cast<std::size_t>(operation - setup.operations.data());
    return index < setup.moves.size() ? &setup.moves[index] : nullptr;
}

DroppedOperation droppedFor(CheckKind kind)
{
    DroppedOperation dropped;
    switch (kind) {
        case CheckKind::Chuck:
            dropped.cause = RestCause::Chuck;
            dropped.reason = LT_TEXT("Engine", "it would meet the chuck");
            break;
        case CheckKind::Tailstock:
            dropped.cause = RestCause::Tailstock;
            dropped.reason = LT_TEXT("Engine", "it would meet the tailstock");
            break;
        case CheckKind::HolderInStock:
            dropped.cause = RestCause::Holder;
            dropped.reason = LT_TEXT("Engine", "its holder would meet the stock");
            break;
        case CheckKind::InsertBelowDrawing:
            dropped.cause = RestCause::BackAngle;
            dropped.reason = LT_TEXT("Engine", "its insert would cut into the drawing");
            break;
        default:
            dropped.cause = RestCause::Holder;
            dropped.reason = LT_TEXT("Engine", "it would meet the stock on its way there");
    }
    return dropped;
}

/// Of the operation, else of the move that the line makes.
Value toolAt(const SetupPlan& setup, std::int64_t line)
{
    if (const PlannedOperation* operation = operationAt(setup, line)) return std::int64_t{operation->tool};
    for (const gcode::Move& move : setup.check.path.moves)
        if (move.line == line && move.tool != 0) return std::int64_t{move.tool};
    return {};
}

Row rowOf(const CheckFinding& finding, const SetupPlan& setup, std::size_t index)
{
    Row row{describedValues(finding)};
    row.cells.emplace_back("setup", static_cast<std::int64_t>(index) + 1);
    const PlannedOperation* operation = operationAt(setup, finding.line);
    row.cells.emplace_back("operation", operation ? Value(std::string(key(operation->kind))) : Value());
    row.cells.emplace_back("tool", toolAt(setup, finding.line));
    return row;
}

}  // namespace

const PlannedOperation* operationAt(const SetupPlan& setup, std::int64_t line)
{
    for (std::size_t i = 0; i < setup.operations.size(); ++i) {
        const std::int64_t next = i + 1 < setup.operations.size() ? setup.operations[i + 1].first_line : INT64_MAX;
        if (setup.operations[i].first_line > 0 && setup.operations[i].holds(line, next)) return &setup.operations[i];
    }
    return nullptr;
}

std::vector<DroppedOperation> faultyRestOperations(const TurningPlan& plan)
{
    std::vector<DroppedOperation> all;
    for (std::size_t i = 0; i < plan.setups.size(); ++i)
        for (const CheckFinding& finding : plan.setups[i].check.findings) {
            const Operation* operation = movesAt(plan.setups[i], finding.line);
            if (!operation || !operation->rest_z_start_mm) continue;
            const int setup = static_cast<int>(i) + 1;
            const bool is_known = std::any_of(all.begin(), all.end(), [&](const DroppedOperation& other) {
                return other.setup == setup && other.tool == operation->tool &&
                       other.z_start_mm == *operation->rest_z_start_mm;
            });
            if (is_known) continue;
            DroppedOperation dropped = droppedFor(finding.kind);
            dropped.setup = setup;
            dropped.tool = operation->tool;
            dropped.z_start_mm = *operation->rest_z_start_mm;
            all.push_back(dropped);
        }
    return all;
}

void throwIfRefused(const TurningPlan& plan)
{
    if (!plan.is_refused) return;
    Rows findings;
    std::int64_t count = 0;
    double gouge = 0;
    Values first;
    for (std::size_t i = 0; i < plan.setups.size(); ++i) {
        const SetupPlan& setup = plan.setups[i];
        const CheckResult& check = setup.check;
        for (const gcode::Diagnostic& diagnostic : check.path.diagnostics)
            if (diagnostic.error) throw Error(*diagnostic.error);
        gouge = std::max(gouge, check.gouge_um);
        for (const CheckFinding& finding : check.findings) {
            if (first.empty()) {
                const PlannedOperation* operation = operationAt(setup, finding.line);
                const Text other = LT_TEXT("Engine", "a move that was not planned");
                first = {{"operation", operation ? nameOf(operation->kind) : other},
                         {"tool", toolAt(setup, finding.line)},
                         {"kind", nameOf(finding.kind)},
                         {"z_mm", finding.z_mm},
                         {"program_line", finding.line},
                         {"setup", static_cast<std::int64_t>(i) + 1}};
            }
            findings.rows.push_back(rowOf(finding, setup, i));
            ++count;
        }
    }
    Values values{{"count", count}, {"gouge_um", gouge}};
    values.insert(values.end(), first.begin(), first.end());
    values.emplace_back("findings", findings);
    throw Error(errors::programRefused, values);
}

std::string stoppedText(const std::string& program)
{
    std::string text = program;
    const auto stop = [&text](std::size_t from) {
        std::size_t end = std::min(text.find('\n', from), text.size());
        if (end > from && text[end - 1] == '\r') --end;
        text.replace(from, end - from, stopBlock);
        return text.find('\n', from);
    };
    const bool is_tape = !text.empty() && text.front() == '%';
    const std::size_t end = stop(0);
    if (is_tape && end != std::string::npos) stop(end + 1);
    return text;
}

std::string refusedPath(const std::string& path)
{
    return path + ".refused";
}

}  // namespace lathelier::cam
