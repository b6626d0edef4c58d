// Fills the map of the growth under the lobes in the background, coarse at first and finer from pass to pass.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <string>
#include <vector>

#include "engine/stability/simulation/stability_raster.h"
#include "widgets/core/task/worker.h"

namespace lathelier::training_panel {

class RasterFiller : public QObject {
    Q_OBJECT

public:
    explicit RasterFiller(QObject* parent = nullptr);

    /// Begins anew when the question differs from the last one; else goes on.
    void ask(const std::vector<stability::Mode>& modes, const stability::RasterParameters& parameters);

    /// The finest map so far; nullptr: none yet.
    const stability::RasterResult* raster() const { return raster_.get(); }
    bool isBusy() const { return poll_.isActive(); }

signals:
    void filled();  ///< raster() is finer than before

private:
    void next();
    void poll();

    std::vector<stability::Mode> modes_;
    stability::RasterParameters asked_;
    std::string question_;
    std::size_t pass_ = 0;
    std::shared_ptr<const stability::RasterResult> raster_;
    QTimer poll_;
    Worker worker_;  ///< last: stopped before anything else goes
};

}  // namespace lathelier::training_panel
