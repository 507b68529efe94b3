// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";
const data = "DATA";
const rows = data.rows.map((values, number) =>
{
    const row = {number};
    data.columns.forEach((c, i) => row[c] = data.strings.includes(c) ? data.table[values[i]] : values[i]);
    return row;
});
const filters = {scene: "taylorGreen", solver: "", device: "", precision: "", left: "in fronts"};
const colours = {picDem: "#D55E00", sphDem: "#0072B2", dem: "#009E73"};
const shownColumns = ["scene", "solver", "run", "spacing", "particles", "precision", "device", "card", "error", "kept", "cost", "steps", "quantity", "yardstick", "settings", "date", "version", "left"];
let sortBy = "cost", up = true, chosen = null;

function matches(row, but)
{
    return Object.entries(filters).every(([key, value]) =>
        key === but || value === "" || (key === "left" ? (value === "in fronts") === (row.left === "") : row[key] === value));
}

function visible() { return rows.filter(r => matches(r)); }

function element(name, attributes, parent, text)
{
    const svg = parent.namespaceURI === "http://www.w3.org/2000/svg";
    const e = svg ? document.createElementNS(parent.namespaceURI, name) : document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) e.setAttribute(key, value);
    if (text !== undefined) e.textContent = text;
    parent.appendChild(e);
    return e;
}

function plain(value)
{
    if (value === null || value === undefined) return "";
    return typeof value === "number" ? String(Number(value.toPrecision(4))) : value;
}

function drawFilters()
{
    const place = document.getElementById("filters");
    place.textContent = "";
    for (const key of Object.keys(filters))
    {
        const label = element("label", {}, place, key === "left" ? "rows " : key + " ");
        const select = element("select", {"data-filter": key}, label);
        const values = key === "left" ? ["in fronts", "left out"] : [...new Set(rows.filter(r => matches(r, key)).map(r => r[key]))].sort();
        if (filters[key] && !values.includes(filters[key])) values.push(filters[key]);
        for (const value of ["", ...values])
        {
            const option = element("option", {value}, select, value || "all");
            option.selected = value === filters[key];
        }
        select.addEventListener("change", () => { filters[key] = select.value; draw(); });
    }
}

function ticks(low, high)
{
    const found = [];
    const many = Math.log10(high/low) < 2;
    for (let p = Math.floor(Math.log10(low)); p <= Math.log10(high); ++p)
        for (const m of many ? [1, 2, 5] : [1])
            if (m*10**p >= low && m*10**p <= high) found.push(m*10**p);
    return found;
}

function front(points)
{
    const best = [];
    for (const r of [...points].sort((a, b) => a.cost - b.cost || a.kept - b.kept))
        if (!best.length || r.kept < best[best.length - 1].kept) best.push(r);
    return best;
}

function drawPlot(shown)
{
    const plot = document.getElementById("plot");
    plot.textContent = "";
    const points = shown.filter(r => r.cost > 0 && r.error > 0);
    if (!points.length)
    {
        element("text", {x: 20, y: 40}, plot, "no rows with cost and error");
        return;
    }
    const heights = points.flatMap(r => r.kept ? [r.error, r.kept] : [r.error]);
    const range = values => [Math.min(...values)/1.5, Math.max(...values)*1.5];
    const [x0, x1] = range(points.map(r => r.cost)), [y0, y1] = range(heights);
    const x = v => 70 + 810*Math.log(v/x0)/Math.log(x1/x0), y = v => 370 - 350*Math.log(v/y0)/Math.log(y1/y0);
    for (const t of ticks(x0, x1))
    {
        element("line", {x1: x(t), x2: x(t), y1: 20, y2: 370, stroke: "#eee"}, plot);
        element("text", {x: x(t), y: 386, "text-anchor": "middle"}, plot, plain(t));
    }
    for (const t of ticks(y0, y1))
    {
        element("line", {x1: 70, x2: 880, y1: y(t), y2: y(t), stroke: "#eee"}, plot);
        element("text", {x: 64, y: y(t) + 4, "text-anchor": "end"}, plot, plain(t));
    }
    element("text", {x: 475, y: 408, "text-anchor": "middle"}, plot, "cost [s a simulated second]");
    element("text", {x: 14, y: 195, "text-anchor": "middle", transform: "rotate(-90 14 195)"}, plot, "error");
    const groups = {};
    if (filters.scene !== "")
        for (const r of points) if (r.kept) (groups[r.solver + " " + r.device] ||= []).push(r);
    for (const mine of Object.values(groups))
    {
        const best = front(mine);
        let path = "";
        best.forEach((r, i) => { path += (i ? `H${x(r.cost)}V${y(r.kept)}` : `M${x(r.cost)} ${y(r.kept)}`); });
        element("path", {d: path + "H880", fill: "none", stroke: colours[mine[0].solver] || "#777", "stroke-width": 4, opacity: 0.25}, plot);
    }
    for (const r of points)
    {
        const colour = colours[r.solver] || "#777";
        const filled = r.device === "GPU" ? "none" : colour;
        if (r.kept > 1.001*r.error) element("circle", {cx: x(r.cost), cy: y(r.kept), r: 6, fill: "none", stroke: colour, opacity: 0.4}, plot);
        const dot = element("circle", {cx: x(r.cost), cy: y(r.error), r: r === chosen ? 8 : 5, fill: filled, stroke: colour, "stroke-width": 1.5, "pointer-events": "all"}, plot);
        element("title", {}, dot, `${r.scene} ${r.solver} ${r.run}: error ${plain(r.error)}, ${plain(r.cost)} s, ${r.device}, ${r.settings}`);
        dot.addEventListener("click", () => { chosen = r; draw(); document.querySelector("tr.chosen")?.scrollIntoView({block: "center"}); });
    }
}

function drawTable(shown)
{
    const place = document.getElementById("table");
    place.textContent = "";
    const table = element("table", {}, place);
    const head = element("tr", {}, element("thead", {}, table));
    for (const c of shownColumns)
    {
        const cell = element("th", {}, head, c + (c === sortBy ? (up ? " ▲" : " ▼") : ""));
        cell.addEventListener("click", () => { up = sortBy === c ? !up : true; sortBy = c; draw(); });
    }
    const order = (a, b) =>
    {
        const p = a[sortBy], q = b[sortBy];
        if (p === q) return a.number - b.number;
        if (p === null) return 1;
        if (q === null) return -1;
        return (p < q ? -1 : 1)*(up ? 1 : -1);
    };
    const body = element("tbody", {}, table);
    for (const r of [...shown].sort(order))
    {
        const line = element("tr", r === chosen ? {class: "chosen"} : {}, body);
        for (const c of shownColumns) element("td", {class: "long", title: plain(r[c])}, line, plain(r[c]));
    }
}

function draw()
{
    const shown = visible();
    drawFilters();
    drawPlot(shown);
    document.getElementById("count").textContent = `${shown.length} of ${rows.length} rows`;
    drawTable(shown);
}

draw();
