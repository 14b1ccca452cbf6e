/**
 * The body turning in space: an orthographic view of a flat thing that lies in the plane of e₁
 * (the handle) and e₂, drawn as SVG. Z, up, is along the angular momentum.
 *
 * R = R_z(φ) R_y(θ) R_z(ψ) takes the body axes (e₂, e₃, e₁) to the space axes (X, Y, Z).
 */
"use strict";

/** @typedef {[number, number, number]} Vector along X, Y, Z */

/** @typedef {[number, number]} Spot along e₁ and e₂ */

/**
 * A flat thing. Its outlines are filled with the colour of the face that is seen; thin lines are on
 * both faces, bars are thick, and the dot is on the face of +e₃ alone.
 *
 * @typedef {object} Thing
 * @property {Spot[][]} outlines
 * @property {Spot[][]} lines
 * @property {Spot[][]} bars
 * @property {Spot} dot
 * @property {number} tip how far the head reaches along e₁
 */

const SCALE = 100;
const AZIMUTH = (-50 * Math.PI) / 180;
const ELEVATION = (22 * Math.PI) / 180;

/** @type {{ right: Vector, up: Vector, towards: Vector }} the viewer's axes */
const EYE = {
  right: [-Math.sin(AZIMUTH), Math.cos(AZIMUTH), 0],
  up: [
    -Math.sin(ELEVATION) * Math.cos(AZIMUTH),
    -Math.sin(ELEVATION) * Math.sin(AZIMUTH),
    Math.cos(ELEVATION),
  ],
  towards: [
    Math.cos(ELEVATION) * Math.cos(AZIMUTH),
    Math.cos(ELEVATION) * Math.sin(AZIMUTH),
    Math.sin(ELEVATION),
  ],
};

/** @type {Record<string, Thing>} */
const THINGS = { racket: racket(), book: book(), molecule: molecule() };

/** @returns {Thing} */
function racket() {
  const [centre, long, wide] = [0.62, 0.42, 0.32];
  const lines = [-0.66, -0.33, 0, 0.33, 0.66].flatMap((t) => {
    const half = Math.sqrt(1 - t * t);
    return /** @type {Spot[][]} */ ([
      [
        [centre - long * half, wide * t],
        [centre + long * half, wide * t],
      ],
      [
        [centre + long * t, -wide * half],
        [centre + long * t, wide * half],
      ],
    ]);
  });
  return {
    outlines: [ellipse(centre, 0, long, wide)],
    lines,
    bars: [
      [
        [-0.95, 0],
        [centre - long, 0],
      ],
    ],
    dot: [centre, 0],
    tip: centre + long,
  };
}

/** @returns {Thing} */
function book() {
  const [long, wide] = [0.95, 0.62];
  return {
    outlines: [
      [
        [-long, -wide],
        [long, -wide],
        [long, wide],
        [-long, wide],
      ],
    ],
    lines: [
      [
        [-long, 0.84 * wide],
        [long, 0.84 * wide],
      ],
      [
        [0.4, -0.3],
        [0.4, 0.3],
      ],
      [
        [0.55, -0.2],
        [0.55, 0.2],
      ],
    ],
    bars: [
      [
        [-long, wide],
        [long, wide],
      ],
    ],
    dot: [-0.35, 0],
    tip: long,
  };
}

/** @returns {Thing} */
function molecule() {
  const hydrogens = /** @type {Spot[]} */ ([
    [0.76, 0.5],
    [0.76, -0.5],
    [-0.76, 0.5],
    [-0.76, -0.5],
  ]);
  return {
    outlines: [
      ellipse(0.36, 0, 0.2, 0.2),
      ellipse(-0.36, 0, 0.2, 0.2),
      ...hydrogens.map(([x, y]) => ellipse(x, y, 0.13, 0.13)),
    ],
    lines: [],
    bars: [
      [
        [-0.36, 0.06],
        [0.36, 0.06],
      ],
      [
        [-0.36, -0.06],
        [0.36, -0.06],
      ],
      ...hydrogens.map((end) => /** @type {Spot[]} */ ([[Math.sign(end[0]) * 0.36, 0], end])),
    ],
    dot: [0.36, 0],
    tip: 0.56,
  };
}

/**
 * @param {number} x centre along e₁
 * @param {number} y centre along e₂
 * @param {number} long half axis along e₁
 * @param {number} wide half axis along e₂
 * @returns {Spot[]}
 */
