/**
 * The two charts: the phase portrait (ψ, dψ/dφ) with the motion in it, and ε over γ.
 */
"use strict";

/**
 * The frame of a chart: where it stands in its SVG, and what it shows.
 *
 * @typedef {object} Frame
 * @property {number} left
 * @property {number} right
 * @property {number} top
 * @property {number} bottom
 * @property {[number, number]} across the range of x
 * @property {[number, number]} along the range of y
 */

/** @typedef {[number, number]} Point in the units of a chart */

const DEGREE = Math.PI / 180;

/** The range of ψ in the phase portrait: one turn. */
const PORTRAIT = /** @type {[number, number]} */ ([-Math.PI / 2, 1.5 * Math.PI]);

/**
 * SVG coordinates of a point, kept within reach of the frame.
 *
 * @param {Frame} frame
 * @param {Point} point
 * @returns {[number, number]}
 */
function placed(frame, [x, y]) {
  const u = (x - frame.across[0]) / (frame.across[1] - frame.across[0]);
  const v = (y - frame.along[0]) / (frame.along[1] - frame.along[0]);
  return [
    frame.left + clamp(u, -1, 2) * (frame.right - frame.left),
    frame.bottom - clamp(v, -1, 2) * (frame.bottom - frame.top),
  ];
}

/**
 * The drawing commands of a line through points; a point that is not a number breaks it.
 *
 * @param {Frame} frame
 * @param {Point[]} points
 * @returns {string}
 */
function curve(frame, points) {
  let commands = "";
  let open = false;
  for (const point of points) {
    if (Number.isFinite(point[0] + point[1])) {
      const [x, y] = placed(frame, point);
      commands += `${open ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`;
      open = true;
    } else {
      open = false;
    }
  }
  return commands;
}

/**
 * An empty chart: its frame, ticks and the names of its axes.
 *
 * @param {Element} svg whose title and description stay
 * @param {Frame} frame
 * @param {{ at: number, text: string }[]} xTicks
 * @param {{ at: number, text: string }[]} yTicks
 * @param {[string, string]} names
 * @returns {Element} a group that is clipped to the frame, for curves
 */
function emptyChart(svg, frame, xTicks, yTicks, names) {
  svg.querySelectorAll("g, clipPath").forEach((part) => part.remove());
  const { left, right, top, bottom } = frame;
  const box = { x: left, y: top, width: right - left, height: bottom - top };
  const clip = add(svg, "clipPath", { id: `${svg.id}-frame` });
  add(clip, "rect", box);
  const axes = add(svg, "g", { class: "axes" });
  for (const { at, text } of xTicks) {
    const [x] = placed(frame, [at, frame.along[0]]);
    add(axes, "path", { d: `M${x} ${top}V${bottom}` });
    add(axes, "text", { x, y: bottom + 18, class: "middle" }).textContent = text;
  }
  for (const { at, text } of yTicks) {
    const [, y] = placed(frame, [frame.across[0], at]);
    add(axes, "path", { d: `M${left} ${y}H${right}` });
    add(axes, "text", { x: left - 7, y: y + 4.5, class: "end" }).textContent = text;
  }
  add(axes, "rect", box);
  add(axes, "text", { x: (left + right) / 2, y: bottom + 38, class: "middle" }).textContent =
    names[0];
  add(axes, "text", { x: left, y: top - 9 }).textContent = names[1];
  return add(svg, "g", { "clip-path": `url(#${svg.id}-frame)` });
}

/**
 * Round numbers in a range, about four of them.
 *
 * @param {[number, number]} range
 * @param {string} [unit]
 * @returns {{ at: number, text: string }[]}
 */
function roundTicks([low, high], unit = "") {
  const rough = (high - low) / 4;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((x) => x * power).find((x) => x >= rough) ?? rough;
  const ticks = [];
  for (let i = Math.ceil(low / step); i * step <= high; i++) {
    const at = i * step;
    const text =
      at === 0 ? "0" : Math.abs(at) < 1e-3 ? at.toExponential(0) : `${Number(at.toPrecision(3))}`;
    ticks.push({ at, text: withMinus(text) + unit });
  }
  return ticks;
}

/**
 * @param {string} text
 * @returns {string} the same with the sign that is as wide as a plus
 */
