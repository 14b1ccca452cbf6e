/**
 * Numbers as they are typed: exact fractions, rounded to float64 once and last.
 *
 * 1 − b, γ + b and a − γ lose their digits when they are formed from rounded numbers; formed from
 * fractions of integers, each is right to its last bit.
 */
"use strict";

/** @typedef {{ top: bigint, bottom: bigint }} Fraction a number top/bottom with bottom > 0 */

const LONGEST_NUMBER = 60;
const LARGEST_EXPONENT = 150;

/**
 * The number that a text such as "0.0629", "0,0629", "-3e-5" or "55/874" stands for.
 *
 * @param {string} text
 * @returns {Fraction | null} null if it is no number, or longer than this page reads
 */
function readNumber(text) {
  const word = text.trim().replace(/[−–]/g, "-");
  if (word.length > LONGEST_NUMBER) return null;
  const ratio = /^([+-]?\d+)\s*\/\s*(\d+)$/.exec(word);
  if (ratio) {
    const bottom = BigInt(ratio[2]);
    return bottom === 0n ? null : { top: integer(ratio[1]), bottom };
  }
  const decimal = /^([+-]?)(\d*)[.,]?(\d*)(?:e([+-]?\d{1,4}))?$/i.exec(word);
  if (!decimal || decimal[2] + decimal[3] === "") return null;
  const [, sign, whole, part, power = "0"] = decimal;
  if (Math.abs(Number(power)) > LARGEST_EXPONENT) return null;
  const exponent = Number(power) - part.length;
  const digits = integer(sign + whole + part);
  return exponent >= 0
    ? { top: digits * 10n ** BigInt(exponent), bottom: 1n }
    : { top: digits, bottom: 10n ** BigInt(-exponent) };
}

/**
 * @param {string} text an optional sign and digits
 * @returns {bigint}
 */
function integer(text) {
  return text.startsWith("-") ? -BigInt(text.slice(1)) : BigInt(text.replace("+", ""));
}

/**
 * x + y.
 *
 * @param {Fraction} x
 * @param {Fraction} y
 * @returns {Fraction}
 */
function plus(x, y) {
  return { top: x.top * y.bottom + y.top * x.bottom, bottom: x.bottom * y.bottom };
}

/**
 * x − y.
 *
 * @param {Fraction} x
 * @param {Fraction} y
 * @returns {Fraction}
 */
function minus(x, y) {
  return plus(x, { top: -y.top, bottom: y.bottom });
}

/**
 * The sign of x: −1, 0 or 1.
 *
 * @param {Fraction} x
 * @returns {number}
 */
function signOf(x) {
  return x.top > 0n ? 1 : x.top < 0n ? -1 : 0;
}

/**
 * The nearest float64, to one unit in the last place.
 *
 * @param {Fraction} x
 * @returns {number}
 */
function toFloat(x) {
  if (x.top < 0n) return -toFloat({ top: -x.top, bottom: x.bottom });
  // A quotient of at least 64 bits, whose rounding is the only one that counts.
  const shift = Math.max(0, 64 + bitLength(x.bottom) - bitLength(x.top));
  const quotient = Number((x.top << BigInt(shift)) / x.bottom);
  const half = Math.floor(shift / 2);
  return quotient * 2 ** -half * 2 ** (half - shift);
}

/**
 * @param {bigint} n not negative
 * @returns {number} how many bits it has, to within 3
 */
function bitLength(n) {
  return 4 * n.toString(16).length;
}

/**
 * x/y − 1.
 *
 * @param {Fraction} x
 * @param {Fraction} y positive
 * @returns {Fraction}
 */
function excess(x, y) {
  return { top: x.top * y.bottom - y.top * x.bottom, bottom: y.top * x.bottom };
}

/**
 * A fraction as one types it, in lowest terms.
 *
 * @param {Fraction} x
 * @returns {string}
 */
function fractionText({ top, bottom }) {
  let [p, q] = [top < 0n ? -top : top, bottom];
  while (q) [p, q] = [q, p % q];
  return bottom === p ? `${top / p}` : `${top / p}/${bottom / p}`;
}
