/**
 * Two pens that know the same strokes: one paints on a canvas, one writes SVG. A picture is a function
 * that takes either, so what is saved is what is seen.
 */
"use strict";

/** @typedef {[number, number]} Spot in pixels; a spot that is not a number breaks a line */

/**
 * @typedef {object} Stroke
 * @property {string} [fill]
 * @property {string} [stroke]
 * @property {number} [width]
 * @property {number[]} [dash]
 * @property {number} [alpha]
 */

/**
 * @typedef {object} Lettering
 * @property {string} fill
 * @property {number} [size]
 * @property {"start" | "center" | "end"} [align]
 * @property {boolean} [italic]
 * @property {string} [halo] a colour around the letters
 */

/**
 * @typedef {object} Pen
 * @property {number} width
 * @property {number} height
 * @property {(spots: Spot[], style: Stroke) => void} line
 * @property {(spots: Spot[], style: Stroke) => void} area a closed line
 * @property {(at: Spot, radius: number, style: Stroke) => void} disc
 * @property {(at: Spot, radius: number, inner: string, outer: string) => void} ball lit from above
 * @property {(at: Spot, text: string, style: Lettering) => void} words
 * @property {(box: number[], draw: () => void) => void} inside clipped to [x, y, width, height]
 */

const FONT = 'system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';
const SERIF = 'Georgia, "Times New Roman", "DejaVu Serif", serif';

/**
 * @param {CanvasRenderingContext2D} to
 * @param {number} width
 * @param {number} height
 * @returns {Pen}
 */
function canvasPen(to, width, height) {
  to.lineJoin = "round";
  to.lineCap = "round";
  /** @param {Spot[]} spots */
  const trace = (spots) => {
    to.beginPath();
    let open = false;
    for (const [x, y] of spots) {
      if (x !== x || y !== y) open = false;
      else if (open) to.lineTo(x, y);
      else {
        to.moveTo(x, y);
        open = true;
      }
    }
  };
  /** @param {Stroke} style */
  const paint = ({ fill, stroke, width: wide = 1, dash = [], alpha = 1 }) => {
    to.globalAlpha = alpha;
    if (fill) {
      to.fillStyle = fill;
      to.fill();
    }
    if (stroke) {
      to.strokeStyle = stroke;
      to.lineWidth = wide;
      to.setLineDash(dash);
      to.stroke();
    }
    to.globalAlpha = 1;
  };
  return {
    width,
    height,
    line(spots, style) {
      trace(spots);
      paint({ ...style, fill: undefined });
    },
    area(spots, style) {
      trace(spots);
      to.closePath();
      paint(style);
    },
    disc([x, y], radius, style) {
      to.beginPath();
      to.arc(x, y, radius, 0, 2 * Math.PI);
      paint(style);
    },
    ball([x, y], radius, inner, outer) {
      const light = to.createRadialGradient(
        x - 0.35 * radius,
        y - 0.4 * radius,
        0,
        x,
        y,
        1.05 * radius,
      );
      light.addColorStop(0, inner);
      light.addColorStop(1, outer);
      to.beginPath();
      to.arc(x, y, radius, 0, 2 * Math.PI);
      to.fillStyle = light;
      to.fill();
    },
    words([x, y], text, { fill, size = 13, align = "start", italic, halo }) {
      to.font = `${italic ? "italic " : ""}${size}px ${italic ? SERIF : FONT}`;
      to.textAlign = align;
      if (halo) {
        to.strokeStyle = halo;
        to.lineWidth = 3.5;
        to.setLineDash([]);
        to.strokeText(text, x, y);
      }
      to.fillStyle = fill;
      to.fillText(text, x, y);
    },
    inside([x, y, wide, high], draw) {
      to.save();
      to.beginPath();
      to.rect(x, y, wide, high);
      to.clip();
      draw();
      to.restore();
    },
  };
}

/**
 * @param {number} width
 * @param {number} height
 * @returns {Pen & { text: () => string }}
 */
