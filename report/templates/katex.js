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

function isNeeded(font, classes) {
  const family = Object.keys(rareFonts).find((name) => font.startsWith(`KaTeX_${name}`));
  return !family || classes.has(rareFonts[family]);
}

// Each @font-face with its font inside; the faces of alphabets that no page uses left out.
function selfContained({ css, directory }, classes) {
  return css.replace(/@font-face\{[^}]*\}/g, (face) => {
    const font = face.match(/fonts\/([\w-]+)\.woff2/)[1];
    if (!isNeeded(font, classes)) return "";
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

// KaTeX's HTML in fewer bytes: its classes have short names, its inline styles are classes; the source of a formula, which
// stands beside its MathML, is left out. `css` gives its style sheet the same names.
class Compact {
  constructor() {
    this.classes = new Map();
    this.styles = new Map();
    this.kept = new Set(["katex", "katex-mathml", "katex-html", "base"]);
  }

  short(name) {
    if (this.kept.has(name)) return name;
    if (!this.classes.has(name)) this.classes.set(name, `k${this.classes.size.toString(36)}`);
    return this.classes.get(name);
  }

  style(text) {
    if (!this.styles.has(text)) this.styles.set(text, `s${this.styles.size.toString(36)}`);
    return this.styles.get(text);
  }

  html(source) {
    return source
      .replace(/<annotation[^>]*>[^<]*<\/annotation>|<\/?semantics>| xmlns="http:\/\/www.w3.org\/1998\/Math\/MathML"/g, "")
      .replace(/<span((?: (?:class|style)="[^"]*")+)>/g, (_, attributes) => {
        const names = (/class="([^"]*)"/.exec(attributes) || ["", ""])[1].split(/\s+/).filter(Boolean).map((name) => this.short(name));
        const style = /style="([^"]*)"/.exec(attributes);
        if (style) names.push(this.style(style[1]));
        return names.length > 1 ? `<span class="${names.join(" ")}">` : names.length ? `<span class=${names[0]}>` : "<span>";
      });
  }

  // An inline style is stronger than any rule of the sheet: so are four classes behind it.
  css(sheet) {
    const renamed = sheet.replace(/\.([a-zA-Z][\w-]*)/g, (whole, name) => (this.classes.has(name) ? `.${this.classes.get(name)}` : whole));
    return renamed + [...this.styles].map(([text, name]) => `.katex ${`.${name}`.repeat(4)}{${text}}`).join("\n");
  }
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
  const compact = new Compact();
  // A display is set as text is, which may be broken into lines.
  const set = (source, display) => {
    const key = `${display ? "\\displaystyle " : ""}${breakable(plain(source))}`;
    if (!known.has(key)) {
      known.set(key, compact.html(katex.renderToString(key, { displayMode: false, throwOnError: true, strict: "ignore" })));
    }
    return known.get(key);
  };
  // One symbol, or two beside a sign: MathML alone, which browsers set well enough, in a fifth of the bytes.
  const symbol = (source) =>
    compact.html(katex.renderToString(plain(source), { output: "mathml", throwOnError: true })).replace(/<\/?span[^>]*>/g, "");
  for (const page of pages) {
    page.content = page.content
      .replace(/<tex>([^<]*)<\/tex>/g, (_, source) => set(source, false))
      .replace(/<tex-symbol>([^<]*)<\/tex-symbol>/g, (_, source) => symbol(source))
      .replace(/<tex-display>([^<]*)<\/tex-display>/g, (_, source) => `<div class="formula"${keys(source)}>${set(source, true)}</div>`)
      .replace(/<katex-version>/g, katex.version);
  }
  const css = compact.css(selfContained(styleSheet(), compact.classes));
  process.stdout.write(JSON.stringify({ pages, css }));
}

try {
  main();
} catch (error) {
  process.stderr.write(`${error.message}\n`);
  process.exitCode = 1;
}
