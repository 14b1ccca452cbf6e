/**
 * The body turning in space, with what its motion leaves behind: the trail of its tip, the turn of its
 * handle about M on a dial, and the two angles on two instruments.
 *
 * R = R_z(φ) R_y(θ) R_z(ψ) takes the body axes (e₂, e₃, e₁) to the space axes (X, Y, Z), with Z along
 * the angular momentum M.
 */
"use strict";

/** Where the floor lies and how long M is drawn: level as in a throw, or upright. */
const LEVEL = { floor: -1.28, arrow: 1.4 };
const UPRIGHT = { floor: -1, arrow: 1.12 };
const DIAL = 1.2;
const TRAIL = { steps: 56, turns: 0.5 };

/**
 * The body axes in space.
 *
 * @param {Attitude} attitude
 * @returns {Axes}
 */
function axesOf({ psi, theta, phi }) {
  const [cp, sp] = [Math.cos(phi), Math.sin(phi)];
  const [ct, st] = [Math.cos(theta), Math.sin(theta)];
  const [cs, ss] = [Math.cos(psi), Math.sin(psi)];
  return {
    first: [st * cp, st * sp, ct],
    second: [cp * ct * cs - sp * ss, sp * ct * cs + cp * ss, -st * cs],
    third: [-cp * ct * ss - sp * cs, -sp * ct * ss + cp * cs, st * ss],
  };
}

/**
 * @param {Pen} pen
 * @param {Motion} motion
 * @param {number} share how much of the turn has passed
 * @param {Thing} thing
 * @param {Camera} camera
 * @param {{ ghosts: boolean, whole: boolean, phantom: boolean }} show the first and last attitude; the
 *   path of one turn; that no rigid body is so
 */
function drawSpace(pen, motion, share, thing, camera, show) {
  const scale = Math.min(pen.width / 2.9, pen.height / 2.66);
  const eye = eyeOf(camera, scale, [pen.width / 2, 0.475 * pen.height]);
  const pose = poseAt(motion, share);
  const from = poseAt(motion, 0);
  const axes = axesOf(pose);
  const { floor, arrow } = camera.thrown ? LEVEL : UPRIGHT;
  drawShadow(pen, eye, thing, axes, floor);
  // The body is flat: what lies on the eye's side of its plane is before it, the rest behind.
  const side = Math.sign(dot(axes.third, eye.towards)) || 1;
  /** @param {Vector} point */
  const before = (point) => side * dot(point, axes.third) > 0;
  const layers = [
    ...dialOf(from.phi, pose.phi),
    ...momentumArrow(arrow),
    ...(show.whole ? [pathOf(motion, thing)] : []),
    ...trailOf(motion, share, thing),
  ];
  for (const layer of layers) drawPart(pen, eye, layer, (point) => !before(point));
  if (show.ghosts) {
    for (const at of [0, 1]) drawGhost(pen, eye, thing, axesOf(poseAt(motion, at)), 0.14);
  }
  if (show.phantom) drawGhost(pen, eye, thing, axes, 0.5, COLOURS.warning);
  else thing.draw(pen, eye, axes);
  for (const layer of layers) drawPart(pen, eye, layer, before);
  const tip = seen(eye, [0, 0, arrow + 0.02]);
  pen.words([tip[0] + 7, tip[1] + 3], "M", { fill: COLOURS.ink, size: 17, italic: true });
  drawInstruments(pen, motion, from, pose);
}

/** @typedef {{ points: Vector[], style: Stroke, closed?: boolean }} Layer a line in space */

/**
 * The pieces of a line that lie on one side.
 *
 * @param {Pen} pen
 * @param {Eye} eye
 * @param {Layer} layer
 * @param {(point: Vector) => boolean} here
 */
function drawPart(pen, eye, { points, style }, here) {
  /** @type {Spot[]} */
  const spots = [];
  let some = false;
  for (let i = 1; i < points.length; i++) {
    const middle = sum([0.5, points[i - 1]], [0.5, points[i]]);
    if (here(middle)) {
      if (!spots.length || spots[spots.length - 1][0] !== spots[spots.length - 1][0])
        spots.push(seen(eye, points[i - 1]));
      spots.push(seen(eye, points[i]));
      some = true;
    } else {
      spots.push([NaN, NaN]);
    }
  }
  if (some) pen.line(spots, style);
}

