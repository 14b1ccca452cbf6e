/**
 * The motion of a free body on one level of γ, in float64, without cancellation.
 *
 * In the time τ (in units of I₂/M) the flip angle ψ, the precession φ and the handle's tilt θ are
 * given by Jacobi's functions of u = ωτ, counted from ψ = π/2, φ = 0 with ψ increasing:
 *
 *   γ ≥ 0 (rotating):    ω² = a(γ+b),  n = b/a,          k² = b(a−γ)/(a(γ+b)),
 *                        tan(ψ − π/2) = √((a+b)/a) sn/cn,  cos θ = √((γ+b)/(a+b)) dn;
 *   γ < 0 (oscillating): ω² = b(a−γ),  n = (γ+b)/(a−γ),  k² = a(γ+b)/(b(a−γ)),
 *                        tan(ψ − π/2) = √((γ+b)(a+b)/(b(a−γ))) sn/dn,  cos θ = √((γ+b)/(a+b)) cn;
 *
 *   φ(u) = [(1−b) u + (a+b) n J(u)]/ω,  J = ∫ sn²/(1 + n sn²) du.
 *
 * This is the solution of Euler's equations in closed form: there is no step, and energy and momentum
 * stay where they are to rounding, however long the motion.
 */
"use strict";

/**
 * A shape and a level of it, every entry to its own last bit.
 *
 * @typedef {object} Level
 * @property {number} a I₂/I₁ − 1 > 0
 * @property {number} b 1 − I₂/I₃, in (0, 1]
 * @property {number} gamma γ
 * @property {number} above γ + b > 0
 * @property {number} below a − γ > 0
 * @property {number} total a + b
 * @property {number} clock 1 − b
 */

/**
 * What all points of an orbit share; the names are those of the formulas above.
 *
 * @typedef {object} Orbit
 * @property {Level} level
 * @property {boolean} rotating γ ≥ 0
 * @property {number} speed ω
 * @property {number} characteristic n
 * @property {number} k
 * @property {number} k1 √(1 − k²)
 * @property {number} direct the arithmetic-geometric mean of 1 and k1
 * @property {number} dual the same of 1 and k
 * @property {number} quarterTime u from ψ = π/2 to ψ = π, or to the turning point
 * @property {number} quarterPhase φ over the same stretch
 */

/** @typedef {{ time: number, halves: number }} Place u reduced to |u| ≤ K, and half periods 2K */

/** Least k² and 1 − k²: on the separatrix float64 sees no difference in any angle. */
const LEAST_MODULUS = 1e-280;

/**
 * The orbit of a level.
 *
 * @param {Level} level
 * @returns {Orbit}
 */
function orbitOf(level) {
  const { a, b, gamma, above, below, total } = level;
  const rotating = gamma >= 0;
  const square = rotating ? a * above : b * below;
  const other = rotating ? b * below : a * above;
  const k = Math.sqrt(Math.max(other / square, LEAST_MODULUS));
  const k1 = Math.sqrt(Math.max((Math.abs(gamma) / square) * total, LEAST_MODULUS));
  const orbit = {
    level,
    rotating,
    speed: Math.sqrt(square),
    characteristic: rotating ? b / a : above / below,
    k,
    k1,
    direct: meanOf(k1),
    dual: meanOf(k),
    quarterTime: Infinity,
    quarterPhase: Infinity,
  };
  const far = integralsAt(orbit, { sn: 1, cn: 0, dn: k1 });
  orbit.quarterTime = far.time;
  orbit.quarterPhase = phaseFrom(orbit, far);
  return orbit;
}

/**
 * φ from u and J.
 *
 * @param {Orbit} orbit
 * @param {Integrals} at
 * @returns {number} radians
 */
function phaseFrom(orbit, at) {
  const { clock, total } = orbit.level;
  return (clock * at.time + total * orbit.characteristic * at.third) / orbit.speed;
}

/**
 * φ at |u| ≤ K.
 *
 * @param {Orbit} orbit
 * @param {number} time u
 * @returns {number} radians
 */
function phaseAt(orbit, time) {
  if (time === 0) return 0;
  const at = amplitudeAt(orbit, Math.abs(time));
  const sn = Math.min(at.sn, 1);
  const { third } = integralsAt(orbit, { sn, cn: Math.max(at.cn, 0), dn: at.dn });
  return Math.sign(time) * phaseFrom(orbit, { time: Math.abs(time), third });
}

/**
 * dφ/du = (1 − b sin²ψ)/ω.
 *
 * @param {Orbit} orbit
 * @param {number} time u
 * @returns {number}
 */
function phaseSlope(orbit, time) {
  const { clock, total } = orbit.level;
  const part = orbit.characteristic * amplitudeAt(orbit, time).sn ** 2;
  return (clock + (total * part) / (1 + part)) / orbit.speed;
}

/**
 * When the phase is φ, by Newton's method: φ(u) is convex in u > 0, so from the second on the
 * iterates come down to the root.
 *
 * @param {Orbit} orbit
 * @param {number} phi φ in radians
 * @returns {Place}
 */
function placeAt(orbit, phi) {
  const halves = Math.round(phi / (2 * orbit.quarterPhase));
  const rest = phi - 2 * halves * orbit.quarterPhase;
  const goal = Math.abs(rest);
  // (1 − b)/ω ≤ dφ/du ≤ 1/ω, from both ends of the quarter.
  const low = orbit.speed * goal;
  const left = orbit.speed * Math.max(orbit.quarterPhase - goal, 0);
  const high = Math.max(orbit.quarterTime - left, low);
  let time = clamp((goal * orbit.quarterTime) / orbit.quarterPhase, low, high);
  for (let step = 0; step < 60; step++) {
    const slope = Math.max(phaseSlope(orbit, time), 1e-300);
    const after = clamp(time - (phaseAt(orbit, time) - goal) / slope, low, high);
    const moved = Math.abs(after - time);
    time = after;
    if (moved <= 1e-10 * time) break;
  }
  return { time: Math.sign(rest) * time, halves };
}

/** @typedef {{ psi: number, theta: number, phi: number, time: number }} Attitude angles in
 *  radians, unwrapped; time τ in units of I₂/M; all 0 (ψ = π/2) in the middle of the flip */

/**
 * The attitude at a time.
 *
 * @param {Orbit} orbit
 * @param {number} time u, of any size and sign
 * @returns {Attitude}
 */
function attitudeAt(orbit, time) {
  const { a, b, above, below, total } = orbit.level;
  const halves = Math.round(time / (2 * orbit.quarterTime));
  const rest = clamp(time - 2 * halves * orbit.quarterTime, -orbit.quarterTime, orbit.quarterTime);
  const { sn, cn, dn } = amplitudeAt(orbit, rest);
  const phi = phaseAt(orbit, rest) + 2 * halves * orbit.quarterPhase;
  const side = halves % 2 === 0 ? 1 : -1;
  const top = Math.sqrt(above / total);
  const offset = orbit.rotating
    ? Math.atan2(Math.sqrt(total) * sn, Math.sqrt(a) * cn) + halves * Math.PI
    : side * Math.atan2(Math.sqrt((above / below) * (total / b)) * sn, dn);
  const tilt = orbit.rotating ? top * dn : side * top * cn;
  return {
    psi: Math.PI / 2 + offset,
    theta: Math.acos(clamp(tilt, -1, 1)),
    phi,
    time: time / orbit.speed,
  };
}
