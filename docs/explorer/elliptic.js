/**
 * Elliptic integrals and functions, without cancellation: Carlson's R_F and R_J by duplication
 * (DLMF 19.25, 19.36), Jacobi's sn, cn and dn by theta series (DLMF 20.2, 22.2).
 */
"use strict";

/** @typedef {{ sn: number, cn: number, dn: number }} Amplitude Jacobi's functions at one u */

/** @typedef {{ time: number, third: number }} Integrals u and J at one amplitude */

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
 * @param {number} x
 * @param {number} low
 * @param {number} high
 * @returns {number} the nearest number from low to high
 */
function clamp(x, low, high) {
  return Math.min(Math.max(x, low), high);
}
