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

// Characters of LaTeX: what is shorter needs no break.
const long = 50;
// Characters as they are seen: a matrix or a fraction that is wider than this does not fit the page of a telephone.
const wide = 32;

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
      const inside = pieces(body).filter((one) => one.trim() && one !== "\\allowbreak");
      const matrix = inside.length === 1 && inside[0].startsWith("\\begin");
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

// What stands at `start`: a group in braces, a matrix, a command or a character; and where it ends.
function piece(source, start) {
  const ends = (open, close) => {
    let depth = 0;
    for (let i = start; i < source.length; ) {
      const here = source.startsWith(open, i) ? open : source.startsWith(close, i) ? close : source[i] === "\\" ? source.slice(i, i + 2) : source[i];
      depth += here === open ? 1 : here === close ? -1 : 0;
      i += here.length;
      if (depth === 0) return i;
    }
    throw new Error(`nothing ends ${open} in ${source}`);
  };
  for (const kind of ["{pmatrix}", "{vmatrix}"]) {
    const [begin, end] = [`\\begin${kind}`, `\\end${kind}`];
    if (source.startsWith(begin, start)) return source.slice(start, ends(begin, end));
  }
  if (source[start] === "{") return source.slice(start, ends("{", "}"));
  return /^(?:\\(?:[a-zA-Z]+|.)|.)/s.exec(source.slice(start))[0];
}

function pieces(source) {
  const result = [];
  for (let i = 0; i < source.length; i += result[result.length - 1].length) result.push(piece(source, i));
  return result;
}

// The rows of a matrix, each a list of entries.
function rowsOf(matrix) {
  const rows = [[""]];
  for (const one of pieces(matrix.slice("\\begin{pmatrix}".length, -"\\end{pmatrix}".length))) {
    const row = rows[rows.length - 1];
    if (one === "\\\\") rows.push([""]);
    else if (one === "&") row.push("");
    else row[row.length - 1] += one;
  }
  return rows;
}

// About how many characters are seen side by side.
function widthOf(source) {
  let result = 0;
  const all = pieces(source);
  for (let i = 0; i < all.length; i += 1) {
    const one = all[i];
    if (one === "\\frac") {
      const bare = all.slice(i + 1).filter((next) => next.startsWith("{"));
      result += Math.max(widthOf(bare[0]), widthOf(bare[1]));
      for (let skipped = 0; skipped < 2; i += 1) skipped += all[i + 1].startsWith("{") ? 1 : 0;
    } else if (one.startsWith("\\begin")) {
      const widths = rowsOf(one).map((row) => row.map((entry) => 2 + widthOf(entry)));
      result += widths[0].reduce((sum, _, k) => sum + Math.max(...widths.map((row) => row[k])), 2);
    } else if (one.startsWith("{")) {
      result += widthOf(one.slice(1, -1));
    } else if (/^\\(?:cos|sin|det)$/.test(one)) {
      result += 3;
    } else if (!/^[\s_^]$|^\\(?:left|right|tilde|hat|dot|ddot|operatorname|text)$/.test(one)) {
      result += 1;
    }
  }
  return result;
}

// A matrix or fraction that is too wide on one line as a terminal has it, [a, b; c, d] and (a)/b, which can be broken.
function unfolded(source) {
  const all = pieces(source);
  let result = "";
  for (let i = 0; i < all.length; i += 1) {
    const one = all[i];
    if (one.startsWith("\\begin")) {
      const rows = rowsOf(one).map((row) => row.map((entry) => unfolded(entry.trim())).join(",\\allowbreak\\ "));
      const [left, right] = one.startsWith("\\begin{vmatrix}") ? ["|", "|"] : ["[", "]"];
      result += widthOf(one) > wide ? `\\left${left}${rows.join(";\\allowbreak\\ ")}\\right${right}` : one;
      result += "\\allowbreak ";
    } else if (one === "\\frac" && widthOf(`\\frac${all[i + 1]}${all[i + 2]}`) > wide) {
      const [above, below] = [all[i + 1].slice(1, -1), all[i + 2].slice(1, -1)];
      const sum = pieces(below).some((sign) => sign === "+" || sign === "-") && !below.startsWith("\\left");
      result += `\\left(${unfolded(above)}\\right)/${sum ? `\\left(${below}\\right)` : below}\\allowbreak `;
      i += 2;
    } else {
      result += /^\\(?:cos|sin|det)$/.test(one) ? `\\allowbreak ${one}` : one;
    }
  }
  return result;
}

// Attributes of a tag of KaTeX's: its classes, and its inline style, as one list.
function namesOf(attributes) {
  const classes = (/class="([^"]*)"/.exec(attributes) || ["", ""])[1].split(/\s+/).filter(Boolean);
  const style = /style="([^"]*)"/.exec(attributes);
  return style ? [...classes, `style:${style[1]}`] : classes;
}