/**
 * @param {number} from
 * @param {number} to
 * @param {number} radius
 * @returns {Vector[]} an arc about M
 */
function arcAbout(from, to, radius) {
  const steps = Math.max(2, Math.ceil(Math.abs(to - from) / 0.09));
  return Array.from({ length: steps + 1 }, (_, i) => {
    const angle = from + ((to - from) * i) / steps;
    return /** @type {Vector} */ ([radius * Math.cos(angle), radius * Math.sin(angle), 0]);
  });
}

/**
 * The dial about M, and on it how far the handle has turned.
 *
 * @param {number} from φ at the start
 * @param {number} to φ now
 * @returns {Layer[]}
 */
function dialOf(from, to) {
  const turned = Math.min(to - from, 2 * Math.PI);
  /** @type {Layer[]} */
  const layers = [{ points: arcAbout(0, 2 * Math.PI, DIAL), style: { stroke: COLOURS.edge } }];
  for (let i = 0; i < 12; i++) {
    const angle = from + (Math.PI * i) / 6;
    const way = /** @type {Vector} */ ([Math.cos(angle), Math.sin(angle), 0]);
    const points = [DIAL - (i ? 0.035 : 0.09), DIAL + (i ? 0.035 : 0.09)].map((r) => sum([r, way]));
    layers.push({ points, style: { stroke: COLOURS.quiet, width: i ? 1 : 2 } });
  }
  if (turned > 0) {
    const style = { stroke: COLOURS.accent, width: 4, alpha: 0.85 };
    layers.push({ points: arcAbout(to - turned, to, DIAL), style });
  }
  return layers;
}

/**
 * @param {number} length
 * @returns {Layer[]}
 */
function momentumArrow(length) {
  const style = { stroke: COLOURS.ink, width: 2.6 };
  /** @type {Vector[]} */
  const shaft = Array.from({ length: 15 }, (_, i) => [0, 0, (length * i) / 14]);
  /** @type {Vector[][]} */
  const barbs = [0, 1, 2, 3].map((i) => {
    const angle = (Math.PI * i) / 2;
    return [
      [0, 0, length],
      [0.045 * Math.cos(angle), 0.045 * Math.sin(angle), length - 0.12],
    ];
  });
  return [shaft, ...barbs].map((points) => ({ points, style }));
}

/**
 * The way of the tip in one turn.
 *
 * @param {Motion} motion
 * @param {Thing} thing
 * @returns {Layer}
 */
function pathOf(motion, thing) {
  const points = Array.from({ length: 121 }, (_, i) =>
    sum([thing.tip, axesOf(poseAt(motion, i / 120)).first]),
  );
  return { points, style: { stroke: COLOURS.quiet, width: 1.2, dash: [1.5, 4] } };
}

/**
 * The last half turn of the tip, fading.
 *
 * @param {Motion} motion
 * @param {number} share
 * @param {Thing} thing
 * @returns {Layer[]}
 */
function trailOf(motion, share, thing) {
  const { steps, turns } = TRAIL;
  const length = Math.min(turns, Math.max(share, 0));
  if (length === 0) return [];
  const points = Array.from({ length: steps + 1 }, (_, i) =>
    sum([thing.tip, axesOf(poseAt(motion, share - length * (1 - i / steps))).first]),
  );
  return points.slice(1).map((point, i) => ({
    points: [points[i], point],
    style: {
      stroke: COLOURS.oscillating,
      width: 1 + (3.2 * i) / steps,
      alpha: 0.08 + 0.85 * (i / steps) ** 1.5,
    },
  }));
}

/**
 * @param {Pen} pen
 * @param {Eye} eye
 * @param {Thing} thing
 * @param {Axes} axes
 * @param {number} floor
 */
function drawShadow(pen, eye, thing, axes, floor) {
  if (dot(eye.sky, eye.towards) < 0.02) return;
  for (const [size, alpha] of [
    [1.05, 0.05],
    [1, 0.06],
    [0.94, 0.05],
  ]) {
    const spots = thing.outline.map((point) => {
      const at = placedBy(axes, /** @type {Vector} */ (point.map((x) => size * x)));
      return seen(eye, sum([1, at], [floor - dot(at, eye.sky), eye.sky]));
    });
    pen.area(spots, { fill: "#000000", alpha });
  }
}

