// The style sheet of reports, for the screen and for A4 paper.
#pragma once

#include <string_view>

namespace lathelier::report {

inline constexpr std::string_view reportStyle = R"css(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 28px 36px 48px; max-width: 1040px; background: #fff; color: #1f2933;
  font: 15px/1.45 "Segoe UI", "Noto Sans", "Helvetica Neue", Arial, "DejaVu Sans", sans-serif; }
header { display: flex; justify-content: space-between; align-items: flex-start; gap: 24px;
  border-bottom: 3px solid #1f5fa8; padding-bottom: 12px; margin-bottom: 20px; }
h1 { font-size: 26px; line-height: 1.2; margin: 0; font-weight: 650; }
h2 { font-size: 18px; margin: 30px 0 10px; padding-bottom: 4px; border-bottom: 1px solid #cbd2d9; }
h3, caption { font-size: 14px; font-weight: 650; text-align: left; margin: 14px 0 6px; padding: 0; }
p { margin: 8px 0; }
.origin { text-align: right; margin: 0; color: #52606d; white-space: nowrap; }
.synthetic { display: inline-block; margin: 8px 0 0; padding: 2px 10px; border: 1px solid #b7791f; border-radius: 3px;
  background: #fff8e6; color: #7b4a00; font-size: 14px; }
header .logo { max-height: 64px; max-width: 220px; }
.title-block { display: grid; grid-template-columns: 1fr 1fr; margin: 0 0 18px; border: 1px solid #cbd2d9; font-size: 14px; }
.title-block div { display: flex; gap: 10px; padding: 3px 10px; border-bottom: 1px solid #e4e7eb; }
.title-block dt { flex: 0 0 9em; color: #52606d; } .title-block dd { margin: 0; font-weight: 600; overflow-wrap: anywhere; }
.title-block .signature { min-height: 2.6em; }
.answer { margin: 0 0 18px; padding: 14px 18px; background: #f0f4f8; border-left: 6px solid #829ab1; break-inside: avoid; }
.answer .head { font-size: 21px; line-height: 1.35; font-weight: 600; margin: 0; }
.answer .limit { font-size: 15px; font-weight: 400; color: #52606d; margin-left: 8px; }
.answer p { margin: 6px 0 0; } .answer ul { margin: 6px 0 0; padding-left: 20px; }
.answer .assumed { font-style: italic; color: #7a4f00; }
.answer .ruler { margin: 8px 0 0; max-width: 620px; }
.verdict { display: inline-block; margin-right: 8px; padding: 0 12px; border-radius: 4px; color: #fff; white-space: nowrap;
  background: #52606d; }
.pass .verdict { background: #177a53; } .fail .verdict { background: #b3261e; } .undecided .verdict { background: #8a5a00; }
.answer.pass { background: #e6f6ef; border-color: #1f9d6b; }
.answer.fail { background: #fdecea; border-color: #c0362c; }
.answer.undecided { background: #fff8e6; border-color: #b7791f; }
.grid { display: grid; grid-template-columns: repeat(auto-fill, minmax(420px, 1fr)); gap: 10px 36px; align-items: start; }
.table { margin-bottom: 14px; }
table { border-collapse: collapse; width: 100%; font-size: 14px; }
caption { margin: 0; padding-bottom: 6px; }
th, td { padding: 4px 8px 4px 0; border-bottom: 1px solid #e4e7eb; vertical-align: baseline; text-align: left; }
th { font-weight: 400; }
thead th, thead .number { white-space: normal; }
thead th { font-weight: 600; color: #52606d; border-bottom: 1px solid #9aa5b1; }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.quantities .number { font-weight: 600; }
.unit { color: #52606d; width: 3.2em; padding-left: 0; }
.rows th, .rows td { padding: 3px 10px; }
.rows th:first-child, .rows td:first-child { padding-left: 0; }
.path, .digest { overflow-wrap: anywhere; }
.digest { font: 12px/1.5 "DejaVu Sans Mono", Consolas, monospace; }
figure { margin: 14px 0; }
figure svg, figure img { display: block; width: 100%; height: auto; }
figcaption { color: #52606d; font-size: 13px; margin-top: 4px; }
.notes { margin: 14px 0; padding: 10px 18px; list-style: none; background: #f7f9fb; border: 1px solid #e4e7eb; }
.notes li { margin: 3px 0; }
.notes li::before { content: "\2013\00a0"; color: #829ab1; }
.notes .warning::before { content: none; }
.notes .warning b { display: inline-block; min-width: 1.25em; text-align: center; margin-right: .35em; border-radius: 3px;
  background: #b7791f; color: #fff; }
@page { size: A4; margin: 14mm 15mm; }
@media print {
  body { padding: 0; max-width: none; font-size: 10pt; print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  h1 { font-size: 17pt; } h2 { font-size: 12.5pt; break-after: avoid; } h3 { break-after: avoid; }
  .answer .head { font-size: 13.5pt; } table { font-size: 9pt; } .digest { font-size: 7.5pt; }
  .grid { grid-template-columns: 1fr 1fr; gap: 6px 24px; }
  figure, .notes, .quantities, .title-block, tr { break-inside: avoid; }
}
)css";

}  // namespace lathelier::report
