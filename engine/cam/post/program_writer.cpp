#include "engine/cam/post/program_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/cam/plan_codes.h"
#include "engine/cam/post/cut_off_stop.h"
#include "engine/cam/post/word_text.h"
#include "engine/cam/work_frame.h"

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

constexpr int largestBlockNumber = 99999;  // of a block number
constexpr int cycleDecimals = 3;

class Writer {
public:
    Writer(const Post& post, const ProgramHead& head) : post_(post), head_(head)
    {
        xScale_ = post.x_is_diameter ? 2 : 1;
    }

    WrittenProgram run(const std::vector<Operation>& operations)
    {
        lines(post_.program_start, false);
        for (const std::string& comment : post_.header_comments) addComment(filled(comment));
        for (const std::string& comment : head_.comments) addComment(comment);
        lines(post_.safe_start, true);
        if (head_.states_offset) lines(statedOffset(post_), true);
        if (head_.cut_off_mm) stop(cutOffComment(*head_.cut_off_mm));
        findCycle(operations);
        const Operation* before = nullptr;
        for (std::size_t i = 0; i < operations.size(); ++i) {
            const Operation& operation = operations[i];
            tool_ = operation.tool;
            if (!before || before->tool != operation.tool) {
                if (before) lines(post_.tool_end, true);
                callTool(before != nullptr);
                if (operation.stops_before) stop();
                forget();
            } else if (operation.stops_before) {
                stop();
            }
            write(operation, i);
            before = &operation;
        }
        if (before) lines(post_.tool_end, true);
        lines(head_.has_tailstock && !post_.program_end_tailstock.empty() ? post_.program_end_tailstock
                                                                          : post_.program_end,
              false);
        return std::move(result_);
    }

private:
    void stop(const std::string& what = "bring the tailstock")
    {
        addComment(what);
        lines(post_.stop, true);
    }

    /// An optional stop stands where the tool before is at the change point.
    void callTool(bool is_further)
    {
        const bool alone = head_.has_tailstock && !post_.tool_start_tailstock.empty();
        const Templates& templates = alone ? post_.tool_start_tailstock : post_.tool_start;
        const auto call = templates.begin() + linesBeforeTool(templates);
        lines({templates.begin(), call}, true);
        if (is_further && head_.has_optional_stops) lines(optionalStop(post_), true);
        lines({call, templates.end()}, true);
    }

    void findCycle(const std::vector<Operation>& operations)
    {
        if (!head_.cycles) return;
        if (post_.rough_cycle.empty())
            throw Error(errors::postCannot,
                        {{"post", post_.name}, {"what", LT_TEXT("Engine", "rough in a cycle (G71)")}});
        auto found = roughingCycle(operations, *head_.cycles);
        if (const Text* const reason = std::get_if<Text>(&found))
            result_.no_cycle = *reason;
        else
            cycle_ = std::get<RoughingCycle>(std::move(found));
        hasCycle_ = !result_.no_cycle;
        cycle_.has_finish = cycle_.has_finish && !post_.finish_cycle.empty();
    }

    void write(const Operation& operation, std::size_t index)
    {
        WrittenOperation written;
        written.first_line = line_ + 1;
        if (hasCycle_ && index == cycle_.semi_finish) {  // part of the cycle
            result_.operations.push_back(written);
            return;
        }
        vc_ = operation.cutting_speed_m_min;
        rpm_ = operation.speed_rpm;
        if (!rpm_ && !post_.css)
            rpm_ =
                std::min(head_.max_rpm, std::floor(1000 * vc_ / (2 * std::numbers::pi * largestRadius_mm(operation))));
        std::string name = key(operation.kind);
        std::replace(name.begin(), name.end(), '_', ' ');
        addComment(name);
        if (!operation.reason.empty()) addComment(operation.reason);
        lines(operation.speed_rpm || !post_.css ? post_.spindle_rpm : post_.spindle_css, true);
        lines(post_.coolant_on, true);
        motion_.clear();
        feedUnits_ = -1;
        if (hasCycle_ && index == cycle_.rough && !numbersSuffice()) {
            hasCycle_ = false;
            result_.no_cycle = LT_TEXT("Engine", "the numbers of blocks begin anew within it");
        }
        if (hasCycle_ && index == cycle_.rough)
            written.blocks = writeRoughCycle();
        else if (hasCycle_ && index == cycle_.finish && cycle_.has_finish)
            writeFinishCycle(written);
        else
            written.blocks = writeAll(operation.moves);
        result_.operations.push_back(written);
    }

