#include "engine/stock/stock_quantities.h"

#include "engine/core/units.h"

namespace lathelier::stock {

const std::vector<QuantityOf<StockOutline>>& quantitiesOf(const StockOutline*)
{
    using R = StockOutline;
    static const auto all = describedBy<R>(quantity<R>("z_mm", &R::z_mm), quantity<R>("x_mm", &R::x_mm));
    return all;
}

const std::vector<QuantityOf<StockFinding>>& quantitiesOf(const StockFinding*)
{
    using R = StockFinding;
    static const auto all = describedBy<R>(
        quantity<R>("line", &R::line, {LT_TEXT("Engine", "Line"), {}, 0}),
        quantity<R>("kind", [](const R& r) { return key(r.kind); }),
        quantity<R>("kind_name", [](const R& r) { return nameOf(r.kind); },
                    {LT_TEXT("Engine", "Finding"), {}, 0, false}),
        quantity<R>("z_mm", &R::z_mm, {LT_TEXT("Engine", "z"), unit::mm, 2}),
        quantity<R>("x_mm", &R::x_mm, {LT_TEXT("Engine", "Radius"), unit::mm, 2}),
        quantity<R>("depth_mm", &R::depth_mm, {LT_TEXT("Engine", "Depth"), unit::mm, 2}),
        quantity<R>("width_mm", &R::width_mm, {LT_TEXT("Engine", "Width"), unit::mm, 2}),
        quantity<R>("path", [](const R& r) { return key(r.path); }),
        quantity<R>("path_name", [](const R& r) { return nameOf(r.path); }, {LT_TEXT("Engine", "Path"), {}, 0, false}));
    return all;
}

const std::vector<QuantityOf<StockPass>>& quantitiesOf(const StockPass*)
{
    using R = StockPass;
    static const auto all =
        describedBy<R>(quantity<R>("line", &R::line, {LT_TEXT("Engine", "Line"), {}, 0}),
                       quantity<R>("tool", &R::tool, {LT_TEXT("Engine", "Tool"), {}, 0}),
                       quantity<R>("removed_mm3", &R::removed_mm3, {LT_TEXT("Engine", "Removed"), unit::mm3, 0}),
                       part("contour", &R::after));
    return all;
}

const std::vector<QuantityOf<StockResult>>& quantitiesOf(const StockResult*)
{
    using R = StockResult;
    static const auto all = describedBy<R>(
        quantity<R>("findings", [](const R& r) { return listed(r.findings); }),
        quantity<R>("findings_not_listed", &R::findings_not_listed),
        quantity<R>("stock_passes", [](const R& r) { return listed(r.passes); }), part("stock_before", &R::before),
        quantity<R>("stock_volume_mm3", &R::volume_before_mm3,
                    {LT_TEXT("Engine", "Volume of the stock"), unit::mm3, 0}),
        quantity<R>("stock_removed_mm3", &R::removed_mm3, {LT_TEXT("Engine", "Removed by all passes"), unit::mm3, 0}),
        quantity<R>("stock_removed_by_findings_mm3", &R::removed_by_findings_mm3),
        quantity<R>("stock_step_mm", &R::step_mm, {LT_TEXT("Engine", "Column of stock"), unit::mm, 3}));
    return all;
}

}  // namespace lathelier::stock
