#include "engine/core/units.h"
#include "engine/receptance/tap/tap.h"

namespace lathelier::receptance {

const std::vector<Field<TapParameters>>& fieldsOf(const TapParameters*)
{
    using P = TapParameters;
    static const std::vector<Field<P>> all{
        field("estimator", &P::estimator,
              {{"h1", LT_TEXT("Engine", "H1: noise of the sensor averages out")},
               {"h2", LT_TEXT("Engine", "H2: noise of the hammer averages out")}},
              Label{LT_TEXT("Engine", "Estimator"), LT_TEXT("Engine", "How the spectra of the hits are averaged.")}),
        field(
            "window", &P::window,
            {{"none", LT_TEXT("Engine", "none")}, {"force_exponential", LT_TEXT("Engine", "force and exponential")}},
            Label{LT_TEXT("Engine", "Window"),
                  LT_TEXT("Engine", "Force window and exponential window; the decay that the latter adds is stated.")}),
        field("exponential_time_s", &P::exponential_time_s, {1e-6, 1e4},
              Label{LT_TEXT("Engine", "Time of the exponential window"),
                    LT_TEXT("Engine", "In which it falls to 1/e. By default a third of the block."), unit::s}),
        field("force_window_s", &P::force_window_s, {1e-6, 1e4},
              Label{LT_TEXT("Engine", "Force window"),
                    LT_TEXT("Engine", "From the trigger on. By default twice the pulse."), unit::s, true}),
        field("block_s", &P::block_s, {1e-6, 1e4},
              Label{LT_TEXT("Engine", "Block"),
                    LT_TEXT("Engine",
                            "Length of the signals of a hit; its inverse is the distance of the lines. By default as "
                            "long as the distance of the hits allows, at most 2 s."),
                    unit::s}),
        field("range_hz", &P::range_hz, {0, 1e6},
              Label{LT_TEXT("Engine", "Range of frequencies"),
                    LT_TEXT("Engine", "Whose lines are handed on. By default all usable ones."), unit::hz}),
        field("trigger_percent", &P::trigger_percent, {0.01, 100},
              Label{LT_TEXT("Engine", "Trigger level"), LT_TEXT("Engine", "Of the largest force of a record."),
                    unit::percent, true}),
        field("pre_trigger_s", &P::pre_trigger_s, {0, 1e4},
              Label{LT_TEXT("Engine", "Pre-trigger"),
                    LT_TEXT("Engine", "Of a block in front of its hit. By default 2 % of the block."), unit::s, true}),
        field("double_hit_percent", &P::double_hit_percent, {0.01, 100},
              Label{LT_TEXT("Engine", "Double hit"),
                    LT_TEXT("Engine", "A later pulse of more than this, of the peak, makes a hit a double one."),
                    unit::percent, true}),
        field("force_drop_dB", &P::force_drop_db, {1, 100},
              Label{LT_TEXT("Engine", "Fall of the force"),
                    LT_TEXT("Engine", "Of its spectrum below the maximum, which ends the usable range."),
                    LT_TEXT("Engine", "dB"), true}),
        field("keep_rejected", &P::keep_rejected,
              Label{LT_TEXT("Engine", "Keep rejected hits"),
                    LT_TEXT("Engine", "Averages double, overloaded and weak hits as well."),
                    {},
                    true})};
    return all;
}

}  // namespace lathelier::receptance
