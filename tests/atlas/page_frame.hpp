// What surrounds the cases on the page of the atlas: style, and the box that filters them.

#pragma once

#include <string_view>

namespace atlas {

inline constexpr std::string_view kPageStyle =
    R"css(:root { --off: #c2410c; --on: #1d4ed8; --gate: var(--good); }
@media (prefers-color-scheme: dark) { :root { --off: #fb923c; --on: #7aa7ff; } }
.row { display: flex; flex-wrap: wrap; gap: 1rem; margin-top: .6rem; }
figure img { width: 192px; height: 192px; image-rendering: pixelated; border: 1px solid var(--line); display: block; }
svg { width: 330px; height: 170px; display: block; }
svg text { font: 10px system-ui, sans-serif; fill: var(--faint); }
svg .frame { fill: none; stroke: var(--line); }
svg .off { fill: none; stroke: var(--off); stroke-width: 1.5; } svg circle.off { fill: var(--off); }
svg .on { fill: none; stroke: var(--on); stroke-width: 1.5; } svg circle.on { fill: var(--on); }
svg .gate { stroke: var(--gate); stroke-dasharray: 4 3; } svg .worst { stroke: var(--faint); stroke-dasharray: 1 3; }
.off-word { color: var(--off); } .on-word { color: var(--on); } .gate-word { color: var(--gate); }
input { font: inherit; padding: .2rem .5rem; width: 16rem; }
)css";

inline constexpr std::string_view kPageTop = R"html(<h1>The atlas of failures</h1>
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

} // namespace atlas
