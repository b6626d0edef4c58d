// Errors and notes of planning turning programs and of posts: codes with their English patterns. {name} is replaced by
// the named value; text() puts path, line, column and byte in front, so patterns do not repeat them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode noSetupPossible{
    "no_setup_possible", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The part cannot be clamped so: {reason}; {missing_mm} mm are missing.")};

inline constexpr ErrorCode orderImpossible{"order_impossible", ErrorKind::NoAnswer,
                                           LT_TEXT("Engine", "“{operation}” cannot run before “{needed}”: {reason}.")};

inline constexpr ErrorCode programRefused{
    "program_refused", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "The check of the written program found {count} finding(s) and a gouge of {gouge_um:2} µm; no program was "
            "written. The first: {operation}, tool {tool}, {kind} at z = {z_mm:2} mm, line {program_line}.")};

inline constexpr ErrorCode postUnknown{
    "post_unknown", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "There is no post “{found}”; expected a file or one of: {expected}.")};

inline constexpr ErrorCode postCannot{"post_cannot", ErrorKind::NoAnswer,
                                      LT_TEXT("Engine", "The post {post} cannot {what}.")};

inline constexpr ErrorCode feedBeyondNose{
    "tool_feed_beyond_nose", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "Tool {tool}: a feed of {feed_mm_rev} mm per revolution is more than its nose of {nose_radius_mm} mm "
            "allows; expected at most {most_mm_rev}.")};

