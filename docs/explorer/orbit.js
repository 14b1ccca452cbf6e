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
 * u and J at an amplitude are Carlson's R_F and R_J (DLMF 19.25), Jacobi's functions come from
 * theta series (DLMF 20.2, 22.2). The flip defect is read half a turn before ψ = π/2: ε = ψ where
 * φ = −π. φ increases with u on every level, so nothing is special at a turning point, and below
 * γ* the same code goes on.
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

/** @typedef {{ sn: number, cn: number, dn: number }} Amplitude Jacobi's functions at one u */

/** @typedef {{ time: number, third: number }} Integrals u and J at one amplitude */

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
 * The arithmetic-geometric mean of 1 and x.
 *
 * @param {number} x positive
 * @returns {number}
 */
function meanOf(x) {
  let high = Math.max(1, x);
  let low = Math.min(1, x);
  while (high - low > 1e-8 * high) [high, low] = [(high + low) / 2, Math.sqrt(high * low)];
  return (high + low) / 2;
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
 * u = sn R_F(cn², dn², 1) and J = (sn³/3) R_J(cn², dn², 1, 1 + n sn²) by Carlson's duplication
 * (DLMF 19.36.i), both along the same sequence. p − x, p − y and p − z are products here, so every
 * term of R_J's sum is positive and to its last bit.
 *
 * @param {Orbit} orbit
 * @param {Amplitude} at with sn > 0
 * @returns {Integrals}
 */
function integralsAt({ k, characteristic }, { sn, cn, dn }) {
  const square = sn * sn;
  let x = cn * cn;
  let y = dn * dn;
  let z = 1;
  let p = 1 + characteristic * square;
  let delta = square ** 3 * (1 + characteristic) * (k * k + characteristic) * characteristic;
  let sum = 0;
  let share = 1;
  for (let step = 0; step < 60; step++) {
    if (Math.max(p, z) - Math.min(x, y) < 4e-3 * p) break;
    const rx = Math.sqrt(x);
    const ry = Math.sqrt(y);
    const rz = Math.sqrt(z);
    const rp = Math.sqrt(p);
    const product = (rp + rx) * (rp + ry) * (rp + rz);
    sum += (share / product) * arcOver(delta / (product * product));
    const shift = rx * ry + ry * rz + rz * rx;
    x = (x + shift) / 4;
    y = (y + shift) / 4;
    z = (z + shift) / 4;
    p = (p + shift) / 4;
    share /= 4;
    delta /= 64;
  }
  const end = share * thirdKindSeries(x, y, z, p);
  return { time: sn * firstKindSeries(x, y, z), third: (sn * square * (end + 6 * sum)) / 3 };
}

/**
 * R_C(1, 1 + e) = arctan(√e)/√e.
 *
 * @param {number} e not negative
 * @returns {number}
 */
function arcOver(e) {
  if (e < 1e-9) return 1 - e / 3;
  const root = Math.sqrt(e);
  return Math.atan(root) / root;
}

/**
 * R_F of nearly equal arguments (DLMF 19.36.1).
 *
 * @param {number} x
 * @param {number} y
 * @param {number} z
 * @returns {number}
 */
function firstKindSeries(x, y, z) {
  const mean = (x + y + z) / 3;
  const [X, Y] = [1 - x / mean, 1 - y / mean];
  const Z = -X - Y;
  const e2 = X * Y - Z * Z;
  const e3 = X * Y * Z;
  return (1 - e2 / 10 + e3 / 14 + (e2 * e2) / 24 - (3 * e2 * e3) / 44) / Math.sqrt(mean);
}

/**
 * R_J of nearly equal arguments (DLMF 19.36.2).
 *
 * @param {number} x
 * @param {number} y
 * @param {number} z
 * @param {number} p
 * @returns {number}
 */
function thirdKindSeries(x, y, z, p) {
  const mean = (x + y + z + 2 * p) / 5;
  const [X, Y, Z] = [1 - x / mean, 1 - y / mean, 1 - z / mean];
  const P = -(X + Y + Z) / 2;
  const xyz = X * Y * Z;
  const e2 = X * Y + X * Z + Y * Z - 3 * P * P;
  const e3 = xyz + 2 * e2 * P + 4 * P ** 3;
  const e4 = (2 * xyz + e2 * P + 3 * P ** 3) * P;
  const e5 = xyz * P * P;
  const series =
    1 -
    (3 * e2) / 14 +
    e3 / 6 +
    (9 * e2 * e2) / 88 -
    (3 * e4) / 22 -
    (9 * e2 * e3) / 52 +
    (3 * e5) / 26;
  return series / (mean * Math.sqrt(mean));
}

/**
 * sn, cn and dn at |u| ≤ K, by theta series in the nome of the smaller of k² and 1 − k²; every
 * term that float64 can see is there.
 *
 * @param {Orbit} orbit
 * @param {number} time u
 * @returns {Amplitude}
 */
function amplitudeAt(orbit, time) {
  return orbit.k1 <= orbit.k ? hyperbolicSeries(orbit, time) : circularSeries(orbit, time);
}

/**
 * @param {Orbit} orbit with k² < ½
 * @param {number} time u
 * @returns {Amplitude}
 */
function circularSeries({ k, k1, direct, dual }, time) {
  const q = Math.exp((-Math.PI * direct) / dual);
  const sine = Math.sin(direct * time);
  const cosine = Math.cos(direct * time);
  const c2 = 1 - 2 * sine * sine;
  const c4 = 2 * c2 * c2 - 1;
  const c6 = c2 * (4 * c2 * c2 - 3);
  const odd = q * (c2 + q ** 8 * c6);
  const even = q ** 4 * c4;
  const three = 1 + 2 * (odd + even);
  const four = 1 - 2 * (odd - even);
  const one = sine * (1 - q ** 2 * (1 + 2 * c2) + q ** 6 * (1 + 2 * c2 + 2 * c4));
  const two = cosine * (1 + q ** 2 * (2 * c2 - 1) + q ** 6 * (1 - 2 * c2 + 2 * c4));
  const ratio = (2 * Math.sqrt(Math.sqrt(q))) / Math.sqrt(k);
  const root = Math.sqrt(k1);
  return { sn: (ratio * one) / four, cn: (ratio * root * two) / four, dn: (root * three) / four };
}

/**
 * The same where k² ≥ ½. With y the argument, e = e^(−2|y|) and w = q e^(2|y|) ≤ 1, every series
 * is divided by e^|y|/2.
 *
 * @param {Orbit} orbit
 * @param {number} time u
 * @returns {Amplitude}
 */
function hyperbolicSeries({ k, k1, direct, dual }, time) {
  const y = dual * Math.abs(time);
  const logNome = (-Math.PI * dual) / direct;
  const logW = Math.min(0, 2 * y + logNome);
  const q = Math.exp(logNome);
  const w = Math.exp(logW);
  const e = Math.exp(-2 * y);
  const qw = q * w;
  const q4w2 = (q * q * w) ** 2;
  const last = (q * q * qw) ** 3;
  const one = -Math.expm1(-2 * y) - qw * (1 - e ** 3) + q4w2 * (1 - e ** 5) - last * (1 - e ** 7);
  const two = 1 + e + qw * (1 + e ** 3) + q4w2 * (1 + e ** 5) + last * (1 + e ** 7);
  const first = w * e * e;
  const second = qw * qw * (1 + e ** 4);
  const third = (q * q * w) ** 3 * (1 + e ** 6);
  const three = 1 + w + first + second + third;
  const four = -Math.expm1(logW) - first + second - third;
  const half = Math.exp(-y - logNome / 4);
  return {
    sn: (Math.sign(time) * one) / two / Math.sqrt(k),
    cn: (half * Math.sqrt(k1 / k) * four) / two,
    dn: (half * Math.sqrt(k1) * three) / two,
  };
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

/**
 * @param {number} x
 * @param {number} low
 * @param {number} high
 * @returns {number} the nearest number from low to high
 */
function clamp(x, low, high) {
  return Math.min(Math.max(x, low), high);
}

/**
 * The flip defect: π/2 less what ψ gains from ψ = π/2 while φ gains π.
 *
 * Angles near ψ = 0 and π are formed from their small part, so that it keeps its own digits.
 *
 * @param {Orbit} orbit
 * @param {Place} place where φ = π
 * @returns {number} ε in radians
 */
function defectAt(orbit, { time, halves }) {
  const { a, b, above, below, total } = orbit.level;
  const { sn, cn, dn } = amplitudeAt(orbit, time);
  const behind = sn < 0;
  if (orbit.rotating) {
    const offset = Math.atan2(Math.sqrt(a) * cn, Math.sqrt(total) * Math.abs(sn));
    return behind ? -offset - (halves - 1) * Math.PI : offset - halves * Math.PI;
  }
  const reach = Math.sqrt((above / below) * (total / b));
  const offset = Math.atan2(dn, reach * Math.abs(sn));
  return behind === (halves % 2 !== 0) ? offset : Math.PI - offset;
}

/**
 * ε(γ) of a level.
 *
 * @param {Level} level
 * @returns {number} radians
 */
function flipDefect(level) {
  const orbit = orbitOf(level);
  return defectAt(orbit, placeAt(orbit, Math.PI));
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

/**
 * ε₀, the defect on the separatrix: with k = √(ab), r = √(b/a) and P = π + arctan(r tanh kP) it is
 * cot ε₀ = √(1 + r²) sinh kP. The map contracts everywhere and nothing in it cancels.
 *
 * @param {Level} level
 * @returns {number} radians
 */
function separatrixDefect({ a, b, total }) {
  const k = Math.sqrt(a * b);
  const r = Math.sqrt(b / a);
  let phase = Math.PI;
  for (let step = 0; step < 20; step++) {
    const tangent = Math.tanh(k * phase);
    const ratio = r * tangent;
    const slope = 1 - (b * (1 - tangent * tangent)) / (1 + ratio * ratio);
    const change = (phase - Math.PI - Math.atan(ratio)) / slope;
    phase -= change;
    if (Math.abs(change) <= 1e-10 * phase) break;
  }
  return Math.atan(Math.sqrt(a / total) / Math.sinh(k * phase));
}

/**
 * γ*, below which the trajectory turns back before it has flipped: there a quarter of the
 * oscillation takes φ = π. The phase of a quarter grows with γ, so bisection on log((γ+b)/(−γ)).
 *
 * @param {Level} level of the shape, any γ
 * @returns {number | null} null where every trajectory with γ < 0 takes more than that
 */
function turningLevel({ a, b, total, clock }) {
  if (clock * clock >= 4 * b * total) return null;
  let [low, high] = [-40, 640];
  let gamma = 0;
  for (let step = 0; step < 64; step++) {
    const middle = (low + high) / 2;
    const share = 1 / (1 + Math.exp(middle));
    gamma = -b * share;
    const above = (b * Math.exp(middle)) / (1 + Math.exp(middle));
    const orbit = orbitOf({ a, b, gamma, above, below: a - gamma, total, clock });
    if (orbit.quarterPhase < Math.PI) low = middle;
    else high = middle;
  }
  return gamma;
}

/**
 * The γ > 0 with a perfect flip, ε(γ) = 0, by bisection on log γ: ε falls steadily there.
 *
 * @param {Level} level of the shape, any γ
 * @returns {number | null} null where ε stays positive up to γ = a
 */
function perfectLevel({ a, b, total, clock }) {
  /** @param {number} gamma */
  const falls = (gamma) =>
    flipDefect({ a, b, gamma, above: gamma + b, below: a - gamma, total, clock }) < 0;
  const last = a * (1 - 1e-9);
  if (!falls(last)) return null;
  let [low, high] = [-640, Math.log(last)];
  for (let step = 0; step < 60; step++) {
    const middle = (low + high) / 2;
    if (falls(Math.exp(middle))) high = middle;
    else low = middle;
  }
  return Math.exp(high);
}

/**
 * The paper's ε₀, equation (eps0) without its remainder.
 *
 * @param {Level} level
 * @returns {number} radians
 */
function printedDefect({ a, b, total }) {
  const factor = 2 * Math.sqrt(a / total) * Math.exp(-b / Math.sqrt(1 + b / a));
  return Math.exp(-Math.sqrt(a * b) * Math.PI) * factor;
}

/**
 * The paper's ε(γ), the theorem's straight line through its own ε₀.
 *
 * @param {Level} level
 * @returns {number} radians
 */
function printedLine(level) {
  const start = printedDefect(level);
  return start - level.gamma / (4 * level.b * start);
}
