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

// --- records
LATHELIER_NOTE(ProfilePlane, "profile_plane", Info, LT_TEXT("Engine", "{path}: the points lie in the plane {plane} at {at_mm} mm; read as a profile in it."))
LATHELIER_NOTE(CoordinateIgnored, "coordinate_ignored", Warning, LT_TEXT("Engine", "{path}: {coordinate} runs from {from_mm} to {to_mm} mm; all points were read as one section."))
LATHELIER_NOTE(ColumnsGuessed, "columns_guessed", Warning, LT_TEXT("Engine", "{path}: the columns have no names; read as {columns}."))
LATHELIER_NOTE(AngleUnitGuessed, "angle_unit_guessed", Warning, LT_TEXT("Engine", "{path}: no unit of the angle is stated; read as rad because it runs over {extent}."))
LATHELIER_NOTE(AnglesUniform, "angles_uniform", Info, LT_TEXT("Engine", "{path}: no angles are stated; {count} values were spread evenly over one turn."))
LATHELIER_NOTE(SizeFromNominal, "size_from_nominal", Info, LT_TEXT("Engine", "{path}: deviations laid on the nominal radius of {radius_mm} mm; the size is not measured."))
LATHELIER_NOTE(NominalNotUsed, "nominal_not_used", Info, LT_TEXT("Engine", "{path}: the file holds radii; the nominal radius of {radius_mm} mm is not used."))
LATHELIER_NOTE(TimeUnitAssumed, "time_unit_assumed", Warning, LT_TEXT("Engine", "{path}: no unit of the time is stated; read as seconds."))
LATHELIER_NOTE(TimeIrregular, "time_irregular", Warning, LT_TEXT("Engine", "{path}: {count} time steps differ from {step_s} s, the first at line {line}."))
LATHELIER_NOTE(TimeCoarse, "time_coarse", Warning, LT_TEXT("Engine", "{path}: the times are written too coarsely; {rate_hz} frames a second were used instead."))
LATHELIER_NOTE(RateUnknown, "rate_unknown", Warning, LT_TEXT("Engine", "{path}: neither times nor a rate are stated."))
LATHELIER_NOTE(SamplesMissing, "samples_missing", Warning, LT_TEXT("Engine", "{path}: {count} samples of {channel} are missing."))
LATHELIER_NOTE(ChannelUnitUnknown, "channel_unit_unknown", Warning, LT_TEXT("Engine", "{path}: no unit of {channel} is stated."))
LATHELIER_NOTE(ConverterRateWrong, "converter_rate_wrong", Info, LT_TEXT("Engine", "{path}: the stated converter rate of {stated_kHz} kHz does not fit {channels} channels; {used_kHz} kHz was used."))
LATHELIER_NOTE(ConverterDelayDiffers, "converter_delay_differs", Info, LT_TEXT("Engine", "{path}: the stated delay of {stated_ms} ms does not fit the rates; {used_ms} ms from channel to channel was used."))
LATHELIER_NOTE(FullScaleAssumed, "full_scale_assumed", Info, LT_TEXT("Engine", "{path}: {code} converter codes of {device} were read as {volts} V."))
LATHELIER_NOTE(FullScaleUnknown, "full_scale_unknown", Warning, LT_TEXT("Engine", "{path}: the recorder {device} is not known; the values are converter codes. State the full scale."))
LATHELIER_NOTE(RecordInSegments, "record_in_segments", Warning, LT_TEXT("Engine", "{path}: the recording has {count} segments; there may be gaps between them."))

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

// --- form
LATHELIER_NOTE(Undersampled, "undersampled", Warning, LT_TEXT("Engine", "{points} points a turn are too few for {cutoff_upr} UPR by the rule of 7 points a wave; they carry {supported_upr} UPR. The answer is given all the same."))
LATHELIER_NOTE(GapsInProfile, "gaps_in_profile", Info, LT_TEXT("Engine", "{count} gaps in the profile, the largest of {largest_deg}°: beside them filter and harmonics rest on the points that are there."))
LATHELIER_NOTE(PartialArc, "partial_arc", Warning, LT_TEXT("Engine", "The points leave {missing_deg}° of the turn out: this is the roundness of an arc, and harmonics say little."))
LATHELIER_NOTE(AnglesUneven, "angles_uneven", Info, LT_TEXT("Engine", "The points are unevenly spread over the turn; filter and harmonics take that into account."))
LATHELIER_NOTE(DuplicatePoints, "duplicate_points", Info, LT_TEXT("Engine", "{count} points lie where others do."))
LATHELIER_NOTE(OutliersRemoved, "outliers_removed", Info, LT_TEXT("Engine", "{count} outliers were left out (Hampel)."))
LATHELIER_NOTE(SectorsExcluded, "sectors_excluded", Info, LT_TEXT("Engine", "{count} points in the excluded sectors were left out."))
LATHELIER_NOTE(MinimumZoneNotUnique, "minimum_zone_not_unique", Info, LT_TEXT("Engine", "Another centre gives the same minimum zone: RONt is sure, the centre is not."))
LATHELIER_NOTE(InscribedNotUnique, "inscribed_not_unique", Info, LT_TEXT("Engine", "Another centre holds an equal maximum inscribed circle; RONt(MICI) depends on which is taken."))
LATHELIER_NOTE(CertificateOpen, "certificate_open", Warning, LT_TEXT("Engine", "{circle} is proved to {gap_um} µm only."))
LATHELIER_NOTE(NoiseNotKnown, "noise_not_known", Info, LT_TEXT("Engine", "Too few points to tell their noise from the form; state the uncertainty of a point for an uncertainty of the result."))
LATHELIER_NOTE(SizeNominal, "size_nominal", Info, LT_TEXT("Engine", "The profile holds deviations from a nominal radius: form is measured, size is not."))
LATHELIER_NOTE(RotationNotDetermined, "rotation_not_determined", Warning, LT_TEXT("Engine", "The form does not determine the angle between the profiles; several rotations fit as well."))

// --- projects
LATHELIER_NOTE(SourceChanged, "source_changed", Warning, LT_TEXT("Engine", "{path} has changed since the project was saved."))
LATHELIER_NOTE(SourceMissing, "source_missing", Warning, LT_TEXT("Engine", "{path} is missing."))
