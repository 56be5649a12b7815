// The text of the style sheet.

#include "program/report/page_style.h"

namespace spoke::report {
namespace {

// The colours of series are those of Okabe and Ito, which differ for the colour-blind, darkened or
// lightened to stand out from the background by a contrast of 3 or more. Print is always light.
constexpr std::string_view kStyle = R"(
:root {
  color-scheme: light dark;
  --paper: #ffffff; --panel: #f7f8fa; --ink: #1a1d21; --soft: #5b6470; --rule: #dfe3e8;
  --good: #00795a; --warning: #9a5b00; --bad: #b3341a;
  --s0: #0072b2; --s1: #d55e00; --s2: #009067; --s3: #b3568b;
  --s4: #b07d00; --s5: #3a93c9; --s6: #6b7280; --s7: #7a4fbf;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --paper: #14171b; --panel: #1b1f25; --ink: #e6e9ed; --soft: #9aa4b1; --rule: #323943;
    --good: #4cc9a0; --warning: #e8b04a; --bad: #ff8f73;
    --s0: #4ea8e0; --s1: #ff8a3c; --s2: #2fc49a; --s3: #e59ac4;
    --s4: #e8b93a; --s5: #8fd0f5; --s6: #a3acb8; --s7: #b79aef;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0; background: var(--paper); color: var(--ink);
  font: 16px/1.55 system-ui, -apple-system, "Segoe UI", "Noto Sans", "DejaVu Sans", sans-serif;
}
main { max-width: 66rem; margin: 0 auto; padding: 3rem 1.5rem 4rem; }
header { border-bottom: 1px solid var(--rule); margin-bottom: 2rem; padding-bottom: 1.25rem; }
h1 { font-size: 1.9rem; line-height: 1.2; letter-spacing: -0.015em; margin: 0; text-wrap: balance; }
header p { color: var(--soft); font-size: 1.05rem; margin: 0.5rem 0 0; max-width: none; }
h2 { font-size: 1.25rem; line-height: 1.3; letter-spacing: -0.01em; margin: 2.75rem 0 0.75rem; }
p { margin: 0.75rem 0; max-width: 46rem; overflow-wrap: anywhere; }
.note {
  border-left: 4px solid var(--tone, var(--s0)); background: var(--panel);
  border-radius: 0 8px 8px 0; padding: 0.5rem 1.2rem; margin: 1.25rem 0;
}
.note p { margin: 0.45rem 0; max-width: none; }
.good { --tone: var(--good); } .warning { --tone: var(--warning); }
.bad { --tone: var(--bad); } .muted { --tone: var(--soft); }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0.25rem 1.5rem; margin: 1rem 0; }
main > dl { border: 1px solid var(--rule); border-radius: 10px; padding: 1rem 1.2rem; font-size: 0.9rem; }
dt { color: var(--soft); } dd { margin: 0; overflow-wrap: anywhere; }
.scroll { overflow-x: auto; margin: 1.25rem 0; }
table { border-collapse: collapse; width: 100%; font-size: 0.875rem; }
caption { text-align: left; color: var(--soft); padding-bottom: 0.6rem; font-size: 0.9rem; }
caption span { display: inline-block; position: sticky; left: 0; max-width: calc(100vw - 3rem); }
th, td { text-align: left; padding: 0.38rem 0.6rem; vertical-align: baseline; }
th:first-child, td:first-child { padding-left: 0.4rem; }
th { font-weight: 600; vertical-align: bottom; border-bottom: 2px solid var(--rule); }
td { border-bottom: 1px solid var(--rule); white-space: nowrap; }
td:last-child:not(.number) { white-space: normal; min-width: 8rem; }
.number { text-align: right; font-variant-numeric: tabular-nums; }
tr[class] td { color: var(--tone); } tr.good td { font-weight: 600; }
tbody tr:hover td { background: var(--panel); }
figure { margin: 1.25rem 0; break-inside: avoid; }
main > figure { border: 1px solid var(--rule); border-radius: 10px; padding: 1.1rem 1.3rem; }
figcaption { color: var(--soft); font-size: 0.9rem; margin-top: 0.4rem; }
figure .scroll { margin: 0; }
svg.chart { display: block; width: 100%; min-width: 36rem; height: auto; }
svg.chart text { fill: var(--ink); font-size: 12.5px; font-variant-numeric: tabular-nums; }
svg.chart .title { font-size: 15px; font-weight: 600; }
svg.chart .axis, svg.chart .tick, svg.chart .value { fill: var(--soft); }
svg.chart .value { font-size: 11px; }
svg.chart .middle { text-anchor: middle; } svg.chart .end { text-anchor: end; }
svg.chart .grid { stroke: var(--rule); stroke-width: 1; }
svg.chart .base { stroke: var(--soft); stroke-width: 1; }
svg.chart .error { stroke: var(--ink); stroke-width: 1.25; fill: none; opacity: 0.75; }
svg.chart .reference { stroke: var(--ink); stroke-width: 1.25; stroke-dasharray: 5 4; opacity: 0.7; }
svg.chart .mark { stroke: var(--ink); stroke-width: 2.5; }
svg.chart .bar { fill: var(--c); } svg.chart .faint { opacity: 0.45; } svg.chart .bar:hover { opacity: 0.8; }
svg.chart .line { stroke: var(--c); stroke-width: 2; fill: none; stroke-linejoin: round; }
svg.chart .dashed { stroke-dasharray: 7 5; }
svg.chart .band { fill: var(--c); opacity: 0.16; }
svg.chart .point { fill: var(--c); stroke: var(--paper); stroke-width: 1.25; }
.s0 { --c: var(--s0); } .s1 { --c: var(--s1); } .s2 { --c: var(--s2); } .s3 { --c: var(--s3); }
.s4 { --c: var(--s4); } .s5 { --c: var(--s5); } .s6 { --c: var(--s6); } .s7 { --c: var(--s7); }
@media screen and (min-width: 1700px) { main { max-width: 76rem; } }
main.wide { max-width: 112rem; padding: 2.5rem 2.5rem 4rem; }
h3 { font-size: 0.95rem; margin: 0 0 0.5rem; }
.tiles {
  display: grid; grid-template-columns: repeat(auto-fit, minmax(11.5rem, 1fr)); gap: 0.9rem;
  list-style: none; margin: 1.5rem 0; padding: 0;
}
.tiles li {
  border: 1px solid var(--rule); border-top: 3px solid var(--tone, var(--s0)); border-radius: 8px;
  background: var(--panel); padding: 0.8rem 1.05rem 0.9rem; display: flex; flex-direction: column;
}
.tiles span { color: var(--soft); font-size: 0.875rem; }
.tiles strong { font-size: 1.4rem; font-weight: 600; line-height: 1.35; letter-spacing: -0.01em;
  font-variant-numeric: tabular-nums; color: var(--tone, var(--ink)); }
.tiles small { color: var(--soft); font-size: 0.8125rem; }
.groups { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(24rem, 100%), 1fr)); gap: 0.9rem; }
.groups section {
  border: 1px solid var(--rule); border-radius: 8px; padding: 1rem 1.2rem; font-size: 0.9rem;
}
.groups dl { margin: 0; gap: 0.25rem 1.2rem; grid-template-columns: max-content minmax(0, 1fr); }
.controls {
  display: flex; flex-wrap: wrap; align-items: center; gap: 0.6rem 1.2rem; font-size: 0.9rem;
  margin: 0.75rem 0;
}
.controls label, .controls > span { display: inline-flex; align-items: center; gap: 0.55rem; }
.controls label > span, .controls .hint { color: var(--soft); }
.controls .hint { flex: 1 1 24rem; font-size: 0.8125rem; }
.controls .grow { flex: 1 1 12rem; } .controls .grow input { flex: 1; min-width: 6rem; }
.controls output { font-variant-numeric: tabular-nums; min-width: 3.6rem; }
input[type=range], input[type=checkbox] { accent-color: var(--s0); margin: 0; }
button, select {
  font: inherit; color: var(--ink); background: var(--paper); border: 1px solid var(--rule);
  border-radius: 6px; padding: 0.28rem 0.8rem; cursor: pointer;
}
button:hover:enabled, select:hover { border-color: var(--soft); }
button:disabled { color: var(--soft); cursor: default; opacity: 0.65; }
button.primary {
  background: var(--s0); border-color: var(--s0); color: var(--paper); font-weight: 600;
  min-width: 5.2rem;
}
:focus-visible { outline: 3px solid var(--s0); outline-offset: 2px; border-radius: 4px; }
.unseen { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
.animation { border: 1px solid var(--rule); border-radius: 10px; padding: 1rem 1.2rem 0.5rem; }
.views { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(26rem, 100%), 1fr)); gap: 1.2rem; }
.views figure { margin: 0; } .views figcaption { margin: 0 0 0.5rem; }
.views canvas {
  display: block; width: 100%; aspect-ratio: 1; max-height: min(34rem, 68vh); background: var(--panel);
  border-radius: 8px;
}
.views canvas { cursor: grab; touch-action: none; }
.views canvas:active { cursor: grabbing; }
.views .whole canvas { aspect-ratio: auto; height: min(44rem, 76vh); max-height: none; }
.views figure { min-width: 0; }
.looks { display: inline-flex; flex-wrap: wrap; gap: 0.35rem; }
.looks button { font-size: 0.8125rem; padding: 0.15rem 0.6rem; }
.colors { display: flex; flex-wrap: wrap; align-items: center; gap: 0.6rem; margin-top: 0.75rem;
  font-size: 0.8125rem; color: var(--soft); font-variant-numeric: tabular-nums; }