const tag = /<span((?: (?:class|style|aria-hidden)="[^"]*")*)>/g;

// KaTeX's HTML in fewer bytes: the classes and inline style of a tag together are one class, whose name is the shorter the
// more often they are met, its tags are <i>; the source of a formula, which stands beside its MathML, is left out. First
// every formula is counted, as often as it is set; then `html` gives it its form, and `css` gives the style sheet the same
// names.
class Compact {
  constructor() {
    this.counts = new Map();
    this.kept = new Set(["katex", "katex-mathml"]);
  }

  count(source) {
    for (const [, attributes] of source.matchAll(tag)) {
      const list = namesOf(attributes).join("\n");
      if (list) this.counts.set(list, (this.counts.get(list) || 0) + 1);
    }
  }

  // a, b, ..., Z, a0, ..., without what the pages have as names of their own, which are longer.
  name() {
    const letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    const often = [...this.counts].filter(([list]) => !this.kept.has(list)).sort(([a, n], [b, m]) => m - n || (a < b ? -1 : 1));
    this.names = new Map(often.map(([list], k) => [list, letters[k % 52] + (k < 52 ? "" : (Math.floor(k / 52) - 1).toString(36))]));
    this.holders = new Map();  // of a class or style: the names of the lists that it is in
    for (const [list, name] of this.names) {
      for (const one of list.split("\n")) this.holders.set(one, [...(this.holders.get(one) || []), name]);
    }
  }

  // What selects all that has the class or style, as strong as so many classes.
  selector(one, strength = 1) {
    const all = (this.holders.get(one) || [one]).map((name) => `.${name}`.repeat(strength));
    return all.length > 1 ? `:is(${all})` : all[0];
  }

  // MathML that is only read aloud needs no attributes, which are about its look.
  html(source, shown = false) {
    return source
      .replace(/<annotation[^>]*>[^<]*<\/annotation>|<\/?semantics>| xmlns="http:\/\/www.w3.org\/1998\/Math\/MathML"/g, "")
      .replace(/<math><mrow>(.*?)<\/mrow><\/math>/gs, "<math>$1</math>")
      .replace(/<math>.*?<\/math>/gs, (math) => (shown ? math : math.replace(/(<[a-z]+) [^>]*>/g, "$1>")))
      .replace(tag, (_, attributes) => {
        const list = namesOf(attributes).join("\n");
        const hidden = attributes.includes("aria-hidden") ? " aria-hidden=true" : "";
        return list ? `<i class=${this.names.get(list) || list}${hidden}>` : "<i>";
      })
      .replaceAll("</span>", "</i>");
  }

  // An <i> is then what a <span> is. An inline style is stronger than any rule of the sheet: so are four classes behind it.
  css(sheet) {
    const renamed = sheet
      .replace(/\.([a-zA-Z][\w-]*)(?=[^{}]*\{)/g, (_, name) => this.selector(name))
      .replaceAll(">span", ">i");
    const styles = [...this.holders.keys()].filter((one) => one.startsWith("style:"));
    const mathml =
      "math{font-family:KaTeX_Main}math mi{font-family:KaTeX_Math;font-style:italic}" +
      "math mi.n{font-family:KaTeX_Main;font-style:normal}";
    return `${renamed}.katex i{font-style:inherit}${mathml}` + styles.map((style) => `.katex ${this.selector(style, 4)}{${style.slice(6)}}`).join("\n");
  }
}

// What MathML alone says well enough: one symbol; in a sentence or a list what needs no break and stands on one line.
function isShort(kind, source) {
  return kind === "-symbol" || (source.length < 40 && !/\\(?:frac|sqrt|begin|left|sum|int|text|tilde|hat|bar|d?dot)(?![a-z])/.test(source));
}

// With the punctuation behind it, which is not to stand on the next line alone.
const formulas = /<tex(-display|-symbol|)>([^<]*)<\/tex\1>([.,;:]?)/g;

function main() {
  const { katex } = katexLibrary();
  const { pages } = JSON.parse(fs.readFileSync(0, "utf8"));
  const options = { displayMode: false, throwOnError: true, strict: "ignore" };
  const known = new Map();
  // A display is set as text is, which may be broken into lines.
  const set = (kind, source) => {
    const key = kind === "-display" ? `\\displaystyle ${breakable(unfolded(plain(source)))}` : breakable(plain(source));
    if (!known.has(key)) known.set(key, katex.renderToString(key, options));
    return known.get(key);
  };
  const compact = new Compact();
  // In a fifth of the bytes. A name of one letter is italic and one of several upright, as the style sheet sees it;
  // without mathvariant a browser takes the letter from whatever font has mathematical ones.
  const mathml = (source) =>
    compact
      .html(katex.renderToString(plain(source), { ...options, output: "mathml" }), true)
      .replace(/<\/?i(?= |>)[^>]*>/g, "")
      .replace(/<mi( mathvariant="normal")?>([^<]*)<\/mi>/g, (_, upright, name) =>
        [...name].length > 1 || upright ? `<mi class=n mathvariant=normal>${name}</mi>` : `<mi mathvariant=normal>${name}</mi>`);
  for (const { content } of pages) {
    for (const [, kind, source] of content.matchAll(formulas)) {
      if (!isShort(kind, plain(source))) compact.count(set(kind, source));
    }
  }
  compact.name();
  for (const page of pages) {
    page.content = page.content
      .replace(formulas, (_, kind, source, mark) => {
        const short = isShort(kind, plain(source));
        const html = short ? mathml(source) : compact.html(set(kind, source));
        if (kind === "-display") return `<div class="formula">${html}</div>${mark}`;
        return short && mark ? `<span class=whole>${html}${mark}</span>` : html + mark;
      })
      .replace(/<katex-version>/g, katex.version);
  }
  const css = compact.css(selfContained(styleSheet(), new Set(compact.holders.keys())));
  process.stdout.write(JSON.stringify({ pages, css }));
}

try {
  main();
} catch (error) {
  process.stderr.write(`${error.message}\n`);
  process.exitCode = 1;
}