function ellipse(x, y, long, wide) {
  return Array.from({ length: 48 }, (_, i) => {
    const angle = (2 * Math.PI * i) / 48;
    return [x + long * Math.cos(angle), y + wide * Math.sin(angle)];
  });
}

/**
 * @param {Spot[]} outline
 * @returns {Spot[]} the outline with its first spot again at the end
 */
function toItsStart(outline) {
  return [...outline, outline[0]];
}

/**
 * The body axes in space.
 *
 * @param {Attitude} attitude
 * @returns {{ first: Vector, second: Vector, third: Vector }}
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
 * @param {Vector} x
 * @param {Vector} y
 * @returns {number}
 */
function dot(x, y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/**
 * SVG coordinates of a point in space.
 *
 * @param {Vector} point
 * @returns {string}
 */
function onPaper(point) {
  return `${(SCALE * dot(point, EYE.right)).toFixed(1)} ${(-SCALE * dot(point, EYE.up)).toFixed(1)}`;
}

/**
 * The drawing commands of a line through points in space.
 *
 * @param {Vector[]} points
 * @returns {string}
 */
function lineThrough(points) {
  return "M" + points.map(onPaper).join("L");
}

/**
 * The parts of the scene that stay while a motion plays: the circle a level handle's head runs on,
 * M, and the path of the head.
 *
 * @param {SVGElement} scene
 * @param {Thing} thing
 * @param {Vector[]} path the handle's direction along the motion
 */
function drawStage(scene, thing, path) {
  const ring = Array.from({ length: 73 }, (_, i) => {
    const angle = (Math.PI * i) / 36;
    return /** @type {Vector} */ ([thing.tip * Math.cos(angle), thing.tip * Math.sin(angle), 0]);
  });
  const head = path.map((way) => /** @type {Vector} */ (way.map((x) => thing.tip * x)));
  const top = -SCALE * dot([0, 0, 1.28], EYE.up);
  scene.querySelectorAll("path, text, circle").forEach((part) => part.remove());
  add(scene, "path", { class: "ring", d: lineThrough(ring) });
  add(scene, "path", { class: "trail", d: lineThrough(head) });
  add(scene, "path", { class: "momentum", d: `M0 0V${top + 8}` });
  add(scene, "path", { class: "momentum-head", d: `M0 ${top}l-4.5 11h9z` });
  add(scene, "text", { x: 9, y: top + 12, class: "vector" }).textContent = "M";
  add(scene, "path", { class: "bars" });
  add(scene, "path", { class: "outlines" });
  add(scene, "path", { class: "lines" });
  add(scene, "circle", { class: "dot", r: 4.5 });
}

/**
 * The body at one moment.
 *
 * @param {SVGElement} scene with the parts of drawStage
 * @param {Thing} thing
 * @param {Attitude} attitude
 */
function drawThing(scene, thing, attitude) {
  const { first, second, third } = axesOf(attitude);
  /** @param {Spot} spot */
  const inSpace = ([x, y]) => /** @type {Vector} */ (first.map((e, i) => x * e + y * second[i]));
  /** @param {Spot[][]} strokes */
  const drawn = (strokes) => strokes.map((stroke) => lineThrough(stroke.map(inSpace))).join("");
  const front = dot(third, EYE.towards) > 0;
  part(scene, "bars").setAttribute("d", drawn(thing.bars));
  part(scene, "lines").setAttribute("d", drawn(thing.lines));
  const outlines = part(scene, "outlines");
  outlines.setAttribute("d", drawn(thing.outlines.map(toItsStart)));
  outlines.setAttribute("class", front ? "outlines front" : "outlines back");
  const mark = part(scene, "dot");
  const [x, y] = onPaper(inSpace(thing.dot)).split(" ");
  mark.setAttribute("cx", x);
  mark.setAttribute("cy", y);
  mark.setAttribute("visibility", front ? "visible" : "hidden");
}

/**
 * @param {SVGElement} scene
 * @param {string} name a class
 * @returns {Element}
 */
function part(scene, name) {
  return /** @type {Element} */ (scene.querySelector(`.${name}`));
}

/**
 * A new element at the end of an SVG element.
 *
 * @param {Element} parent
 * @param {string} name
 * @param {Record<string, string | number>} [attributes]
 * @returns {Element}
 */
function add(parent, name, attributes = {}) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  return parent.appendChild(element);
}
