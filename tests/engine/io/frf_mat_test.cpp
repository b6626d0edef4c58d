// MAT files of level 5, made byte by byte.
#include <gtest/gtest.h>
#include <zlib.h>

#include <random>

#include "engine/io/file_kind.h"
#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/mat_file.h"
#include "tests/engine/io/frf_files.h"
#include "tests/engine/io/reading.h"

namespace lathelier {
namespace {

using testing::rawBytes;

/// Writes MAT files in either byte order.
struct MatText {
    bool big = false;
    bool compressed = false;
    bool stored_small = false;  ///< real doubles as int16, as MATLAB does
    std::string bytes;

    MatText(bool isBig, bool isCompressed, bool isSmall) : big(isBig), compressed(isCompressed), stored_small(isSmall)
    {
        bytes = "MATLAB 5.0 MAT-file, made by a test";
        bytes.resize(124, ' ');
        bytes += rawBytes<std::uint16_t>(0x0100, big) + (big ? "MI" : "IM");
    }

    std::string element(std::uint32_t type, std::string data) const
    {
        const auto size = static_cast<std::uint32_t>(data.size());
        data.resize((data.size() + 7) / 8 * 8, '\0');
        return rawBytes(type, big) + rawBytes(size, big) + data;
    }

    std::string numbers(const std::vector<double>& values) const
    {
        std::string data;
        for (const double value : values)
            data += stored_small ? rawBytes(static_cast<std::int16_t>(value), big) : rawBytes(value, big);
        return element(stored_small ? 3 : 9, data);
    }

    void add(const std::string& name, const std::vector<double>& re, const std::vector<double>& im = {})
    {
        const std::uint32_t flags = 6U | (im.empty() ? 0U : 0x800U);
        std::string matrix =
            element(6, rawBytes(flags, big) + rawBytes<std::uint32_t>(0, big)) +
            element(5, rawBytes(static_cast<std::int32_t>(re.size()), big) + rawBytes<std::int32_t>(1, big));
        if (name.size() <= 4) {  // a small element
            std::string padded = name;
            padded.resize(4, '\0');
            matrix += rawBytes(static_cast<std::uint32_t>(name.size()) << 16U | 1U, big) + padded;
        } else {
            matrix += element(1, name);
        }
        matrix += numbers(re);
        if (!im.empty()) matrix += numbers(im);
        const std::string whole = element(14, matrix);
        if (!compressed) {
            bytes += whole;
            return;
        }
        std::string packed(compressBound(whole.size()), '\0');
        uLongf size = packed.size();
        ASSERT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(whole.data()),
                           whole.size()),
                  Z_OK);
        packed.resize(size);
        bytes += rawBytes<std::uint32_t>(15, big) + rawBytes(static_cast<std::uint32_t>(size), big) + packed;
    }
};

std::string plainFile(bool big = false, bool compressed = false, bool small = false)
{
    MatText mat(big, compressed, small);
    mat.add("freq", {10, 20, 30});
    mat.add("H", {1, 2, 3}, {-4, -5, -6});
    mat.add("comment_values", {1, 2});
    return mat.bytes;
}

io::FrfFile readMat(const std::string& bytes, const std::string& variables = {})
{
    return io::readFrf("test.mat", bytes, {}, {io::FrfUnitChoice::MPerN, variables});
}

ErrorCode codeOf(const std::string& bytes, const io::FrfOptions& options)
{
    try {
        io::readFrf("test.mat", bytes, {}, options);
    } catch (const Error& error) {
        EXPECT_TRUE(find(error.values(), "path"));
        EXPECT_TRUE(find(error.values(), "byte"));
        return error.code();
    }
    ADD_FAILURE() << "no error";
    return errors::unknownOption;
}

TEST(FrfMat, readsVectorsInAnyForm)
{
    for (const bool big : {false, true})
        for (const bool compressed : {false, true})
            for (const bool small : {false, true}) {
                const Frf frf = readMat(plainFile(big, compressed, small)).frfs.at(0).frf;
                EXPECT_EQ(frf.frequency_hz, (std::vector<double>{10, 20, 30}));
                ASSERT_EQ(frf.value.size(), 3U);
                EXPECT_EQ(frf.value[1], std::complex<double>(2000, -5000));
            }
}

TEST(FrfMat, variablesAreListed)
{
    Notes notes;
    const io::FileFacts facts = io::readFrfFacts("test.mat", plainFile(), {}, {}, notes);
    EXPECT_EQ(facts.format, "MAT");
    const auto& rows = std::get<Rows>(*find(facts.details, "variables")).rows;
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(std::get<std::string>(*find(rows[1].cells, "name")), "H");
    EXPECT_EQ(std::get<std::int64_t>(*find(rows[1].cells, "rows")), 3);
    EXPECT_EQ(std::get<std::string>(*find(rows[1].cells, "class")), "double");
    EXPECT_TRUE(std::get<bool>(*find(rows[1].cells, "complex")));
    EXPECT_EQ(io::likeliestKind({&io::scanFiles(), &io::frfFiles()}, "x", plainFile(), {}).kind->key, "frf");
}

