// Boxes, widths, scales, leaders: the parts of a drawing by themselves.
#include "engine/drawing/drawing.h"

#include <gtest/gtest.h>

namespace lathelier::drawing {
namespace {

TEST(Drawing, ScalesFallByAtLeastHalf)
{
    for (std::size_t i = 1; i < scales().size(); ++i) EXPECT_LE(scales()[i].factor(), 0.51 * scales()[i - 1].factor());
}

}  // namespace
}  // namespace lathelier::drawing
