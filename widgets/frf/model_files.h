// What the computed response is made of: a shaft and its spindle, from files or items of the project.
#pragma once

#include "engine/core/input_file.h"
#include "engine/core/shaft.h"
#include "engine/receptance/spindle_receptance.h"
#include "widgets/core/files/file_cache.h"
#include "widgets/core/files/stores.h"

namespace lathelier::frf_panel {

struct ShaftFile {
    Shaft shaft;  ///< as read
    Notes notes;  ///< of the reading
};

/// Errors as receptance::readShaftFile().
class ShaftStore : public FileCache<ShaftFile> {
public:
    ShaftStore() : FileCache(20) {}

protected:
    ShaftFile read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override;
};

struct SpindleFile {
    receptance::SpindleReceptance spindle;  ///< as read
    Notes notes;                            ///< of the reading
};

/// Errors as receptance::readSpindle().
class SpindleStore : public FileCache<SpindleFile> {
public:
    SpindleStore() : FileCache(20) {}

protected:
    SpindleFile read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override;
};

/// A value with what a report says of where it came from.
template <class T>
struct Taken {
    T value;                 ///< from a file or an item
    InputFile input;         ///< the file, or the item as if it had been one
    Notes notes;             ///< of the reading
    bool synthetic = false;  ///< marked as made by a program
};

inline constexpr const char* frfRole = "frf";
inline constexpr const char* shaftRole = "shaft";
inline constexpr const char* spindleRole = "spindle";

/// Nothing when the input is not given. Errors: those of the stores, itemNotThere.
std::optional<Taken<Shaft>> takeShaft(const project::PanelState& state, Stores& stores, const Progress& progress);
std::optional<Taken<receptance::SpindleReceptance>> takeSpindle(const project::PanelState& state, Stores& stores,
                                                                const Progress& progress);

/// The item of an input, whose kind has to be `kind`. Error itemNotThere.
const Values& itemOf(const project::PanelState& state, const char* role, const char* kind);

/// An item as if it had been a file: its name and the digest of its values.
InputFile inputOfItem(const project::Source& source, const Values& values);

}  // namespace lathelier::frf_panel
