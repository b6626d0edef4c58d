// Units of signals over time: forces, motions, volts, as headings and sensors state them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lathelier::io {

/// Unit of a signal. Displacement, velocity and acceleration are motions.
struct SignalUnit {
    enum class Kind { Force, Displacement, Velocity, Acceleration, Voltage };
    Kind kind = Kind::Force;
    double scale = 1;  ///< one unit in N, mm, mm/s, mm/s² or V

    bool isMotion() const { return kind != Kind::Force && kind != Kind::Voltage; }
};

/// "N", "lbf", "m/s^2", "g" (acceleration of free fall), "mm", "mV"; none for other words.
std::optional<SignalUnit> signalUnit(std::string_view text);

/// A parsed heading: "force_N", "acc_m_s2", "a (g)", "F [kN]".
struct SignalHeading {
    std::string name;                ///< as written, without the unit
    std::optional<SignalUnit> unit;  ///< none: the heading states none that is known
    std::string unit_text;           ///< in the place of the unit, as written; empty: nothing
};
SignalHeading parseSignalHeading(std::string_view heading);

/// Sensitivity of a sensor: "2.25 mV/N", "100 mV/g", "10 mV/(m/s^2)", "500 N/V", or the value of one unit of the
/// record: "500 N". A negative value turns the sign.
struct Sensitivity {
    SignalUnit per_unit;   ///< force or motion of one unit of the record; signed
    bool of_volts = true;  ///< the unit of the record is a volt; false: whatever the record holds
};
std::optional<Sensitivity> sensitivityOf(std::string_view text);

}  // namespace lathelier::io
