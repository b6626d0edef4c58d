// Programs and moves of the panel "Turning program" as files.
#pragma once

#include <QString>
#include <QWidget>

#include "engine/cam/drawn/drawn_plan.h"

namespace lathelier::turning_panel {

/// Unchecked programs are not exported. Two programs get separate names; existing files with these names are replaced
/// only after confirmation. Errors: checkVoid, cutsNotChecked, programRefused, outputIsInput, nothingReplaced,
/// fileNotWritable.
void writePrograms(const cam::TurningOutcome& outcome, const QString& path, QWidget* parent);

/// The moves of one clamping as CSV. Error fileNotWritable.
void writeMovesOf(const cam::SetupPlan& setup, const QString& path);

}  // namespace lathelier::turning_panel
