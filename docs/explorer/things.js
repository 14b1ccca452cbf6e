/**
 * What turns: a racket, a book, a molecule, or a box with the moments that were typed. Each is flat or
 * nearly so, lies in the plane of e₁ (the handle) and e₂, and has a face of one colour towards e₃ and of
 * another towards −e₃.
 */
"use strict";

/** @typedef {{ first: Vector, second: Vector, third: Vector }} Axes of the body, in space */

/**
 * @typedef {object} Thing
 * @property {number} tip how far it reaches along e₁
 * @property {Vector[]} outline of its shadow
 * @property {(pen: Pen, eye: Eye, axes: Axes) => void} draw
 */

const HEAD = { centre: 0.56, long: 0.48, wide: 0.36 };
const ROUND = 44;

/** @type {Record<string, Thing>} */
const THINGS = {
  racket: { tip: 1.04, outline: racketOutline(), draw: drawRacket },
  book: solidBox([0.92, 0.6, 0.09], true),
  molecule: { tip: 1, outline: corners(0.95, 0.66, 0), draw: drawMolecule },
};

/**
 * @param {Axes} axes
 * @param {Vector} point along e₁, e₂, e₃
 * @returns {Vector} in space
 */
function placedBy({ first, second, third }, [x, y, z]) {
  return sum([x, first], [y, second], [z, third]);
}

/**
 * @param {number} angle
 * @param {number} [size]
 * @returns {Vector} on the rim of the head
 */
function onRim(angle, size = 1) {
  return [HEAD.centre + size * HEAD.long * Math.cos(angle), size * HEAD.wide * Math.sin(angle), 0];
}

/** @returns {Vector[]} */
function racketOutline() {
  const rim = Array.from({ length: ROUND }, (_, i) => onRim((2 * Math.PI * (i + 0.5)) / ROUND));
  rim.splice(ROUND / 2, 0, [-0.2, 0.04, 0], [-0.97, 0.06, 0], [-0.97, -0.06, 0], [-0.2, -0.04, 0]);
  return rim;
}

/**
 * @param {number} long
 * @param {number} wide
 * @param {number} z
 * @returns {Vector[]}
 */
function corners(long, wide, z) {
  return [
    [-long, -wide, z],
    [long, -wide, z],
    [long, wide, z],
    [-long, wide, z],
  ];
}

/**
 * The colour of a face in the light.
 *
 * @param {string} colour
 * @param {Vector} normal
 * @param {Eye} eye
 * @returns {string}
 */
function lit(colour, normal, eye) {
  const light = Math.max(0, dot(normal, eye.light));
  const dimmed = mixed(colour, "#0b1016", 0.42 * (1 - light));
  return mixed(dimmed, "#ffffff", 0.3 * light ** 6);
}

/**
 * A round bar through points of the body: each piece as bright as its direction to the lamp allows,
 * with a thin light along it.
 *
 * @param {Pen} pen
 * @param {Eye} eye
 * @param {Axes} axes
 * @param {Vector[]} points
 * @param {number} radius
 * @param {string} colour
 */
function drawBar(pen, eye, axes, points, radius, colour) {
  const spots = points.map((point) => placedBy(axes, point));
  const flat = spots.map((spot) => seen(eye, spot));
  const shine = [-0.28 * radius * eye.scale, -0.32 * radius * eye.scale];
  /** @type {[Spot[], number, number][]} */
  const pieces = [];
  for (let i = 1; i < spots.length; i++) {
    const way = sum([1, spots[i]], [-1, spots[i - 1]]);
    const along = dot(way, eye.light) / Math.sqrt(dot(way, way));
    const light = Math.sqrt(Math.max(0, 1 - along * along));
    pieces.push([[flat[i - 1], flat[i]], 2 * radius * scaleAt(eye, spots[i]), light]);
  }
  for (const [piece, width, light] of pieces) {
    pen.line(piece, { stroke: mixed("#05080b", colour, 0.35 + 0.65 * light), width });
  }
  for (const [piece, width, light] of pieces) {
    const moved = piece.map(([x, y]) => /** @type {Spot} */ ([x + shine[0], y + shine[1]]));
    const stroke = mixed(colour, "#ffffff", 0.15 + 0.4 * light);
    pen.line(moved, { stroke, width: 0.22 * width, alpha: 0.55 });
  }
}

