/**
 * One turn of the handle: a stretch of an orbit, from wherever it starts.
 *
 * The symmetric throw of a level runs from φ = −π to φ = π and from ψ = ε to ψ = π − ε. A throw from
 * a start (ψ₀, dψ/dφ) runs on the orbit of that start. Where the handle points down, cos θ < 0, a
 * rotating orbit is the mirror image ψ → −ψ, θ → π − θ of one of those in orbit.js.
 */
"use strict";

/**
 * @typedef {object} Motion
 * @property {Orbit} orbit
 * @property {number} begin u at its start
 * @property {number} end u a turn later
 * @property {number} shift what ψ has beyond the ψ of the orbit, a multiple of π
 * @property {number} side −1 for the mirror image, else 1
 */

/**
 * The symmetric turn of a level.
 *
 * @param {Level} level
 * @returns {Motion}
 */
function symmetricTurn(level) {
  const orbit = orbitOf(level);
  const end = timeOf(orbit, placeAt(orbit, Math.PI));
  return { orbit, begin: -end, end, shift: 0, side: 1 };
}

/**
 * The turn from a start, or null where the body only spins about e₂ or e₃ for ever.
 *
 * @param {Level} shape any level of it
 * @param {number} psi ψ₀
 * @param {number} rate dψ/dφ there, at most largestRate in size
 * @returns {Motion | null}
 */
function turnFrom(shape, psi, rate) {
  const { a, b, total } = shape;
  const level = levelThrough(shape, psi, rate);
  const [sine, cosine] = [Math.sin(psi), Math.cos(psi)];
  if (level.above <= 0 || (rate === 0 && Math.abs(sine) < 1e-15)) return null;
  const orbit = orbitOf(level);
  const handle = (rate * (1 - b * sine * sine)) / (a + b * sine * sine);
  const side = orbit.rotating && handle < 0 ? -1 : 1;
  // ψ − π/2 of the orbit, less a multiple of π, has −cos ψ for its sine where sin ψ is not negative.
  const turned = sine < 0 ? -1 : 1;
  const [across, along] = [-side * turned * cosine, turned * sine];
  const root = Math.sqrt(a + b * sine * sine);
  const tilted = Math.abs(handle) * Math.sqrt(total / level.above);
  const here = orbit.rotating
    ? { sn: (Math.sqrt(a) * across) / root, cn: (Math.sqrt(total) * along) / root, dn: tilted }
    : {
        sn: across * Math.sqrt((level.below / root ** 2) * (b / level.above)),
        cn: tilted,
        dn: (Math.sqrt(total) * along) / root,
      };
  let begin = signedTime(orbit, here);
  if (!orbit.rotating && handle < 0) begin = 2 * orbit.quarterTime - begin;
  const from = attitudeAt(orbit, begin);
  const shift = Math.PI * Math.round((psi - side * from.psi) / Math.PI);
  return { orbit, begin, end: timeOf(orbit, placeAt(orbit, from.phi + 2 * Math.PI)), shift, side };
}

/**
 * The level of a start, each entry without cancellation.
 *
 * @param {Level} shape
 * @param {number} psi
 * @param {number} rate
 * @returns {Level}
 */
function levelThrough({ a, b, total, clock }, psi, rate) {
  const square = Math.sin(psi) ** 2;
  const scale = a + b * square;
  const down = rate * (1 - b * square);
  const handle = down / scale;
  const gamma = handle * down - b * square;
  const above = handle * down + b * Math.cos(psi) ** 2;
  const below = ((scale - down) / scale) * (scale + down);
  return { a, b, gamma, above, below, total, clock };
}

/**
 * The largest dψ/dφ that a body of this shape can have at ψ: there the handle lies along M.
 *
 * @param {Level} shape
 * @param {number} psi
 * @returns {number}
 */
function largestRate({ a, b, clock }, psi) {
  return (a + b * Math.sin(psi) ** 2) / (clock + b * Math.cos(psi) ** 2);
}

/**
 * @param {Orbit} orbit
 * @param {Amplitude} here
 * @returns {number} u from −K to K
 */
function signedTime(orbit, here) {
  if (here.sn === 0) return 0;
  return Math.sign(here.sn) * integralsAt(orbit, { ...here, sn: Math.abs(here.sn) }).time;
}

/**
 * @param {Orbit} orbit
 * @param {Place} place
 * @returns {number} u
 */
function timeOf(orbit, { time, halves }) {
  return time + 2 * halves * orbit.quarterTime;
}

/**
 * The attitude after a share of the turn, which may be more than all of it; time and φ as in orbit.js.
 *
 * @param {Motion} motion
 * @param {number} share
 * @returns {Attitude}
 */
function poseAt({ orbit, begin, end, shift, side }, share) {
  const at = attitudeAt(orbit, begin + share * (end - begin));
  if (side > 0) return { ...at, psi: at.psi + shift };
  return { ...at, psi: shift - at.psi, theta: Math.PI - at.theta };
}

/**
 * dψ/dφ of an attitude.
 *
 * @param {Level} level
 * @param {Attitude} pose
 * @returns {number}
 */
function rateOf(level, { psi, theta }) {
  return largestRate(level, psi) * Math.cos(theta);
}

/**
 * How long the turn takes.
 *
 * @param {Motion} motion
 * @returns {number} in units of I₂/M
 */
function durationOf({ orbit, begin, end }) {
  return (end - begin) / orbit.speed;
}
