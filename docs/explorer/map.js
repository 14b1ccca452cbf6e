/**
 * The map of shapes (a, b): bands of ε₀, the region of rigid bodies b ≤ 1/(a + 2), and the bodies of
 * the paper.
 */
"use strict";

const MAP = {
  a: /** @type {[number, number]} */ ([0.1, 100]),
  b: /** @type {[number, number]} */ ([0.005, 1]),
};

/** Levels of ε₀ in degrees, between the bands. */
const BANDS = [45, 30, 20, 10, 5, 2, 1, 0.1];

/** Where each band begins, found once: points (log a, log b) from the bottom to the top. */
let bandEdges = /** @type {Point[][] | null} */ (null);

/**
 * @param {number} a
 * @param {number} b
 * @returns {number} ε₀ in radians
 */
function defectOf(a, b) {
  return separatrixDefect({ a, b, gamma: 0, above: b, below: a, total: a + b, clock: 1 - b });
}

/** @returns {Point[][]} */
function edgesOfBands() {
  const [low, high] = MAP.b.map(Math.log10);
  return BANDS.map((angle) =>
    Array.from({ length: 49 }, (_, i) => {
      const y = low + ((high - low) * i) / 48;
      // ε₀ falls in a.
      let [left, right] = [-4, 6];
      for (let step = 0; step < 24; step++) {
        const x = (left + right) / 2;
        if (defectOf(10 ** x, 10 ** y) > angle * DEGREE) left = x;
        else right = x;
      }
      return /** @type {Point} */ ([left, y]);
    }),
  );
}

/**
 * @param {Pen | { width: number, height: number }} pen
 * @returns {Frame}
 */
function mapFrame(pen) {
  const across = /** @type {Point} */ (MAP.a.map(Math.log10));
  const along = /** @type {Point} */ (MAP.b.map(Math.log10));
  return frameOf(/** @type {Pen} */ (pen), across, along);
}

/**
 * The map without the present shape.
 *
 * @param {Pen} pen
 * @param {NamedShape[]} bodies
 */
function drawMap(pen, bodies) {
  const frame = mapFrame(pen);
  /** @param {number[]} numbers @returns {Tick[]} */
  const ticks = (numbers) => numbers.map((x) => ({ at: Math.log10(x), text: String(x) }));
  const all = /** @type {[Tick[], Tick[]]} */ ([
    ticks([0.1, 1, 10, 100]),
    ticks([0.01, 0.03, 0.1, 0.3, 1]),
  ]);
  const names = /** @type {[string, string]} */ (["a = I₂/I₁ − 1", "b = 1 − I₂/I₃"]);
  bandEdges ??= edgesOfBands();
  drawChart(pen, frame, all, names, () => {
    drawBands(pen, frame, bandEdges ?? []);
    drawForbidden(pen, frame);
    nameBands(pen, frame, bandEdges ?? []);
    for (const body of bodies) drawBody(pen, frame, body);
  });
}

/**
 * @param {Pen} pen
 * @param {Frame} frame
 * @param {Point[][]} edges
 */
function drawBands(pen, frame, edges) {
  const far = frame.across[1] + 5;
  const end = /** @type {Point[]} */ ([
    [far, frame.along[1]],
    [far, frame.along[0]],
  ]);
  for (const [i, edge] of edges.entries()) {
    const fill = mixed(COLOURS.card, COLOURS.rotating, 0.08 + (0.62 * i) / BANDS.length);
    pen.area(placedAll(frame, [...edge, ...end]), { fill });
    pen.line(placedAll(frame, edge), { stroke: COLOURS.rotating, width: 1, alpha: 0.55 });
  }
}

/**
 * The names of the bands: the lower ones near the bottom, the rest near the top, where no body stands.
 *
 * @param {Pen} pen
 * @param {Frame} frame
 * @param {Point[][]} edges
 */
function nameBands(pen, frame, edges) {
  const words = /** @type {Lettering} */ ({
    fill: COLOURS.rotating,
    size: 11.5,
    halo: COLOURS.card,
    align: "center",
  });
  for (const [i, edge] of edges.entries()) {
    const [x, y] = placed(frame, edge[BANDS[i] > 5 ? 9 : 45]);
    if (x > frame.left + 14 && x < frame.right - 14) pen.words([x, y + 4], `${BANDS[i]}°`, words);
  }
}

/**
 * The shapes of no rigid body, hatched, and the flat bodies on their border.
 *
 * @param {Pen} pen
 * @param {Frame} frame
 */
function drawForbidden(pen, frame) {
  const [low, high] = frame.across;
  /** @type {Point[]} */
  const border = Array.from({ length: 61 }, (_, i) => {
    const x = low - 1 + ((high - low + 1.2) * i) / 60;
    return [x, -Math.log10(10 ** x + 2)];
  });
  const spots = placedAll(frame, border);
  pen.area([...spots, [frame.right + 40, frame.top - 40], [frame.left - 200, frame.top - 40]], {
    fill: COLOURS.card,
    alpha: 0.35,
  });
  const span = frame.bottom - frame.top;
  for (let x = frame.left - span; x < frame.right; x += 13) {
    /** @type {Spot[]} */
    const hatch = [];
    for (let i = 0; i <= 40; i++) {
      const spot = /** @type {Spot} */ ([x + (span * i) / 40, frame.bottom - (span * i) / 40]);
      const [p, q] = pointAt(frame, spot);
      hatch.push(10 ** q > 1 / (10 ** p + 2) ? spot : [NaN, NaN]);
    }
    pen.line(hatch, { stroke: COLOURS.ink, width: 0.7, alpha: 0.28 });
  }
  pen.line(spots, { stroke: COLOURS.ink, width: 2.4 });
  const words = { fill: COLOURS.ink, size: 13, halo: COLOURS.card };
  const at = placed(frame, [1.4, Math.log10(0.36)]);
  pen.words(at, "no rigid body", { ...words, align: "center" });
  pen.words(placed(frame, [-0.93, Math.log10(0.37)]), "flat bodies", words);
}

/** @typedef {{ a: number, b: number, label: string, rigid: boolean, below: boolean }} NamedShape */

/**
 * @param {Pen} pen
 * @param {Frame} frame
 * @param {NamedShape} body
 */
function drawBody(pen, frame, { a, b, label: name, rigid, below }) {
  const at = placed(frame, [Math.log10(a), Math.log10(b)]);
  const fill = rigid ? COLOURS.ink : COLOURS.card;
  pen.disc(at, 4.2, { fill, stroke: rigid ? COLOURS.card : COLOURS.ink, width: 1.6 });
  const words = { fill: COLOURS.ink, size: 11.5, halo: COLOURS.card };
  pen.words([at[0], at[1] + (below ? 17 : -9)], name, { ...words, align: "center" });
}

/**
 * The present shape.
 *
 * @param {Pen} pen
 * @param {Level} level
 * @param {boolean} rigid
 */
function drawShape(pen, { a, b }, rigid) {
  const frame = mapFrame(pen);
  const point = /** @type {Point} */ ([
    clamp(Math.log10(a), ...frame.across),
    clamp(Math.log10(b), ...frame.along),
  ]);
  drawKnob(pen, placed(frame, point), rigid ? COLOURS.good : COLOURS.warning);
}
