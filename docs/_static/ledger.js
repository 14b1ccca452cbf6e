// The ledger's filter: words and verdicts narrow the list; without scripts the list is whole.
document.addEventListener("DOMContentLoaded", () => {
  const parts = [...document.querySelectorAll(".ledger")];
  if (!parts.length) return;
  const place = Object.assign(document.createElement("div"), { className: "ledger-filter" });
  parts[0].closest("section").before(place);
  const field = Object.assign(document.createElement("input"), {
    type: "search", placeholder: "words, a label, a verdict", ariaLabel: "Filter the ledger",
  });
  const count = document.createElement("span");
  count.setAttribute("aria-live", "polite");
  place.append(field, count);
  const entries = [...document.querySelectorAll(".ledger > p")];
  const texts = entries.map((entry) => entry.textContent.toLowerCase());
  const narrow = () => {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    let left = 0;
    entries.forEach((entry, n) => {
      entry.hidden = !words.every((word) => texts[n].includes(word));
      left += !entry.hidden;
    });
    for (const part of parts) {
      part.closest("section").hidden = !part.querySelector("p:not([hidden])");
    }
    count.textContent = words.length ? `${left} claims` : "";
  };
  field.addEventListener("input", narrow);
});
