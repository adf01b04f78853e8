// What surrounds the cases on the page of the atlas: style, and the box that filters them.

#pragma once

#include <string_view>

namespace atlas {

inline constexpr std::string_view kPageStart = R"html(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>The atlas of failures</title>
<style>
:root { color-scheme: light dark; --ink: #222; --paper: #fff; --faint: #777; --line: #d8d8d8;
  --off: #c2410c; --on: #1d4ed8; --gate: #15803d; --bad: #b91c1c; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e6e6; --paper: #16181c; --faint: #9a9a9a; --line: #3a3d44;
  --off: #fb923c; --on: #7aa7ff; --gate: #4ade80; --bad: #f87171; } }
body { font: 15px/1.45 system-ui, sans-serif; color: var(--ink); background: var(--paper);
  max-width: 1120px; margin: 2rem auto; padding: 0 1rem; }
h1 { margin-bottom: 0; } h2 { font-size: 1.1rem; margin: 0; }
p { margin: .3rem 0; } code { font-size: .92em; }
table { border-collapse: collapse; width: 100%; font-size: .9rem; margin: 1rem 0; }
th, td { text-align: left; padding: .2rem .6rem .2rem 0; border-bottom: 1px solid var(--line); vertical-align: top; }
td.number, th.number { text-align: right; white-space: nowrap; }
a { color: inherit; }
section { border-top: 1px solid var(--line); padding: 1rem 0; }
.row { display: flex; flex-wrap: wrap; gap: 1rem; margin-top: .6rem; }
figure { margin: 0; } figcaption { font-size: .8rem; color: var(--faint); }
figure img { width: 192px; height: 192px; image-rendering: pixelated; border: 1px solid var(--line); display: block; }
svg { width: 330px; height: 170px; display: block; }
svg text { font: 10px system-ui, sans-serif; fill: var(--faint); }
svg .frame { fill: none; stroke: var(--line); }
svg .off { fill: none; stroke: var(--off); stroke-width: 1.5; } svg circle.off { fill: var(--off); }
svg .on { fill: none; stroke: var(--on); stroke-width: 1.5; } svg circle.on { fill: var(--on); }
svg .gate { stroke: var(--gate); stroke-dasharray: 4 3; } svg .worst { stroke: var(--faint); stroke-dasharray: 1 3; }
.off-word { color: var(--off); } .on-word { color: var(--on); } .gate-word { color: var(--gate); }
.bad { color: var(--bad); font-weight: 600; } .faint { color: var(--faint); }
input { font: inherit; padding: .2rem .5rem; width: 16rem; }
</style>
</head>
<body>
<h1>The atlas of failures</h1>
<p class="faint">Every way in which a technique is known to go wrong, swept through one parameter and held against
ray-traced truth: <span class="off-word">with the remedy switched off</span>, <span class="on-word">with it on</span>,
and <span class="gate-word">the limit that the picture has to keep</span>. The dotted line is the step of the pictures.</p>
)html";

inline constexpr std::string_view kFilterBox = R"html(
<p><label>Show <input id="filter" type="search" placeholder="M2, or V, or a word of a remedy"></label></p>
<script>
document.getElementById("filter").addEventListener("input", event => {
  const wanted = event.target.value.trim().toLowerCase();
  for (const one of document.querySelectorAll("[data-case]")) {
    const words = one.dataset.case.toLowerCase().split(" ");
    one.hidden = wanted !== "" && !words.some(word => word.startsWith(wanted)) && !words.join(" ").includes("_" + wanted);
  }
});
</script>
)html";

inline constexpr std::string_view kPageEnd = "</body>\n</html>\n";

} // namespace atlas