/**
 * @param {Pen} pen
 * @param {Eye} eye
 * @param {Thing} thing
 * @param {Axes} axes
 * @param {number} alpha
 * @param {string} [rim] a colour
 */
function drawGhost(pen, eye, thing, axes, alpha, rim) {
  const spots = thing.outline.map((point) => seen(eye, placedBy(axes, point)));
  const face = dot(axes.third, eye.towards) > 0 ? COLOURS.front : COLOURS.back;
  pen.area(spots, { fill: face, alpha });
  pen.area(spots, { stroke: rim ?? face, width: rim ? 2.4 : 1.4, dash: [5, 4], alpha: 0.9 });
}

/**
 * Two round instruments: the turn of the handle, and the flip with what is missing to half a turn.
 *
 * @param {Pen} pen
 * @param {Motion} motion
 * @param {Attitude} from
 * @param {Attitude} pose
 */
function drawInstruments(pen, motion, from, pose) {
  const radius = clamp(0.085 * Math.min(pen.width, 1.3 * pen.height), 17, 40);
  const [aside, y] = [Math.max(radius + 12, 44), pen.height - radius - 24];
  const turn = pose.phi - from.phi;
  const flip = pose.psi - from.psi;
  drawInstrument(pen, [aside, y], radius, Math.PI, -turn, COLOURS.accent, []);
  pen.words([aside, y + radius + 16], `handle ${degrees(turn)}`, label());
  const missing = motion.begin === -motion.end ? Math.PI - (poseAt(motion, 1).psi - from.psi) : 0;
  /** @type {[number, number][]} */
  const wedges =
    Math.abs(missing) > 1e-3 && Math.abs(missing) < Math.PI
      ? [
          [Math.PI, Math.PI - missing / 2],
          [0, missing / 2],
        ]
      : [];
  const at = /** @type {Spot} */ ([pen.width - aside, y]);
  const start = Math.PI - (motion.begin === -motion.end ? missing / 2 : 0);
  drawInstrument(pen, at, radius, start, -flip, COLOURS.oscillating, wedges);
  pen.words([at[0], y + radius + 16], `flip ${degrees(flip)}`, label());
}

/** @returns {Lettering} */
function label() {
  return { fill: COLOURS.ink, size: 12.5, align: "center", halo: COLOURS.card };
}

/**
 * @param {number} angle
 * @returns {string}
 */
function degrees(angle) {
  return withMinus(`${Math.round(angle / DEGREE)}°`);
}

/**
 * @param {Pen} pen
 * @param {Spot} at
 * @param {number} radius
 * @param {number} start where its pointer begins, counted from the right against the clock
 * @param {number} turned
 * @param {string} colour
 * @param {[number, number][]} wedges what is missing
 */
function drawInstrument(pen, at, radius, start, turned, colour, wedges) {
  /** @param {number} from @param {number} to @param {number} size @returns {Spot[]} */
  const arc = (from, to, size) =>
    Array.from({ length: 33 }, (_, i) => {
      const angle = from + ((to - from) * i) / 32;
      return [at[0] + size * Math.cos(angle), at[1] - size * Math.sin(angle)];
    });
  pen.disc(at, radius, { fill: COLOURS.card, stroke: COLOURS.edge, width: 1.2, alpha: 0.92 });
  for (const [from, to] of wedges) {
    pen.area([at, ...arc(from, to, radius - 1)], { fill: COLOURS.warning, alpha: 0.55 });
  }
  const swept = Math.sign(turned) * Math.min(Math.abs(turned), 2 * Math.PI);
  pen.area([at, ...arc(start + turned - swept, start + turned, 0.78 * radius)], {
    fill: colour,
    alpha: 0.3,
  });
  pen.line([at, ...arc(start + turned, start + turned, 0.9 * radius).slice(0, 1)], {
    stroke: colour,
    width: 2.6,
  });
  pen.disc(at, 2.4, { fill: COLOURS.ink });
}