function withMinus(text) {
  return text.replace(/-/g, "−");
}

/**
 * dψ/dφ ≥ 0 at ψ on a level; not a number where the level does not come.
 *
 * @param {Level} level
 * @param {number} psi radians
 * @returns {number}
 */
function rateAt({ a, b, gamma, clock }, psi) {
  const square = Math.sin(psi) ** 2;
  return Math.sqrt((a + b * square) * (gamma + b * square)) / (clock + b * Math.cos(psi) ** 2);
}

/**
 * The same shape on another level, for drawing.
 *
 * @param {Level} level
 * @param {number} gamma
 * @returns {Level}
 */
function onLevel(level, gamma) {
  return { ...level, gamma, above: gamma + level.b, below: level.a - gamma };
}

/**
 * The phase portrait with the motion in it.
 *
 * @param {Element} svg
 * @param {Orbit} orbit
 * @param {number} end u at the end of the motion
 * @returns {Frame}
 */
function drawPortrait(svg, orbit, end) {
  const { level } = orbit;
  const separatrix = onLevel(level, 0);
  const crest = Math.min(rateAt(separatrix, Math.PI / 2), 2.5 * rateAt(separatrix, Math.PI / 4));
  const reach = Math.max(1.7 * crest, Math.min(1.15 * rateAt(level, Math.PI / 2) || 0, 5 * crest));
  const frame = {
    left: 62,
    right: 456,
    top: 26,
    bottom: 292,
    across: PORTRAIT,
    along: /** @type {Point} */ ([-reach, reach]),
  };
  const xTicks = [-90, 0, 90, 180, 270].map((x) => ({ at: x * DEGREE, text: withMinus(`${x}°`) }));
  const inside = emptyChart(svg, frame, xTicks, roundTicks(frame.along), ["flip angle ψ", "dψ/dφ"]);
  const tall = (reach / crest) ** 2;
  for (const share of [0.85, 0.5, 0.2, 0.05])
    addLevel(inside, frame, onLevel(level, -share * level.b), "oscillating");
  for (const share of [0.1, 0.5, 1.2, 2.2, 4, 8, 16]) {
    const gamma = share * level.b;
    if (share < tall && gamma < level.a) addLevel(inside, frame, onLevel(level, gamma), "rotating");
  }
  addLevel(inside, frame, separatrix, "separatrix");
  for (const x of [0, 180]) addSpot(inside, frame, [x * DEGREE, 0], "unstable");
  for (const x of [-90, 90, 270]) addSpot(inside, frame, [x * DEGREE, 0], "stable");
  add(inside, "path", { class: "this-motion", d: curve(frame, motionCurve(orbit, end)) });
  addSpot(inside, frame, phasePoint(orbit, -end), "start");
  add(inside, "circle", { class: "now", r: 6.5 });
  return frame;
}

/**
 * @param {Element} group
 * @param {Frame} frame
 * @param {Level} level
 * @param {string} kind
 */
function addLevel(group, frame, level, kind) {
  /** @type {Point[][]} */
  const sides = [[], []];
  const turning = level.gamma < 0 ? Math.asin(Math.sqrt(-level.gamma / level.b)) : 0;
  for (let cell = -1; cell <= 1; cell++) {
    // Cosine steps: dense at the turning points, where the curve is steep.
    for (let i = 0; i <= 40; i++) {
      const share = (1 - Math.cos((Math.PI * i) / 40)) / 2;
      const psi = cell * Math.PI + turning + share * (Math.PI - 2 * turning);
      const rate = rateAt(level, psi) || 0;
      sides[0].push([psi, rate]);
      sides[1].push([psi, -rate]);
    }
    if (turning > 0) sides.forEach((side) => side.push([NaN, NaN]));
  }
  for (const side of sides) add(group, "path", { class: kind, d: curve(frame, side) });
}

/**
 * @param {Element} group
 * @param {Frame} frame
 * @param {Point} point
 * @param {string} kind
 */
function addSpot(group, frame, point, kind) {
  const [cx, cy] = placed(frame, point);
  add(group, "circle", { class: kind, cx, cy, r: kind === "start" ? 4 : 4.5 });
}

/**
 * The point of the phase plane at a time, ψ brought into the portrait.
 *
 * @param {Orbit} orbit
 * @param {number} time u
 * @returns {Point}
 */
