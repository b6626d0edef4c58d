// The walk through a part: what a question needs and nobody gave comes from an earlier question of the same part, else
// from the supply (the shop), and is listed.
//
// Precedence of an input: given in its own place; the product of its kind of the nearest earlier place that can be
// answered; the supply. Filled are the inputs that the task requires, one of those of which it needs one, and those
// that the place names.
//
// Filled inputs are items named "place:kind" or "shop:kind". promised() tells them without any computation;
// complete() computes what is needed. Equal questions are answered once for all places and threads.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/walk/place.h"
#include "engine/walk/supply.h"

namespace lathelier::walk {

/// Where an input that nobody gave comes from.
struct Taken {
    std::string role;
    Text from;                ///< title of the place; empty: the supply
    bool is_assumed = false;  ///< of the supply
    friend bool operator==(const Taken&, const Taken&) = default;
};

/// Of one value of a project. Thread-safe; lives as long as a computation may use it.
class Walk {
public:
    /// `places` in the order of the work. `generation`: counts up when changed files are taken, so that none of the
    /// answers before is used again.
    Walk(project::Project project, std::vector<Place> places, Supply supply, std::shared_ptr<Stores> stores,
         int generation = 0);

    const std::vector<Place>& places() const { return places_; }
    const Place* place(const std::string& id) const;  ///< nullptr: none

    /// The state of the place with what will fill its free inputs: items without values, whose origin changes when
    /// what they follow from does. The project's state where there is no such place.
    const project::PanelState& promised(const std::string& id) const;

    /// What promised() filled in.
    const std::vector<Taken>& taken(const std::string& id) const;

    /// Of all that the answer of the place follows from; precondition: place().
    const std::string& digest(const std::string& id) const { return promiseOf(*place(id)).digest; }

    /// Whether nothing is missing in promised().
    bool canAnswer(const std::string& id) const;

    /// The state with its values. `notes`: what was assumed on the way. Errors of the earlier places, with `of_place`
    /// (the title of the one that failed); nothingFollows. Throws Cancelled.
    project::PanelState complete(const std::string& id, Notes& notes, const Progress& progress) const;

    /// The answer of the place. Errors of complete() and of its task. Throws Cancelled.
    std::shared_ptr<const PlaceAnswer> answer(const std::string& id, const Progress& progress) const;

private:
    struct Promise {
        project::PanelState state;
        std::vector<Taken> taken;
        std::map<std::string, const Place*> givers;  ///< by role; nullptr: the supply
        std::string digest;                          ///< of the state and of all that it follows from
    };

    struct Given {
        project::Item item;
        bool is_synthetic = false;
    };

    const Promise& promiseOf(const Place& place) const;
    Promise makePromise(const Place& place) const;
    void promiseInput(const Place& place, const task::Input& input, Promise& promise) const;
    const Place* giverOf(const Place& place, const std::string& kind) const;
    bool isReady(const Place& place) const;
    Given give(const Place& giver, const std::string& kind, Notes& notes, const Progress& progress) const;
    std::optional<Shaft> partFor(const Place& place, Notes& notes, const Progress& progress) const;

    project::Project project_;
    std::vector<Place> places_;
    Supply supply_;
    std::shared_ptr<Stores> stores_;
    int generation_;
    mutable std::recursive_mutex mutex_;  ///< guards promises_
    mutable std::map<std::string, Promise> promises_;
};

}  // namespace lathelier::walk
