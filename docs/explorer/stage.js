/**
 * The stage: the pictures, the clock that moves them, and what is shown now.
 *
 * Each picture has a part that stays while a motion plays, kept as a bitmap, and a part that moves.
 */
"use strict";

const HOME = {
  space: { yaw: (-34 * Math.PI) / 180, pitch: (19 * Math.PI) / 180, thrown: true },
  sphere: { yaw: (58 * Math.PI) / 180, pitch: (24 * Math.PI) / 180, thrown: false },
};

/** What is on the stage. The share of the turn goes on beyond 1 unless it stops there. */
const shown = {
  motion: /** @type {Motion | null} */ (null),
  realizable: true,
  thing: THINGS.racket,
  defect: 0,
  turning: /** @type {number | null} */ (null),
  perfect: /** @type {number | null} */ (null),
  share: 0,
  rest: 0,
  playing: false,
  once: false,
  ghosts: false,
  tempo: 0.3,
  eyes: { space: { ...HOME.space }, sphere: { ...HOME.sphere } },
};

const SECONDS_OF_REST = 1.2;
const NAMES = ["space", "portrait", "levels", "map", "sphere"];

/**
 * @typedef {object} View
 * @property {HTMLCanvasElement} canvas
 * @property {HTMLCanvasElement} still what stays
 * @property {boolean} stale whether that must be drawn again
 * @property {number} width in pixels of the page; 0 while it is hidden
 * @property {number} height
 */

/** @type {Record<string, View>} */
const VIEWS = Object.fromEntries(
  NAMES.map((name) => {
    const canvas = /** @type {HTMLCanvasElement} */ (/** @type {unknown} */ (byId(name)));
    const still = document.createElement("canvas");
    return [name, { canvas, still, stale: true, width: 0, height: 0 }];
  }),
);

/** The bodies as the map shows them. */
const ON_MAP = BODIES.filter(({ label: text }) => text).map((body) => {
  const [a, b] = [body.a, body.b].map((text) =>
    toFloat(/** @type {Fraction} */ (readNumber(text))),
  );
  const rigid = b * (a + 2) <= 1;
  return { a, b, label: body.label ?? "", rigid, below: rigid };
});

/**
 * What stays of a picture while a motion plays.
 *
 * @param {string} name
 * @param {Pen} pen
 * @param {Motion} motion
 */
function drawStill(name, pen, motion) {
  const { level } = motion.orbit;
  if (name === "portrait") drawPortrait(pen, motion);
  else if (name === "sphere") drawSphere(pen, motion, shown.eyes.sphere);
  else if (name === "levels") {
    drawLevels(pen, level, shown.turning);
    drawPresentLevel(pen, level, shown.defect, shown.turning);
  } else if (name === "map") {
    drawMap(pen, ON_MAP);
    drawShape(pen, level, shown.realizable);
  }
}

/**
 * What moves in a picture.
 *
 * @param {string} name
 * @param {Pen} pen
 * @param {Motion} motion
 */
function drawMoving(name, pen, motion) {
  const { share, thing, eyes, ghosts, once: whole } = shown;
  const show = { ghosts, whole, phantom: !shown.realizable };
  if (name === "space") drawSpace(pen, motion, share, thing, eyes.space, show);
  else if (name === "portrait") drawPhasePoint(pen, motion, share);
  else if (name === "sphere") drawMomentum(pen, motion, share, eyes.sphere);
}

/**
 * A picture as a whole.
 *
 * @param {string} name
 * @param {Pen} pen
 */
function drawWhole(name, pen) {
  if (!shown.motion) return;
  const { width, height } = pen;
  pen.area(
    [
      [0, 0],
      [width, 0],
      [width, height],
      [0, height],
    ],
    { fill: COLOURS.card },
  );
  drawStill(name, pen, shown.motion);
  drawMoving(name, pen, shown.motion);
}

let asked = false;

/**
 * Have the stage drawn with the next frame.
 *
 * @param {...string} stale the pictures of which more changes than the moment
 */
function redraw(...stale) {
  for (const name of stale) VIEWS[name].stale = true;
  if (asked) return;
  asked = true;
  requestAnimationFrame((now) => {
    asked = false;
    drawStage();
    if (shown.playing) passTime(now);
  });
}

/** Draw all pictures that are to be seen. */
function drawStage() {
  if (!shown.motion) return;
  for (const name of NAMES) drawView(name, VIEWS[name], shown.motion);
  showMoment(shown.motion);
}

/**
 * @param {string} name
 * @param {View} view
 * @param {Motion} motion
 */
function drawView(name, view, motion) {
  const { canvas, still, width, height } = view;
  if (!width || (!view.stale && (name === "levels" || name === "map"))) return;
  const ratio = canvas.width / width;
  if (view.stale && name !== "space") {
    const kept = /** @type {CanvasRenderingContext2D} */ (still.getContext("2d"));
    kept.setTransform(ratio, 0, 0, ratio, 0, 0);
    kept.clearRect(0, 0, width, height);
    drawStill(name, canvasPen(kept, width, height), motion);
  }
  view.stale = false;
  const to = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  to.setTransform(1, 0, 0, 1, 0, 0);
  to.clearRect(0, 0, canvas.width, canvas.height);
  if (name !== "space") to.drawImage(still, 0, 0);
  to.setTransform(ratio, 0, 0, ratio, 0, 0);
  drawMoving(name, canvasPen(to, width, height), motion);
}

/** Fit the bitmaps to the panels as they are now. */
function fitStage() {
  for (const view of Object.values(VIEWS)) {
    const { canvas, still } = view;
    const { clientWidth: width, clientHeight: height } = canvas;
    // More than two pixels to one are not seen, and cost time.
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const [wide, high] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (wide === canvas.width && high === canvas.height && width === view.width) continue;
    [canvas.width, canvas.height, still.width, still.height] = [wide, high, wide, high];
    Object.assign(view, { width, height, stale: true });
  }
  redraw();
}

/**
 * The clock and the slider beside it.
 *
 * @param {Motion} motion
 */
function showMoment(motion) {
  const { share } = shown;
  const part = share > 1 ? share - Math.floor(share) : share;
  field("moment").value = String(Math.round(1000 * part));
  const turned = Math.round((poseAt(motion, share).phi - poseAt(motion, 0).phi) / DEGREE);
  field("moment").setAttribute("aria-valuetext", `handle turned by ${turned}°`);
  byId("passed").textContent = `${(share / shown.tempo).toFixed(1)} s`;
}

/** @param {boolean} playing */
function setPlaying(playing) {
  shown.playing = playing;
  byId("play").textContent = playing ? "Pause" : "Play";
  before = 0;
  redraw();
}

let before = 0;

/**
 * Time runs evenly; where the motion stops after a turn it rests there, and begins again.
 *
 * @param {number} now in milliseconds
 */
function passTime(now) {
  // A hand on the start holds the clock.
  const step = before && !held.reach ? Math.min((now - before) / 1000, 0.1) : 0;
  before = now;
  if (!shown.once || shown.share < 1) {
    shown.share += step * shown.tempo;
    if (shown.once) shown.share = Math.min(shown.share, 1);
    shown.rest = 0;
  } else {
    shown.rest += step;
    if (shown.rest > SECONDS_OF_REST) shown.share = 0;
  }
  redraw();
}
