/**
 * The choice: what is typed becomes a level and a throw, exactly as far as that goes.
 *
 * A shape is given by a and b or by three moments, a throw by γ or by a start (ψ₀, dψ/dφ). What was
 * touched last counts; the other fields follow.
 */
"use strict";

/**
 * @typedef {object} NamedBody
 * @property {string} name
 * @property {string} title
 * @property {string} source
 * @property {string} a
 * @property {string} b
 * @property {string[]} [moments]
 * @property {string} drawn
 * @property {string} [label] on the map
 */

/**
 * @typedef {object} Choice
 * @property {Level} level
 * @property {Motion} motion
 * @property {boolean} realizable
 * @property {[Fraction, Fraction]} shape a and b
 */

const LIMITS = { a: [1e-6, 1e4], b: [1e-6, 1] };
const ONE = /** @type {Fraction} */ ({ top: 1n, bottom: 1n });
const MOMENTS = ["I1", "I2", "I3"];

/** Which of the fields count. */
const given = { moments: false, point: false };

/** @type {NamedBody[]} */
const BODIES = JSON.parse(byId("bodies").textContent ?? "[]");

/**
 * @param {string} id
 * @returns {HTMLElement}
 */
function byId(id) {
  return /** @type {HTMLElement} */ (document.getElementById(id));
}

/**
 * @param {string} id of an input or a select
 * @returns {HTMLInputElement}
 */
function field(id) {
  return /** @type {HTMLInputElement} */ (document.getElementById(id));
}

/** What is wrong with one input, in words for the reader. */
class Complaint extends Error {
  /**
   * @param {string} input its id
   * @param {string} message
   */
  constructor(input, message) {
    super(message);
    this.input = input;
  }
}

/**
 * @returns {Choice}
 * @throws {Complaint}
 */
function readForm() {
  const shape = given.moments ? shapeOfMoments() : shapeOfNumbers();
  const [a, b] = shape;
  const product = { top: b.top * (a.top + 2n * a.bottom), bottom: b.bottom * a.bottom };
  const realizable = product.top <= product.bottom;
  const plain = {
    a: toFloat(a),
    b: toFloat(b),
    total: toFloat(plus(a, b)),
    clock: toFloat(minus(ONE, b)),
  };
  if (given.point) {
    const motion = readStart({ ...plain, gamma: 0, above: plain.b, below: plain.a });
    return { level: motion.orbit.level, motion, realizable, shape };
  }
  const gamma = typed("gamma", "γ");
  const above = plus(gamma, b);
  const below = minus(a, gamma);
  if (signOf(above) <= 0 || signOf(below) <= 0) {
    const range = withMinus(`−b = ${brief(-toFloat(b))} and a = ${brief(toFloat(a))}`);
    throw new Complaint("gamma", `γ must lie between ${range}, ends excluded`);
  }
  const level = {
    ...plain,
    gamma: toFloat(gamma),
    above: toFloat(above),
    below: toFloat(below),
  };
  return { level, motion: symmetricTurn(level), realizable, shape };
}

/**
 * @returns {[Fraction, Fraction]}
 * @throws {Complaint}
 */
function shapeOfNumbers() {
  const a = typed("a", "a");
  const b = typed("b", "b");
  inLimits("a", "a", a, "a = I₂/I₁ − 1 must be from 0.000001 to 10000");
  inLimits("b", "b", b, "b = 1 − I₂/I₃ must be from 0.000001 to 1");
  return [a, b];
}

/**
 * @returns {[Fraction, Fraction]}
 * @throws {Complaint}
 */
function shapeOfMoments() {
  const [one, two, three] = MOMENTS.map((id) => {
    const moment = typed(id, `I${"₁₂₃"[Number(id[1]) - 1]}`);
    if (signOf(moment) <= 0) throw new Complaint(id, "a moment of inertia must be positive");
    return moment;
  });
  if (signOf(minus(two, one)) <= 0) throw new Complaint("I2", "I₂ must be more than I₁");
  if (signOf(minus(three, two)) <= 0) throw new Complaint("I3", "I₃ must be more than I₂");
  const a = excess(two, one);
  const inverse = excess(two, three);
  const b = { top: -inverse.top, bottom: inverse.bottom };
  inLimits("I1", "a", a, "I₂/I₁ − 1 must be from 0.000001 to 10000");
  inLimits("I3", "b", b, "1 − I₂/I₃ must be at least 0.000001");
  return [a, b];
}

