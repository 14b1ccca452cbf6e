/**
 * The page: what is typed becomes a level, and everything shown is computed from it.
 */
"use strict";

/** @typedef {{ name: string, title: string, source: string, a: string, b: string, drawn: string }} NamedBody */

/** @typedef {{ level: Level, realizable: boolean }} Choice what the form says, when it says something */

const LIMITS = { a: [1e-6, 1e4], b: [1e-6, 1] };
const ONE = /** @type {Fraction} */ ({ top: 1n, bottom: 1n });
const SECONDS_PER_TURN = 6;
const SECONDS_OF_REST = 1.2;

/** @type {NamedBody[]} */
const BODIES = JSON.parse(byId("bodies").textContent ?? "[]");

/** What is on the screen: the motion drawn and where it stands, from −1 to 1 in time. */
const shown = {
  orbit: /** @type {Orbit | null} */ (null),
  end: 0,
  thing: THINGS.racket,
  frame: /** @type {Frame | null} */ (null),
  defect: 0,
  turning: /** @type {number | null} */ (null),
  perfect: /** @type {number | null} */ (null),
  moment: -1,
  rest: 0,
  playing: false,
  stale: false,
  remembering: 0,
};

/**
 * @param {string} id
 * @returns {HTMLElement}
 */
function byId(id) {
  return /** @type {HTMLElement} */ (document.getElementById(id));
}

/**
 * @param {string} id of an input or a select
 * @returns {HTMLInputElement}
 */
function field(id) {
  return /** @type {HTMLInputElement} */ (document.getElementById(id));
}

/**
 * @param {string} id
 * @param {string} text
 */
function write(id, text) {
  byId(id).textContent = withMinus(text);
}

// Reading the form

/** What is wrong with one input, in words for the reader. */
class Complaint extends Error {
  /**
   * @param {string} input its id
   * @param {string} message
   */
  constructor(input, message) {
    super(message);
    this.input = input;
  }
}

/**
 * @returns {Choice}
 * @throws {Complaint}
 */
function readForm() {
  const a = typed("a", "a");
  const b = typed("b", "b");
  inLimits("a", a, "a = I₂/I₁ − 1 must be from 0.000001 to 10000");
  inLimits("b", b, "b = 1 − I₂/I₃ must be from 0.000001 to 1");
  const gamma = typed("gamma", "γ");
  const above = plus(gamma, b);
  const below = minus(a, gamma);
  if (signOf(above) <= 0 || signOf(below) <= 0) {
    const range = withMinus(`−b = ${brief(-toFloat(b))} and a = ${brief(toFloat(a))}`);
    throw new Complaint("gamma", `γ must lie between ${range}, ends excluded`);
  }
  const product = { top: b.top * (a.top + 2n * a.bottom), bottom: b.bottom * a.bottom };
  return {
    level: {
      a: toFloat(a),
      b: toFloat(b),
      gamma: toFloat(gamma),
      above: toFloat(above),
      below: toFloat(below),
      total: toFloat(plus(a, b)),
      clock: toFloat(minus(ONE, b)),
    },
    realizable: product.top <= product.bottom,
  };
}

/**
 * @param {string} id
 * @param {string} name
 * @returns {Fraction}
 * @throws {Complaint}
 */
function typed(id, name) {
  const number = readNumber(field(id).value);
  if (number) return number;
  throw new Complaint(
    id,
    `${name} is not a number I can read; write for example 0.0629, −3e−5 or 55/874`,
  );
}

/**
 * @param {"a" | "b"} id
 * @param {Fraction} number
 * @param {string} message
 * @throws {Complaint}
 */
function inLimits(id, number, message) {
  const value = signOf(number) * Math.abs(toFloat(number));
  if (!(value >= LIMITS[id][0] && value <= LIMITS[id][1])) throw new Complaint(id, message);
  // What rounds to 1 may still be more.
  if (id === "b" && signOf(minus(ONE, number)) < 0) throw new Complaint(id, message);
}

// Writing numbers

/**
 * @param {number} x
 * @returns {string} four digits
 */
function brief(x) {
  return withMinus(x === 0 ? "0" : `${Number(x.toPrecision(4))}`);
}

/**
 * @param {number} x in radians
 * @returns {string} in degrees, without their sign
 */
function inDegrees(x) {
  const degrees = x / DEGREE;
  const size = Math.abs(degrees);
  if (size === 0) return "0";
  return withMinus(size >= 1e4 || size < 1e-3 ? degrees.toExponential(2) : degrees.toFixed(4));
}