    /// Number of blocks written.
    std::int64_t writeAll(const std::vector<CutMove>& moves)
    {
        std::int64_t blocks = 0;
        for (const CutMove& move : moves) {
            if (move.cutting_speed_m_min && post_.css) {
                vc_ = *move.cutting_speed_m_min;
                rpm_.reset();
                lines(post_.spindle_css, true);
            } else if (move.speed_rpm && move.speed_rpm != rpm_) {
                rpm_ = move.speed_rpm;
                lines(post_.speed_change, true);
                if (post_.feed_per_min) feedUnits_ = -1;
            }
            blocks += write(move);
        }
        return blocks;
    }

    CutMove safe() const { return {CutKind::Rapid, {cycle_.start_z_mm, cycle_.safe_x_mm}}; }

    std::int64_t writeRoughCycle()
    {
        const CutMove start{CutKind::Rapid, {cycle_.start_z_mm, cycle_.start_x_mm}};
        std::int64_t blocks = writeAll({safe(), start});
        // The templates need the block numbers of the contour, so the cycle is written twice.
        Writer trial = *this;
        trial.writeContour();
        firstBlock_ = trial.firstBlock_;
        lastBlock_ = trial.lastBlock_;
        blocks += writeContour();
        blocks += writeAll({start, safe()});
        return blocks;
    }

    std::int64_t writeContour()
    {
        lines(post_.rough_cycle, true);
        contourFirstLine_ = line_ + 1;
        firstBlock_ = numberOfNext(1);
        const std::int64_t x = unitsOf(xScale_ * cycle_.contour.front().to.y(), post_.x_decimals);
        std::string down = post_.rapid;  // X alone, even where unchanged words are repeated
        append(down, xWord(x));
        add(down);
        remember(x, z_);
        motion_ = post_.rapid;
        std::int64_t blocks = 1;
        const std::vector<CutMove> rest(cycle_.contour.begin() + 1, cycle_.contour.end() - 1);
        blocks += writeAll(rest);
        lastBlock_ = numberOfNext(2);
        blocks += writeAll({cycle_.contour.back()});
        contourLastLine_ = line_;
        // After the cycle the tool is at its start point.
        remember(unitsOf(xScale_ * cycle_.start_x_mm, post_.x_decimals), unitsOf(-cycle_.start_z_mm, post_.z_decimals));
        motion_.clear();
        feedUnits_ = -1;
        return blocks;
    }

    bool numbersSuffice() const
    {
        constexpr int furtherBlocks = 20;
        const auto blocks = static_cast<std::int64_t>(2 * cycle_.contour.size() + post_.rough_cycle.size());
        return !post_.block_numbers ||
               number_ + post_.block_numbers->step * (blocks + furtherBlocks) <= largestBlockNumber;
    }

    /// Without block numbering only the first and last contour blocks are numbered.
    int numberOfNext(int otherwise)
    {
        if (post_.block_numbers) return number_ == 0 ? post_.block_numbers->start : number_;
        nextNumber_ = otherwise;
        return otherwise;
    }

    void writeFinishCycle(WrittenOperation& written)
    {
        written.blocks = writeAll(cycle_.before);
        lines(post_.finish_cycle, true);
        written.contour_first_line = contourFirstLine_;
        written.contour_last_line = contourLastLine_;
        motion_.clear();
        feedUnits_ = -1;
        written.blocks += writeAll({safe()});
    }

