// Shows the entries of a page that fit what is asked for: by the controls of its form, or by the page's address
// (statements.html?status=refuted&origin=paper). Without this script all are shown.
"use strict";
(() => {
  const form = document.querySelector("form.filter");
  const entries = [...document.querySelectorAll("article[data-status]")];
  const controls = [...form.elements].filter((control) => control.name);
  const texts = new Map();
  const text = (entry) => {
    if (!texts.has(entry)) texts.set(entry, entry.textContent.toLowerCase());
    return texts.get(entry);
  };

  const fits = (entry, control) =>
    !control.value ||
    (control.name === "text" ? text(entry).includes(control.value.toLowerCase()) : entry.dataset[control.name] === control.value);

  function show() {
    let shown = 0;
    for (const entry of entries) {
      entry.hidden = !controls.every((control) => fits(entry, control));
      shown += entry.hidden ? 0 : 1;
    }
    for (const section of document.querySelectorAll("main section")) {
      const own = [...section.querySelectorAll("article[data-status]")];
      section.hidden = own.length > 0 && own.every((entry) => entry.hidden);
    }
    form.querySelector("output").textContent = `${shown} of ${entries.length}`;
  }

  function clear() {
    for (const control of controls) control.value = "";
    show();
  }

  // Who follows a link to an entry is to find it.
  function find() {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (target && target.closest("[hidden]")) {
      clear();
      target.scrollIntoView();
    }
  }

  const asked = new URLSearchParams(location.search);
  for (const control of controls) control.value = asked.get(control.name) || "";
  form.hidden = false;
  form.addEventListener("input", show);
  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("reset", () => setTimeout(show));
  window.addEventListener("hashchange", find);
  show();
  find();
})();