function svgPen(width, height) {
  /** @type {string[]} */
  const parts = [];
  let names = 0;
  /** @param {number} x */
  const short = (x) => String(Math.round(100 * x) / 100);
  /** @param {Spot[]} spots */
  const trace = (spots) => {
    let open = false;
    return spots
      .map(([x, y]) => {
        if (x !== x || y !== y) {
          open = false;
          return "";
        }
        const step = `${open ? "L" : "M"}${short(x)} ${short(y)}`;
        open = true;
        return step;
      })
      .join("");
  };
  /** @param {Stroke} style */
  const paint = ({ fill, stroke, width: wide = 1, dash, alpha }) =>
    `fill="${fill ?? "none"}"` +
    (stroke ? ` stroke="${stroke}" stroke-width="${short(wide)}"` : "") +
    (stroke && dash?.length ? ` stroke-dasharray="${dash}"` : "") +
    (alpha === undefined ? "" : ` opacity="${short(alpha)}"`);
  /** @param {string} text */
  const plain = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/"/g, "&quot;");
  return {
    width,
    height,
    line: (spots, style) =>
      void parts.push(`<path d="${trace(spots)}" ${paint({ ...style, fill: undefined })}/>`),
    area: (spots, style) => void parts.push(`<path d="${trace(spots)}Z" ${paint(style)}/>`),
    disc: ([x, y], radius, style) =>
      void parts.push(
        `<circle cx="${short(x)}" cy="${short(y)}" r="${short(radius)}" ${paint(style)}/>`,
      ),
    ball([x, y], radius, inner, outer) {
      const name = `light${names++}`;
      parts.push(
        `<radialGradient id="${name}" cx=".5" cy=".5" r=".525" fx=".325" fy=".3">` +
          `<stop stop-color="${inner}"/><stop offset="1" stop-color="${outer}"/></radialGradient>` +
          `<circle cx="${short(x)}" cy="${short(y)}" r="${short(radius)}" fill="url(#${name})"/>`,
      );
    },
    words([x, y], text, { fill, size = 13, align = "start", italic, halo }) {
      const family = plain(italic ? SERIF : FONT);
      parts.push(
        `<text x="${short(x)}" y="${short(y)}" fill="${fill}" font-size="${size}" ` +
          `font-family="${family}" text-anchor="${align === "center" ? "middle" : align}"` +
          (italic ? ' font-style="italic"' : "") +
          (halo ? ` stroke="${halo}" stroke-width="3.5" paint-order="stroke"` : "") +
          `>${plain(text)}</text>`,
      );
    },
    inside([x, y, wide, high], draw) {
      const name = `frame${names++}`;
      const box = `x="${short(x)}" y="${short(y)}" width="${short(wide)}" height="${short(high)}"`;
      parts.push(`<clipPath id="${name}"><rect ${box}/></clipPath><g clip-path="url(#${name})">`);
      draw();
      parts.push("</g>");
    },
    text: () =>
      `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" ` +
      `viewBox="0 0 ${width} ${height}" stroke-linejoin="round" stroke-linecap="round">` +
      `${parts.join("")}</svg>\n`,
  };
}

// Colours

/** The colours of the page, by their names in the style sheet without the dashes. */
const COLOURS = /** @type {Record<string, string>} */ ({});

/** Read them again, when the page turns light or dark. */
function readColours() {
  const style = getComputedStyle(document.documentElement);
  const names =
    "paper card ink quiet edge grid accent rotating oscillating front back warning good frame grip string page sphere";
  for (const name of names.split(" ")) COLOURS[name] = style.getPropertyValue(`--${name}`).trim();
}

/**
 * @param {string} from a colour as #rrggbb
 * @param {string} to
 * @param {number} share 0 for the first, 1 for the second
 * @returns {string}
 */
function mixed(from, to, share) {
  let colour = "#";
  for (const i of [1, 3, 5]) {
    const [x, y] = [from, to].map((text) => parseInt(text.slice(i, i + 2), 16));
    colour += Math.round(x + (y - x) * clamp(share, 0, 1))
      .toString(16)
      .padStart(2, "0");
  }
  return colour;
}
