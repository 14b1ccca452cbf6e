/**
 * The form: its fields follow one another, and what follows from them is written beside them.
 */
"use strict";

/**
 * Write into an element and into all that repeat it in the story.
 *
 * @param {string} id
 * @param {string} text
 */
function write(id, text) {
  const words = withMinus(text);
  const places = document.querySelectorAll(`#${id}, [data-live="${id}"]`);
  for (const place of places) if (place.textContent !== words) place.textContent = words;
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

/** Read the form and show what follows from it, or the one thing that is wrong. */
function update() {
  for (const input of document.querySelectorAll("[aria-invalid]"))
    input.removeAttribute("aria-invalid");
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
function show({ level, motion, realizable, shape }) {
  const defect0 = separatrixDefect(level);
  const defect = level.gamma === 0 ? defect0 : flipDefect(level);
  const body = bodyOf();
  Object.assign(shown, {
    motion,
    realizable,
    thing: body ? THINGS[body.drawn] : solidBox(sidesOf(level), false),
    defect,
    turning: turningLevel(level),
    perfect: perfectLevel(level),
  });
  const flip = given.point ? poseAt(motion, 1).psi - poseAt(motion, 0).psi : Math.PI - 2 * defect;
  tabulate("flip", flip, given.point ? 10 : 15);
  tabulate("defect", defect, 15);
  tabulate("line", printedLine(level), 6);
  tabulateError("line-error", printedLine(level), defect);
  tabulate("defect0", defect0, 15);
  tabulate("printed", printedDefect(level), 6);
  tabulateError("printed-error", printedDefect(level), defect0);
  if (!body) field("body").value = "";
  write("source", body ? body.source : "");
  follow(level, motion, shape, body);
  describe(level, flip, defect);
  setSliders(level);
  showCommand(commandOf());
  showTempo();
  rememberSoon();
  redraw("portrait", "levels", "map", "sphere");
}

/**
 * Fill the fields that do not count with what follows from those that do.
 *
 * @param {Level} level
 * @param {Motion} motion
 * @param {[Fraction, Fraction]} shape
 * @param {NamedBody | undefined} body
 */
function follow(level, motion, shape, body) {
  if (given.moments) {
    for (const [i, id] of ["a", "b"].entries()) {
      const text = fractionText(shape[i]);
      field(id).value = text.length > 24 ? rounded(toFloat(shape[i]), 15) : text;
    }
  } else {
    const { a, clock } = level;
    const moments = body?.moments ?? [1 / (1 + a), 1, 1 / clock].map((x) => rounded(1000 * x, 6));
    for (const [i, id] of MOMENTS.entries()) field(id).value = moments[i];
  }
  if (given.point) {
    field("gamma").value = rounded(level.gamma, 6);
  } else {
    const start = poseAt(motion, 0);
    field("psi0").value = rounded(start.psi, 6);
    field("rate").value = rounded(rateOf(level, start), 6);
  }
  byId("form").dataset.shape = given.moments ? "moments" : "numbers";
  byId("form").dataset.start = given.point ? "point" : "level";
}

/**
 * The sentence and the list of facts.
 *
 * @param {Level} level
 * @param {number} flip
 * @param {number} defect
 */
function describe({ a, b, gamma }, flip, defect) {
  const { turning, perfect, realizable } = shown;
  const short = Math.abs(2 * defect) / DEGREE;
  const side = defect > 0 ? "short of" : "beyond";
  const from = given.point
    ? `From ψ₀ = ${brief(Number(toFloat(typed("psi0", "ψ₀"))) / DEGREE)}°, in`
    : "In";
  const rest = given.point ? "" : `, ${brief(short)}° ${side} half a turn`;
  write(
    "sentence",
    `${from} one turn of the handle it turns over by ${brief(flip / DEGREE)}°${rest}.`,
  );
  const turned = turning !== null && gamma < turning && !given.point;
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
  byId("to-perfect").toggleAttribute("disabled", perfect === null);
  const limit = brief(1 / (a + 2));
  write(
    "realizable",
    realizable ? `✓ yes: b ≤ 1/(a + 2) = ${limit}` : `✗ no: b > 1/(a + 2) = ${limit}`,
  );
  const verdict = realizable
    ? `≤ 1/(a + 2) = ${limit}: a rigid body can have it`
    : `> 1/(a + 2) = ${limit}: no rigid body has it`;
  write("verdict", `a = ${brief(a)}, b = ${brief(b)} ${verdict}`);
  for (const place of document.querySelectorAll('#realizable, [data-live="verdict"]')) {
    place.classList.toggle("yes", realizable);
    place.classList.toggle("no", !realizable);
  }
  for (const [id, value] of Object.entries({ a, b, gamma })) {
    write(`${id}-value`, field(id).value.includes("/") ? `≈ ${brief(value)}` : "");
  }
  write("psi0-value", `${brief(toFloat(typed("psi0", "ψ₀")) / DEGREE)}°`);
  describePictures({ a, b, gamma }, defect);
}

/**
 * The pictures in words.
 *
 * @param {{ a: number, b: number, gamma: number }} level
 * @param {number} defect
 */
function describePictures({ a, b, gamma }, defect) {
  const words = byId("kind").textContent;
  write("space-text", byId("sentence").textContent ?? "");
  write("portrait-text", `${words}; it starts at ψ = ${byId("psi0-value").textContent}.`);
  write(
    "levels-text",
    `At γ = ${brief(gamma)} the exact defect is ${inDegrees(defect)}°, the paper’s ${byId("line-degrees").textContent}°.`,
  );
  const where = shown.realizable ? "within" : "outside";
  write("map-text", `a = ${brief(a)}, b = ${brief(b)}, ${where} the region of rigid bodies.`);
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

// Sliders

/** @param {Level} level */
function setSliders(level) {
  const { a, b, gamma, clock } = level;
  const psi = toFloat(typed("psi0", "ψ₀"));
  const rate = toFloat(typed("rate", "dψ/dφ"));
  const moments = MOMENTS.map((id) =>
    toFloat(/** @type {Fraction} */ (readNumber(field(id).value) ?? ONE)),
  );
  const turn = 2 * Math.PI;
  /** @type {Record<string, [number, number]>} position and what it means */
  const positions = {
    a: [Math.log10(a), a],
    b: [Math.log10(b), b],
    gamma: [Math.sign(gamma) * 100 * Math.cbrt(Math.abs(gamma) / (gamma < 0 ? b : a)), gamma],
    psi0: [(psi - turn * Math.floor((psi - PORTRAIT[0]) / turn)) / DEGREE, psi],
    rate: [Math.sign(rate) * 100 * Math.cbrt(Math.abs(rate) / rateScale(level, psi)), rate],
  };
  for (const [id, [position, value]] of Object.entries(positions)) {
    field(`${id}-slider`).value = String(position);
    field(`${id}-slider`).setAttribute("aria-valuetext", brief(value));
  }
  for (const [i, id] of MOMENTS.entries()) {
    const slider = field(`${id}-slider`);
    const at = Math.log10(moments[i]);
    // The range stays under the hand that slides.
    if (slider !== document.activeElement) {
      slider.min = String(at - 1);
      slider.max = String(at + 1);
    }
    slider.value = String(at);
    slider.setAttribute("aria-valuetext", brief(moments[i]));
  }
  field("I3").disabled = clock === 0 && !given.moments;
}

/**
 * The largest rate of the slider: what the body can do, but not beyond what is of interest.
 *
 * @param {Level} level
 * @param {number} psi
 * @returns {number}
 */
function rateScale(level, psi) {
  const separatrix = onLevel(level, 0);
  const far = 4 * Math.min(rateAt(separatrix, Math.PI / 2), 2.5 * rateAt(separatrix, Math.PI / 4));
  return Math.min(0.999 * largestRate(level, psi), far);
}

/** @param {"a" | "b"} id */
function slideShape(id) {
  const a =
    id === "a"
      ? 10 ** Number(field("a-slider").value)
      : toFloat(readNumber(field("a").value) ?? ONE);
  const b =
    id === "b"
      ? 10 ** Number(field("b-slider").value)
      : toFloat(readNumber(field("b").value) ?? ONE);
  if (id === "a") setShape(rounded(a), field("b").value);
  else setShape(field("a").value, rounded(b));
}

/**
 * Another shape, with the throw brought back into what it allows.
 *
 * @param {string} a
 * @param {string} b
 */
function setShape(a, b) {
  given.moments = false;
  field("a").value = a;
  field("b").value = b;
  fitThrow();
  update();
}

/** Bring γ, or the rate, back into what the shape allows. */
function fitThrow() {
  const [a, b, gamma] = ["a", "b", "gamma"].map((name) => readNumber(field(name).value));
  if (!a || !b) return;
  if (given.point) {
    const psi = toFloat(readNumber(field("psi0").value) ?? ONE);
    const rate = toFloat(readNumber(field("rate").value) ?? ONE);
    const [p, q] = [toFloat(a), toFloat(b)];
    const most =
      0.99 *
      largestRate({ a: p, b: q, gamma: 0, above: q, below: p, total: p + q, clock: 1 - q }, psi);
    if (Math.abs(rate) > most) field("rate").value = rounded(Math.sign(rate) * most, 4);
    return;
  }
  if (!gamma) return;
  if (signOf(plus(gamma, b)) <= 0) field("gamma").value = rounded(-0.9 * toFloat(b));
  if (signOf(minus(a, gamma)) <= 0) field("gamma").value = rounded(0.9 * toFloat(a));
}

/** @param {string} id of a moment: it stays between its neighbours, its shape within limits */
function slideMoment(id) {
  const i = MOMENTS.indexOf(id);
  const others = MOMENTS.map((name) => toFloat(readNumber(field(name).value) ?? ONE));
  const low = i > 0 ? 1.001 * others[i - 1] : others[1] / 1e4;
  const high = i < 2 ? others[i + 1] / 1.001 : 1e4 * others[1];
  field(id).value = rounded(clamp(10 ** Number(field(`${id}-slider`).value), low, high), 5);
  given.moments = true;
  update();
  if (document.body.classList.contains("invalid")) {
    fitThrow();
    update();
  }
}

/** γ by the slider: a cube, so that it is fine near the separatrix. */
function slideGamma() {
  const share = Number(field("gamma-slider").value) / 100;
  const [a, b] = ["a", "b"].map((id) => readNumber(field(id).value));
  if (!a || !b) return update();
  const size = share < 0 ? toFloat(b) : toFloat(a);
  setGamma(0.999 * size * share ** 3, 3);
}

/**
 * @param {number | null} gamma
 * @param {number} [digits]
 */
function setGamma(gamma, digits = 6) {
  if (gamma === null) return;
  given.point = false;
  field("gamma").value = rounded(gamma, digits);
  update();
}

/**
 * Throw it from there; four digits, as one types them.
 *
 * @param {number} psi
 * @param {number} rate
 */
function setStart(psi, rate) {
  given.point = true;
  shown.share = 0;
  field("psi0").value = String(Number(psi.toFixed(4)));
  field("rate").value = rounded(rate, 4);
  update();
}

/** @param {string} id the slider of the two that was moved */
function slideStart(id) {
  const level = shown.motion?.orbit.level;
  if (!level) return;
  const moved = id === "psi0-slider";
  const psi = moved
    ? Number(field(id).value) * DEGREE
    : toFloat(readNumber(field("psi0").value) ?? ONE);
  const share = Number(field("rate-slider").value) / 100;
  const most = 0.99 * largestRate(level, psi);
  const kept = toFloat(readNumber(field("rate").value) ?? ONE);
  setStart(psi, moved ? clamp(kept, -most, most) : rateScale(level, psi) * share ** 3);
}

/** @param {string} name of a body */
function chooseBody(name) {
  const body = BODIES.find((one) => one.name === name);
  field("body").value = body?.name ?? "";
  if (!body) return update();
  given.moments = false;
  field("a").value = body.a;
  field("b").value = body.b;
  fitThrow();
  update();
}

// Speed

/** @param {number} tempo turns of the handle a second */
function setTempo(tempo) {
  shown.tempo = tempo;
  field("tempo").value = String(Math.log10(tempo));
  showTempo();
}

function showTempo() {
  const { tempo, motion } = shown;
  write("tempo-value", `${rounded(tempo, 2)} turns a second`);
  field("tempo").setAttribute("aria-valuetext", `${rounded(tempo, 2)} turns a second`);
  if (!motion) return;
  const duration = durationOf(motion);
  write(
    "spin",
    `One turn lasts ${brief(duration)} I₂/M, here ${rounded(1 / tempo, 2)} s: M/I₂ = ${brief(duration * tempo)} rad/s.`,
  );
}
