/**
 * The story: an opening and four scenes that set the stage as they are scrolled to, and the bench after them.
 */
"use strict";

/**
 * @typedef {object} Scene
 * @property {string} body
 * @property {string} level rocks, separatrix, perfect, …
 * @property {boolean} once whether the motion stops after a turn
 * @property {boolean} ghosts
 * @property {number} tempo
 * @property {number} yaw from where it is seen, in degrees
 */

/** @type {Record<string, Scene>} */
const SCENES = {
  opening: { body: "str", level: "perfect", once: false, ghosts: false, tempo: 0.3, yaw: -34 },
  throw: { body: "str", level: "perfect", once: true, ghosts: false, tempo: 0.25, yaw: -22 },
  "portrait-scene": {
    body: "str",
    level: "rocks",
    once: false,
    ghosts: false,
    tempo: 0.4,
    yaw: -34,
  },
  "defect-scene": {
    body: "str",
    level: "separatrix",
    once: true,
    ghosts: true,
    tempo: 0.25,
    yaw: -50,
  },
  "body-scene": {
    body: "racket-3",
    level: "separatrix",
    once: true,
    ghosts: false,
    tempo: 0.25,
    yaw: -34,
  },
  bench: { body: "str", level: "separatrix", once: true, ghosts: false, tempo: 0.3, yaw: -34 },
};

/** The scene on the stage, and whether a hand has changed anything. */
const scene = { name: "opening", touched: false };

/** What the bench was left with. */
let left = /** @type {string | null} */ (null);

/**
 * A level of the present shape by its name.
 *
 * @param {string} name
 */
function setLevel(name) {
  const { b, a } = level();
  /** @type {Record<string, number | null>} */
  const levels = {
    rocks: -0.2 * b,
    separatrix: 0,
    rolls: Math.min(0.3 * b, 0.5 * a),
    perfect: shown.perfect,
    turning: shown.turning,
  };
  shown.share = 0;
  setGamma(levels[name]);
}

/**
 * Change the scene.
 *
 * @param {string} name
 */
function enter(name) {
  const from = scene.name;
  if (from === name && shown.motion) return;
  if (from === "bench" && scene.touched) left = `#${addressOf()}`;
  scene.name = name;
  byId("stage").dataset.scene = name;
  if (left && name === "bench") {
    history.replaceState(null, "", left);
    recall();
    update();
  } else {
    const { body, level: place, once, ghosts, tempo, yaw } = SCENES[name];
    Object.assign(shown, { once, ghosts, share: 0 });
    given.point = false;
    field("gamma").value = "0";
    chooseBody(body);
    setLevel(place);
    setTempo(tempo);
    glide(yaw * DEGREE);
  }
  showChecks();
  fitStage();
}

let gliding = 0;

/**
 * Lead the eye to where the scene is seen best; at once for who wants less motion.
 *
 * @param {number} yaw
 */
function glide(yaw) {
  const eye = shown.eyes.space;
  const { pitch } = HOME.space;
  cancelAnimationFrame(gliding);
  if (!shown.motion || matchMedia("(prefers-reduced-motion: reduce)").matches) {
    Object.assign(eye, { yaw, pitch });
    return;
  }
  const [from, low, start] = [eye.yaw, eye.pitch, performance.now()];
  /** @param {number} now */
  const step = (now) => {
    const share = clamp((now - start) / 900, 0, 1);
    const eased = share * share * (3 - 2 * share);
    Object.assign(eye, { yaw: from + eased * (yaw - from), pitch: low + eased * (pitch - low) });
    redraw("space");
    if (share < 1) gliding = requestAnimationFrame(step);
  };
  gliding = requestAnimationFrame(step);
}

/** The boxes and buttons that say how the stage is set. */
function showChecks() {
  field("once").checked = shown.once;
  field("ghosts").checked = shown.ghosts;
  field("upright").checked = !shown.eyes.space.thrown;
  for (const link of byId("steps").querySelectorAll("a"))
    link.setAttribute("aria-current", link.hash === `#${scene.name}` ? "step" : "false");
  const chosen = byId("stage").dataset.picture;
  // Where there is room for four pictures the choice is between two.
  const roomy = matchMedia("(min-width: 56.01rem)").matches;
  const picture = roomy && chosen !== "levels" ? "map" : chosen;
  for (const button of byId("pictures").querySelectorAll("button"))
    button.setAttribute("aria-pressed", String(button.dataset.picture === picture));
}

/** Follow the scroll: the scene is the one in the middle of what is read. */
function followScroll() {
  const sections = [...document.querySelectorAll(".scene, #bench")];
  const find = () => {
    const bottom = byId("stage").getBoundingClientRect().bottom;
    const high = window.innerHeight;
    // On a telephone the stage lies above the text, elsewhere beside it.
    const line = bottom < 0.9 * high ? (bottom + high) / 2 : 0.55 * high;
    const bench = byId("bench");
    // Whoever works the form stays at the bench, wherever it was scrolled to.
    if (bench.contains(document.activeElement) && bench.getBoundingClientRect().top < high) return;
    const here = sections.filter((section) => section.getBoundingClientRect().top < line).at(-1);
    if (here) enter(here.id);
  };
  let waiting = false;
  addEventListener(
    "scroll",
    () => {
      if (waiting) return;
      waiting = true;
      requestAnimationFrame(() => {
        waiting = false;
        find();
      });
    },
    { passive: true },
  );
  find();
}

/** The buttons within the text. */
function listenToStory() {
  byId("story").addEventListener("click", (event) => {
    const button = event.target instanceof Element ? event.target.closest("button") : null;
    if (!button) return;
    const { level: name, body, throw: thrown, atOnce } = button.dataset;
    if (name || body || thrown || atOnce) scene.touched = true;
    if (name) setLevel(name);
    if (body) chooseBody(body);
    if (atOnce) {
      chooseBody(atOnce);
      setLevel("separatrix");
    }
    if (thrown) {
      chooseBody(thrown);
      setLevel("perfect");
    }
  });
}
