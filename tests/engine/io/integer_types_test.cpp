// Clouds whose coordinates are whole numbers of any type, and headers of PCD that are wrong.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "tests/engine/io/reading.h"

namespace lathelier {
namespace {

using testing::appendBytes;
using testing::errorOf;
using testing::integerOf;
using testing::readText;

/// The points (1, 2, 3), (4, 5, 6)… and one with the largest and the smallest number that is allowed.
template <class T>
std::vector<std::array<T, 3>> numbersOf()
{
    using Limits = std::numeric_limits<T>;
    // Coordinates end at ten million.
    const auto largest = static_cast<T>(std::min<std::uint64_t>(Limits::max(), 10000000));
    const auto smallest = static_cast<T>(std::max<std::int64_t>(static_cast<std::int64_t>(Limits::min()), -10000000));
    return {{1, 2, 3}, {4, 5, 6}, {7, 8, 10}, {largest, smallest, 0}};
}

template <class T>
void expectNumbers(const io::ScanFile& file)
{
    const auto numbers = numbersOf<T>();
    ASSERT_EQ(file.scan.points_mm.size(), numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(file.scan.points_mm[i][static_cast<Eigen::Index>(k)], static_cast<double>(numbers[i][k]))
                << i << ' ' << k;
}

template <class T>
std::string bodyOf()
{
    std::string body;
    for (const auto& point : numbersOf<T>())
        for (const T value : point) appendBytes(body, value);
    return body;
}

template <class T>
void checkPcd()
{
    const std::string size = std::to_string(sizeof(T));
    const std::string type = std::numeric_limits<T>::is_signed ? "I" : "U";
    SCOPED_TRACE("PCD " + type + size);
    expectNumbers<T>(readText("VERSION 0.7\nFIELDS x y z\nSIZE " + size + " " + size + " " + size + "\nTYPE " + type +
                              " " + type + " " + type + "\nCOUNT 1 1 1\nPOINTS 4\nDATA binary\n" + bodyOf<T>()));
}

template <class T>
void checkPly(const std::vector<std::string>& names)
{
    for (const std::string& name : names) {
        SCOPED_TRACE("PLY " + name);
        expectNumbers<T>(readText("ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty " + name +
                                  " x\nproperty " + name + " y\nproperty " + name + " z\nend_header\n" + bodyOf<T>()));
    }
}

TEST(IntegerTypes, OfPcd)
{
    checkPcd<std::int8_t>();
    checkPcd<std::int16_t>();
    checkPcd<std::int32_t>();
    checkPcd<std::int64_t>();
    checkPcd<std::uint8_t>();
    checkPcd<std::uint16_t>();
    checkPcd<std::uint32_t>();
    checkPcd<std::uint64_t>();
}

TEST(IntegerTypes, OfPlyUnderBothNames)
{
    checkPly<std::int8_t>({"char", "int8"});
    checkPly<std::uint8_t>({"uchar", "uint8"});
    checkPly<std::int16_t>({"short", "int16"});
    checkPly<std::uint16_t>({"ushort", "uint16"});
    checkPly<std::int32_t>({"int", "int32"});
    checkPly<std::uint32_t>({"uint", "uint32"});
}

TEST(IntegerTypes, NormalsOfPlyAndPcdAreRead)
{
    std::string ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\nend_header\n";
    std::string pcd =
        "VERSION 0.7\nFIELDS x y z normal_x normal_y normal_z\nSIZE 4 4 4 4 4 4\nTYPE F F F F F F\n"
        "COUNT 1 1 1 1 1 1\nPOINTS 4\nDATA binary\n";
    for (int i = 0; i < 4; ++i)
        for (const float value : {static_cast<float>(i), static_cast<float>(i * i), 3.0F, 0.0F, 0.6F, 0.8F}) {
            appendBytes(ply, value);
            appendBytes(pcd, value);
        }
    for (const std::string& text : {ply, pcd}) {
        const io::ScanFile file = readText(text);
        ASSERT_EQ(file.scan.normals.size(), 4u);
        EXPECT_LT((file.scan.normals[2] - Eigen::Vector3f(0, 0.6F, 0.8F)).norm(), 1e-6F);
    }
}

struct WrongHeader {
    const char* from;
    const char* to;
    std::int64_t line;
};

TEST(PcdHeader, WrongLinesAreRefusedWithTheirPlace)
{
    const std::string right =
        "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 4\nHEIGHT 1\nPOINTS 4\nDATA ascii\n";
    const std::string rows = "1 2 3\n4 5 6\n7 8 9\n1 5 7\n";
    EXPECT_EQ(readText(right + rows).scan.points_mm.size(), 4u);
    for (const WrongHeader& wrong : std::vector<WrongHeader>{{"SIZE 4 4 4", "SIZE 4 4", 3},
                                                             {"SIZE 4 4 4", "SIZE 4 3 4", 3},
                                                             {"SIZE 4 4 4", "SIZE 4 -4 4", 3},
                                                             {"TYPE F F F", "TYPE F X F", 4},
                                                             {"COUNT 1 1 1", "COUNT 1 9999999 1", 5},
                                                             {"COUNT 1 1 1", "COUNT 1 0 1", 9},
                                                             {"COUNT 1 1 1", "COUNT 1048576 1 1", 9},
                                                             {"WIDTH 4", "WIDTH four", 6},
                                                             {"POINTS 4", "POINTS -4", 8},
                                                             {"FIELDS x y z", "FIELDS x y w", 9},
                                                             {"DATA ascii", "DATA morse", 9},
                                                             {"HEIGHT 1", "DEPTH 1", 7}}) {
        SCOPED_TRACE(wrong.to);
        std::string text = right;
        text.replace(text.find(wrong.from), std::strlen(wrong.from), wrong.to);
        const Error error = errorOf(text + rows);
        EXPECT_EQ(error.code(), errors::malformed) << error.what();
        EXPECT_EQ(integerOf(error, "line"), wrong.line) << error.what();
    }
    EXPECT_EQ(errorOf(right.substr(0, right.find("DATA"))).code(), errors::malformed);
}

}  // namespace
}  // namespace lathelier
