// The ledger's filter: words, verdicts and marks narrow the list, and the address keeps them;
// without scripts the list is whole. And on a claim's page: buttons that copy what one cites.
const GREEK = {
  α: "alpha", β: "beta", γ: "gamma", δ: "delta", ε: "epsilon", ϵ: "epsilon", θ: "theta", ϑ: "theta",
  κ: "kappa", λ: "lambda", μ: "mu", π: "pi", σ: "sigma", τ: "tau", φ: "phi", ϕ: "phi", χ: "chi",
  ψ: "psi", ω: "omega",
};
// One spelling for what people type in several: case, accents, subscripts, Greek letters by name,
// each name with a space before it, since epsilon is not to be found by psi.
const folded = (text) => [...text.toLowerCase().normalize("NFKD").replace(/[\u0300-\u036f]/g, "")]
  .map((letter) => (letter in GREEK ? ` ${GREEK[letter]}` : letter)).join("").replaceAll("−", "-");
// Whether a word of the text begins so.
const begins = (text, word) => {
  for (let at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + 1)) {
    if (!/[a-z]/.test(text[at - 1] ?? "") || !/[a-z]/.test(word[0])) return true;
  }
  return false;
};

// What people type for a Greek letter, and the letter's name: eps0 finds ε₀, and epsilon0 the label eps0.
const SHORT = { eps: "epsilon", gam: "gamma", th: "theta", lam: "lambda" };
const forms = (word) => [word, ...Object.entries(SHORT).flatMap(([short, name]) => {
  const digits = (start) => word.startsWith(start) && /^\d*$/.test(word.slice(start.length));
  if (digits(name)) return [short + word.slice(name.length)];
  return digits(short) ? [name + word.slice(short.length)] : [];
})];

function filterLedger(parts) {
  const place = Object.assign(document.createElement("div"), { className: "ledger-filter" });
  parts[0].closest("section").before(place);
  const field = Object.assign(document.createElement("input"), {
    type: "search", placeholder: "words, a label, a place", ariaLabel: "Filter the ledger",
  });
  const count = document.createElement("span");
  count.setAttribute("aria-live", "polite");
  place.append(field);
  const entries = [...document.querySelectorAll(".ledger > p")];
  const texts = entries.map((entry) => folded(entry.textContent));
  const kinds = entries.map((entry) => {
    const verdict = [...entry.querySelector(".verdict").classList].find((name) => name !== "verdict");
    const stated = entry.querySelector(".place") ? "paper" : "lemma";
    const marks = [...entry.querySelectorAll(".mark")].map((mark) => mark.classList[1]);
    const kind = entry.querySelector(".kind")?.textContent;
    return new Set([verdict, stated, ...marks, kind]);
  });
  const WORDS = {
    proved: "PROVED", enclosed: "ENCLOSED", refuted: "REFUTED", defined: "DEFINED",
    assumed: "ASSUMED", paper: "in the paper", lemma: "lemmas", coq: "checked by Coq",
    axioms: "rest on quoted theorems",
    identity: "identities", number: "numbers", bound: "bounds", order: "orders", limit: "limits",
    statement: "statements",
  };
  const GROUPS = [["proved", "enclosed", "refuted", "defined", "assumed"], ["paper", "lemma"],
    ["coq"], ["axioms"],
    ["identity", "number", "bound", "order", "limit", "statement"]];
  const buttons = Object.entries(WORDS).map(([name, words]) => {
    const button = Object.assign(document.createElement("button"), { textContent: words });
    button.dataset.name = name;
    button.setAttribute("aria-pressed", "false");
    button.addEventListener("click", () => { press(button, !pressed(button)); narrow(true); });
    place.append(button);
    return button;
  });
  place.append(count);
  const pressed = (button) => button.getAttribute("aria-pressed") === "true";
  const press = (button, on) => button.setAttribute("aria-pressed", String(on));
  const read = () => {
    const asked = new URLSearchParams(location.hash.slice(1));
    field.value = asked.get("q") ?? "";
    const names = (asked.get("only") ?? "").split(",");
    buttons.forEach((button) => press(button, names.includes(button.dataset.name)));
  };
  const narrow = (keep) => {
    const words = folded(field.value).split(/\s+/).filter(Boolean);
    const names = buttons.filter(pressed).map((button) => button.dataset.name);
    const asked = GROUPS.map((group) => group.filter((name) => names.includes(name)));
    let left = 0;
    entries.forEach((entry, n) => {
      const said = `${texts[n]} ${[...kinds[n]].join(" ")}`;
      entry.hidden = !words.every((word) => forms(word).some((form) => begins(said, form)))
        || asked.some((group) => group.length && !group.some((name) => kinds[n].has(name)));
      left += !entry.hidden;
    });
    for (const part of parts) {
      part.closest("section").hidden = !part.querySelector("p:not([hidden])");
    }
    count.textContent = words.length || names.length ? `${left} claim${left === 1 ? "" : "s"}` : "";
    if (!keep) return;
    const state = new URLSearchParams();
    if (field.value) state.set("q", field.value);
    if (names.length) state.set("only", names.join(","));
    history.replaceState(null, "", state.size ? `#${state}` : location.pathname);
  };
  field.addEventListener("input", () => narrow(true));
  addEventListener("hashchange", () => { read(); narrow(false); });
  read();
  narrow(false);
}

function addCopyButtons(source) {
  const what = { LaTeX: source.dataset.latex, BibTeX: source.dataset.bibtex, link: location.href };
  for (const [name, text] of Object.entries(what)) {
    if (!text) continue;
    const button = Object.assign(document.createElement("button"), { textContent: `copy ${name}` });
    button.addEventListener("click", async () => {
      await navigator.clipboard.writeText(text);
      button.textContent = "copied";
      setTimeout(() => { button.textContent = `copy ${name}`; }, 1500);
    });
    source.append(button);
  }
}

// The search knows letters by their names, as formulas have them: ε₀ is asked for as epsilon.
function searchByName() {
  const asked = new URLSearchParams(location.search).get("q") ?? "";
  const named = folded(asked).replace(/(?<=[a-z])\d+/g, "").trim();
  if (/[^\x00-\x7f]/.test(asked) && named) location.replace(`?q=${encodeURIComponent(named)}`);
}

document.addEventListener("DOMContentLoaded", () => {
  if (document.getElementById("search-results")) searchByName();
  const parts = [...document.querySelectorAll(".ledger")];
  if (parts.length) filterLedger(parts);
  document.querySelectorAll(".copied-from").forEach(addCopyButtons);
  for (const graph of document.querySelectorAll(".graph")) {
    const own = graph.querySelector(".own").getBoundingClientRect();
    graph.scrollLeft += own.left + own.width / 2 - graph.getBoundingClientRect().left - graph.clientWidth / 2;
  }
});
