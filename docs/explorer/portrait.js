/**
 * The phase portrait (ψ, dψ/dφ): the levels of γ, the separatrix between them, and the motion.
 */
"use strict";

/** The range of ψ: one turn. */
const PORTRAIT = /** @type {[number, number]} */ ([-Math.PI / 2, 1.5 * Math.PI]);

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
 * The frame of the portrait of a shape. How far it reaches hangs on the shape alone, so that it stands
 * still under the hand that drags in it, unless the level lies far out.
 *
 * @param {Pen | { width: number, height: number }} pen
 * @param {Level} level
 * @returns {Frame}
 */
function portraitFrame(pen, level) {
  const separatrix = onLevel(level, 0);
  const crest = Math.min(rateAt(separatrix, Math.PI / 2), 2.5 * rateAt(separatrix, Math.PI / 4));
  const own = rateAt(level, Math.PI / 2) || 0;
  let reach = held.reach || 1.7 * crest;
  while (!held.reach && reach < 0.98 * own && reach < 60 * crest) reach *= 1.6;
  return frameOf(/** @type {Pen} */ (pen), PORTRAIT, [-reach, reach]);
}

/**
 * All of the portrait that does not move.
 *
 * @param {Pen} pen
 * @param {Motion} motion
 */
function drawPortrait(pen, motion) {
  const { level } = motion.orbit;
  const frame = portraitFrame(pen, level);
  const separatrix = onLevel(level, 0);
  const xTicks = [-90, 0, 90, 180, 270].map((x) => ({ at: x * DEGREE, text: withMinus(`${x}°`) }));
  const names = /** @type {[string, string]} */ (["flip angle ψ", "rate dψ/dφ"]);
  drawChart(pen, frame, [xTicks, roundTicks(frame.along)], names, () => {
    drawEyes(pen, frame, separatrix);
    const tall = (frame.along[1] / (rateAt(separatrix, Math.PI / 2) || 1)) ** 2;
    for (const share of [0.85, 0.5, 0.2, 0.05])
      drawLevel(pen, frame, onLevel(level, -share * level.b), {
        stroke: COLOURS.oscillating,
        width: 1.2,
        dash: [6, 4],
      });
    for (const share of [0.1, 0.5, 1.2, 2.2, 4, 8, 16, 32, 64, 128]) {
      if (share < 1.5 * tall && share * level.b < level.a)
        drawLevel(pen, frame, onLevel(level, share * level.b), {
          stroke: COLOURS.rotating,
          width: 1.2,
        });
    }
    drawLevel(pen, frame, separatrix, { stroke: COLOURS.ink, width: 2, dash: [1.5, 4] });
    for (const x of [0, 180]) {
      const at = placed(frame, [x * DEGREE, 0]);
      pen.disc(at, 4.5, { fill: COLOURS.card, stroke: COLOURS.ink, width: 1.6 });
    }
    for (const x of [-90, 90, 270])
      pen.disc(placed(frame, [x * DEGREE, 0]), 3.6, { fill: COLOURS.ink });
    const way = placedAll(frame, motionCurve(motion));
    pen.line(way, { stroke: COLOURS.card, width: 6, alpha: 0.8 });
    pen.line(way, { stroke: COLOURS.ink, width: 3.2 });
    const [first, last] = [0, 1].map((share) => placed(frame, phasePoint(motion, share)));
    pen.disc(last, 4.5, { fill: COLOURS.card, stroke: COLOURS.ink, width: 2 });
    pen.disc(first, 5, { fill: COLOURS.accent, stroke: COLOURS.card, width: 1.5 });
  });
}

/**
 * The two eyes of the separatrix, in which the body rocks.
 *
 * @param {Pen} pen
 * @param {Frame} frame
 * @param {Level} separatrix
 */
function drawEyes(pen, frame, separatrix) {
  /** @type {Point[][]} */
  const sides = [[], []];
  for (let i = -60; i <= 180; i++) {
    const psi = (i * Math.PI) / 120;
    sides[0].push([psi, rateAt(separatrix, psi)]);
    sides[1].unshift([psi, -rateAt(separatrix, psi)]);
  }
  pen.area(placedAll(frame, [...sides[0], ...sides[1]]), {
    fill: COLOURS.oscillating,
    alpha: 0.09,
  });
}

/**
 * @param {Pen} pen
 * @param {Frame} frame
 * @param {Level} level
 * @param {Stroke} style
 */
function drawLevel(pen, frame, level, style) {
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
  for (const side of sides) pen.line(placedAll(frame, side), style);
}

/**
 * The point of the phase plane after a share of the turn, ψ brought into the portrait.
 *
 * @param {Motion} motion
 * @param {number} share
 * @returns {Point}
 */
function phasePoint(motion, share) {
  const pose = poseAt(motion, share);
  const turn = 2 * Math.PI;
  const psi = pose.psi - turn * Math.floor((pose.psi - PORTRAIT[0]) / turn);
  return [psi, rateOf(motion.orbit.level, pose)];
}

/**
 * The way of the motion through the phase plane, broken where it leaves on one side to come back on
 * the other. A motion that comes round again is drawn once.
 *
 * @param {Motion} motion
 * @returns {Point[]}
 */
function motionCurve(motion) {
  const once = (4.04 * motion.orbit.quarterTime) / (motion.end - motion.begin);
  /** @type {Point[]} */
  const points = [];
  for (let i = 0; i <= 300; i++) {
    const point = phasePoint(motion, (Math.min(1, once) * i) / 300);
    const before = points.at(-1);
    if (before && Math.abs(point[0] - before[0]) > Math.PI) points.push([NaN, NaN]);
    points.push(point);
  }
  return points;
}

/**
 * The point that moves.
 *
 * @param {Pen} pen
 * @param {Motion} motion
 * @param {number} share
 */
function drawPhasePoint(pen, motion, share) {
  const frame = portraitFrame(pen, motion.orbit.level);
  pen.inside(boxOf(frame), () =>
    drawKnob(pen, placed(frame, phasePoint(motion, share)), COLOURS.front),
  );
}
