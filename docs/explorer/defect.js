/**
 * The flip defect of a level: exact, by the paper's formulas, and the levels at which it is special.
 *
 * It is read half a turn before ψ = π/2: ε = ψ where φ = −π. φ increases with u on every level, so
 * nothing is special at a turning point, and below γ* the same code goes on.
 */
"use strict";

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
