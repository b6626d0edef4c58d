#include "engine/io/text/encoding.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "engine/core/utf8.h"
#include "engine/io/io_codes.h"
#include "engine/io/text/windows1252.h"

namespace lathelier::io {
namespace {

constexpr std::size_t checkMask = 0xFFFFF;  ///< interval of progress checks, about a million characters

/// Plain replacement of a typographic blank, minus or apostrophe.
char32_t plainCharacter(char32_t c)
{
    switch (c) {
        case 0xA0:    // no-break space
        case 0x2007:  // figure space
        case 0x2009:  // thin space
        case 0x202F:  // narrow no-break space
        case 0xFEFF:  // a byte order mark in the middle of joined files
            return ' ';
        case 0x2212: return '-';
        case 0x2019: return '\'';
        default: return c;
    }
}

unsigned char byteAt(std::string_view bytes, std::size_t i)
{
    return static_cast<unsigned char>(bytes[i]);
}

/// The first byte from `i` on that is not ASCII; tested eight at a time.
std::size_t skipAscii(std::string_view bytes, std::size_t i)
{
    for (; i + 8 <= bytes.size(); i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i, 8);
        if ((word & 0x8080808080808080u) != 0) break;
    }
    while (i < bytes.size() && byteAt(bytes, i) < 0x80) ++i;
    return i;
}

struct Utf8Check {
    std::size_t bad_byte = std::string_view::npos;
    bool needs_plain = false;  ///< true: contains characters changed by plainCharacter
};

Utf8Check checkUtf8(std::string_view bytes, const Progress& progress)
{
    Utf8Check result;
    std::size_t steps = 0;
    for (std::size_t i = skipAscii(bytes, 0); i < bytes.size(); i = skipAscii(bytes, i)) {
        if ((++steps & checkMask) == 0) progress.check();
        const auto [c, length] = utf8At(bytes, i);
        if (length == 0) {
            result.bad_byte = i;
            return result;
        }
        result.needs_plain = result.needs_plain || plainCharacter(c) != c;
        i += length;
    }
    return result;
}

std::string plainUtf8(std::string_view bytes, const Progress& progress)
{
    std::string result;
    std::size_t steps = 0;
    for (std::size_t i = 0; i < bytes.size();) {
        if ((++steps & checkMask) == 0) progress.check();
        const auto [c, length] = utf8At(bytes, i);
        appendUtf8(result, plainCharacter(c));
        i += std::max<std::size_t>(length, 1);
    }
    return result;
}

/// Windows-1252, the usual encoding of "Latin-1" files: 0x80…0x9F are printable there.
std::string fromLatin1(std::string_view bytes, const Progress& progress)
{
    static const std::array<std::string, 256> written = [] {
        std::array<std::string, 256> all;
        for (char32_t c = 0; c < all.size(); ++c)
            appendUtf8(all[c], plainCharacter(c >= 0x80 && c < 0xA0 ? windows1252[c - 0x80] : c));
        return all;
    }();
    std::string result;
    result.reserve(bytes.size() + bytes.size() / 16);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if ((i & checkMask) == 0) progress.check();
        result += written[byteAt(bytes, i)];
    }
    return result;
}

std::string fromUtf16(std::string_view bytes, bool bigEndian, const Progress& progress)
{
    std::string result;
    result.reserve(bytes.size() / 2 + 16);
    const std::size_t units = bytes.size() / 2;
    const auto unit = [&](std::size_t i) {
        const char32_t first = byteAt(bytes, 2 * i);
        const char32_t second = byteAt(bytes, 2 * i + 1);
        return bigEndian ? (first << 8) | second : (second << 8) | first;
    };
    for (std::size_t i = 0; i < units; ++i) {
        if ((i & checkMask) == 0) progress.check();
        char32_t c = unit(i);
        if (c >= 0xD800 && c <= 0xDFFF) {
            const char32_t low = i + 1 < units ? unit(i + 1) : 0;
            if (c < 0xDC00 && low >= 0xDC00 && low <= 0xDFFF) {
                c = 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00);
                ++i;
            } else {
                c = 0xFFFD;
            }
        }
        appendUtf8(result, plainCharacter(c));
    }
    // Some programs end a UTF-16 file with a single-byte line feed.
    if (bytes.size() % 2 != 0) appendUtf8(result, plainCharacter(byteAt(bytes, bytes.size() - 1)));
    return result;
}

std::string fromUtf32(std::string_view bytes, bool bigEndian, const Progress& progress)
{
    std::string result;
    for (std::size_t i = 0; i + 4 <= bytes.size(); i += 4) {
        if ((i & checkMask) == 0) progress.check();
        char32_t c = 0;
        for (std::size_t k = 0; k < 4; ++k) c = (c << 8) | byteAt(bytes, bigEndian ? i + k : i + 3 - k);
        appendUtf8(result, c > 0x10FFFF || (c >= 0xD800 && c <= 0xDFFF) ? 0xFFFD : plainCharacter(c));
    }
    return result;
}

constexpr std::string_view utf32leMark("\xFF\xFE\0\0", 4);
constexpr std::string_view utf32beMark("\0\0\xFE\xFF", 4);

