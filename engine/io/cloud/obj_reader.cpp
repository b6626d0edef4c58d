// Wavefront OBJ: vertices, normals and polygons; appearance is ignored.
#include "engine/io/cloud/obj_reader.h"

#include <array>

#include "engine/io/cloud/mesh_faces.h"
#include "engine/io/cloud/raw_scan.h"
#include "engine/io/text/number.h"
#include "engine/io/text/number_cell.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

constexpr std::size_t mostWords = 1 << 18;  ///< in one statement, including continuation lines

class ObjBody {
public:
    ObjBody(const ScanSource& source, RawScan& raw)
        : text_(source.text), lines_(source.text), numbers_(source), progress_(source.progress), raw_(raw)
    {
    }

    void read()
    {
        while (nextStatement()) {
            if ((lines_.number() & 0x3FFF) == 0) progress_.check();
            const std::string_view key = words_[0];
            if (key.front() == '#')
                readRemark();
            else if (key == "v")
                readVertex();
            else if (key == "vn")
                normals_.push_back(readVector().cast<float>());
            else if (key == "f" || key == "fo")
                faces_.push_back({corners_.size(), addCorners(), lines_.number()});
            else if (!isPassedOver(key))
                throw malformed(lines_.number(), lines_.line(), key,
                                LT_TEXT("Engine", "an OBJ keyword such as v or f"));
        }
        for (const Face& face : faces_)
            addPolygon(raw_.scan, std::span(corners_).subspan(face.begin, face.count),
                       {{"line", face.line}, {"column", std::int64_t{1}}});
        if (normalsFollowVertices_ && normals_.size() == raw_.scan.points_mm.size())
            raw_.scan.normals = std::move(normals_);
        raw_.facts.rows = static_cast<std::int64_t>(raw_.scan.points_mm.size());
        raw_.facts.decimal = numbers_.decimalName();
        raw_.places.find = [text = text_, decimal = numbers_.decimal()](double largest) {
            return placeOfLarge(text, "v", decimal, largest);
        };
    }

private:
    struct Face {
        std::size_t begin;
        std::size_t count;
        std::int64_t line;
    };

    static bool isPassedOver(std::string_view key)
    {
        for (const char* known :
             {"vt",       "vp",       "g",      "o",          "s",         "l",     "p",     "usemtl", "mtllib",
              "usemap",   "maplib",   "cstype", "deg",        "bmat",      "step",  "curv",  "curv2",  "surf",
              "parm",     "trim",     "hole",   "scrv",       "sp",        "end",   "con",   "mg",     "bevel",
              "c_interp", "d_interp", "lod",    "shadow_obj", "trace_obj", "ctech", "stech", "call",   "csh"})
            if (key == known) return true;
        return false;
    }

    /// Goes to the next non-blank line; a backslash continues the line.
    bool nextStatement()
    {
        do {
            if (!lines_.next()) return false;
            splitWords(lines_.line(), words_);
            std::vector<std::string_view> more;
            while (!words_.empty() && words_.back().ends_with('\\') && words_[0].front() != '#') {
                words_.back().remove_suffix(1);
                if (words_.back().empty()) words_.pop_back();
                if (!lines_.next()) break;
                if (words_.size() > mostWords) throw broken(0, LT_TEXT("Engine", "a shorter statement"));
                splitWords(lines_.line(), more);
                words_.insert(words_.end(), more.begin(), more.end());
                if (more.empty()) break;
            }
        } while (words_.empty());
        return true;
    }

    void readRemark()
    {
        if (!raw_.stated_unit) raw_.stated_unit = statedUnit(lines_.line());
        ++raw_.skipped_count;
        if (raw_.facts.skipped.size() < 100)
            raw_.facts.skipped.push_back({lines_.number(), LT_TEXT("Engine", "remark")});
    }

    /// The place of word `i`; a statement over several lines is placed at its last line.
    Error broken(std::size_t i, Text expected) const
    {
        const std::string_view line = lines_.line();
        if (i < words_.size() && words_[i].data() >= line.data() && words_[i].data() <= line.data() + line.size())
            return malformed(lines_.number(), line, words_[i], expected);
        return malformed(lines_.number(), line, line.substr(line.size()), expected);
    }

    double number(std::size_t i)
    {
        if (i >= words_.size()) throw broken(i, LT_TEXT("Engine", "a number"));
        // The number reader needs the line that contains the word, which differs for a continued statement.
        const std::string_view line = lines_.line();
        const bool inLine =
            words_[i].data() >= line.data() && words_[i].data() + words_[i].size() <= line.data() + line.size();
        return numbers_.read(lines_.number(), inLine ? line : words_[i], words_[i]);
    }

    Eigen::Vector3d readVector() { return {number(1), number(2), number(3)}; }

    void readVertex()
    {
        if (raw_.places.first_line == 0) raw_.places.first_line = lines_.number();
        raw_.scan.points_mm.push_back(readVector());
        // x y z, with a weight or a colour behind
        if (words_.size() > 8) throw broken(8, LT_TEXT("Engine", "the end of the line"));
        for (std::size_t i = 4; i < words_.size(); ++i) number(i);
        raw_.facts.columns = std::max<std::int64_t>(raw_.facts.columns, static_cast<std::int64_t>(words_.size()) - 1);
    }

    /// From 0; a negative index counts back from the last vertex so far.
    std::int64_t resolve(std::size_t word, std::string_view text, std::size_t count) const
    {
        const auto index = wholeInteger(text);
        if (!index || *index == 0) throw broken(word, LT_TEXT("Engine", "the index of a vertex"));
        return *index > 0 ? *index - 1 : *index + static_cast<std::int64_t>(count);
    }

    /// The corners of a face: v, v/vt, v/vt/vn or v//vn. Returns their number.
    std::size_t addCorners()
    {
        if (words_.size() < 4) throw broken(words_.size(), LT_TEXT("Engine", "three corners or more"));
        for (std::size_t i = 1; i < words_.size(); ++i) {
            const std::string_view word = words_[i];
            const std::size_t slash = word.find('/');
            const std::size_t second = slash == std::string_view::npos ? slash : word.find('/', slash + 1);
            corners_.push_back(resolve(i, word.substr(0, slash), raw_.scan.points_mm.size()));
            const bool hasNormal = second != std::string_view::npos;
            const std::int64_t normal =
                hasNormal ? resolve(i, word.substr(second + 1), normals_.size()) : corners_.back();
            normalsFollowVertices_ = normalsFollowVertices_ && normal == corners_.back();
        }
        return words_.size() - 1;
    }

    std::string_view text_;
    Lines lines_;
    NumberCells numbers_;
    const Progress& progress_;
    RawScan& raw_;
    std::vector<Eigen::Vector3f> normals_;
    std::vector<std::int64_t> corners_;
    std::vector<Face> faces_;
    bool normalsFollowVertices_ = true;  ///< vertex and normal indices are equal throughout
    std::vector<std::string_view> words_;
};

}  // namespace

RawScan readObj(const ScanSource& source)
{
    RawScan raw;
    raw.facts.format = "obj";
    raw.facts.encoding = source.encoding;
    raw.facts.delimiter = "space";
    ObjBody(source, raw).read();
    return raw;
}

}  // namespace lathelier::io
