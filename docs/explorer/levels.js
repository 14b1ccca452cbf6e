/**
 * The defect over γ: exact, the paper's straight line, the level γ* of turning back, and the present one.
 */
"use strict";

/**
 * How far it reaches: a few ε₀² b, so that the bend shows, and farther where the level lies outside.
 *
 * @param {Level} level
 * @param {number | null} turning γ*
 * @returns {number}
 */
function levelsWidth(level, turning) {
  if (held.wide) return held.wide;
  const start = separatrixDefect(level);
  let wide = Math.max(8 * level.b * start * start, 2.2 * Math.abs(turning ?? 0));
  while (wide < 1.05 * Math.abs(level.gamma)) wide *= 1.7;
  return wide;
}

/**
 * @param {Pen | { width: number, height: number }} pen
 * @param {Level} level
 * @param {number | null} turning γ*
 * @returns {Frame}
 */
function levelsFrame(pen, level, turning) {
  const { a, b, gamma } = level;
  const wide = levelsWidth(level, turning);
  const low = Math.max(-wide, -b * (1 - 1e-6));
  const high = Math.min(wide, a * (1 - 1e-6));
  const heights = [low, gamma, 0, high].map((x) => flipDefect(onLevel(level, x)) / DEGREE);
  const bottom = Math.min(...heights, 0);
  const top = Math.max(...heights);
  const margin = 0.08 * (top - bottom);
  return frameOf(/** @type {Pen} */ (pen), [low, high], [bottom - margin, top + margin]);
}

/**
 * @param {Pen} pen
 * @param {Level} level
 * @param {number | null} turning γ*
 */
function drawLevels(pen, level, turning) {
  const frame = levelsFrame(pen, level, turning);
  const [low, high] = frame.across;
  const ticks = /** @type {[Tick[], Tick[]]} */ ([
    roundTicks(frame.across),
    roundTicks(frame.along, "°"),
  ]);
  const names = /** @type {[string, string]} */ (["γ, distance from the separatrix", "defect ε"]);
  drawChart(pen, frame, ticks, names, () => {
    const zero = placedAll(frame, [
      [low, 0],
      [high, 0],
    ]);
    pen.line(zero, { stroke: COLOURS.quiet, width: 1 });
    if (turning !== null) {
      const wall = placedAll(frame, [
        [turning, frame.along[0]],
        [turning, frame.along[1]],
      ]);
      pen.line(wall, { stroke: COLOURS.rotating, width: 1.5, dash: [2, 5] });
      const words = { fill: COLOURS.rotating, size: 14, italic: true, halo: COLOURS.card };
      pen.words([wall[1][0] + 5, frame.top + 16], "γ*", words);
    }
    const line = [low, high].map((x) => {
      const y = printedLine(onLevel(level, x)) / DEGREE;
      return /** @type {Point} */ ([x, y]);
    });
    pen.line(straight(frame, line), { stroke: COLOURS.oscillating, width: 2.2, dash: [8, 5] });
    /** @type {Point[]} */
    const exact = Array.from({ length: 121 }, (_, i) => {
      const x = low + ((high - low) * i) / 120;
      return [x, flipDefect(onLevel(level, x)) / DEGREE];
    });
    pen.line(placedAll(frame, exact), { stroke: COLOURS.ink, width: 3 });
    const words = { size: 13, halo: COLOURS.card };
    pen.words([frame.right - 8, frame.top + 18], "exact", {
      ...words,
      fill: COLOURS.ink,
      align: "end",
    });
    pen.words([frame.right - 8, frame.top + 36], "the paper’s line", {
      ...words,
      fill: COLOURS.oscillating,
      align: "end",
    });
  });
}

/**
 * A straight line through two points, cut at the frame in pixels, where nothing is rounded away.
 *
 * @param {Frame} frame
 * @param {Point[]} line
 * @returns {Spot[]}
 */
function straight({ left, right, top, bottom, across, along }, line) {
  return line.map(([x, y]) => [
    left + ((x - across[0]) / (across[1] - across[0])) * (right - left),
    bottom - clamp((y - along[0]) / (along[1] - along[0]), -1e4, 1e4) * (bottom - top),
  ]);
}

/**
 * @param {Pen} pen
 * @param {Level} level
 * @param {number} defect
 * @param {number | null} turning
 */
function drawPresentLevel(pen, level, defect, turning) {
  const frame = levelsFrame(pen, level, turning);
  pen.inside(boxOf(frame), () =>
    drawKnob(pen, placed(frame, [level.gamma, defect / DEGREE]), COLOURS.front),
  );
}
