#include "engine/cam/post/program_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "engine/cam/plan_codes.h"

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

constexpr double kPi = 3.14159265358979323846;

/// `units` of the last of `decimals` places as text.
std::string numberText(std::int64_t units, int decimals, bool point)
{
    std::string digits = std::to_string(std::abs(units));
    if (digits.size() <= static_cast<std::size_t>(decimals))
        digits.insert(0, static_cast<std::size_t>(decimals) + 1 - digits.size(), '0');
    std::string text = digits.substr(0, digits.size() - static_cast<std::size_t>(decimals));
    std::string fraction = digits.substr(digits.size() - static_cast<std::size_t>(decimals));
    while (!fraction.empty() && fraction.back() == '0') fraction.pop_back();
    if (!fraction.empty())
        text.append(1, '.').append(fraction);
    else if (point)
        text += ".";
    if (units < 0) text.insert(text.begin(), '-');
    return text;
}

/// A word: its letter and its number. (Appended: GCC 12 warns wrongly of literal + string.)
std::string wordText(const char* letter, std::int64_t units, int decimals, bool point)
{
    std::string text(letter);
    text += numberText(units, decimals, point);
    return text;
}

std::int64_t unitsOf(double value, int decimals)
{
    return std::llround(value * std::pow(10, decimals));
}

/// Largest radius that feed moves of an operation work at.
double largestRadius_mm(const Operation& operation)
{
    double radius = 0;
    for (std::size_t i = 0; i < operation.moves.size(); ++i)
        if (operation.moves[i].kind != CutKind::Rapid) {
            radius = std::max(radius, operation.moves[i].to.y());
            if (i > 0 && operation.kind != OperationKind::Finish && operation.kind != OperationKind::SemiFinish)
                radius = std::max(radius, std::min(operation.moves[i - 1].to.y(), operation.moves.front().to.y()));
        }
    return std::max(radius, 0.5);
}

class Writer {
public:
    Writer(const Post& post, const ProgramHead& head) : post_(post), head_(head)
    {
        x_scale_ = post.x_is_diameter ? 2 : 1;
    }

    WrittenProgram run(const std::vector<Operation>& operations)
    {
        lines(post_.program_start, false);
        for (const std::string& comment : post_.header_comments) addComment(filled(comment));
        for (const std::string& comment : head_.comments) addComment(comment);
        lines(post_.safe_start, true);
        const Operation* before = nullptr;
        for (const Operation& operation : operations) {
            tool_ = operation.tool;
            if (!before || before->tool != operation.tool) {
                if (before) lines(post_.tool_end, true);
                const bool alone = head_.has_tailstock && !post_.tool_start_tailstock.empty();
                lines(alone ? post_.tool_start_tailstock : post_.tool_start, true);
                if (operation.stops_before) stop();
                forget();
            } else if (operation.stops_before) {
                stop();
            }
            write(operation);
            before = &operation;
        }
        if (before) lines(post_.tool_end, true);
        lines(head_.has_tailstock && !post_.program_end_tailstock.empty() ? post_.program_end_tailstock
                                                                          : post_.program_end,
              false);
        return std::move(result_);
    }

private:
    void stop()
    {
        addComment("bring the tailstock");
        lines(post_.stop, true);
    }

    void write(const Operation& operation)
    {
        WrittenOperation written;
        written.first_line = line_ + 1;
        vc_ = operation.cutting_speed_m_min;
        rpm_ = operation.speed_rpm;
        if (!rpm_ && !post_.css)
            rpm_ = std::min(head_.max_rpm, std::floor(1000 * vc_ / (2 * kPi * largestRadius_mm(operation))));
        std::string name = key(operation.kind);
        std::replace(name.begin(), name.end(), '_', ' ');
        addComment(name);
        if (!operation.reason.empty()) addComment(operation.reason);
        lines(operation.speed_rpm || !post_.css ? post_.spindle_rpm : post_.spindle_css, true);
        lines(post_.coolant_on, true);
        motion_.clear();
        feed_units_ = -1;
        for (const CutMove& move : operation.moves) {
            if (move.cutting_speed_m_min && post_.css) {
                vc_ = *move.cutting_speed_m_min;
                rpm_.reset();
                lines(post_.spindle_css, true);
            } else if (move.speed_rpm && move.speed_rpm != rpm_) {
                rpm_ = move.speed_rpm;
                lines(post_.speed_change, true);
                if (post_.feed_per_min) feed_units_ = -1;
            }
            written.blocks += write(move);
        }
        result_.operations.push_back(written);
    }

