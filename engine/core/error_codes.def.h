// LATHELIER_ERROR(code, stable key, kind, English pattern). {name} is replaced by the named value.
// The place (path, line, column, byte) is put in front by text(); patterns do not repeat it.
// Included several times on purpose: no include guard.

// --- usage
LATHELIER_ERROR(UnknownOption, "unknown_option", WrongUsage, LT_TEXT("Engine", "The option {option} is not known."))
LATHELIER_ERROR(ValueOutOfRange, "value_out_of_range", WrongUsage, LT_TEXT("Engine", "{parameter} is {found}; expected {expected} from {minimum} to {maximum}."))
LATHELIER_ERROR(ValueNotUnderstood, "value_not_understood", WrongUsage, LT_TEXT("Engine", "{parameter}: found “{found}”, expected {expected}."))

// --- files
LATHELIER_ERROR(FileNotFound, "file_not_found", InputRejected, LT_TEXT("Engine", "This file does not exist."))
LATHELIER_ERROR(FileNotReadable, "file_not_readable", InputRejected, LT_TEXT("Engine", "The file cannot be read: {reason}."))
LATHELIER_ERROR(NotAFile, "not_a_file", InputRejected, LT_TEXT("Engine", "Expected a file, found {found}."))
LATHELIER_ERROR(FileEmpty, "file_empty", InputRejected, LT_TEXT("Engine", "The file is empty."))
LATHELIER_ERROR(FileNotWritable, "file_not_writable", InputRejected, LT_TEXT("Engine", "The file cannot be written: {reason}."))
LATHELIER_ERROR(FormatUnknown, "format_unknown", InputRejected, LT_TEXT("Engine", "The kind of this file is not known: found {found}, expected {expected}."))
LATHELIER_ERROR(Malformed, "malformed", InputRejected, LT_TEXT("Engine", "Found “{found}”, expected {expected}."))
LATHELIER_ERROR(Truncated, "truncated", InputRejected, LT_TEXT("Engine", "The file ends early: {found} of {expected} {items} are there."))
LATHELIER_ERROR(NumberAmbiguous, "number_ambiguous", InputRejected, LT_TEXT("Engine", "“{found}” can be read in two ways: {first} or {second}. State the decimal mark."))
LATHELIER_ERROR(UnitUnknown, "unit_unknown", InputRejected, LT_TEXT("Engine", "The file states no unit, and an extent of {extent} fits no guess. State the unit."))
LATHELIER_ERROR(NoPoints, "no_points", InputRejected, LT_TEXT("Engine", "The file holds no usable point."))
LATHELIER_ERROR(CoordinateTooLarge, "coordinate_too_large", InputRejected, LT_TEXT("Engine", "The coordinate {found} is out of reach; expected at most {maximum}."))

// --- records
LATHELIER_ERROR(ColumnsUnknown, "columns_unknown", InputRejected, LT_TEXT("Engine", "The columns cannot be told: found “{found}”, expected {expected}."))
LATHELIER_ERROR(NominalRadiusMissing, "nominal_radius_missing", InputRejected, LT_TEXT("Engine", "The file holds deviations only, from {minimum} to {maximum}. State the nominal radius."))
LATHELIER_ERROR(PartnerMissing, "partner_missing", InputRejected, LT_TEXT("Engine", "The record is not complete: {partner} is not beside it."))
LATHELIER_ERROR(RecordContradicts, "record_contradicts", InputRejected, LT_TEXT("Engine", "The record contradicts itself ({check}): found {found}, expected {expected}."))

// --- no answer
LATHELIER_ERROR(TooFewPoints, "too_few_points", NoAnswer, LT_TEXT("Engine", "{found} points are too few; at least {minimum} are needed."))
LATHELIER_ERROR(PointsDegenerate, "points_degenerate", NoAnswer, LT_TEXT("Engine", "The points all lie {found}; no answer follows from that."))
LATHELIER_ERROR(PartsDoNotMatch, "parts_do_not_match", NoAnswer, LT_TEXT("Engine", "The two parts do not match: only {overlap_percent} % of the copy lies near the reference."))
LATHELIER_ERROR(NotConverged, "not_converged", NoAnswer, LT_TEXT("Engine", "No stable solution after {iterations} iterations."))
LATHELIER_ERROR(NotABodyOfRevolution, "not_a_body_of_revolution", NoAnswer, LT_TEXT("Engine", "The {role} is not a body of revolution (residual {residual_mm} mm)."))
LATHELIER_ERROR(OutOfMemory, "out_of_memory", NoAnswer, LT_TEXT("Engine", "There is not enough memory for this."))
LATHELIER_ERROR(Internal, "internal", NoAnswer, LT_TEXT("Engine", "Lathelier made a mistake here ({reason}). Please report it."))

// --- projects
LATHELIER_ERROR(VersionTooNew, "version_too_new", InputRejected, LT_TEXT("Engine", "The project has format version {found}; this program reads up to version {maximum}."))

// --- spindle
LATHELIER_ERROR(DiameterMissing, "diameter_missing", InputRejected, LT_TEXT("Engine", "The record does not say the workpiece's diameter. State it."))
LATHELIER_ERROR(ChannelsUnknown, "channels_unknown", InputRejected, LT_TEXT("Engine", "{signal} cannot be channel {found}: {reason}. The record has {channels} channels, counted from 0."))
LATHELIER_ERROR(ChannelUnitMissing, "channel_unit_missing", InputRejected, LT_TEXT("Engine", "{signal}: channel {found} ({channel}) states no unit; expected µm, mm or V in its heading, such as X3_um."))
LATHELIER_ERROR(MarkerNotFound, "marker_not_found", InputRejected, LT_TEXT("Engine", "Channel {place} ({channel}) is no marker of revolutions: {reason}."))
LATHELIER_ERROR(MarkerElsewhere, "marker_elsewhere", InputRejected, LT_TEXT("Engine", "Channel {place} ({channel}) is no marker of revolutions: {reason}. Channel {candidate} ({candidate_channel}) looks like one."))
LATHELIER_ERROR(AngleNotTurning, "angle_not_turning", InputRejected, LT_TEXT("Engine", "Channel {place} ({channel}) is no angle of revolution: {reason}."))
LATHELIER_ERROR(TimeNotIncreasing, "time_not_increasing", InputRejected, LT_TEXT("Engine", "The time does not go forward at row {row}."))
LATHELIER_ERROR(TooFewRevolutions, "too_few_revolutions", NoAnswer, LT_TEXT("Engine", "{found} whole revolutions are too few; at least {minimum} are needed."))
LATHELIER_ERROR(RecordTooShort, "record_too_short", NoAnswer, LT_TEXT("Engine", "{found} revolutions are too few for {sections} sections; at least {minimum} are needed."))
LATHELIER_ERROR(RecordsDiffer, "records_differ", InputRejected, LT_TEXT("Engine", "The records are not of one workpiece: {parameter} is {first} in the first and {found} here."))
