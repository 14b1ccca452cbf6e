// The atlas: words narrow its list, and the address keeps them; without scripts the list is whole.
// The spellings are those of `tresym atlas --search`.
const SPELLED = [["∞", "oo"], ["→", "->"], ["−", "-"], ["^", "**"], ["≤", "<="], ["≥", ">="]];
const wordsOf = (text) => SPELLED.reduce((said, [sign, word]) => said.replaceAll(sign, word), text)
  .toLowerCase().replace(/['’]/g, "").split(/[\s,;?]+/).map((word) => word.replace(/\(\w\)$/, ""))
  .filter((word) => word);

function filterAtlas(field) {
  const rows = [...document.querySelectorAll("ul.atlas > li")];
  const count = document.getElementById("atlas-count");
  const narrow = () => {
    const words = wordsOf(field.value);
    for (const row of rows) row.hidden = !words.every((word) => row.dataset.words.includes(word));
    const shown = rows.filter((row) => !row.hidden).length;
    count.textContent = `${shown} of ${rows.length}`;
    history.replaceState(null, "", field.value ? `#${encodeURIComponent(field.value)}` : location.pathname);
  };
  field.value = decodeURIComponent(location.hash.slice(1));
  field.addEventListener("input", narrow);
  if (field.value) narrow();
}

addEventListener("DOMContentLoaded", () => {
  const field = document.getElementById("atlas-search");
  if (field) filterAtlas(field);
});
