// Sets the formulas of all pages. Reads {"pages": [{"name", "content"}]} from standard input, writes the same with
// every <tex>...</tex> and <tex-display>...</tex-display> replaced by KaTeX's HTML with MathML inside, its version in
// place of <katex-version>, and under "css" its style sheet with the fonts that the pages need. A formula that KaTeX
// does not understand is an error.
"use strict";
const fs = require("fs");

function katexLibrary() {
  for (const place of ["katex", "/usr/share/nodejs/katex", "/usr/share/javascript/katex/katex.js"]) {
    try {
      return { katex: require(place), file: require.resolve(place) };
    } catch (error) {
      if (error.code !== "MODULE_NOT_FOUND") throw error;
    }
  }
  throw new Error("KaTeX is not there (Debian has it in katex)");
}

// The style sheet and the fonts beside it, wherever the library was found.
function styleSheet() {
  for (const place of ["/usr/share/javascript/katex", "/usr/share/nodejs/katex/dist"]) {
    if (fs.existsSync(`${place}/katex.min.css`)) {
      return { css: fs.readFileSync(`${place}/katex.min.css`, "utf8"), directory: place };
    }
  }
  throw new Error("the style sheet of KaTeX is not there (Debian has it in libjs-katex)");
}

const rareFonts = {
  Caligraphic: "mathcal", Fraktur: "mathfrak", SansSerif: "mathsf", Script: "mathscr", Typewriter: "mathtt",
};

function isNeeded(font, html) {
  const family = Object.keys(rareFonts).find((name) => font.startsWith(`KaTeX_${name}`));
  return !family || html.includes(rareFonts[family]);
}

// Each @font-face with its font inside; the faces of alphabets that no page uses left out.
function selfContained({ css, directory }, html) {
  return css.replace(/@font-face\{[^}]*\}/g, (face) => {
    const font = face.match(/fonts\/([\w-]+)\.woff2/)[1];
    if (!isNeeded(font, html)) return "";
    const data = fs.readFileSync(`${directory}/fonts/${font}.woff2`).toString("base64");
    return face.replace(/src:[^;}]*/, `src:url(data:font/woff2;base64,${data}) format("woff2")`);
  });
}

const references = { "&lt;": "<", "&gt;": ">", "&quot;": '"', "&#39;": "'", "&amp;": "&" };

function plain(escaped) {
  return escaped.replace(/&(?:lt|gt|quot|#39|amp);/g, (reference) => references[reference]);
}

function main() {
  const { katex } = katexLibrary();
  const { pages } = JSON.parse(fs.readFileSync(0, "utf8"));
  const known = new Map();
  const set = (source, displayMode) => {
    const key = `${displayMode} ${source}`;
    if (!known.has(key)) {
      known.set(key, katex.renderToString(plain(source), { displayMode, throwOnError: true, strict: "ignore" }));
    }
    return known.get(key);
  };
  for (const page of pages) {
    page.content = page.content
      .replace(/<tex>([^<]*)<\/tex>/g, (_, source) => set(source, false))
      .replace(/<tex-display>([^<]*)<\/tex-display>/g, (_, source) => set(source, true))
      .replace(/<katex-version>/g, katex.version);
  }
  const css = selfContained(styleSheet(), pages.map((page) => page.content).join(""));
  process.stdout.write(JSON.stringify({ pages, css }));
}

try {
  main();
} catch (error) {
  process.stderr.write(`${error.message}\n`);
  process.exitCode = 1;
}