/**
 * @param {Pen} pen
 * @param {Eye} eye
 * @param {Axes} axes
 */
function drawRacket(pen, eye, axes) {
  const parts = [drawGrip, drawHead];
  if (dot(axes.first, eye.towards) < 0) parts.reverse();
  for (const part of parts) part(pen, eye, axes);
}

/**
 * @param {Pen} pen
 * @param {Eye} eye
 * @param {Axes} axes
 */
function drawHead(pen, eye, axes) {
  const front = dot(axes.third, eye.towards) > 0;
  const normal = sum([front ? 1 : -1, axes.third]);
  /** @param {Vector} point */
  const spot = (point) => seen(eye, placedBy(axes, point));
  const turn = Array.from({ length: ROUND + 1 }, (_, i) => (2 * Math.PI * i) / ROUND);
  const colour = lit(front ? COLOURS.front : COLOURS.back, normal, eye);
  pen.area(
    turn.map((angle) => spot(onRim(angle))),
    { fill: colour, alpha: 0.88 },
  );
  drawStrings(pen, spot, mixed(colour, COLOURS.string, 0.5), 0.01 * eye.scale);
  if (front) drawStencil(pen, spot, 0.055 * eye.scale);
  drawBar(
    pen,
    eye,
    axes,
    turn.map((angle) => onRim(angle)),
    0.034,
    COLOURS.frame,
  );
  for (const side of [1, -1]) {
    const strut = [0, 0.25, 0.5, 0.75, 1].map((t) => throatAt(t, side));
    drawBar(pen, eye, axes, strut, 0.03, COLOURS.frame);
  }
}

/**
 * The throat, from the rim to the shaft, as a quadratic curve.
 *
 * @param {number} t
 * @param {number} side
 * @returns {Vector}
 */
function throatAt(t, side) {
  const [x, y] = onRim(0.76 * Math.PI);
  const weights = [(1 - t) ** 2, 2 * t * (1 - t), t * t];
  return [
    weights[0] * x + weights[1] * 0.0 + weights[2] * -0.26,
    side * (weights[0] * y + weights[1] * 0.11 + weights[2] * 0.025),
    0,
  ];
}

/**
 * @param {Pen} pen
 * @param {(point: Vector) => Spot} spot
 * @param {string} stroke
 * @param {number} width
 */
function drawStrings(pen, spot, stroke, width) {
  /** @type {Spot[]} */
  const strings = [];
  const gap = /** @type {Spot} */ ([NaN, NaN]);
  for (let i = -6; i <= 6; i++) {
    const t = i / 7;
    const half = Math.sqrt(1 - t * t);
    const [x, y] = [HEAD.centre + HEAD.long * t, HEAD.wide * t];
    strings.push(spot([x, -HEAD.wide * half, 0]), spot([x, HEAD.wide * half, 0]), gap);
    strings.push(spot([HEAD.centre - HEAD.long * half, y, 0]));
    strings.push(spot([HEAD.centre + HEAD.long * half, y, 0]), gap);
  }
  pen.line(strings, { stroke, width: Math.max(width, 0.6) });
}

/**
 * The letter on the strings of the front: an ε, to be read with the handle down.
 *
 * @param {Pen} pen
 * @param {(point: Vector) => Spot} spot
 * @param {number} width
 */
