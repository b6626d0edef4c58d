// Programs and moves of the panel "Turning program" as files.
#pragma once

#include <QString>
#include <QWidget>

#include "widgets/turning/turning_picture.h"

namespace lathelier::turning_panel {

/// What was not checked as it stands is not given out. Two programs get names of their own; what is there under these
/// is replaced only where the user says so. Errors: checkVoid, cutsNotChecked, programRefused, outputIsInput,
/// nothingReplaced, fileNotWritable.
void writePrograms(const TurningPicture& picture, const QString& path, QWidget* parent);

/// The moves of one clamping as CSV. Error fileNotWritable.
void writeMovesOf(const cam::SetupPlan& setup, const QString& path);

}  // namespace lathelier::turning_panel
