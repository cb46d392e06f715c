// SPDX-License-Identifier: GPL-2.0-or-later
// Style sheet of the page of a run: light or dark as the reader's system is, from 400 px on.
// Scope: wide pictures and tables scroll within themselves, the page never does sideways. From
// 1500 px on, where a picture is still 680 px wide in half of it, there are two columns.
#pragma once

namespace muckpile {

inline constexpr const char* kPageStyle = R"css(
:root { color-scheme: light dark; --ground: #f6f7f8; --card: #ffffff; --ink: #1c2024; --quiet: #5b636b;
  --line: #d8dce0; --accent: #1f5a9e; --warn: #8a1c1c; --warn-ground: #fdecec; }
@media (prefers-color-scheme: dark) {
  :root { --ground: #15181b; --card: #1e2226; --ink: #e6e9ec; --quiet: #a0a8b0; --line: #363c42;
    --accent: #7fb3ec; --warn: #ffb3ab; --warn-ground: #3c1d1b; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--ground); color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
main { max-width: 1160px; margin: 0 auto; padding: 1rem; }
h1 { font-size: 1.6rem; line-height: 1.25; margin: .5rem 0; } h2 { font-size: 1.2rem; margin: 2rem 0 .6rem; }
p { margin: .4rem 0; } .quiet, figcaption { color: var(--quiet); font-size: .9rem; }
.warning { border-left: 4px solid var(--warn); background: var(--warn-ground); color: var(--warn); padding: .5rem .8rem; }
.figures { display: grid; grid-template-columns: repeat(auto-fill, minmax(155px, 1fr)); gap: .6rem; margin: 0; }
.figures div { background: var(--card); border: 1px solid var(--line); border-radius: 6px; padding: .5rem .7rem; }
.figures dt { color: var(--quiet); font-size: .85rem; } .figures dd { margin: 0; font-size: 1.3rem; }
figure { margin: 0 0 1rem; background: var(--card); border: 1px solid var(--line); border-radius: 6px; padding: .6rem; }
.wide { overflow-x: auto; } figure img { display: block; width: 100%; min-width: 680px; height: auto; background: #fff; }
.chart { width: 100%; min-width: 560px; height: auto; display: block; } .chart text { fill: var(--quiet); font-size: 13px; }
.chart .grid { stroke: var(--line); fill: none; } .chart .curve { stroke: var(--accent); stroke-width: 2; fill: none; }
table { border-collapse: collapse; width: 100%; font-size: .92rem; background: var(--card); }
th, td { text-align: left; vertical-align: top; padding: .3rem .6rem; border-bottom: 1px solid var(--line); overflow-wrap: anywhere; }
td:first-child { overflow-wrap: break-word; }
th { font-weight: 600; } td.text { text-align: right; } td.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 340px), 1fr)); gap: 0 2rem; align-items: start; }
code { font-family: ui-monospace, monospace; font-size: .85rem; overflow-wrap: anywhere; }
details { margin: .8rem 0; } summary { cursor: pointer; color: var(--accent); }
li { margin: .25rem 0; }
@media (min-width: 1500px) { main { max-width: 1900px; columns: 2; column-gap: 2rem; }
  h1, h1 + p, .warning, .figures { column-span: all; } h2 { break-after: avoid; margin-top: 1rem; }
  figure, .pair, .figures div, tr, li { break-inside: avoid; } }
)css";

}  // namespace muckpile
