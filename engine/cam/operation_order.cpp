#include "engine/cam/operation_order.h"

#include <algorithm>

namespace lathelier::cam {

std::optional<Text> reasonToFollow(OperationKind later, OperationKind earlier)
{
    using Kind = OperationKind;
    if (later == earlier) return std::nullopt;
    if (later == Kind::PartOff) return LT_TEXT("Engine", "the part is cut off last: nothing holds it afterwards");
    switch (earlier) {
        case Kind::Face:
            return later == Kind::CentreDrill ? LT_TEXT("Engine", "the centre hole is drilled into the finished face")
                                              : LT_TEXT("Engine", "the other tools start from the finished face");
        case Kind::CentreDrill:
            if (later == Kind::Face) return std::nullopt;
            return LT_TEXT("Engine", "the tailstock has to hold the work before it is turned");
        case Kind::Rough:
            if (later == Kind::Face || later == Kind::CentreDrill) return std::nullopt;
            return later == Kind::Finish
                       ? LT_TEXT("Engine", "the finishing tool would have to take off what roughing takes")
                       : LT_TEXT("Engine", "the stock around it is roughed first");
        case Kind::SemiFinish:
            if (later == Kind::Finish)
                return LT_TEXT("Engine", "the finish needs an even allowance, without the steps of roughing");
            return std::nullopt;
        case Kind::Finish:
            if (later == Kind::Thread) return LT_TEXT("Engine", "a thread is cut into its finished row");
            return std::nullopt;
        case Kind::FinishBack:
        case Kind::Groove:
            if (later == Kind::Thread)
                return LT_TEXT("Engine", "a thread runs out into the groove that is cut before it");
            return std::nullopt;
        default: return std::nullopt;
    }
}

std::optional<OrderFault> faultOf(const std::vector<OperationStep>& order)
{
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t k = i + 1; k < order.size(); ++k) {
            if (order[i].setup != order[k].setup) continue;
            if (const auto reason = reasonToFollow(order[i].kind, order[k].kind))
                return OrderFault{order[i], order[k], *reason};
        }
    return std::nullopt;
}

std::vector<OperationStep> inOrder(std::vector<OperationStep> usual, const std::vector<OperationStep>& wanted)
{
    const auto has = [](const std::vector<OperationStep>& steps, const OperationStep& step) {
        return std::find(steps.begin(), steps.end(), step) != steps.end();
    };
    std::vector<OperationStep> named;
    for (const OperationStep& step : wanted)
        if (has(usual, step) && !has(named, step)) named.push_back(step);
    std::size_t next = 0;
    for (OperationStep& step : usual)
        if (has(named, step)) step = named[next++];
    return usual;
}

}  // namespace lathelier::cam