.colors[hidden], .controls label[hidden] { display: none; }
.colors .bar { width: min(16rem, 40vw); height: 0.75rem; border-radius: 4px; }
.controls label > span.y-axis { color: var(--s2); } .controls label > span.z-axis { color: var(--s3); }
.views strong, .plot strong { color: var(--ink); font-weight: 600; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(32rem, 100%), 1fr)); gap: 0.9rem; }
.plot { border: 1px solid var(--rule); border-radius: 10px; margin: 0; padding: 0.9rem 1rem 0.7rem; min-width: 0; }
.plot figcaption { margin: 0 0 0.3rem; } .plot figcaption span { margin-left: 0.6rem; }
.plot canvas:not(.swatch) {
  display: block; width: 100%; height: 15rem; cursor: crosshair; touch-action: pan-y;
}
.legend { display: flex; flex-wrap: wrap; gap: 0.1rem 0.3rem; max-height: 6.2rem; overflow-y: auto; }
.legend button {
  display: inline-flex; align-items: center; gap: 0.5rem; border-color: transparent;
  background: none; padding: 0.15rem 0.5rem; font-size: 0.8125rem;
}
.legend button[aria-pressed=false] span { text-decoration: line-through; color: var(--soft); }
.legend button[aria-pressed=false] .swatch { opacity: 0.25; }
.legend .swatch { width: 22px; height: 6px; }
.legend output { min-width: 7.5em; text-align: left; font-variant-numeric: tabular-nums; color: var(--soft); }
.side { display: grid; gap: 0.9rem; grid-template-columns: repeat(auto-fit, minmax(min(38rem, 100%), 1fr)); }
.runs { display: grid; gap: 0.9rem; }
.runs figure, .side figure { border: 1px solid var(--rule); border-radius: 10px; margin: 0; padding: 0.9rem 1rem; min-width: 0; }
.runs figcaption { margin: 0 0 0.5rem; } .runs canvas {
  display: block; width: 100%; height: 26rem; cursor: crosshair; touch-action: pan-y; user-select: none;
}
.runs .scroll canvas { touch-action: pan-x pan-y; }
.chosen { min-height: 6rem; font-size: 0.9rem; } .chosen p { max-width: none; }
code { font: 0.85em/1.5 ui-monospace, "DejaVu Sans Mono", monospace; overflow-wrap: anywhere; }
@media print {
  .controls { display: none; } main > figure, main > dl { border: none; padding: 0; }
  body { font-size: 10pt; } main { max-width: none; padding: 0; } h2 { break-after: avoid; }
  tr { break-inside: avoid; } .note, svg.chart { print-color-adjust: exact; }
  .scroll { overflow: visible; } td { white-space: normal; } svg.chart { min-width: 0; }
}
)";

}  // namespace

std::string_view page_style() { return kStyle; }

}  // namespace spoke::report
