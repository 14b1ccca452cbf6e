/**
 * The momentum sphere: M as the body sees it, with the polhodes on which it runs and the separatrix,
 * two great circles through ±e₂.
 */
"use strict";

/**
 * M/M in the body's axes (e₁, e₂, e₃).
 *
 * @param {number} psi
 * @param {number} handle cos θ
 * @returns {Vector}
 */
function momentumAt(psi, handle) {
  const level = Math.sqrt(Math.max(0, 1 - handle * handle));
  return [handle, -level * Math.cos(psi), level * Math.sin(psi)];
}

/**
 * The polhode of a level: all its closed curves.
 *
 * @param {Level} level
 * @returns {Vector[][]}
 */
function polhodes({ a, b, gamma }) {
  /** @param {number} psi @returns {number} */
  const handle = (psi) => {
    const square = b * Math.sin(psi) ** 2;
    return Math.sqrt(Math.max(0, (gamma + square) / (a + square)));
  };
  const count = 120;
  if (gamma >= 0) {
    return [1, -1].map((side) =>
      Array.from({ length: count + 1 }, (_, i) => {
        const psi = (2 * Math.PI * i) / count;
        return momentumAt(psi, side * handle(psi));
      }),
    );
  }
  const turning = Math.asin(Math.sqrt(-gamma / b));
  return [0, Math.PI].map((cell) =>
    Array.from({ length: count + 1 }, (_, i) => {
      const way = Math.cos((2 * Math.PI * i) / count);
      const psi = cell + Math.PI / 2 + (Math.PI / 2 - turning) * way;
      return momentumAt(psi, (i <= count / 2 ? 1 : -1) * handle(psi));
    }),
  );
}

/**
 * @param {Pen} pen
 * @param {Camera} camera
 * @returns {Eye}
 */
function sphereEye(pen, camera) {
  return eyeOf(camera, Math.min(pen.width, pen.height) / 3, [pen.width / 2, 0.52 * pen.height]);
}

/**
 * All of it but the point that moves.
 *
 * @param {Pen} pen
 * @param {Motion} motion
 * @param {Camera} camera
 */
function drawSphere(pen, motion, camera) {
  const { level } = motion.orbit;
  const eye = sphereEye(pen, camera);
  /** @type {[Vector[], Stroke][]} */
  const curves = [];
  for (const share of [0.85, 0.6, 0.35, 0.12]) {
    for (const curve of polhodes(onLevel(level, -share * level.b)))
      curves.push([curve, { stroke: COLOURS.oscillating, width: 1.2 }]);
  }
  for (const share of [0.02, 0.1, 0.3, 0.6, 0.85]) {
    for (const curve of polhodes(onLevel(level, share * level.a)))
      curves.push([curve, { stroke: COLOURS.rotating, width: 1.2 }]);
  }
  for (const curve of polhodes(onLevel(level, 0)))
    curves.push([curve, { stroke: COLOURS.ink, width: 2, dash: [1.5, 4] }]);
  const own = polhodeOf(motion);
  curves.push([own, { stroke: COLOURS.card, width: 6 }], [own, { stroke: COLOURS.ink, width: 3 }]);
  drawAxes(pen, eye, false);
  // The rim of a sphere seen from near is smaller than its great circle.
  const rim = (eye.scale * DISTANCE) / Math.sqrt(DISTANCE * DISTANCE - 1);
  pen.ball(eye.centre, rim, mixed(COLOURS.sphere, "#ffffff", 0.5), COLOURS.sphere);
  pen.disc(eye.centre, rim, { stroke: COLOURS.edge, width: 1.4 });
  /** @param {Vector} point */
  const near = (point) => dot(point, eye.towards) > 1 / DISTANCE;
  for (const [points, style] of curves.slice(0, -2))
    drawPart(pen, eye, { points, style: { ...style, alpha: 0.16 } }, (point) => !near(point));
  for (const [points, style] of curves) drawPart(pen, eye, { points, style }, near);
  drawAxes(pen, eye, true);
}

/**
 * The way of M in one turn of the handle.
 *
 * @param {Motion} motion
 * @returns {Vector[]}
 */
function polhodeOf(motion) {
  return Array.from({ length: 201 }, (_, i) => {
    const { psi, theta } = poseAt(motion, i / 200);
    return momentumAt(psi, Math.cos(theta));
  });
}

/**
 * @param {Pen} pen
 * @param {Eye} eye
 * @param {boolean} near those in front of the sphere
 */
function drawAxes(pen, eye, near) {
  for (const [i, name] of ["e₁", "e₂", "e₃"].entries()) {
    const axis = /** @type {Vector} */ ([0, 0, 0]);
    axis[i] = 1;
    if (dot(axis, eye.towards) > 0 !== near) continue;
    const [from, to, at] = [1, 1.16, 1.24].map((size) => seen(eye, sum([size, axis])));
    pen.line([from, to], { stroke: COLOURS.quiet, width: 2 });
    const words = { fill: COLOURS.ink, size: 14, italic: true, halo: COLOURS.card };
    pen.words([at[0], at[1] + 4], name, { ...words, align: "center" });
  }
}

/**
 * M now.
 *
 * @param {Pen} pen
 * @param {Motion} motion
 * @param {number} share
 * @param {Camera} camera
 */
function drawMomentum(pen, motion, share, camera) {
  const eye = sphereEye(pen, camera);
  const { psi, theta } = poseAt(motion, share);
  const at = momentumAt(psi, Math.cos(theta));
  const hidden = dot(at, eye.towards) <= 1 / DISTANCE;
  if (hidden) pen.disc(seen(eye, at), 6, { stroke: COLOURS.front, width: 2, alpha: 0.7 });
  else drawKnob(pen, seen(eye, at), COLOURS.front);
}
