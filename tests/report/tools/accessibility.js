// What keeps a reader from a page, found by the browser itself: a list of sentences. The rules are those of WCAG 2.1,
// level AA, that apply to pages without forms or media: contrast (1.4.3), nothing known by its colour alone (1.4.1),
// names of pictures, links, controls and regions (1.1.1, 2.4.4, 4.1.2), the order of headings (1.3.1), heads of tables,
// a language and a title, keys for what scrolls (2.1.1).
"use strict";
const faults = new Map(); // sentence -> how often
const fault = (text) => faults.set(text, (faults.get(text) || 0) + 1);
const excerpt = (element) => element.textContent.trim().replace(/\s+/g, " ").slice(0, 40);

// --- contrast ---

// [red, green, blue, alpha], each 0..1.
function parse(colour) {
  const numbers = colour.match(/-?[\d.]+(?:e-?\d+)?%?/g).map((text) => (text.endsWith("%") ? parseFloat(text) / 100 : parseFloat(text)));
  const scale = colour.startsWith("color(") ? 1 : 255;
  const [red, green, blue] = numbers;
  return [red / scale, green / scale, blue / scale, numbers.length > 3 ? numbers[3] : 1];
}

function over([r, g, b, a], [R, G, B]) {
  return [r * a + R * (1 - a), g * a + G * (1 - a), b * a + B * (1 - a), 1];
}

const page = matchMedia("(prefers-color-scheme: dark)").matches ? [0.07, 0.07, 0.07, 1] : [1, 1, 1, 1];
const backgrounds = new Map();
function background(element) {
  if (!element) return page;
  if (!backgrounds.has(element)) {
    backgrounds.set(element, over(parse(getComputedStyle(element).backgroundColor), background(element.parentElement)));
  }
  return backgrounds.get(element);
}

function luminance([r, g, b]) {
  const linear = (c) => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
  return 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
}

function contrast(a, b) {
  const [x, y] = [luminance(a), luminance(b)].sort((p, q) => q - p);
  return (x + 0.05) / (y + 0.05);
}

function needed(style) {
  const size = parseFloat(style.fontSize);
  return size >= 24 || (size >= 18.66 && parseInt(style.fontWeight) >= 700) ? 3 : 4.5;
}

// What only a screen reader is to find is a pixel wide.
function visible(element) {
  return element.getClientRects().length > 0 && element.getBoundingClientRect().width > 1;
}

function legible(element, pseudo) {
  const style = getComputedStyle(element, pseudo);
  const behind = pseudo ? over(parse(style.backgroundColor), background(element)) : background(element);
  const ratio = contrast(over(parse(style.color), behind), behind);
  if (ratio < needed(style)) {
    fault(`contrast ${ratio.toFixed(2)} of .${element.className || element.tagName.toLowerCase()}: ${excerpt(element)}`);
  }
}

const judged = new Set();
const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
while (texts.nextNode()) {
  let element = texts.currentNode.parentElement;
  if (!texts.currentNode.data.trim() || element.closest("svg, script, style")) continue;
  element = element.closest(".katex") || element; // one colour for all of a formula
  if (judged.has(element)) continue;
  judged.add(element);
  if (visible(element)) legible(element);
}

// --- what colour alone would tell ---

for (const mark of document.querySelectorAll(".dot, .swatch, .score span")) {
  if (/^(none|normal|"")$/.test(getComputedStyle(mark, "::before").content)) {
    fault(`colour alone tells the status of .${mark.className}`);
  } else {
    legible(mark, "::before");
  }
}

// --- names ---

const name = (element) =>
  element.textContent.trim() || element.getAttribute("aria-label") || element.getAttribute("title") ||
  element.getAttribute("xlink:title") || "";
for (const picture of document.querySelectorAll("img")) {
  if (!(picture.getAttribute("alt") || "").trim()) fault(`a picture without words: ${picture.getAttribute("src")}`);
}
for (const part of document.querySelectorAll('[role="img"], [role="region"]')) {
  if (!part.getAttribute("aria-label")) fault(`no name for .${part.className}`);
}
for (const link of document.querySelectorAll("a, button, summary")) {
  if (!name(link)) fault(`a ${link.tagName.toLowerCase()} without a name: ${link.getAttribute("href")}`);
}
for (const control of document.querySelectorAll("input, select")) {
  if (!control.labels.length && !control.getAttribute("aria-label")) fault(`a control without a label: ${control.name}`);
}
if (!document.documentElement.lang) fault("the page has no language");
if (!document.title.trim()) fault("the page has no title");
if (document.querySelectorAll("main").length !== 1) fault("the page has not one main part");

// --- order ---

let level = 0;
for (const heading of document.querySelectorAll("h1, h2, h3, h4, h5, h6")) {
  const next = Number(heading.tagName[1]);
  if (next > level + 1) fault(`a heading h${next} after h${level}: ${excerpt(heading)}`);
  level = next;
}
for (const table of document.querySelectorAll("table")) {
  if (!table.querySelector("th")) fault(`a table without heads: ${excerpt(table)}`);
}
for (const list of document.querySelectorAll("dl")) {
  for (const child of list.children) {
    if (!/^(DT|DD|DIV)$/.test(child.tagName)) fault(`a ${child.tagName.toLowerCase()} in a list of definitions`);
  }
}

// --- what is cut off, or has to be scrolled for ---

for (const part of document.querySelectorAll("body *")) {
  if (part.closest(".katex, svg")) continue;
  const style = getComputedStyle(part);
  const formula = part.matches(".formula, p, li, dd, td");
  if (!formula && !/auto|scroll|hidden/.test(style.overflowX)) continue;
  if (style.display === "inline" || part.scrollWidth <= part.clientWidth + 1 || part.clientWidth <= 1) continue;
  if (!/auto|scroll/.test(style.overflowX)) {
    fault(`cut off, or ${part.scrollWidth - part.clientWidth} pixels too wide: .${part.className}: ${excerpt(part)}`);
  } else if (part.tabIndex < 0) {
    fault(`${part.scrollWidth - part.clientWidth} pixels to scroll for, without a key: .${part.className}: ${excerpt(part)}`);
  }
}

return [...faults].map(([text, count]) => (count > 1 ? `${text} (${count} times)` : text));
