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

// Characters of LaTeX: what is shorter needs no break; what is longer, in a fraction or a matrix, may find none.
const long = 50;
const huge = 600;

// Where the pair that begins with \left at `start` ends: just behind its \right and the bracket.
function pairEnd(source, start) {
  const pair = /\\(left|right)(?![a-zA-Z])\s*(\\[a-zA-Z]+|\\.|.)/g;
  pair.lastIndex = start;
  let depth = 0;
  for (let found = pair.exec(source); found; found = pair.exec(source)) {
    depth += found[1] === "left" ? 1 : -1;
    if (depth === 0) return { at: found.index, end: pair.lastIndex, bracket: found[2] };
  }
  throw new Error(`no \\right for a \\left: ${source}`);
}

// A long formula that can be broken between its brackets: these have a size of their own then. Those around a matrix, or
// inside a group, stay as they are.
function breakable(source) {
  if (source.length < long) return source;
  let result = "";
  let depth = 0;
  for (let i = 0; i < source.length; ) {
    const open = depth === 0 && /^\\left(?![a-zA-Z])\s*(\\[a-zA-Z]+|\\.|.)/.exec(source.slice(i));
    if (open) {
      const { at, end, bracket } = pairEnd(source, i);
      const body = source.slice(i + open[0].length, at);
      const matrix = /\\begin\{/.test(body) && body.trim().startsWith("\\begin{");
      const size = /\\frac|\\begin/.test(body) ? "\\Big" : "\\big";
      result += matrix
        ? source.slice(i, end)
        : `${size}l${open[1]} ${breakable(body)} ${size}r${bracket}`;
      i = end;
      continue;
    }
    const words = depth === 0 && /^\\text\{([^{}]*)\}/.exec(source.slice(i));
    if (words) {
      result += words[1].replace(/\S+\s*|\s+/g, (word) => `\\text{${word}}\\allowbreak `);
      i += words[0].length;
      continue;
    }
    if (source[i] === "\\") {
      const command = /^\\([a-zA-Z]+|.)/.exec(source.slice(i))[0];
      result += command;
      i += command.length;
      continue;
    }
    depth += source[i] === "{" ? 1 : source[i] === "}" ? -1 : 0;
    result += source[i];
    i += 1;
  }
  return result;
}

// For a formula that has to be scrolled for.
function keys(source) {
  const matrices = (source.match(/begin/g) || []).length;
  const wide = source.length > huge ? /frac|begin/.test(source) : source.length > huge / 2 && matrices > 2;
  return wide ? ' tabindex="0" role="region" aria-label="A wide formula"' : "";
}

function main() {
  const { katex } = katexLibrary();
  const { pages } = JSON.parse(fs.readFileSync(0, "utf8"));
  const known = new Map();
  // A display is set as text is, which may be broken into lines.
  const set = (source, display) => {
    const key = `${display ? "\\displaystyle " : ""}${breakable(plain(source))}`;
    if (!known.has(key)) {
      known.set(key, katex.renderToString(key, { displayMode: false, throwOnError: true, strict: "ignore" }));
    }
    return known.get(key);
  };
  for (const page of pages) {
    page.content = page.content
      .replace(/<tex>([^<]*)<\/tex>/g, (_, source) => set(source, false))
      .replace(/<tex-display>([^<]*)<\/tex-display>/g, (_, source) => `<div class="formula"${keys(source)}>${set(source, true)}</div>`)
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
