/**
 * Hands on the pictures: by pointer and by the arrow keys.
 */
"use strict";

/**
 * What a hand does in a picture.
 *
 * @typedef {object} Grip
 * @property {(spot: Spot) => void} move the hand is at this spot
 * @property {(across: number, along: number) => void} step by the keys: −1, 0 or 1, more with Shift
 * @property {() => void} [grasp] before it begins
 * @property {() => void} [release]
 * @property {() => void} [home]
 */

/** Frames do not change their range under a hand. */
const held = { reach: 0, wide: 0 };

/** @type {Record<string, Grip>} */
const GRIPS = {
  space: lookAround("space"),
  sphere: lookAround("sphere"),
  portrait: {
    grasp: () => (held.reach = level() ? portraitFrame(VIEWS.portrait, level()).along[1] : 0),
    release() {
      held.reach = 0;
      redraw("portrait");
    },
    move: (spot) => startAt(pointAt(portraitFrame(VIEWS.portrait, level()), spot)),
    step(across, along) {
      const [psi, rate] = ["psi0", "rate"].map((id) => toFloat(readNumber(field(id).value) ?? ONE));
      const reach = portraitFrame(VIEWS.portrait, level()).along[1];
      startAt([psi + 2 * DEGREE * across, rate + 0.02 * reach * along]);
    },
  },
  levels: {
    grasp: () => (held.wide = level() ? levelsWidth(level(), shown.turning) : 0),
    release() {
      held.wide = 0;
      redraw("levels");
    },
    move: (spot) => levelAt(pointAt(levelsFrame(VIEWS.levels, level(), shown.turning), spot)[0]),
    step(across, along) {
      const [low, high] = levelsFrame(VIEWS.levels, level(), shown.turning).across;
      levelAt(level().gamma + ((across - along) * (high - low)) / 80);
    },
  },
  map: {
    move(spot) {
      const [x, y] = pointAt(mapFrame(VIEWS.map), spot);
      setShape(rounded(10 ** x), rounded(10 ** y));
    },
    step(across, along) {
      const { a, b } = level();
      const [x, y] = [Math.log10(a) + 0.02 * across, Math.log10(b) + 0.02 * along];
      setShape(
        rounded(10 ** clamp(x, ...mapFrame(VIEWS.map).across), 4),
        rounded(10 ** clamp(y, -3, 0), 4),
      );
    },
  },
};

/** @returns {Level} the present one */
function level() {
  return /** @type {Motion} */ (shown.motion).orbit.level;
}

/**
 * A throw from a point of the portrait, if the body can have it.
 *
 * @param {Point} point
 */
function startAt([psi, rate]) {
  const reach = portraitFrame(VIEWS.portrait, level()).along[1];
  const { a, b, total, clock } = level();
  // The crest of its level stays in the frame.
  const crest = 0.97 * reach * clock;
  const highest = Math.min((crest * crest) / total - b, a * 0.9999);
  const most = Math.min(
    rateAt(onLevel(level(), highest), psi) || 0,
    0.9999 * largestRate(level(), psi),
  );
  setStart(psi, clamp(rate, -most, most));
}

/** @param {number} gamma brought into what the shape allows */
function levelAt(gamma) {
  const { a, b } = level();
  setGamma(clamp(gamma, -0.999 * b, 0.999 * a), 4);
}

/**
 * @param {"space" | "sphere"} name
 * @returns {Grip}
 */
function lookAround(name) {
  const camera = shown.eyes[name];
  let last = /** @type {Spot | null} */ (null);
  const seenAgain = () => {
    rememberSoon();
    redraw(name);
  };
  return {
    grasp() {
      last = null;
      cancelAnimationFrame(gliding);
    },
    move([x, y]) {
      if (last) leadAround(camera, x - last[0], y - last[1]);
      last = [x, y];
      seenAgain();
    },
    step(across, along) {
      leadAround(camera, 12 * across, -12 * along);
      seenAgain();
    },
    home() {
      const { yaw, pitch } = HOME[name];
      Object.assign(camera, { yaw, pitch });
      seenAgain();
    },
  };
}

/** @type {Record<string, [number, number]>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Give every picture its hands. */
function takeHands() {
  for (const name of NAMES) {
    const { canvas } = VIEWS[name];
    const grip = GRIPS[name];
    /** @param {PointerEvent} event */
    const moved = (event) => {
      const box = canvas.getBoundingClientRect();
      grip.move([event.clientX - box.left, event.clientY - box.top]);
    };
    canvas.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || !shown.motion) return;
      canvas.setPointerCapture(event.pointerId);
      grip.grasp?.();
      moved(event);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (canvas.hasPointerCapture(event.pointerId)) moved(event);
    });
    for (const end of ["pointerup", "pointercancel"])
      canvas.addEventListener(end, () => grip.release?.());
    canvas.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey || !shown.motion) return;
      const arrow = ARROWS[event.key];
      if (arrow) {
        const size = event.shiftKey ? 5 : 1;
        grip.step(size * arrow[0], size * arrow[1]);
      } else if (event.key === "Home" && grip.home) grip.home();
      else if (event.key === " ") setPlaying(!shown.playing);
      else return;
      event.preventDefault();
    });
  }
}