    /// Number of blocks written.
    int write(const CutMove& move)
    {
        const std::int64_t x = unitsOf(x_scale_ * move.to.y(), post_.x_decimals);
        const std::int64_t z = unitsOf(-move.to.x(), post_.z_decimals);
        const bool x_moves = !is_known_ || x != x_, z_moves = !is_known_ || z != z_;
        if (!x_moves && !z_moves) return 0;
        if (move.kind == CutKind::Thread && post_.thread.empty())
            throw Error(errors::postCannot, {{"post", post_.name}, {"what", LT_TEXT("Engine", "cut threads")}});
        if (!is_known_ && head_.has_tailstock) {  // along the tailstock first, then down
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
        is_known_ = true;
    }

    std::string word(CutKind kind) const
    {
        return kind == CutKind::Rapid ? post_.rapid : kind == CutKind::Thread ? post_.thread : post_.line;
    }
    /// In every block, with four decimals: pitches of inch threads need them.
    std::string leadWord(double lead_mm)
    {
        feed_units_ = -1;
        constexpr int kDecimals = 4;
        return wordText(post_.thread_lead.c_str(), unitsOf(lead_mm, kDecimals), kDecimals, post_.decimal_point);
    }
    std::string xWord(std::int64_t units) const { return wordText("X", units, post_.x_decimals, post_.decimal_point); }
    std::string zWord(std::int64_t units) const { return wordText("Z", units, post_.z_decimals, post_.decimal_point); }

    /// Empty where a line does as well.
    std::string circleWords(const CutMove& move, std::int64_t x, std::int64_t z) const
    {
        const double x_unit = std::pow(10, -post_.x_decimals) / x_scale_, z_unit = std::pow(10, -post_.z_decimals);
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
        if (units == feed_units_ && post_.modal) return {};
        feed_units_ = units;
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
        is_known_ = false;
        motion_.clear();
    }

    std::string filled(const std::string& pattern) const
    {
        std::string text;
        for (std::size_t at = 0; at < pattern.size();) {
            const std::size_t end = pattern[at] == '{' ? pattern.find('}', at) : std::string::npos;
            if (end == std::string::npos) {
                text += pattern[at++];
                continue;
            }
            text += valueOf(pattern.substr(at + 1, end - at - 1));
            at = end + 1;
        }
        return text;
    }

    std::string valueOf(const std::string& name) const
    {
        const auto whole = [](double value) { return std::to_string(std::llround(value)); };
        if (name == "title") return commentText(post_, head_.title);
        if (name == "number") return std::to_string(head_.number);
        if (name == "tool") return std::to_string(tool_);
        if (name == "tool2") return fmt::format("{:02}", tool_);
        if (name == "max_rpm") return whole(std::floor(head_.max_rpm));
        if (name == "vc") return whole(vc_);
        if (name == "rpm") return whole(rpm_.value_or(0));
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
        if (!post_.block_numbers) return addPlain(text);
        if (number_ == 0) number_ = post_.block_numbers->start;
        std::string numbered = wordText("N", number_, 0, false);
        append(numbered, text);
        addPlain(numbered);
        number_ += post_.block_numbers->step;
        if (number_ > 99999) number_ = post_.block_numbers->step;
    }

    void addPlain(const std::string& text)
    {
        result_.text += text + post_.end_of_line;
        ++line_;
    }

    const Post& post_;
    const ProgramHead& head_;
    WrittenProgram result_;
    double x_scale_ = 2;
    std::int64_t line_ = 0;
    int number_ = 0, tool_ = 0;
    double vc_ = 0;
    std::optional<double> rpm_;
    std::string motion_;
    std::int64_t x_ = 0, z_ = 0, feed_units_ = -1;
    bool is_known_ = false;
};

}  // namespace

std::string commentText(const Post& post, const std::string& text)
{
    static constexpr std::pair<const char*, const char*> replaced[]{
        {"Ø", "D"},  {"µ", "U"},  {"·", "."},  {"×", "X"}, {"–", "-"}, {"…", "-"}, {"°", " DEG"}, {"ä", "AE"},
        {"ö", "OE"}, {"ü", "UE"}, {"ß", "SS"}, {"ą", "A"}, {"ć", "C"}, {"ę", "E"}, {"ł", "L"},    {"ń", "N"},
        {"ó", "O"},  {"ś", "S"},  {"ź", "Z"},  {"ż", "Z"}, {"Ł", "L"}, {"Ś", "S"}, {"Ż", "Z"},    {"Ó", "O"}};
    std::string ascii;
    for (std::size_t at = 0; at < text.size();) {
        const auto byte = static_cast<unsigned char>(text[at]);
        if (byte < 0x80) {
            ascii += text[at++];
            continue;
        }
        std::size_t length = 1;
        while (at + length < text.size() && (static_cast<unsigned char>(text[at + length]) & 0xC0) == 0x80) ++length;
        const std::string letter = text.substr(at, length);
        const auto* found = std::find_if(std::begin(replaced), std::end(replaced),
                                         [&](const auto& pair) { return letter == pair.first; });
        ascii += found != std::end(replaced) ? found->second : "?";
        at += length;
    }
    std::string result;
    for (const char c : ascii) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte > 0x7E || c == '%')
            result += ' ';
        else if (c == '(' || c == '[' || c == '{')
            result += '[';
        else if (c == ')' || c == ']' || c == '}')
            result += ']';
        else if (c == ';')
            result += ',';
        else
            result += static_cast<char>(std::toupper(byte));
    }
    if (result.size() > static_cast<std::size_t>(post.comment_length))
        result.resize(static_cast<std::size_t>(post.comment_length));
    return result;
}

WrittenProgram writeProgram(const Post& post, const ProgramHead& head, const std::vector<Operation>& operations)
{
    return Writer(post, head).run(operations);
}

}  // namespace lathelier::cam
