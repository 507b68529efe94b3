// SPDX-License-Identifier: GPL-3.0-or-later
// As much of a browser's document as docs/charts/rows.html asks for; testRows.py puts the page's script in the place of the word below
"use strict";
class Element
{
    constructor(name, space) { Object.assign(this, {name, namespaceURI: space || "html", children: [], attributes: {}, listeners: {}, text: "", selected: false}); }
    setAttribute(key, value) { if (String(value).includes("NaN")) throw Error(`${this.name} ${key}=${value}`); this.attributes[key] = String(value); }
    appendChild(child) { this.children.push(child); }
    addEventListener(what, then) { this.listeners[what] = then; }
    scrollIntoView() {}
    set textContent(value) { this.text = value; this.children = []; }
    get textContent() { return this.text; }
    get value() { return (this.children.find(c => c.selected) || this.children[0]).attributes.value; }
    all(name) { return [...(this.name === name ? [this] : []), ...this.children.flatMap(c => c.all(name))]; }
}
const svg = "http://www.w3.org/2000/svg";
const places = {filters: new Element("p"), plot: new Element("svg", svg), count: new Element("p"), table: new Element("div")};
const document =
{
    getElementById: id => places[id],
    createElement: name => new Element(name),
    createElementNS: (space, name) => new Element(name, space),
    querySelector: () => null
};
SCRIPT
function wanted(truth, what) { if (!truth) throw Error(what); }
function choose(filter, value)
{
    const select = places.filters.all("select").find(s => s.attributes["data-filter"] === filter);
    for (const option of select.children) option.selected = option.attributes.value === value;
    select.listeners.change();
}
const lines = () => places.table.all("tr").length - 1;
const first = lines();
wanted(first > 5 && places.plot.all("circle").length >= first, "taylorGreen is drawn");
wanted(places.plot.all("path").length === 2, "a front of each solver");
choose("solver", "sphDem");
wanted(lines() < first && lines() > 0, "the filter takes rows out");
choose("solver", "");
choose("left", "left out");
wanted(lines() > 0, "rows that are left out can be seen");
choose("scene", "");
choose("left", "");
wanted(lines() === rows.length, "all rows");
const head = places.table.all("th").find(h => h.text.startsWith("error"));
head.listeners.click();
const column = places.table.all("th").findIndex(h => h.text.startsWith("error"));
const errors = places.table.all("tr").slice(1).map(r => r.children[column].text).filter(t => t !== "").map(Number);
wanted(errors.every((e, i) => !i || e >= errors[i - 1]), "sorted by error");
places.plot.all("circle")[0].listeners.click();
wanted(places.table.all("tr").some(r => r.attributes.class === "chosen"), "a point finds its row");
console.log("ok");