    /// Number of blocks written.
    int write(const CutMove& move)
    {
        const std::int64_t x = unitsOf(xScale_ * move.to.y(), post_.x_decimals);
        const std::int64_t z = unitsOf(-move.to.x(), post_.z_decimals);
        const bool x_moves = !isKnown_ || x != x_, z_moves = !isKnown_ || z != z_;
        if (!x_moves && !z_moves) return 0;
        if (move.kind == CutKind::Thread && post_.thread.empty())
            throw Error(errors::postCannot, {{"post", post_.name}, {"what", LT_TEXT("Engine", "cut threads")}});
        if (!isKnown_ && head_.has_tailstock) {  // along the tailstock first, then down
            add(word(move.kind) + zWord(z));
            add(xWord(x));
            motion_ = post_.rapid;
            return remember(x, z), 2;
        }
        std::string text;
        const std::string circle = move.kind == CutKind::Arc ? circleWords(move, x, z) : std::string();
        const CutKind kind = move.kind == CutKind::Arc && circle.empty() ? CutKind::Line : move.kind;
        const std::string motion = kind == CutKind::Arc ? (move.clockwise ? post_.arc_cw : post_.arc_ccw) : word(kind);
        if (motion != motion_ || !post_.modal) text += motion;
        if (x_moves || !post_.modal) append(text, xWord(x));
        if (z_moves || !post_.modal) append(text, zWord(z));
        if (kind == CutKind::Arc) append(text, circle);
        if (kind == CutKind::Thread)
            append(text, leadWord(move.feed_mm_rev));
        else if (kind != CutKind::Rapid)
            append(text, feedWord(move.feed_mm_rev));
        motion_ = motion;
        add(text);
        return remember(x, z), 1;
    }

    void remember(std::int64_t x, std::int64_t z)
    {
        x_ = x;
        z_ = z;
        isKnown_ = true;
    }

    std::string word(CutKind kind) const
    {
        return kind == CutKind::Rapid ? post_.rapid : kind == CutKind::Thread ? post_.thread : post_.line;
    }
    /// Repeated in every block, with four decimals: pitches of inch threads need them.
    std::string leadWord(double lead_mm)
    {
        feedUnits_ = -1;
        constexpr int leadDecimals = 4;
        return wordText(post_.thread_lead.c_str(), unitsOf(lead_mm, leadDecimals), leadDecimals, post_.decimal_point);
    }
    std::string xWord(std::int64_t units) const { return wordText("X", units, post_.x_decimals, post_.decimal_point); }
    std::string zWord(std::int64_t units) const { return wordText("Z", units, post_.z_decimals, post_.decimal_point); }

    /// Empty where a line is sufficient.
    std::string circleWords(const CutMove& move, std::int64_t x, std::int64_t z) const
    {
        const double x_unit = std::pow(10, -post_.x_decimals) / xScale_, z_unit = std::pow(10, -post_.z_decimals);
        const Vector2d from(static_cast<double>(z_) * z_unit, static_cast<double>(x_) * x_unit);
        const Vector2d to(static_cast<double>(z) * z_unit, static_cast<double>(x) * x_unit);
        const double radius = (move.centre - move.to).norm(), chord = (to - from).norm();
        const double sagitta = radius - std::sqrt(std::max(0.0, radius * radius - chord * chord / 4));
        if (sagitta < z_unit / 2) return {};
        if (post_.arc != ArcWords::CentreOffsets) {
            // The control needs a radius of at least half the chord.
            const std::int64_t least = static_cast<std::int64_t>(std::ceil(chord / 2 / z_unit - 1e-6));
            return wordText(post_.arc == ArcWords::Radius ? "R" : "CR=",
                            std::max(unitsOf(radius, post_.z_decimals), least), post_.z_decimals, post_.decimal_point);
        }
        // I counts radii, with as many decimals as X.
        const std::int64_t i = unitsOf(move.centre.y() - from.y(), post_.x_decimals);
        const std::int64_t k = unitsOf(-move.centre.x() - from.x(), post_.z_decimals);
        std::string text = wordText("I", i, post_.x_decimals, post_.decimal_point);
        append(text, wordText("K", k, post_.z_decimals, post_.decimal_point));
        return text;
    }