/**
 * @param {number} x
 * @param {number} digits
 * @returns {string}
 */
function inDigits(x, digits) {
  return withMinus(x === 0 ? "0" : x.toPrecision(digits));
}

/**
 * Fill two cells of the table.
 *
 * @param {string} id
 * @param {number} x in radians
 * @param {number} digits
 */
function tabulate(id, x, digits) {
  write(id, inDigits(x, digits));
  write(`${id}-degrees`, inDegrees(x));
}

/**
 * How far a formula is off: relative in the one cell, absolute in the other.
 *
 * @param {string} id
 * @param {number} formula
 * @param {number} exact
 */
function tabulateError(id, formula, exact) {
  const relative = (100 * (formula - exact)) / Math.abs(exact);
  const share = Math.abs(relative) >= 1e4 ? relative.toExponential(1) : relative.toPrecision(2);
  const sign = formula > exact ? "+" : "";
  write(id, `${sign}${Math.abs(relative) < 1e4 ? Number(share) : share} %`);
  write(`${id}-degrees`, sign + inDegrees(formula - exact));
}

// Showing a choice

/** Read the form and show what follows from it, or the one thing that is wrong. */
function update() {
  for (const id of ["a", "b", "gamma"]) field(id).removeAttribute("aria-invalid");
  try {
    const choice = readForm();
    write("message", "");
    document.body.classList.remove("invalid");
    show(choice);
  } catch (error) {
    if (!(error instanceof Complaint)) throw error;
    write("message", error.message);
    field(error.input).setAttribute("aria-invalid", "true");
    document.body.classList.add("invalid");
  }
}

/** @param {Choice} choice */
function show({ level, realizable }) {
  const orbit = orbitOf(level);
  const place = placeAt(orbit, Math.PI);
  const defect0 = separatrixDefect(level);
  const defect = level.gamma === 0 ? defect0 : defectAt(orbit, place);
  const turning = turningLevel(level);
  const body = bodyOf();
  Object.assign(shown, {
    orbit,
    end: place.time + 2 * place.halves * orbit.quarterTime,
    thing: THINGS[body?.drawn ?? "racket"],
    defect,
    turning,
    perfect: perfectLevel(level),
    stale: true,
  });
  tabulate("defect", defect, 15);
  tabulate("line", printedLine(level), 6);
  tabulateError("line-error", printedLine(level), defect);
  tabulate("defect0", defect0, 15);
  tabulate("printed", printedDefect(level), 6);
  tabulateError("printed-error", printedDefect(level), defect0);
  tabulate("flip", Math.PI - 2 * defect, 15);
  describe(level, defect, turning, realizable, body);
  setSliders(level);
  clearTimeout(shown.remembering);
  shown.remembering = setTimeout(remember, 300);
  requestAnimationFrame(redraw);
}

/** @returns {NamedBody | undefined} the named body that the form still describes */
function bodyOf() {
  const body = BODIES.find(({ name }) => name === field("body").value);
  return body && body.a === field("a").value && body.b === field("b").value ? body : undefined;
}

/**
 * The sentence and the list of facts.
 *
 * @param {Level} level
 * @param {number} defect
 * @param {number | null} turning
 * @param {boolean} realizable
 * @param {NamedBody | undefined} body
 */
function describe({ a, b, gamma }, defect, turning, realizable, body) {
  const flip = Math.PI - 2 * defect;
  const short = Math.abs(2 * defect) / DEGREE;
  const side = defect > 0 ? "short of" : "beyond";
  write(
    "sentence",
    `In one turn of the handle it turns over by ${brief(flip / DEGREE)}°, ${brief(short)}° ${side} half a turn.`,
  );
  const turned = turning !== null && gamma < turning;
  write(
    "kind",
    gamma > 0
      ? "rotating: the flip goes on in the same sense for ever"
      : gamma === 0
        ? "separatrix: it flips once in all time"
        : turned
          ? "oscillating, and below γ*: it has turned back within this turn of the handle"
          : "oscillating: it flips and flips back",
  );
  write(
    "turning",
    turning === null ? "none for this shape: it never turns back within one turn" : brief(turning),
  );
  byId("to-turning").toggleAttribute("disabled", turning === null);
  byId("to-perfect").toggleAttribute("disabled", shown.perfect === null);
  const limit = brief(1 / (a + 2));
  write(
    "realizable",
    realizable ? `✓ yes: b ≤ 1/(a + 2) = ${limit}` : `✗ no: b > 1/(a + 2) = ${limit}`,
  );
  byId("realizable").className = realizable ? "yes" : "no";
  write("source", body ? body.source : "");
  if (!body) field("body").value = "";
  const shape = body ? `--body ${body.name}` : `--shape ${plain("a")} ${plain("b")}`;
  showCommand(`tresym flip ${shape} --gamma=${plain("gamma")}`);
  for (const [id, value] of Object.entries({ a, b, gamma })) {
    write(`${id}-value`, field(id).value.includes("/") ? `≈ ${brief(value)}` : "");
  }
}