inline constexpr ErrorCode workMaterialUnknown{
    "work_material_unknown", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The material “{found}” is not in the library; expected one of: {expected}.")};

inline constexpr ErrorCode nothingReplaced{
    "nothing_replaced", ErrorKind::OutputFailed,
    LT_TEXT("Engine", "Nothing was written: what is there was not to be replaced.")};

inline constexpr ErrorCode cutsNotChecked{
    "cuts_not_checked", ErrorKind::NoAnswer,
    LT_TEXT(
        "Engine",
        "The program of clamping {clamping} calls tool {tool}, which is not in the job: what it cuts is not checked. "
        "Add the tool to the job.")};

inline constexpr ErrorCode checkVoid{
    "check_void", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The program of clamping {clamping} was changed after its check; check it again first.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode programChangedByHand{
    "program_changed_by_hand", Severity::Warning,
    LT_TEXT("Engine", "The program of clamping {clamping} is not the planned one: it was changed by hand.")};

inline constexpr NoteCode changesOfOtherProgram{
    "changes_of_other_program", Severity::Warning,
    LT_TEXT("Engine",
            "Clamping {clamping}: changes by hand belong to another program than the one that stands here now, and are "
            "left out.")};

inline constexpr NoteCode programCorrected{
    "program_corrected", Severity::Info,
    LT_TEXT("Engine",
            "The program of clamping {clamping} is “{item}”, corrected for deflection by up to {correction_um} µm of "
            "the radius; it is checked against the drawing with this correction.")};

inline constexpr NoteCode correctedFromOther{
    "corrected_from_other", Severity::Warning,
    LT_TEXT("Engine",
            "“{item}” was corrected from another program than the one that is planned now: correct that one again.")};

inline constexpr NoteCode programNotUsed{
    "program_not_used", Severity::Warning,
    LT_TEXT("Engine",
            "“{item}” is a program of clamping {clamping}; there is no such clamping here, so it is not used.")};

inline constexpr NoteCode programGiven{
    "program_given", Severity::Info,
    LT_TEXT("Engine", "The program of clamping {clamping} is {path}, and not the planned one.")};

inline constexpr NoteCode speedLimitAssumed{
    "speed_limit_assumed", Severity::Warning,
    LT_TEXT("Engine", "The job states no highest speed of the spindle; {max_rpm} 1/min is written as the limit."),
    NoteRole::Assumed};

inline constexpr NoteCode restCannot{
    "rest_operation_refused", Severity::Info,
    LT_TEXT("Engine", "Tool {tool} could reach the rest at z = {z_start_mm} … {z_end_mm} mm, but {reason}.")};

inline constexpr NoteCode cuttingDataAssumed{
    "cutting_data_assumed", Severity::Info,
    LT_TEXT("Engine", "Assumed, from {source}: specific cutting force {k_c11_N_mm2} N/mm², exponent {m_c}."),
    NoteRole::Assumed};

inline constexpr NoteCode materialForPowerMissing{
    "material_for_power_missing", Severity::Info,
    LT_TEXT("Engine", "The job states no material from the library, so no power is computed.")};

inline constexpr NoteCode noStableSpeedHere{
    "no_stable_speed", Severity::Warning,
    LT_TEXT("Engine", "No stable speed for z = {z_start_mm} … {z_end_mm} mm; {speed_rpm} 1/min is kept.")};

inline constexpr NoteCode stableDepthHere{
    "stable_depth", Severity::Info,
    LT_TEXT("Engine",
            "At {speed_rpm} 1/min depths up to {stable_depth_mm:3} mm would be stable at z = {z_start_mm} … {z_end_mm} "
            "mm, with the force of the work material.")};

inline constexpr NoteCode speedChatters{
    "speed_chatters", Severity::Warning,
    LT_TEXT(
        "Engine",
        "The rule of the papers, which knows no depth, gives {speed_rpm} 1/min for z = {z_start_mm} … {z_end_mm} mm: "
        "{depth_mm:3} mm chatter there, up to {stable_depth_mm:3} mm are stable. The exact relation gives "
        "{exact_rpm:0} 1/min, stable up to {exact_depth_mm:3} mm.")};

inline constexpr NoteCode backSpeed{
    "back_speed", Severity::Info,
    LT_TEXT("Engine",
            "Tool {tool} turns z = {z_start_mm} … {z_end_mm} mm at {speed_rpm} 1/min (f_m {frequency_hz:1} Hz, lobe "
            "{lobe}).")};

inline constexpr NoteCode powerNearLimit{
    "power_near_limit", Severity::Warning,
    LT_TEXT(
        "Engine",
        "{operation} with tool {tool} takes about {power_kW:2} kW of the motor, {share_percent:0} % of the machine's "
        "{machine_kW} kW (efficiency {efficiency}; ± 25 %).")};

inline constexpr NoteCode toolFromLibrary{
    "tool_from_library", Severity::Info,
    LT_TEXT("Engine", "Tool {tool}: {what} of {name} from the library ({standing}): {source}.")};

inline constexpr NoteCode feedForRoughness{
    "feed_for_roughness", Severity::Info,
    LT_TEXT("Engine",
            "The drawing allows Rz {Rz_um} µm at z = {z_start_mm} … {z_end_mm} mm: the finish feeds {feed_mm_rev:3} mm "
            "per revolution there (ideal Rz {ideal_Rz_um:2} µm).")};

inline constexpr NoteCode roughnessNotReached{
    "roughness_not_reached", Severity::Warning,
    LT_TEXT(
        "Engine",
        "The drawing allows Rz {Rz_um} µm at z = {z_start_mm} … {z_end_mm} mm; at the least feed of {feed_mm_rev:3} "
        "mm per revolution the ideal Rz of tool {tool} is {ideal_Rz_um:2} µm.")};

inline constexpr NoteCode secondClampingAssumed{
    "second_clamping_assumed", Severity::Warning,
    LT_TEXT("Engine",
            "Second clamping: gripped at z = {grip_start_mm} … {grip_end_mm} mm, chuck face {chuck_face_z_mm} mm from "
            "the new free end; {face_allowance_mm} mm are faced off there."),
    NoteRole::Assumed};

inline constexpr NoteCode softJaws{
    "soft_jaws", Severity::Info,
    LT_TEXT("Engine", "The cylinder that is gripped in the second clamping carries a tolerance: use soft jaws.")};

inline constexpr NoteCode twoClampingsNoBetter{
    "two_clampings_no_better", Severity::Info,
    LT_TEXT("Engine", "Two clampings were tried: they leave {left_mm} mm, one leaves {left_one_mm} mm.")};

inline constexpr NoteCode finishCutsDeep{
    "finish_cuts_deep", Severity::Warning,
    LT_TEXT("Engine",
            "The finishing tool {tool} reaches where roughing does not and cuts up to {depth_mm} mm there, near z = "
            "{z_mm} mm.")};

inline constexpr NoteCode threadNotPlanned{
    "thread_not_planned", Severity::Warning,
    LT_TEXT("Engine", "The thread {designation} is not cut, {reason}: its body is turned to the drawn diameter.")};

inline constexpr NoteCode threadCut{
    "thread_cut", Severity::Info,
    LT_TEXT(
        "Engine",
        "Thread {designation}: pitch {pitch_mm} mm, {passes} passes to a depth of {depth_mm:3} mm; what it takes off "
        "is not looked at.")};

inline constexpr NoteCode edgesBroken{
    "edges_broken", Severity::Info,
    LT_TEXT("Engine", "Edges broken by {edge_break_mm} mm as the job asks: {count}; left sharp: {left}.")};

inline constexpr NoteCode insertNotOfHolder{
    "insert_not_of_holder", Severity::Warning,
    LT_TEXT(
        "Engine",
        "Tool {tool}: the insert {insert} does not fit the holder {holder} (shape, clearance or length of the edge).")};

inline constexpr NoteCode outsideRange{
    "tool_outside_range", Severity::Info,
    LT_TEXT("Engine",
            "Tool {tool}: {quantity} of {found} is outside {low} … {high}, the range of its insert "
            "({standing}).")};

inline constexpr NoteCode partOffLeftOut{
    "part_off_left_out", Severity::Warning,
    LT_TEXT("Engine", "The part is not cut off: it stands between chuck and tailstock.")};

inline constexpr NoteCode faceNotReached{
    "face_not_reached", Severity::Warning,
    LT_TEXT("Engine", "The end is not faced: tool {tool} would meet the tailstock.")};

inline constexpr NoteCode tailstockNotInSpeeds{
    "tailstock_not_in_speeds", Severity::Warning,
    LT_TEXT("Engine", "The speeds are those of a part whose end is free; the tailstock holds it stiffer.")};

inline constexpr NoteCode cycleNotPossible{
    "cycle_not_possible", Severity::Warning,
    LT_TEXT("Engine", "Clamping {clamping}: roughing is written as moves and not as a cycle, {reason}.")};

inline constexpr NoteCode noToolToFace{
    "no_tool_to_face", Severity::Warning,
    LT_TEXT("Engine",
            "The end is not faced, {face_mm} mm stay: the main edge of every insert would run below the face (entering "
            "angle below 90°).")};

inline constexpr NoteCode boreNotPlanned{
    "bore_not_planned", Severity::Warning,
    LT_TEXT("Engine",
            "The bore of ⌀{diameter_mm} mm at z = {z_start_mm} … {z_end_mm} mm is not in the program: nothing that is "
            "planned makes it.")};

inline constexpr NoteCode featureNotPlanned{
    "feature_not_planned", Severity::Warning,
    LT_TEXT("Engine",
            "The drawing has a feature that is not in the program: {feature} {designation} at z = {z_start_mm} … "
            "{z_end_mm} mm.")};

inline constexpr NoteCode cutOffFirst{
    "cut_off_first", Severity::Warning,
    LT_TEXT("Engine",
            "The second clamping begins with a stop: the work is to be cut off to {length_mm:2} mm before it, from the "
            "finished face; the first program does not part it off.")};

}  // namespace notes

}  // namespace lathelier
