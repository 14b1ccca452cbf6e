/**
 * The beginning: what is on the page learns what to do.
 */
"use strict";

function begin() {
  readColours();
  for (const { name, title } of [...BODIES, { name: "", title: "your own numbers" }]) {
    field("body").appendChild(new Option(title, name));
  }
  listenToForm();
  listenToPlayer();
  listenToStory();
  takeHands();
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    readColours();
    redraw(...NAMES);
  });
  new ResizeObserver(fitStage).observe(byId("panels"));
  byId("copy-command").addEventListener("click", () => copy(commandOf(), "command"));
  byId("copy-link").addEventListener("click", () => {
    remember();
    copy(location.href, "link");
  });
  byId("save-png").addEventListener("click", () => save(field("picture").value, "png"));
  byId("save-svg").addEventListener("click", () => save(field("picture").value, "svg"));
  // In the site, a way back; beside its source, and on a page of the site, there is none.
  byId("home").hidden = location.pathname.endsWith("/docs/explorer/index.html") || self !== top;
  openAddress();
  // The page's own changes of the address are not heard here.
  addEventListener("hashchange", () => recall() && location.reload());
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) setPlaying(true);
}

/** Begin with the first scene, or with what the address says. */
function openAddress() {
  const at = recall();
  if (at === null) {
    enter("opening");
  } else {
    history.scrollRestoration = "manual";
    scene.touched = true;
    scene.name = at;
    byId("stage").dataset.scene = at;
    setTempo(shown.tempo);
    update();
    showChecks();
    fitStage();
    byId(at).scrollIntoView({ behavior: "instant" });
  }
  followScroll();
}

function listenToForm() {
  byId("form").addEventListener("submit", (event) => event.preventDefault());
  byId("form").addEventListener("input", () => (scene.touched = true), true);
  byId("bench").addEventListener("focusin", () => enter("bench"));
  byId("stage").addEventListener("pointerdown", () => (scene.touched = true), true);
  byId("stage").addEventListener("keydown", () => (scene.touched = true), true);
  field("body").addEventListener("change", () => chooseBody(field("body").value));
  /** @param {string[]} ids @param {() => void} count */
  const onTyping = (ids, count) => {
    for (const id of ids)
      field(id).addEventListener("input", () => {
        count();
        update();
      });
  };
  onTyping(["a", "b"], () => (given.moments = false));
  onTyping(MOMENTS, () => (given.moments = true));
  onTyping(["gamma"], () => (given.point = false));
  onTyping(["psi0", "rate"], () => (given.point = true));
  field("a-slider").addEventListener("input", () => slideShape("a"));
  field("b-slider").addEventListener("input", () => slideShape("b"));
  for (const id of MOMENTS) field(`${id}-slider`).addEventListener("input", () => slideMoment(id));
  field("gamma-slider").addEventListener("input", slideGamma);
  for (const id of ["psi0-slider", "rate-slider"])
    field(id).addEventListener("input", () => slideStart(id));
  byId("to-separatrix").addEventListener("click", () => setGamma(0));
  byId("to-perfect").addEventListener("click", () => setGamma(shown.perfect));
  byId("to-turning").addEventListener("click", () => setGamma(shown.turning));
}

function listenToPlayer() {
  byId("play").addEventListener("click", () => setPlaying(!shown.playing));
  field("moment").addEventListener("input", () => {
    setPlaying(false);
    shown.share = Number(field("moment").value) / 1000;
    redraw();
  });
  field("tempo").addEventListener("input", () => {
    setTempo(10 ** Number(field("tempo").value));
    rememberSoon();
  });
  for (const id of ["once", "ghosts", "upright"]) {
    field(id).addEventListener("change", () => {
      shown.once = field("once").checked;
      shown.ghosts = field("ghosts").checked;
      shown.eyes.space.thrown = !field("upright").checked;
      if (shown.once) shown.share = Math.min(shown.share, 1);
      rememberSoon();
      redraw();
    });
  }
  for (const button of byId("pictures").querySelectorAll("button")) {
    button.addEventListener("click", () => {
      byId("stage").dataset.picture = button.dataset.picture;
      showChecks();
      fitStage();
      rememberSoon();
    });
  }
}

begin();
