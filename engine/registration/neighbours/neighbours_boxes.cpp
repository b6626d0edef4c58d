#include "engine/registration/neighbours/neighbours_boxes.h"

#include <algorithm>

#include "engine/core/parallel.h"

namespace lathelier::registration {

BoxTree::BoxTree(const std::vector<Box>& leaves, const Progress& progress)
{
    std::vector<Box> boxes = leaves;
    while (!boxes.empty() && (levels_.empty() || boxes.size() > 1)) {
        std::vector<Node> nodes((boxes.size() + fan - 1) / fan);
        std::vector<Box> parents(nodes.size());
        parallelFor(nodes.size(), 4096, progress, [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n)
                for (std::size_t c = 0; c < fan; ++c) {
                    const Box box = n * fan + c < boxes.size() ? boxes[n * fan + c] : Box();
                    for (int a = 0; a < 3; ++a) {
                        nodes[n].low[a][c] = box.low_mm[a];
                        nodes[n].high[a][c] = box.high_mm[a];
                    }
                    parents[n].low_mm = parents[n].low_mm.cwiseMin(box.low_mm);
                    parents[n].high_mm = parents[n].high_mm.cwiseMax(box.high_mm);
                }
        });
        levels_.push_back(std::move(nodes));
        boxes = std::move(parents);
    }
}

}  // namespace lathelier::registration