TEST(FrfMat, unitAndVariablesMayHaveToBeGiven)
{
    EXPECT_EQ(codeOf(plainFile(), {}), errors::frfUnitMissing);
    MatText mat(false, false, false);
    mat.add("axis", {10, 20});
    mat.add("one", {1, 2}, {3, 4});
    mat.add("two", {5, 6}, {7, 8});
    EXPECT_EQ(codeOf(mat.bytes, {io::FrfUnitChoice::MPerN, {}}), errors::frfVariablesUnknown);
    EXPECT_EQ(readMat(mat.bytes, "f=axis, H=two").frfs.at(0).frf.value[0], std::complex<double>(5000, 7000));
    for (const char* wrong : {"f=axis", "axis,two", "f=axis,H=three", "f=one,H=two", "H=,f="})
        EXPECT_EQ(codeOf(mat.bytes, {io::FrfUnitChoice::MPerN, wrong}), errors::frfVariablesUnknown) << wrong;
    mat.add("lines_Hz", {10, 20});
    EXPECT_EQ(codeOf(mat.bytes, {io::FrfUnitChoice::MPerN, {}}), errors::frfVariablesUnknown);
}

TEST(FrfMat, anAngularFrequencyIsAskedFor)
{
    constexpr double perRadian = 0.5 / std::numbers::pi;
    const auto file = [](const std::string& name) {
        MatText mat(false, false, false);
        mat.add(name, {10, 20});
        mat.add("H", {1, 2}, {3, 4});
        return mat.bytes;
    };
    io::FrfOptions options{io::FrfUnitChoice::MPerN, {}};
    for (const char* name : {"w", "om", "omega", "Omega", "om_axis", "omega_1", "W"})
        EXPECT_EQ(codeOf(file(name), options), errors::frequencyUnitMissing) << name;
    EXPECT_EQ(codeOf(file("w"), {io::FrfUnitChoice::MPerN, "f=w,H=H"}), errors::frequencyUnitMissing);
    const auto firstLine = [&](const std::string& name) {
        return io::readFrf("test.mat", file(name), {}, options).frfs.at(0).frf.frequency_hz[0];
    };
    // The name states a unit.
    for (const char* name : {"omega_rad_s", "w_rads", "rad_s"}) EXPECT_EQ(firstLine(name), 10 * perRadian) << name;
    EXPECT_EQ(firstLine("w_hz"), 10);
    EXPECT_EQ(firstLine("lines_kHz"), 10000);
    options.frequency_unit = io::FrequencyUnitChoice::RadPerSecond;
    for (const char* name : {"w", "f", "freq"}) EXPECT_EQ(firstLine(name), 10 * perRadian) << name;
    EXPECT_EQ(firstLine("f_Hz"), 10);
    options.frequency_unit = io::FrequencyUnitChoice::Hertz;
    EXPECT_EQ(firstLine("omega"), 10);
    // Beside f the angular one is not needed.
    MatText both(false, false, false);
    both.add("w", {62, 125});
    both.add("f", {10, 20});
    both.add("H", {1, 2}, {3, 4});
    EXPECT_EQ(readMat(both.bytes).frfs.at(0).frf.frequency_hz[0], 10);
}

TEST(FrfMat, level73IsNamed)
{
    std::string bytes = plainFile();
    bytes[125] = 2;
    EXPECT_EQ(codeOf(bytes, {io::FrfUnitChoice::MPerN, {}}), errors::formatUnknown);
}

TEST(FrfMat, cutAndChangedFilesAreRefusedOrRead)
{
    std::mt19937 random(5);
    for (const bool compressed : {false, true}) {
        const std::string whole = plainFile(false, compressed);
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const std::string cut = whole.substr(0, length);
            try {
                readMat(cut);
            } catch (const Error& error) {
                EXPECT_TRUE(find(error.values(), "byte") || error.code() == errors::fileEmpty) << length;
            }
        }
        for (int k = 0; k < 20000; ++k) {
            std::string changed = whole;
            for (int n = 0; n < 3; ++n)
                changed[124 + random() % (changed.size() - 124)] =
                    static_cast<char>(random() % 3 == 0 ? 255 : random());
            try {
                readMat(changed);
            } catch (const Error& error) {
                EXPECT_TRUE(find(error.values(), "path"));
            }
        }
    }
}

}  // namespace
}  // namespace lathelier