/// Digits in UTF-16 have a zero in every other byte.
Encoding utf16ByZeros(std::string_view bytes)
{
    const std::size_t pairs = std::min<std::size_t>(bytes.size(), 4096) / 2;
    std::size_t evenZeros = 0;
    std::size_t oddZeros = 0;
    for (std::size_t i = 0; i < pairs; ++i) {
        evenZeros += bytes[2 * i] == '\0';
        oddZeros += bytes[2 * i + 1] == '\0';
    }
    if (pairs >= 2 && oddZeros * 10 >= pairs * 8 && evenZeros * 10 <= pairs) return Encoding::Utf16le;
    if (pairs >= 2 && evenZeros * 10 >= pairs * 8 && oddZeros * 10 <= pairs) return Encoding::Utf16be;
    return Encoding::Auto;
}

std::string_view withoutFilling(std::string_view bytes)
{
    while (!bytes.empty() && (bytes.back() == '\0' || bytes.back() == '\x1a')) bytes.remove_suffix(1);
    return bytes;
}

void cutFilling(std::string& text)
{
    text.resize(withoutFilling(text).size());
}

Encoding detect(std::string_view bytes, std::size_t& mark)
{
    mark = 0;
    if (bytes.starts_with("\xEF\xBB\xBF")) return mark = 3, Encoding::Utf8;
    if (bytes.starts_with("\xFF\xFE")) return mark = 2, Encoding::Utf16le;
    if (bytes.starts_with("\xFE\xFF")) return mark = 2, Encoding::Utf16be;
    return utf16ByZeros(bytes);
}

}  // namespace

DecodedText::DecodedText(std::string_view bytes, std::string encoding) : view_(bytes), encoding_(std::move(encoding)) {}

DecodedText::DecodedText(std::string owned, std::string encoding)
    : owned_(std::move(owned)), isOwned_(true), encoding_(std::move(encoding))
{
}

DecodedText::DecodedText(DecodedText&& other) noexcept = default;
DecodedText& DecodedText::operator=(DecodedText&& other) noexcept = default;

bool hasUtf32Mark(std::string_view bytes)
{
    return bytes.starts_with(utf32leMark) || bytes.starts_with(utf32beMark);
}

bool looksLikeText(std::string_view bytes)
{
    if (hasUtf32Mark(bytes)) return true;
    std::size_t mark = 0;
    const Encoding found = detect(bytes, mark);
    if (found == Encoding::Utf16le || found == Encoding::Utf16be) return true;
    const std::string_view head = withoutFilling(bytes).substr(0, 65536);
    const auto isControl = [](char c) {
        return (static_cast<unsigned char>(c) < 0x20 && !(c >= '\t' && c <= '\r')) || c == 0x7F;
    };
    return std::none_of(head.begin(), head.end(), isControl);
}

DecodedText decodeText(std::string_view bytes, Encoding encoding, const Progress& progress)
{
    if (encoding == Encoding::Auto && hasUtf32Mark(bytes)) {
        const bool bigEndian = bytes.front() == '\0';
        std::string text = fromUtf32(bytes.substr(4), bigEndian, progress);
        cutFilling(text);
        return {std::move(text), bigEndian ? "utf-32be" : "utf-32le"};
    }
    std::size_t mark = 0;
    const Encoding found = detect(bytes, mark);
    if (encoding == Encoding::Auto) encoding = found;
    if (encoding == found) bytes.remove_prefix(mark);
    if (encoding == Encoding::Utf16le || encoding == Encoding::Utf16be) {
        const bool bigEndian = encoding == Encoding::Utf16be;
        std::string text = fromUtf16(bytes, bigEndian, progress);
        cutFilling(text);
        return {std::move(text), bigEndian ? "utf-16be" : "utf-16le"};
    }
    bytes = withoutFilling(bytes);
    if (encoding == Encoding::Latin1) return {fromLatin1(bytes, progress), "latin-1"};
    const Utf8Check check = checkUtf8(bytes, progress);
    if (check.bad_byte != std::string_view::npos) {
        if (encoding == Encoding::Utf8 && mark == 0)
            throw Error(errors::malformed, {{"byte", static_cast<std::int64_t>(check.bad_byte)},
                                            {"found", LT_TEXT("Engine", "a byte that is no UTF-8")},
                                            {"expected", LT_TEXT("Engine", "text in UTF-8")}});
        return {fromLatin1(bytes, progress), "latin-1"};
    }
    if (check.needs_plain) return {plainUtf8(bytes, progress), "utf-8"};
    return {bytes, "utf-8"};
}

std::int64_t columnAt(std::string_view line, std::size_t offset)
{
    return 1 + static_cast<std::int64_t>(countCharacters(line.substr(0, offset)));
}

std::string excerpt(std::string_view text)
{
    std::string result;
    std::size_t characters = 0;
    for (std::size_t i = 0; i < text.size() && characters < 40; ++characters) {
        const auto [c, length] = utf8At(text, i);
        appendUtf8(result, length == 0 ? char32_t{0xFFFD} : c < 0x20 || c == 0x7F ? char32_t{' '} : c);
        i += std::max<std::size_t>(length, 1);
        if (characters == 39 && i < text.size()) result += "…";
    }
    return result;
}

}  // namespace lathelier::io