    std::string feedWord(double feed_mm_rev)
    {
        double feed = feed_mm_rev;
        if (post_.feed_per_min) {
            if (!rpm_)
                throw Error(errors::postCannot,
                            {{"post", post_.name},
                             {"what", LT_TEXT("Engine", "state a feed per minute without a fixed speed")}});
            feed *= *rpm_;
        }
        const std::int64_t units = unitsOf(feed, post_.f_decimals);
        if (units == feedUnits_ && post_.modal) return {};
        feedUnits_ = units;
        return wordText("F", units, post_.f_decimals, post_.decimal_point);
    }

    static void append(std::string& text, const std::string& words)
    {
        if (words.empty()) return;
        if (!text.empty()) text += ' ';
        text += words;
    }

    void forget()
    {
        isKnown_ = false;
        motion_.clear();
    }

    std::string filled(const std::string& pattern) const
    {
        return filledTemplate(pattern, [this](const std::string& name) { return valueOf(name); });
    }

    std::string valueOf(const std::string& name) const
    {
        const auto whole = [](double value) { return std::to_string(std::llround(value)); };
        if (name == "title") return commentText(post_, head_.title);
        if (name == "number") return std::to_string(head_.number);
        if (name == "tool") return std::to_string(tool_);
        if (name == "tool2") return twoDigits(post_, tool_);
        if (name == "max_rpm") return whole(std::floor(head_.max_rpm));
        if (name == "vc") return whole(vc_);
        if (name == "rpm") return whole(rpm_.value_or(0));
        return hasCycle_ ? valueOfCycle(name) : std::string();
    }

    std::string valueOfCycle(const std::string& name) const
    {
        const auto length = [this](double value_mm, int decimals) {
            return numberText(unitsOf(value_mm, decimals), decimals, post_.decimal_point);
        };
        if (name == "first") return std::to_string(firstBlock_);
        if (name == "last") return std::to_string(lastBlock_);
        if (name == "depth") return length(cycle_.depth_mm, cycleDecimals);
        if (name == "retract") return length(retract_mm, cycleDecimals);
        if (name == "x_allowance") return length(xScale_ * head_.cycles->allowance_mm, cycleDecimals);
        if (name == "z_allowance") return length(head_.cycles->allowance_mm, cycleDecimals);
        if (name == "feed")
            return length(cycle_.feed_mm_rev * (post_.feed_per_min ? rpm_.value_or(0) : 1), post_.f_decimals);
        return {};
    }

    void lines(const Templates& templates, bool numbered)
    {
        for (const std::string& pattern : templates) numbered ? add(filled(pattern)) : addPlain(filled(pattern));
    }

    void addComment(const std::string& text)
    {
        addPlain(post_.comment_open + commentText(post_, text) + post_.comment_close);
    }

    void add(const std::string& text)
    {
        if (!post_.block_numbers && nextNumber_ == 0) return addPlain(text);
        if (!post_.block_numbers) {
            std::string numbered = wordText("N", std::exchange(nextNumber_, 0), 0, false);
            append(numbered, text);
            return addPlain(numbered);
        }
        if (number_ == 0) number_ = post_.block_numbers->start;
        std::string numbered = wordText("N", number_, 0, false);
        append(numbered, text);
        addPlain(numbered);
        number_ += post_.block_numbers->step;
        if (number_ > largestBlockNumber) number_ = post_.block_numbers->step;
    }

    void addPlain(const std::string& text)
    {
        result_.text += text + post_.end_of_line;
        ++line_;
    }

    const Post& post_;
    const ProgramHead& head_;
    WrittenProgram result_;
    double xScale_ = 2;
    std::int64_t line_ = 0;
    int number_ = 0, tool_ = 0;
    RoughingCycle cycle_;
    bool hasCycle_ = false;
    int nextNumber_ = 0, firstBlock_ = 0, lastBlock_ = 0;
    std::int64_t contourFirstLine_ = 0, contourLastLine_ = 0;
    double vc_ = 0;
    std::optional<double> rpm_;
    std::string motion_;
    std::int64_t x_ = 0, z_ = 0, feedUnits_ = -1;
    bool isKnown_ = false;
};

}  // namespace

WrittenProgram writeProgram(const Post& post, const ProgramHead& head, const std::vector<Operation>& operations)
{
    return Writer(post, head).run(operations);
}

}  // namespace lathelier::cam
