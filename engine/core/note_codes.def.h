// LATHELIER_NOTE(code, stable key, severity, English pattern). {name} is replaced by the named value.
// Included several times on purpose: no include guard.

// --- reading
LATHELIER_NOTE(UnitGuessed, "unit_guessed", Warning, LT_TEXT("Engine", "{path}: no unit is stated; read as {unit} because of its extent of {extent}."))
LATHELIER_NOTE(RowsSkipped, "rows_skipped", Info, LT_TEXT("Engine", "{path}: {count} rows were skipped."))
LATHELIER_NOTE(PointsNotFinite, "points_not_finite", Warning, LT_TEXT("Engine", "{path}: {count} points without finite coordinates were left out."))
LATHELIER_NOTE(SyntheticData, "synthetic_data", Warning, LT_TEXT("Engine", "{path}: synthetic data, made by a program, not measured."))
LATHELIER_NOTE(CountDiffers, "count_differs", Warning, LT_TEXT("Engine", "{path}: {announced} rows are announced, {found} are there; all were read."))
LATHELIER_NOTE(NormalsUnusable, "normals_unusable", Warning, LT_TEXT("Engine", "{path}: {count} normals have no direction; the normals are not used."))
LATHELIER_NOTE(UnitNotUsed, "unit_not_used", Warning, LT_TEXT("Engine", "{path}: the file states {unit}; the given unit {given} is not used."))

// --- registration
LATHELIER_NOTE(RollNotDetermined, "roll_not_determined", Info, LT_TEXT("Engine", "Roll about the axis is not determined by the geometry; the smallest rotation was kept."))
LATHELIER_NOTE(MotionNotDetermined, "motion_not_determined", Warning, LT_TEXT("Engine", "A {kind} is not determined by the geometry; the initial pose was kept along it."))
LATHELIER_NOTE(MotionWeak, "motion_weak", Warning, LT_TEXT("Engine", "A {kind} is only weakly determined by the geometry."))
LATHELIER_NOTE(SeveralPosesFit, "several_poses_fit", Warning, LT_TEXT("Engine", "{count} poses fit equally well; the one with the smallest rotation was chosen."))
LATHELIER_NOTE(MethodChosen, "method_chosen", Info, LT_TEXT("Engine", "Method chosen: {method} ({reason})."))
LATHELIER_NOTE(EndForEnd, "end_for_end", Info, LT_TEXT("Engine", "The copy was turned end for end."))
LATHELIER_NOTE(OutliersExcluded, "outliers_excluded", Info, LT_TEXT("Engine", "{count} points further than {distance_mm} mm from the reference were left out."))
LATHELIER_NOTE(ZonesExcluded, "zones_excluded", Info, LT_TEXT("Engine", "{count} points in the excluded zones were left out."))
LATHELIER_NOTE(SignUndetermined, "sign_undetermined", Warning, LT_TEXT("Engine", "Inside and outside are not known (no normals, no closed surface): the deviation has no sign."))
LATHELIER_NOTE(NotDistinguishable, "not_distinguishable", Warning, LT_TEXT("Engine", "The difference cannot be told from the scanner's accuracy of {scanner_accuracy_mm} mm."))

// --- projects
LATHELIER_NOTE(SourceChanged, "source_changed", Warning, LT_TEXT("Engine", "{path} has changed since the project was saved."))
LATHELIER_NOTE(SourceMissing, "source_missing", Warning, LT_TEXT("Engine", "{path} is missing."))
