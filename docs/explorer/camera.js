/**
 * An eye that can be led around: it sees points of space as spots of a picture, near things larger.
 */
"use strict";

/** @typedef {[number, number, number]} Vector */

/**
 * @typedef {object} Camera
 * @property {number} yaw radians
 * @property {number} pitch radians above the horizon
 * @property {boolean} thrown whether the third axis of space lies level, as in a throw
 */

/**
 * @typedef {object} Eye
 * @property {Vector} right
 * @property {Vector} up
 * @property {Vector} towards the eye
 * @property {Vector} sky straight up
 * @property {Vector} light towards the lamp
 * @property {number} scale pixels per unit
 * @property {Spot} centre
 */

const DISTANCE = 7;
const STEEPEST = 1.45;

/**
 * @param {Camera} camera
 * @param {number} scale
 * @param {Spot} centre
 * @returns {Eye}
 */
function eyeOf({ yaw, pitch, thrown }, scale, centre) {
  const [cy, sy] = [Math.cos(yaw), Math.sin(yaw)];
  const [cp, sp] = [Math.cos(pitch), Math.sin(pitch)];
  /** @param {Vector} v @returns {Vector} */
  const inSpace = ([x, y, z]) => (thrown ? [y, z, x] : [x, y, z]);
  const right = inSpace([-sy, cy, 0]);
  const up = inSpace([-sp * cy, -sp * sy, cp]);
  const towards = inSpace([cp * cy, cp * sy, sp]);
  const light = sum([-0.4, right], [0.75, up], [0.53, towards]);
  return { right, up, towards, sky: inSpace([0, 0, 1]), light, scale, centre };
}

/**
 * Lead the eye around by pixels or steps.
 *
 * @param {Camera} camera
 * @param {number} across
 * @param {number} along
 */
function leadAround(camera, across, along) {
  camera.yaw = (camera.yaw - 0.008 * across) % (2 * Math.PI);
  camera.pitch = clamp(camera.pitch + 0.008 * along, -STEEPEST, STEEPEST);
}

/**
 * @param {Eye} eye
 * @param {Vector} point
 * @returns {number} pixels per unit there
 */
function scaleAt(eye, point) {
  return (eye.scale * DISTANCE) / (DISTANCE - dot(point, eye.towards));
}

/**
 * @param {Eye} eye
 * @param {Vector} point
 * @returns {Spot}
 */
function seen(eye, point) {
  const scale = scaleAt(eye, point);
  return [
    eye.centre[0] + scale * dot(point, eye.right),
    eye.centre[1] - scale * dot(point, eye.up),
  ];
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
 * A sum of multiples of vectors.
 *
 * @param {...[number, Vector]} terms
 * @returns {Vector}
 */
function sum(...terms) {
  /** @type {Vector} */
  const total = [0, 0, 0];
  for (const [factor, v] of terms) for (let i = 0; i < 3; i++) total[i] += factor * v[i];
  return total;
}