/**
 * @param {Level} shape
 * @returns {Motion}
 * @throws {Complaint}
 */
function readStart(shape) {
  const psi = toFloat(typed("psi0", "ψ₀"));
  const rate = toFloat(typed("rate", "dψ/dφ"));
  if (Math.abs(psi) > 1000) throw new Complaint("psi0", "ψ₀ must be from −1000 to 1000");
  const largest = largestRate(shape, psi);
  if (!(Math.abs(rate) < largest)) {
    throw new Complaint("rate", `here dψ/dφ must be less than ${brief(largest)} in size`);
  }
  const motion = turnFrom(shape, psi, rate);
  if (motion) return motion;
  throw new Complaint(
    "rate",
    "there it spins steadily about one axis and never flips; give it a push",
  );
}

/**
 * @param {string} id
 * @param {string} name
 * @returns {Fraction}
 * @throws {Complaint}
 */
function typed(id, name) {
  const number = readNumber(field(id).value);
  if (number) return number;
  throw new Complaint(
    id,
    `${name} is not a number I can read; write for example 0.0629, −3e−5 or 55/874`,
  );
}

/**
 * @param {string} id of the input to complain about
 * @param {"a" | "b"} name
 * @param {Fraction} number
 * @param {string} message
 * @throws {Complaint}
 */
function inLimits(id, name, number, message) {
  const value = toFloat(number);
  const outside = !(value >= LIMITS[name][0] && value <= LIMITS[name][1]);
  // What rounds to 1 may still be more.
  if (outside || (name === "b" && signOf(minus(ONE, number)) < 0)) throw new Complaint(id, message);
}

/** @returns {NamedBody | undefined} the named body that the form still describes */
function bodyOf() {
  const body = BODIES.find(({ name }) => name === field("body").value);
  if (!body) return undefined;
  const same = given.moments
    ? body.moments?.every((text, i) => text === field(MOMENTS[i]).value)
    : body.a === field("a").value && body.b === field("b").value;
  return same ? body : undefined;
}

/** @returns {string} the command that certifies what is shown */
function commandOf() {
  const body = bodyOf();
  const shape = body
    ? `--body ${body.name}`
    : given.moments
      ? `--inertia ${MOMENTS.map(asTyped).join(" ")}`
      : `--shape ${asTyped("a")} ${asTyped("b")}`;
  const start = given.point
    ? `--psi0=${asTyped("psi0")} --rate=${asTyped("rate")}`
    : `--gamma=${asTyped("gamma")}`;
  return `tresym flip ${shape} ${start}`;
}

/**
 * @param {string} id
 * @returns {string} what is typed, with a hyphen for a minus and a decimal point
 */
function asTyped(id) {
  return field(id).value.trim().replace(/[−–]/g, "-").replace(/\s+/g, "").replace(",", ".");
}

// Numbers in words

/**
 * @param {number} x
 * @returns {string} four digits
 */
function brief(x) {
  return withMinus(x === 0 ? "0" : `${Number(x.toPrecision(4))}`);
}

/**
 * @param {number} x
 * @param {number} [digits]
 * @returns {string} as one types it
 */
function rounded(x, digits = 3) {
  return String(Number(x.toPrecision(digits)));
}

/**
 * @param {number} x in radians
 * @returns {string} in degrees
 */
function inDegrees(x) {
  const angle = x / DEGREE;
  const size = Math.abs(angle);
  if (size === 0) return "0";
  return withMinus(size >= 1e4 || size < 1e-3 ? angle.toExponential(2) : angle.toFixed(4));
}

/**
 * @param {number} x
 * @param {number} digits
 * @returns {string}
 */
function inDigits(x, digits) {
  return withMinus(x === 0 ? "0" : x.toPrecision(digits));
}
