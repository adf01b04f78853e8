// What moves on a page of charts: style, panel and script.

#pragma once

#include <string_view>

namespace chart {

inline constexpr std::string_view kChartPageStyle =
    R"css(.axes { display: flex; flex-wrap: wrap; gap: .4rem 1rem; font-size: .85rem; margin: .5rem 0; }
.axes fieldset { border: 1px solid var(--line); border-radius: 4px; margin: 0; padding: .2rem .7rem; }
.axes label { margin-left: .6rem; white-space: nowrap; }
.view[hidden], .gone { display: none; }
#tip { position: fixed; z-index: 2; pointer-events: none; max-width: 24rem; padding: .4rem .6rem; font-size: .8rem;
  background: var(--paper); border: 1px solid var(--faint); border-radius: 4px; }
#tip[hidden] { display: none; } #tip td { border: 0; padding: 0 .8rem 0 0; } #tip table { margin: .2rem 0 0; }
#panel { border: 1px solid var(--faint); border-radius: 4px; padding: .6rem .9rem .9rem; margin: .6rem 0; }
#panel[hidden] { display: none; } #panel header { display: flex; justify-content: space-between; }
#panel .pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(25rem, 1fr)); gap: .8rem; }
#panel img { width: 100%; display: block; border: 1px solid var(--line); }
#panel .facts { columns: 3 14rem; font-size: .85rem; margin: .5rem 0; }
#panel .facts div { break-inside: avoid; } #panel .facts b { font-weight: 600; }
button { font: inherit; }
)css";

inline constexpr std::string_view kHowToRead =
    R"html(<p class="faint">Down is more accurate, left is cheaper; no point
beats those on the green band. The line joins what <code>auto</code> picks, with the error that it was allowed. What is
exactly zero lies in the shaded gutters. Stay on a point to read it, click it to see its pictures; a line of the legend
hides and shows its points.</p>
)html";

inline constexpr std::string_view kPanel = R"html(<div id="tip" role="status" hidden></div>
<div id="panel" hidden><header><h2></h2><button type="button">close</button></header><div class="facts"></div>
<div class="pictures"></div></div>
)html";

inline constexpr std::string_view kScript = R"html(<script>
"use strict";
const charts = JSON.parse(document.getElementById("data").textContent);
const tip = document.getElementById("tip");
const panel = document.getElementById("panel");
const form = document.querySelector(".axes");
const off = new Set();

function element(kind, text) {
  const made = document.createElement(kind);
  made.textContent = text;
  return made;
}

// The mark that an event belongs to, with its chart and point.
function mark_of(event) {
  const mark = event.target.closest(".p");
  if (!mark) return null;
  const chart = Number(mark.closest("section").dataset.chart);
  return { mark, chart, point: Number(mark.dataset.point) };
}

function show_views() {
  const up = new FormData(form).get("up");
  const across = new FormData(form).get("across");
  for (const view of document.querySelectorAll(".view"))
    view.hidden = view.dataset.up !== up || view.dataset.across !== across;
  tip.hidden = true;
}

function show_series() {
  for (const one of document.querySelectorAll("svg [data-series]")) {
    const is_off = off.has(one.dataset.series);
    if (one.classList.contains("key")) {
      one.classList.toggle("off", is_off);
      one.setAttribute("aria-checked", String(!is_off));
    } else {
      one.classList.toggle("gone", is_off);
    }
  }
}

function show_tip(found) {
  const point = charts[found.chart].points[found.point];
  const table = document.createElement("table");
  for (const [name, value] of point.facts) {
    const row = table.insertRow();
    row.insertCell().textContent = name;
    row.insertCell().textContent = value;
  }
  tip.replaceChildren(element("b", point.name), table);
  tip.hidden = false;
  const box = found.mark.getBoundingClientRect();
  const right = box.right + 12 + tip.offsetWidth < innerWidth;
  tip.style.left = (right ? box.right + 12 : Math.max(0, box.left - 12 - tip.offsetWidth)) + "px";
  tip.style.top = Math.max(0, Math.min(box.top, innerHeight - tip.offsetHeight - 8)) + "px";
}

function figure(address, caption, name) {
  const made = document.createElement("figure");
  const image = document.createElement("img");
  image.src = address;
  image.alt = caption + " of " + name;
  made.append(image, element("figcaption", caption));
  return made;
}

const captions = { picture: "the picture", mask: "its mask: white is lit",
  error: "its errors: red should be lit, blue should be dark, grey is not judged" };

function pin(found) {
  const point = charts[found.chart].points[found.point];
  panel.querySelector("h2").textContent = point.name;
  panel.querySelector(".facts").replaceChildren(...point.facts.map(([name, value]) => {
    const line = element("div", name + ": ");
    line.append(element("b", value));
    return line;
  }));
  const pictures = Object.keys(captions).filter(kind => point.pictures[kind]);
  const figures = pictures.map(kind => figure(point.pictures[kind], captions[kind], point.name));
  if (figures.length && charts[found.chart].truth)
    figures.push(figure(charts[found.chart].truth, "the true mask", "the light"));
  panel.querySelector(".pictures").replaceChildren(...figures);
  document.querySelector(`section[data-chart="${found.chart}"]`).append(panel);
  panel.hidden = false;
  tip.hidden = true;
  for (const mark of document.querySelectorAll("section .p"))
    mark.classList.toggle("pinned", Number(mark.dataset.point) === found.point
      && Number(mark.closest("section").dataset.chart) === found.chart);
}

function unpin() {
  panel.hidden = true;
  for (const mark of document.querySelectorAll(".pinned")) mark.classList.remove("pinned");
}

function press(event) {
  const found = mark_of(event);
  const key = event.target.closest(".key");
  if (found) pin(found);
  if (key) {
    const series = key.dataset.series;
    if (!off.delete(series)) off.add(series);
    show_series();
  }
  return found || key;
}

form.addEventListener("change", show_views);
panel.querySelector("button").addEventListener("click", unpin);
document.addEventListener("click", press);
document.addEventListener("keydown", event => {
  if (event.key === "Escape") unpin();
  if ((event.key === "Enter" || event.key === " ") && press(event)) event.preventDefault();
});
for (const kind of ["mouseover", "focusin"])
  document.addEventListener(kind, event => {
    const found = mark_of(event);
    if (found) show_tip(found);
  });
for (const kind of ["mouseout", "focusout"])
  document.addEventListener(kind, event => {
    if (mark_of(event)) tip.hidden = true;
  });
show_views();
</script>
)html";

} // namespace chart
