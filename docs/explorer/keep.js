/**
 * What one takes along: the address, the command, the pictures.
 */
"use strict";

const SAVED = { width: 960, height: 640 };

let remembering = 0;

/** Browsers allow a few changes of the address a second, so it waits for the end of a drag. */
function rememberSoon() {
  clearTimeout(remembering);
  if (scene.touched) remembering = setTimeout(remember, 300);
}

/** Put the choice into the address, so that it can be sent to somebody. */
function remember() {
  history.replaceState(null, "", `#${addressOf()}`);
}

/** @returns {URLSearchParams} */
function addressOf() {
  const body = bodyOf();
  /** @type {Record<string, string>} */
  const choice = body ? { body: body.name } : {};
  const typedIn = given.moments ? MOMENTS : ["a", "b"];
  for (const id of [...typedIn, ...(given.point ? ["psi0", "rate"] : ["gamma"])])
    choice[id] = asTyped(id);
  const { yaw, pitch, thrown } = shown.eyes.space;
  if (yaw !== HOME.space.yaw || pitch !== HOME.space.pitch)
    choice.eye = `${yaw.toFixed(2)},${pitch.toFixed(2)}`;
  if (!thrown) choice.upright = "1";
  if (shown.once) choice.once = "1";
  if (shown.ghosts) choice.ghosts = "1";
  if (shown.tempo !== 0.3) choice.tempo = rounded(shown.tempo);
  if (byId("stage").dataset.picture !== "portrait")
    choice.picture = byId("stage").dataset.picture ?? "";
  if (scene.name !== "bench") choice.at = scene.name;
  return new URLSearchParams(choice);
}

/**
 * Take the choice from the address.
 *
 * @returns {string | null} the scene it belongs to, or null where there is no choice
 */
function recall() {
  const choice = new URLSearchParams(location.hash.slice(1));
  /** @param {string} key */
  const has = (key) => choice.has(key);
  if (!["a", "body", "I1", "gamma", "psi0"].some(has)) return null;
  const body =
    BODIES.find(({ name }) => name === choice.get("body")) ??
    (has("a") || has("I1") ? undefined : BODIES[0]);
  field("body").value = body?.name ?? "";
  given.moments = MOMENTS.every(has);
  given.point = has("psi0") && has("rate");
  for (const id of ["a", "b", ...MOMENTS, "gamma", "psi0", "rate"])
    field(id).value = choice.get(id) ?? "";
  if (body && !has("a")) [field("a").value, field("b").value] = [body.a, body.b];
  if (!given.point && !has("gamma")) field("gamma").value = "0";
  const eye = (choice.get("eye") ?? "").split(",").map(Number);
  if (eye.length === 2 && eye.every(Number.isFinite)) {
    Object.assign(shown.eyes.space, { yaw: eye[0], pitch: clamp(eye[1], -STEEPEST, STEEPEST) });
  }
  shown.eyes.space.thrown = !has("upright");
  shown.once = has("once");
  shown.ghosts = has("ghosts");
  const tempo = Number(choice.get("tempo"));
  if (tempo > 0) shown.tempo = clamp(tempo, 0.03, 3.2);
  const picture = choice.get("picture");
  if (picture && NAMES.includes(picture) && picture !== "space")
    byId("stage").dataset.picture = picture;
  const at = choice.get("at");
  return at && at in SCENES ? at : "bench";
}

/**
 * A picture as a file.
 *
 * @param {string} name
 * @param {string} format
 */
function save(name, format) {
  const { width, height } = SAVED;
  if (format === "svg") {
    const pen = svgPen(width, height);
    drawWhole(name, pen);
    return offer(new Blob([pen.text()], { type: "image/svg+xml" }), `${name}.svg`);
  }
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [2 * width, 2 * height];
  const to = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  to.scale(2, 2);
  drawWhole(name, canvasPen(to, width, height));
  canvas.toBlob((blob) => blob && offer(blob, `${name}.png`));
}

/**
 * @param {Blob} blob
 * @param {string} name
 */
function offer(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = `racket-${name}`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  write("kept", `saved as racket-${name}`);
}

/**
 * @param {string} text
 * @param {string} what
 */
async function copy(text, what) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    // Without leave for the clipboard, as from a file in some browsers, the old way still works.
    const area = document.createElement("textarea");
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    if (!done) return write("kept", text);
  }
  write("kept", `${what} copied`);
}