function drawStencil(pen, spot, width) {
  /** @type {Spot[]} */
  const letter = [];
  for (const [middle, from, to] of [
    [0.085, 0.12, 1.5],
    [-0.085, 0.5, 1.88],
  ]) {
    for (let i = 0; i <= 14; i++) {
      const angle = Math.PI * (from + ((to - from) * i) / 14);
      letter.push(
        spot([HEAD.centre + middle + 0.085 * Math.sin(angle), -0.11 * Math.cos(angle), 0]),
      );
    }
  }
  pen.line(letter, { stroke: COLOURS.frame, width });
}

/**
 * @param {Pen} pen
 * @param {Eye} eye
 * @param {Axes} axes
 */
function drawGrip(pen, eye, axes) {
  drawBar(
    pen,
    eye,
    axes,
    [
      [-0.2, 0, 0],
      [-0.48, 0, 0],
    ],
    0.042,
    COLOURS.frame,
  );
  drawBar(
    pen,
    eye,
    axes,
    [
      [-0.46, 0, 0],
      [-0.95, 0, 0],
    ],
    0.056,
    COLOURS.grip,
  );
  drawBar(
    pen,
    eye,
    axes,
    [
      [-0.94, 0, 0],
      [-0.97, 0, 0],
    ],
    0.064,
    COLOURS.grip,
  );
  const across = sum([1, eye.towards], [-dot(eye.towards, axes.first), axes.first]);
  const size = Math.sqrt(dot(across, across)) || 1;
  // The wrap runs over the side that is seen.
  const near = sum([0.05 / size, across]);
  const beside = [
    axes.first[1] * near[2] - axes.first[2] * near[1],
    axes.first[2] * near[0] - axes.first[0] * near[2],
    axes.first[0] * near[1] - axes.first[1] * near[0],
  ];
  /** @type {Spot[]} */
  const wrap = [];
  for (let i = 0; i < 6; i++) {
    const x = -0.54 - 0.068 * i;
    const side = /** @type {Vector} */ (beside);
    wrap.push(seen(eye, sum([x, axes.first], [0.3, near], [0.95, side])));
    wrap.push(seen(eye, sum([x - 0.05, axes.first], [0.3, near], [-0.95, side])), [NaN, NaN]);
  }
  pen.line(wrap, { stroke: "#000000", width: 0.011 * eye.scale, alpha: 0.45 });
}

/**
 * The half sides of the box with the moments of a shape: as √(I₂ + I₃ − I₁), √(I₁ + I₃ − I₂) and
 * √(I₁ + I₂ − I₃), the last of which a rigid body has. Beyond, it is without thickness.
 *
 * @param {Level} shape
 * @returns {Vector}
 */
function sidesOf({ a, b, clock }) {
  // In units of I₂, times (1 + a)(1 − b), in which nothing is infinite at b = 1.
  const squares = [
    (1 + a) * clock + (1 + a) - clock,
    clock + (1 + a) - (1 + a) * clock,
    Math.max(clock - (1 + a) * b, 0),
  ];
  const scale = 0.95 / Math.sqrt(squares[0]);
  return /** @type {Vector} */ (squares.map((x) => scale * Math.sqrt(x)));
}

/**
 * @param {Vector} half its half sides
 * @param {boolean} bound whether it is a book, with pages and a title
 * @returns {Thing}
 */
function solidBox(half, bound) {
  return {
    tip: half[0],
    outline: corners(half[0], half[1], 0),
    draw: (pen, eye, axes) => drawBox(pen, eye, axes, half, bound),
  };
}

/**
 * @param {Pen} pen
 * @param {Eye} eye
 * @param {Axes} axes
 * @param {Vector} half
 * @param {boolean} bound
 */
