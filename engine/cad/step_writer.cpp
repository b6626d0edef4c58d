#include "engine/cad/step_writer.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/cad/cad_codes.h"
#include "engine/cad/step_solid.h"
#include "engine/core/units.h"
#include "engine/core/utf8.h"
#include "engine/core/version.h"
#include "engine/shaft/shaft_rules.h"
#include "engine/shaft/turned_marks.h"

namespace lathelier::cad {
namespace {

constexpr double volumeTolerance = 1e-9;
constexpr double shortest_mm = 2e-7;  ///< the kernel identifies points nearer than 1e-7 mm

/// The contour without pieces shorter than shortest_mm, and their total length.
std::pair<Contour, double> withoutTinyPieces(const Contour& closed)
{
    Contour kept;
    double dropped_mm = 0;
    for (ContourPiece piece : closed) {
        for (Eigen::Vector2d* end : {&piece.from_mm, &piece.to_mm})
            if (std::abs(end->y()) < meet_mm) end->y() = 0;
        if (!kept.empty()) piece.from_mm = kept.back().to_mm;
        const double length_mm = (piece.to_mm - piece.from_mm).norm();
        if (length_mm < shortest_mm)
            dropped_mm += length_mm;
        else
            kept.push_back(piece);
    }
    if (!kept.empty()) kept.back().to_mm = kept.front().from_mm;
    return {kept, dropped_mm};
}

std::string now()
{
    return fmt::format("{:%Y-%m-%dT%H:%M:%S}+00:00",
                       fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

void replaceAll(std::string& text, std::string_view placeholder, std::string_view value)
{
    const std::string quoted = fmt::format("'{}'", placeholder);
    const std::string written = fmt::format("'{}'", stepString(value));
    for (std::size_t at = text.find(quoted); at != std::string::npos; at = text.find(quoted, at + written.size()))
        text.replace(at, quoted.size(), written);
}

/// Whether an ASCII letter or a digit stands at this place.
bool isLetterOrDigit(std::string_view text, std::size_t at)
{
    return at < text.size() &&
           ((text[at] >= '0' && text[at] <= '9') || ((text[at] | 0x20) >= 'a' && (text[at] | 0x20) <= 'z'));
}

}  // namespace

std::string stepString(std::string_view utf8)
{
    std::string text;
    int width = 0;  // of the letters in an open directive
    const auto close = [&] {
        if (width != 0) text += "\\X0\\";
        width = 0;
    };
    for (std::size_t at = 0; at < utf8.size();) {
        const Utf8Character character = utf8At(utf8, at);
        const char32_t code = character.length == 0 ? U'?' : character.code;
        at += std::max<std::size_t>(1, character.length);
        // Some readers, the kernel's among them, end a text at a quote before a comma or bracket, doubled or not.
        if (code >= 0x20 && code < 0x7F && !(code == U'\'' && !isLetterOrDigit(utf8, at))) {
            close();
            text += static_cast<char>(code);
            if (code == U'\'' || code == U'\\') text += static_cast<char>(code);
            continue;
        }
        const int needed = code > 0xFFFF ? 4 : 2;
        if (width != needed) {
            close();
            text += needed == 4 ? "\\X4\\" : "\\X2\\";
            width = needed;
        }
        text += fmt::format("{:0{}X}", static_cast<std::uint32_t>(code), 2 * needed);
    }
    close();
    return text;
}

std::string stepText(const Shaft& shaft, const StepOptions& options, const Progress& progress)
{
    checkShaft(shaft);
    requireSolidOfRows(shaft);
    const auto [contour, dropped_mm] = withoutTinyPieces(closedContour(shaft));
    double largest_mm = 0;
    for (const ContourPiece& piece : contour) largest_mm = std::max(largest_mm, piece.to_mm.y());
    ExpectedVolume expected{volume_mm3(shaft), 0};
    expected.tolerance_mm3 = volumeTolerance * expected.volume_mm3 +
                             dropped_mm * 2 * std::numbers::pi * largest_mm * std::max(shaft.length_mm(), largest_mm);
    std::string text = revolvedStep(contour, options.schema, expected, progress);

    std::string name = options.name.empty() ? shaft.name : options.name;
    if (name.empty()) name = "shaft";
    std::string description = options.description;
    if (description.empty() && shaft.material && !shaft.material->name.empty())
        description = "material: " + shaft.material->name;
    const std::pair<const char*, std::string> texts[] = {
        {placeholders::file, name + ".step"},
        {placeholders::product, name},
        {placeholders::description, description},
        {placeholders::author, options.author},
        {placeholders::organisation, options.organisation},
        {placeholders::time, options.time_stamp.value_or(now())},
        {placeholders::system, std::string("Lathelier ") + programVersion},
        {placeholders::kernel, "Open CASCADE Technology"}};
    for (const auto& [placeholder, value] : texts) replaceAll(text, placeholder, value);
    return text;
}

}  // namespace lathelier::cad
