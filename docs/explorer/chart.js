/**
 * What the charts share: a frame with ticks, and the way between its units and pixels.
 */
"use strict";

/**
 * @typedef {object} Frame
 * @property {number} left
 * @property {number} right
 * @property {number} top
 * @property {number} bottom
 * @property {[number, number]} across the range of x
 * @property {[number, number]} along the range of y
 */

/** @typedef {[number, number]} Point in the units of a chart */

/** @typedef {{ at: number, text: string }} Tick */

const DEGREE = Math.PI / 180;

/**
 * @param {Pen} pen
 * @param {[number, number]} across
 * @param {[number, number]} along
 * @returns {Frame}
 */
function frameOf(pen, across, along) {
  return { left: 58, right: pen.width - 22, top: 28, bottom: pen.height - 44, across, along };
}

/**
 * Where a point stands, kept within reach of the frame.
 *
 * @param {Frame} frame
 * @param {Point} point
 * @returns {Spot}
 */
function placed({ left, right, top, bottom, across, along }, [x, y]) {
  const u = (x - across[0]) / (across[1] - across[0]);
  const v = (y - along[0]) / (along[1] - along[0]);
  return [left + clamp(u, -3, 4) * (right - left), bottom - clamp(v, -3, 4) * (bottom - top)];
}

/**
 * The point at a spot, not beyond the frame.
 *
 * @param {Frame} frame
 * @param {Spot} spot
 * @returns {Point}
 */
function pointAt({ left, right, top, bottom, across, along }, [x, y]) {
  const u = clamp((x - left) / (right - left), 0, 1);
  const v = clamp((bottom - y) / (bottom - top), 0, 1);
  return [across[0] + u * (across[1] - across[0]), along[0] + v * (along[1] - along[0])];
}

/**
 * @param {Frame} frame
 * @param {Point[]} points
 * @returns {Spot[]}
 */
function placedAll(frame, points) {
  return points.map((point) => placed(frame, point));
}

/**
 * @param {Frame} frame
 * @returns {number[]} its box
 */
function boxOf({ left, right, top, bottom }) {
  return [left, top, right - left, bottom - top];
}

/**
 * The frame with its ticks and the names of its axes; what is drawn inside lies under the rim.
 *
 * @param {Pen} pen
 * @param {Frame} frame
 * @param {[Tick[], Tick[]]} ticks
 * @param {[string, string]} names
 * @param {() => void} draw
 */
function drawChart(pen, frame, [xTicks, yTicks], names, draw) {
  const { left, right, top, bottom } = frame;
  const quiet = { fill: COLOURS.quiet, size: 12 };
  const room = Math.max(2, Math.floor((bottom - top) / 26));
  const every = Math.ceil(yTicks.length / room);
  const shownTicks = yTicks.filter((_, i) => i % every === 0);
  for (const { at } of xTicks) grid(pen, placed(frame, [at, frame.along[0]]), [0, top - bottom]);
  for (const { at } of shownTicks)
    grid(pen, placed(frame, [frame.across[0], at]), [right - left, 0]);
  pen.inside(boxOf(frame), draw);
  const rim = /** @type {Spot[]} */ ([
    [left, top],
    [right, top],
    [right, bottom],
    [left, bottom],
  ]);
  pen.area(rim, { stroke: COLOURS.quiet, width: 1 });
  for (const { at, text } of xTicks) {
    const [x] = placed(frame, [at, frame.along[0]]);
    pen.words([x, bottom + 17], text, { ...quiet, align: "center" });
  }
  for (const { at, text } of shownTicks) {
    const [, y] = placed(frame, [frame.across[0], at]);
    pen.words([left - 7, y + 4], text, { ...quiet, align: "end" });
  }
  const name = { fill: COLOURS.ink, size: 13 };
  pen.words([(left + right) / 2, bottom + 36], names[0], { ...name, align: "center" });
  pen.words([Math.max(left - 46, 6), top - 10], names[1], name);
}

/**
 * @param {Pen} pen
 * @param {Spot} from
 * @param {[number, number]} way
 */
function grid(pen, [x, y], [dx, dy]) {
  pen.line(
    [
      [x, y],
      [x + dx, y + dy],
    ],
    { stroke: COLOURS.grid },
  );
}

/**
 * Round numbers in a range, about four of them.
 *
 * @param {[number, number]} range
 * @param {string} [unit]
 * @returns {Tick[]}
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
 * The handle of what can be dragged.
 *
 * @param {Pen} pen
 * @param {Spot} at
 * @param {string} fill
 */
function drawKnob(pen, at, fill) {
  pen.disc(at, 13, { fill, alpha: 0.22 });
  pen.disc(at, 7, { fill, stroke: COLOURS.card, width: 2 });
}
