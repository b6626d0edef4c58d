// Memoised results requested by several panels.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "engine/core/progress.h"

namespace lathelier {

/// The last `capacity` answers by key. When several threads ask for the same one, the first computes it and the others
/// wait; if it is cancelled or fails, the next one takes over. Thread-safe.
template <class T>
class Memo {
public:
    explicit Memo(std::size_t capacity = 4) : capacity_(capacity) {}

    std::shared_ptr<const T> find(const std::string& key, const Progress& progress,
                                  const std::function<T(const Progress&)>& compute)
    {
        const std::shared_ptr<Place> place = placeOf(key);
        {
            std::unique_lock lock(place->mutex);
            while (place->computing) {
                place->done.wait_for(lock, std::chrono::milliseconds(10));
                lock.unlock();
                progress.report(0);  // throws when cancelled
                lock.lock();
            }
            if (place->answer) return place->answer;
            place->computing = true;
        }
        struct Leave {
            Place& place;  ///< entry being computed
            ~Leave()
            {
                const std::lock_guard lock(place.mutex);
                place.computing = false;
                place.done.notify_all();
            }
        } leave{*place};
        auto answer = std::make_shared<const T>(compute(progress));
        const std::lock_guard lock(place->mutex);
        place->answer = answer;
        return answer;
    }

private:
    struct Place {
        std::string key;                  ///< key of the answer
        std::mutex mutex;                 ///< guards `computing` and `answer`
        std::condition_variable done;     ///< notified when a computation has ended, with or without an answer
        bool computing = false;           ///< a thread computes the answer
        std::shared_ptr<const T> answer;  ///< null: not computed yet
    };

    std::shared_ptr<Place> placeOf(const std::string& key)
    {
        const std::lock_guard lock(mutex_);
        for (auto at = places_.begin(); at != places_.end(); ++at)
            if ((*at)->key == key) {
                places_.splice(places_.end(), places_, at);  // the most recent ones are last
                return places_.back();
            }
        places_.push_back(std::make_shared<Place>());
        places_.back()->key = key;
        if (places_.size() > capacity_) places_.pop_front();
        return places_.back();
    }

    std::size_t capacity_;
    std::mutex mutex_;
    std::list<std::shared_ptr<Place>> places_;
};

}  // namespace lathelier