/**
 * A command, broken between words only.
 *
 * @param {string} command
 */
function showCommand(command) {
  const words = command.split(" ").flatMap((word) => {
    const whole = document.createElement("span");
    whole.textContent = word;
    return [whole, " "];
  });
  byId("command").replaceChildren(...words.slice(0, -1));
}

/**
 * @param {string} id
 * @returns {string} what is typed, with a hyphen for a minus
 */
function plain(id) {
  return field(id).value.trim().replace(/[−–]/g, "-").replace(/\s+/g, "");
}

// Sliders

/** @param {Level} level */
function setSliders({ a, b, gamma }) {
  field("a-slider").value = String(Math.log10(a));
  field("b-slider").value = String(Math.log10(b));
  field("gamma-slider").value = String(
    Math.sign(gamma) * 100 * Math.cbrt(Math.abs(gamma) / (gamma < 0 ? b : a)),
  );
  field("a-slider").setAttribute("aria-valuetext", brief(a));
  field("b-slider").setAttribute("aria-valuetext", brief(b));
  field("gamma-slider").setAttribute("aria-valuetext", brief(gamma));
}

/** @param {"a" | "b"} id */
function slideShape(id) {
  field(id).value = String(Number((10 ** Number(field(`${id}-slider`).value)).toPrecision(3)));
  const [a, b, gamma] = ["a", "b", "gamma"].map((name) => readNumber(field(name).value));
  if (a && b && gamma) {
    if (signOf(plus(gamma, b)) <= 0) field("gamma").value = rounded(-0.9 * toFloat(b));
    if (signOf(minus(a, gamma)) <= 0) field("gamma").value = rounded(0.9 * toFloat(a));
  }
  update();
}

/** γ by the slider: a cube, so that it is fine near the separatrix. */
function slideGamma() {
  const share = Number(field("gamma-slider").value) / 100;
  const [a, b] = ["a", "b"].map((id) => readNumber(field(id).value));
  if (!a || !b) return update();
  const size = share < 0 ? toFloat(b) : toFloat(a);
  field("gamma").value = rounded(0.999 * size * share ** 3);
  update();
}

/**
 * @param {number} x
 * @returns {string} three digits, as one types them
 */
function rounded(x) {
  return String(Number(x.toPrecision(3)));
}

// The motion

/** Draw all that does not move; once per frame at most. */
function redraw() {
  const { orbit, end, thing, defect, turning } = shown;
  if (!shown.stale || !orbit) return;
  shown.stale = false;
  const path = [];
  for (let i = 0; i <= 360; i++) path.push(axesOf(attitudeAt(orbit, end * (i / 180 - 1))).first);
  const scene = /** @type {SVGElement} */ (/** @type {unknown} */ (byId("scene")));
  drawStage(scene, thing, path);
  shown.frame = drawPortrait(byId("portrait"), orbit, end);
  drawChart(byId("chart"), orbit.level, defect, turning);
  write(
    "portrait-text",
    `${byId("kind").textContent}; from ψ = ${inDegrees(defect)}° to ${inDegrees(Math.PI - defect)}°.`,
  );
  write("scene-text", byId("sentence").textContent ?? "");
  write(
    "chart-text",
    `At γ = ${brief(orbit.level.gamma)} the exact defect is ${inDegrees(defect)}°, the paper’s ${inDegrees(printedLine(orbit.level))}°.`,
  );
  showMoment();
}

