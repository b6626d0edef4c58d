// Waiting for one computation that the user asked for and may stop: making the sample, writing a report.
#pragma once

#include <QString>

#include "widgets/core/task/worker.h"

class QWidget;

namespace lathelier {

/// Runs `job` in the background behind a dialog that shows how far it is and has Cancel, until it has ended. The window
/// is painted meanwhile. The dialog comes when it would be there for half a second.
Worker::Outcome waitFor(QWidget* window, const QString& what, Worker::Job job);

}  // namespace lathelier