function phasePoint(orbit, time) {
  const { psi, theta } = attitudeAt(orbit, time);
  const { a, b, clock } = orbit.level;
  const rate = ((a + b * Math.sin(psi) ** 2) * Math.cos(theta)) / (clock + b * Math.cos(psi) ** 2);
  const turn = 2 * Math.PI;
  return [psi - turn * Math.floor((psi - PORTRAIT[0]) / turn), rate];
}

/**
 * The way of the motion through the phase plane, broken where it leaves on one side to come back on
 * the other. A motion that comes round again is drawn once.
 *
 * @param {Orbit} orbit
 * @param {number} end u at the end of the motion
 * @returns {Point[]}
 */
function motionCurve(orbit, end) {
  const last = Math.min(end, 2.02 * orbit.quarterTime);
  /** @type {Point[]} */
  const points = [];
  for (let i = 0; i <= 300; i++) {
    const point = phasePoint(orbit, last * (i / 150 - 1));
    const before = points.at(-1);
    if (before && Math.abs(point[0] - before[0]) > Math.PI) points.push([NaN, NaN]);
    points.push(point);
  }
  return points;
}

/**
 * Put the dot of the phase portrait where the motion is.
 *
 * @param {Element} svg
 * @param {Frame} frame
 * @param {Orbit} orbit
 * @param {number} time u
 */
function movePoint(svg, frame, orbit, time) {
  const [x, y] = placed(frame, phasePoint(orbit, time));
  const dot = /** @type {Element} */ (svg.querySelector(".now"));
  dot.setAttribute("cx", x.toFixed(1));
  dot.setAttribute("cy", y.toFixed(1));
}

/**
 * ε over γ around the level: exact, the paper's line, γ* and the level itself.
 *
 * @param {Element} svg
 * @param {Level} level
 * @param {number} defect ε of the level
 * @param {number | null} turning γ*
 */
function drawChart(svg, level, defect, turning) {
  const { a, b, gamma } = level;
  const start = separatrixDefect(level);
  const wide = Math.max(1.4 * Math.abs(gamma), 8 * b * start * start, 2.2 * Math.abs(turning ?? 0));
  const low = Math.max(-wide, -b * (1 - 1e-6));
  const high = Math.min(wide, a * (1 - 1e-6));
  /** @type {Point[]} */
  const exact = [];
  for (let i = 0; i <= 120; i++) {
    const x = low + ((high - low) * i) / 120;
    exact.push([x, flipDefect(onLevel(level, x)) / DEGREE]);
  }
  const heights = [...exact.map(([, y]) => y), defect / DEGREE];
  const bottom = Math.min(...heights, 0);
  const top = Math.max(...heights);
  const margin = 0.08 * (top - bottom);
  const frame = {
    left: 62,
    right: 456,
    top: 26,
    bottom: 292,
    across: /** @type {Point} */ ([low, high]),
    along: /** @type {Point} */ ([bottom - margin, top + margin]),
  };
  const inside = emptyChart(svg, frame, roundTicks(frame.across), roundTicks(frame.along, "°"), [
    "γ",
    "defect ε",
  ]);
  if (turning !== null) {
    add(inside, "path", {
      class: "turning",
      d: curve(frame, [
        [turning, frame.along[0]],
        [turning, frame.along[1]],
      ]),
    });
  }
  add(inside, "path", { class: "exact", d: curve(frame, exact) });
  const line = [low, high].map(
    (x) => /** @type {Point} */ ([x, printedLine(onLevel(level, x)) / DEGREE]),
  );
  add(inside, "path", { class: "paper", d: curve(frame, clipped(line, frame.along)) });
  addSpot(inside, frame, [gamma, defect / DEGREE], "level");
}

/**
 * The part of a straight line within a range of heights.
 *
 * @param {Point[]} line its two ends
 * @param {[number, number]} along
 * @returns {Point[]}
 */
function clipped([[x0, y0], [x1, y1]], [low, high]) {
  const slope = (y1 - y0) / (x1 - x0);
  return [low, high].map((limit) => {
    const y = limit === low ? Math.max(Math.min(y0, y1), low) : Math.min(Math.max(y0, y1), high);
    return [x0 + (y - y0) / slope, y];
  });
}