/** Show the body, the readings and the dot of the portrait at the present moment. */
function showMoment() {
  const { orbit, frame, end, moment } = shown;
  if (!orbit || !frame) return;
  const time = moment * end;
  const attitude = attitudeAt(orbit, time);
  drawThing(
    /** @type {SVGElement} */ (/** @type {unknown} */ (byId("scene"))),
    shown.thing,
    attitude,
  );
  movePoint(byId("portrait"), frame, orbit, time);
  const handle = `${Math.round((attitude.phi + Math.PI) / DEGREE)}°`;
  write("turned", handle);
  write("flipped", `${Math.round((attitude.psi - shown.defect) / DEGREE)}°`);
  write("tilted", `${Math.round(90 - attitude.theta / DEGREE)}°`);
  write("passed", `${((time + end) / orbit.speed).toFixed(2)} I₂/M`);
  field("moment").value = String(Math.round(500 * (moment + 1)));
  field("moment").setAttribute("aria-valuetext", `handle turned by ${handle}`);
}

/** @param {boolean} playing */
function setPlaying(playing) {
  shown.playing = playing;
  byId("play").textContent = playing ? "Pause" : "Play";
  if (playing) requestAnimationFrame((now) => advance(now, now));
}

/**
 * One frame of the animation: time runs evenly, and the motion rests at its end.
 *
 * @param {number} before the last frame, in milliseconds
 * @param {number} now
 */
function advance(before, now) {
  if (!shown.playing) return;
  const step = Math.min((now - before) / 1000, 0.1);
  if (shown.moment < 1) {
    shown.moment = Math.min(shown.moment + (2 * step) / SECONDS_PER_TURN, 1);
    shown.rest = 0;
  } else {
    shown.rest += step;
    if (shown.rest > SECONDS_OF_REST) shown.moment = -1;
  }
  showMoment();
  requestAnimationFrame((next) => advance(now, next));
}

// The address keeps the choice, so that it can be sent to somebody; browsers allow a few changes of
// it a second, so it waits for the end of a drag.

function remember() {
  const choice = new URLSearchParams({ a: plain("a"), b: plain("b"), gamma: plain("gamma") });
  const name = field("body").value;
  if (name) choice.set("body", name);
  history.replaceState(null, "", `#${choice}`);
}

function recall() {
  const choice = new URLSearchParams(location.hash.slice(1));
  const body =
    BODIES.find(({ name }) => name === choice.get("body")) ??
    (choice.has("a") ? undefined : BODIES[0]);
  field("body").value = body?.name ?? "";
  field("a").value = body?.a ?? choice.get("a") ?? "";
  field("b").value = body?.b ?? choice.get("b") ?? "";
  field("gamma").value = choice.get("gamma") ?? "0";
}

// Beginning

function begin() {
  for (const { name, title } of [...BODIES, { name: "", title: "your own numbers" }]) {
    field("body").appendChild(new Option(title, name));
  }
  recall();
  field("body").addEventListener("change", chooseBody);
  for (const id of ["a", "b", "gamma"]) field(id).addEventListener("input", update);
  field("a-slider").addEventListener("input", () => slideShape("a"));
  field("b-slider").addEventListener("input", () => slideShape("b"));
  field("gamma-slider").addEventListener("input", slideGamma);
  byId("to-separatrix").addEventListener("click", () => setGamma(0));
  byId("to-perfect").addEventListener("click", () => setGamma(shown.perfect));
  byId("to-turning").addEventListener("click", () => setGamma(shown.turning));
  byId("play").addEventListener("click", () => setPlaying(!shown.playing));
  field("moment").addEventListener("input", () => {
    setPlaying(false);
    shown.moment = Number(field("moment").value) / 500 - 1;
    showMoment();
  });
  byId("form").addEventListener("submit", (event) => event.preventDefault());
  // In the site, a way back; beside its source there is none.
  byId("home").hidden = location.pathname.endsWith("/docs/explorer/index.html");
  update();
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) setPlaying(true);
}

function chooseBody() {
  const body = BODIES.find(({ name }) => name === field("body").value);
  if (!body) return update();
  field("a").value = body.a;
  field("b").value = body.b;
  const [a, b, gamma] = ["a", "b", "gamma"].map((id) => readNumber(field(id).value));
  if (!a || !b || !gamma || signOf(plus(gamma, b)) <= 0 || signOf(minus(a, gamma)) <= 0)
    field("gamma").value = "0";
  update();
}

/** @param {number | null} gamma */
function setGamma(gamma) {
  if (gamma === null) return;
  field("gamma").value = String(Number(gamma.toPrecision(6)));
  update();
}

begin();
