"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const SVG = "http://www.w3.org/2000/svg";
const COLOURS = ["#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#17becf", "#8c564b", "#e377c2", "#7f7f7f", "#bcbd22"];

function add(parent, name, attributes = {}, text = "") {
  const drawing = parent.namespaceURI === SVG || name === "svg";
  const made = drawing ? document.createElementNS(SVG, name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text) made.textContent = text;
  parent.appendChild(made);
  return made;
}

function number(value) {
  return Number(value.toPrecision(5)).toString();
}

// Pictures: one field at a time, stepped through in time.
function showPictures(parent, sets) {
  const controls = add(parent, "div", { class: "controls" });
  const field = add(controls, "select", { "aria-label": "field" });
  sets.forEach((set, k) => add(field, "option", { value: k }, set.field));
  const back = add(controls, "button", { "aria-label": "previous frame" }, "◀");
  const play = add(controls, "button", { "aria-label": "play" }, "play");
  const forward = add(controls, "button", { "aria-label": "next frame" }, "▶");
  const slider = add(controls, "input", { type: "range", min: 0, step: 1, "aria-label": "time" });
  const label = add(controls, "span", { class: "time" });
  const image = add(parent, "img", { alt: "picture of the field" });
  let timer = null;

  function show(at) {
    const set = sets[field.value];
    slider.max = set.images.length - 1;
    slider.value = Math.max(0, Math.min(at, set.images.length - 1));
    image.src = set.images[slider.value];
    label.textContent = `t = ${number(set.times[slider.value])} s`;
  }
  function stop() {
    clearInterval(timer);
    timer = null;
    play.textContent = "play";
  }
  function step(by) {
    const count = Number(slider.max) + 1;
    show((Number(slider.value) + by + count) % count);
  }
  field.onchange = () => show(Number(slider.value));
  slider.oninput = () => { stop(); show(Number(slider.value)); };
  back.onclick = () => { stop(); step(-1); };
  forward.onclick = () => { stop(); step(1); };
  play.onclick = () => {
    if (timer) return stop();
    timer = setInterval(() => step(1), 150);
    play.textContent = "stop";
  };
  field.value = 0;
  show(sets[0].images.length - 1);
}

// Round steps for about `count` ticks.
function ticks(low, high, count) {
  const raw = (high - low) / count || 1;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((k) => k * power).find((k) => k >= raw) || raw;
  const all = [];
  const first = Math.ceil(low / step);
  for (let k = 0; k <= 2 * count && (first + k) * step <= high + 1e-9 * step; k++) all.push((first + k) * step);
  return all;
}

class Chart {
  constructor(parent, chart) {
    this.chart = chart;
    this.hidden = new Set();
    this.all = [chart.times[0], chart.times[chart.times.length - 1]];
    if (this.all[0] === this.all[1]) this.all[1] += 1;
    this.span = this.all;
    const box = add(parent, "div", { class: "chart" });
    add(box, "strong", {}, chart.unit ? `${chart.title} (${chart.unit})` : chart.title);
    this.svg = add(box, "svg", { viewBox: "0 0 520 260", role: "img" });
    this.readout = add(box, "div", { class: "readout" });
    this.legend = add(box, "div", { class: "legend" });
    chart.curves.forEach((curve, k) => this.addName(curve, k));
    this.svg.addEventListener("pointerdown", (event) => { this.from = this.place(event); });
    this.svg.addEventListener("pointermove", (event) => this.move(event));
    window.addEventListener("pointerup", (event) => this.release(event));
    this.svg.addEventListener("dblclick", () => { this.span = this.all; this.draw(); });
    this.draw();
  }

  addName(curve, k) {
    const name = add(this.legend, "button", { title: curve.meaning }, `● ${curve.name}`);
    name.style.color = COLOURS[k % COLOURS.length];
    name.onclick = () => {
      if (!this.hidden.delete(k)) this.hidden.add(k);
      name.classList.toggle("off");
      this.draw();
    };
  }

  // Where the pointer is, in the units of the drawing.
  place(event) {
    const box = this.svg.getBoundingClientRect();
    return Math.max(60, Math.min(510, ((event.clientX - box.left) / box.width) * 520));
  }
  x(time) { return 60 + (450 * (time - this.span[0])) / (this.span[1] - this.span[0]); }
  time(x) { return this.span[0] + ((x - 60) / 450) * (this.span[1] - this.span[0]); }

  move(event) {
    const at = this.place(event);
    if (this.from !== undefined) {
      this.band.setAttribute("x", Math.min(at, this.from));
      this.band.setAttribute("width", Math.abs(at - this.from));
    }
    const { times, curves } = this.chart;
    const now = this.time(at);
    let near = 0;
    times.forEach((t, k) => { if (Math.abs(t - now) < Math.abs(times[near] - now)) near = k; });
    const said = curves.map((c, k) => [c, k]).filter(([, k]) => !this.hidden.has(k))
      .map(([c]) => `${c.name} ${c.values[near] === null ? "-" : number(c.values[near])}`);
    this.readout.textContent = `t = ${number(times[near])} s: ${said.join(", ")}`;
  }

  release(event) {
    if (this.from === undefined) return;
    const ends = [this.from, this.place(event)].sort((a, b) => a - b);
    this.from = undefined;
    if (ends[1] - ends[0] > 5) this.span = ends.map((x) => this.time(x));
    this.draw();
  }

  draw() {
    this.svg.textContent = "";
    const { times, curves } = this.chart;
    const inside = (k) => times[k] >= this.span[0] && times[k] <= this.span[1];
    const seen = curves.filter((_, k) => !this.hidden.has(k))
      .flatMap((c) => c.values.filter((v, k) => v !== null && inside(k)));
    let low = Math.min(...seen), high = Math.max(...seen);
    if (!seen.length) [low, high] = [0, 1];
    const size = Math.max(Math.abs(low), Math.abs(high)) || 1;
    if (high - low < 1e-9 * size) [low, high] = [low - 0.1 * size, high + 0.1 * size]; // rounding only
    const y = (value) => 225 - (210 * (value - low)) / (high - low);
    for (const value of ticks(low, high, 5)) {
      add(this.svg, "line", { x1: 60, x2: 510, y1: y(value), y2: y(value), stroke: "#e8e8e8" });
      add(this.svg, "text", { x: 55, y: y(value) + 4, "text-anchor": "end" }, number(value));
    }
    for (const time of ticks(...this.span, 5)) {
      add(this.svg, "line", { x1: this.x(time), x2: this.x(time), y1: 15, y2: 225, stroke: "#e8e8e8" });
      add(this.svg, "text", { x: this.x(time), y: 240, "text-anchor": "middle" }, number(time));
    }
    add(this.svg, "text", { x: 285, y: 256, "text-anchor": "middle" }, "time (s)");
    curves.forEach((curve, k) => {
      if (this.hidden.has(k)) return;
      let path = "", pen = "M";
      curve.values.forEach((value, row) => {
        if (value === null || !inside(row)) { pen = "M"; return; }
        path += `${pen}${this.x(times[row]).toFixed(2)} ${y(value).toFixed(2)}`;
        pen = "L";
      });
      add(this.svg, "path", { d: path, fill: "none", stroke: COLOURS[k % COLOURS.length], "stroke-width": 1.6 });
    });
    this.band = add(this.svg, "rect", { x: 60, y: 15, width: 0, height: 210, fill: "#0002" });
  }
}

if (data.pictures.length) showPictures(document.getElementById("pictures"), data.pictures);
for (const chart of data.charts) new Chart(document.getElementById("charts"), chart);