function drawBox(pen, eye, axes, half, bound) {
  const thick = half[2];
  const page = bound ? COLOURS.page : COLOURS.sphere;
  /** @type {[number, number, string][]} axis, side, colour: the spine is along −e₂ */
  const faces = [
    [0, 1, page],
    [0, -1, page],
    [1, 1, page],
    [1, -1, bound ? COLOURS.front : page],
    [2, 1, COLOURS.front],
    [2, -1, COLOURS.back],
  ];
  for (const [axis, side, colour] of faces) {
    const normal = sum([side, [axes.first, axes.second, axes.third][axis]]);
    const centre = sum([half[axis], normal]);
    if (dot(normal, sum([DISTANCE, eye.towards], [-1, centre])) <= 0) continue;
    const [u, v] = [0, 1, 2].filter((i) => i !== axis);
    const rim = [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ].map(([s, t]) => {
      const point = /** @type {Vector} */ ([0, 0, 0]);
      point[axis] = side * half[axis];
      [point[u], point[v]] = [s * half[u], t * half[v]];
      return seen(eye, placedBy(axes, point));
    });
    const edge = { stroke: COLOURS.frame, width: 0.012 * eye.scale };
    pen.area(rim, { fill: lit(colour, normal, eye), ...edge });
    if (axis === 2 && bound) {
      /** @param {Vector[]} points */
      const spots = (points) => points.map((point) => seen(eye, placedBy(axes, point)));
      const title = side > 0 ? [0.55, 0.42, 0.29] : [-0.55];
      for (const [i, x] of title.entries()) {
        const reach = 0.36 - 0.09 * i;
        const line = spots([
          [x, -reach, side * thick],
          [x, reach, side * thick],
        ]);
        pen.line(line, { stroke: COLOURS.frame, width: (i ? 0.02 : 0.045) * eye.scale });
      }
    }
  }
}

/**
 * Ethylene: two carbons, four hydrogens, on a plate that shows the face.
 *
 * @param {Pen} pen
 * @param {Eye} eye
 * @param {Axes} axes
 */
function drawMolecule(pen, eye, axes) {
  const front = dot(axes.third, eye.towards) > 0;
  const normal = sum([front ? 1 : -1, axes.third]);
  const plate = corners(1, 0.74, 0).map((point) => seen(eye, placedBy(axes, point)));
  const face = lit(front ? COLOURS.front : COLOURS.back, normal, eye);
  pen.area(plate, { fill: face, alpha: 0.5 });
  /** @type {[Vector, number, string][]} */
  const atoms = [
    [[0.36, 0, 0], 0.2, "#5c6670"],
    [[-0.36, 0, 0], 0.2, "#5c6670"],
  ];
  for (const x of [0.72, -0.72]) {
    for (const y of [0.5, -0.5]) atoms.push([[x, y, 0], 0.135, "#dfe5ea"]);
  }
  /** @type {[number, () => void][]} what is far is drawn first */
  const parts = atoms.map(([at, radius, colour]) => {
    const centre = placedBy(axes, at);
    const draw = () =>
      pen.ball(
        seen(eye, centre),
        radius * scaleAt(eye, centre),
        mixed(colour, "#ffffff", 0.75),
        mixed(colour, "#000000", 0.45),
      );
    return [dot(centre, eye.towards), draw];
  });
  /** @type {[Vector, Vector][]} */
  const bonds = [
    [
      [-0.36, 0.06, 0],
      [0.36, 0.06, 0],
    ],
    [
      [-0.36, -0.06, 0],
      [0.36, -0.06, 0],
    ],
    ...atoms
      .slice(2)
      .map(([at]) => /** @type {[Vector, Vector]} */ ([[Math.sign(at[0]) * 0.36, 0, 0], at])),
  ];
  for (const bond of bonds) {
    const middle = placedBy(axes, sum([0.5, bond[0]], [0.5, bond[1]]));
    const draw = () => drawBar(pen, eye, axes, bond, 0.032, "#8c969f");
    parts.push([dot(middle, eye.towards) - 0.08, draw]);
  }
  parts.sort((x, y) => x[0] - y[0]);
  for (const [, draw] of parts) draw();
}
