// Draws the charts of a page, and opens flights one by one; everything it shows is in the element "content".
"use strict";
(() => {
  const content = JSON.parse(document.getElementById("content").textContent);

  function trace(curve, columns) {
    const made = {
      type: curve.z ? "scatter3d" : "scatter",
      x: columns[curve.x],
      y: columns[curve.y],
      name: curve.label,
      showlegend: curve.label !== "",
      hoverinfo: curve.label === "" ? "skip" : "all",
      mode: curve.kind === "points" ? "markers" : "lines",
    };
    if (curve.z) made.z = columns[curve.z];
    if (curve.kind === "points") {
      made.marker = { color: curve.colour, size: curve.z ? 0.6 * curve.width : curve.width };
    } else {
      made.line = { color: curve.colour, width: curve.width, dash: curve.dash ? "dash" : "solid",
                    // Simplified, a plateau would slope towards the point after it.
                    simplify: false, shape: curve.kind === "steps" ? "hv" : "linear" };
    }
    if (curve.low) {
      const low = columns[curve.low], high = columns[curve.high];
      made.error_y = { type: "data", symmetric: false, color: curve.colour, thickness: 1.2, width: 4,
                       array: made.y.map((y, i) => high[i] - y), arrayminus: made.y.map((y, i) => y - low[i]) };
    }
    if (curve.link) made.customdata = columns[curve.link];
    return made;
  }

  const drawable = (curve, columns) => columns[curve.x] && columns[curve.y] && (!curve.z || columns[curve.z]);

  // Of the page's style, which knows whether it is light or dark.
  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const inColours = (place) => ({ "font.color": colour("--ink"), paper_bgcolor: colour("--paper"), plot_bgcolor: colour("--paper"),
                                  ...Object.fromEntries(place.dataset.axes.split(" ").map((side) => [`${side}.gridcolor`, colour("--line")])) });

  // A finger on a chart scrolls the page; what a mouse drags is zoomed.
  const finger = matchMedia("(pointer: coarse)").matches;

  function axis(title, logarithmic) {
    const made = { title: { text: title, standoff: 8 }, automargin: true, gridcolor: colour("--line"), zeroline: false,
                   linecolor: "#8c8c8c", ticks: "outside", tickcolor: "#8c8c8c", exponentformat: "power" };
    if (logarithmic) made.type = "log";
    return made;
  }

  function save(chart, columns) {
    const names = Object.keys(columns), length = Math.max(...names.map((name) => columns[name].length));
    const cell = (value) => (value === undefined || value === null ? "" : `"${String(value).replaceAll('"', '""')}"`);
    const lines = [names.map(cell).join(",")];
    for (let i = 0; i < length; i++) lines.push(names.map((name) => cell(columns[name][i])).join(","));
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([lines.join("\n") + "\n"], { type: "text/csv" }));
    link.download = `${chart.name}.csv`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }

  const sheet = { width: 24, height: 24, path: "M3 3h18v18H3V3zm2 4v4h6V7H5zm8 0v4h6V7h-6zm-8 6v6h6v-6H5zm8 0v6h6v-6h-6z" };

  // Words become numbers, so that every curve has a place of its own in the row of a word.
  function inRows(made, number, of, words) {
    const errors = made.error_y, offset = 0.6 * ((number + 0.5) / of - 0.5);
    made.text = words.map((word, i) => {
      const ends = errors ? ` (${(made.y[i] - errors.arrayminus[i]).toFixed(2)} to ${(made.y[i] + errors.array[i]).toFixed(2)})` : "";
      return `${word}<br>${made.name} ${made.y[i].toFixed(2)}${ends}`;
    });
    Object.assign(made, { x: made.y, y: words.map((_, i) => i + offset), hoverinfo: "text", error_x: errors });
    delete made.error_y;
    return made;
  }

  function wrapped(text, width) {
    const lines = [""];
    for (const word of text.split(" ")) {
      if (lines.at(-1) !== "" && lines.at(-1).length + word.length >= width) lines.push(word);
      else lines.push(`${lines.pop()} ${word}`.trim());
    }
    return lines.join("<br>");
  }

  function draw(place, chart, columns) {
    const curves = chart.curves.filter((curve) => drawable(curve, columns));
    const layout = {
      margin: { l: 56, r: 12, t: 30, b: 44 }, autosize: true, hovermode: "closest", dragmode: finger ? false : "zoom",
      font: { family: 'system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif', size: 12, color: colour("--ink") },
      xaxis: axis(chart.x, chart.logarithmic.includes("x")), yaxis: axis(chart.y, chart.logarithmic.includes("y")),
      legend: { orientation: "h", x: 0, yref: "container", y: 0, yanchor: "bottom", font: { size: 11 } },
      paper_bgcolor: colour("--paper"), plot_bgcolor: colour("--paper"),
    };
    const narrow = place.clientWidth < 480;
    for (const side of [layout.xaxis, layout.yaxis]) side.title.text = wrapped(side.title.text, narrow ? 34 : 60);
    // Many names need room of their own, or they would take it from the curves.
    const names = curves.filter((curve) => curve.label !== "").length;
    if (names > 4) place.style.height = `${24 + 1.15 * (names - 4)}rem`;
    if (chart.equal) {
      layout.yaxis.scaleanchor = "x";
      // With equal scales a margin changes the range, hence the labels, hence the margin, and so on.
      layout.xaxis.automargin = "height";
      layout.yaxis.automargin = false;
      layout.margin.l = 64;
    }
    if (chart.z) {
      const side = (title) => ({ title: { text: title }, gridcolor: colour("--line"), zeroline: false, showspikes: false, nticks: 5 });
      // The box's sides as charts.IN_SPACE has them.
      layout.scene = { xaxis: side(chart.x), yaxis: side(chart.y), zaxis: side(chart.z), dragmode: "orbit",
                       aspectmode: "manual", aspectratio: { x: 1, y: 1, z: 0.4 }, camera: { eye: { x: 1.1, y: -1.3, z: 0.9 } } };
      layout.margin = { l: 0, r: 0, t: 30, b: 30 };
    }
    if (chart.x_range) layout.xaxis.range = chart.x_range;
    if (chart.y_range) layout.yaxis.range = chart.y_range;
    const traces = curves.map((curve) => trace(curve, columns));
    if (chart.rows) {
      const words = columns[curves[0].x];
      traces.forEach((made, number) => inRows(made, number, traces.length, words));
      const texts = words.map((word) => wrapped(word.replaceAll("<", "&lt;").replaceAll(" TU", "\u00a0TU"), narrow ? 16 : 26));
      Object.assign(layout.xaxis, { title: { text: chart.y }, nticks: 6 });
      Object.assign(layout.yaxis, { title: { text: "" }, tickmode: "array", tickvals: words.map((_, i) => i), ticktext: texts,
                                    range: [words.length - 0.5, -0.5], showgrid: false });
      const lines = Math.max(...texts.map((text) => text.split("<br>").length));
      place.style.height = `${9 + words.length * Math.max(2.4, 0.6 + 0.95 * lines)}rem`;
    }
    const config = {
      responsive: true, displaylogo: false,
      modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"],
      toImageButtonOptions: { filename: chart.name, scale: 3 },
      modeBarButtonsToAdd: [{ name: "csv", title: "Save as CSV", icon: sheet, click: () => save(chart, columns) }],
    };
    return Plotly.newPlot(place, traces, layout, config).then(() => {
      place.dataset.drawn = "yes";
      place.dataset.axes = chart.z ? "scene.xaxis scene.yaxis scene.zaxis" : "xaxis yaxis";
      place.on("plotly_click", (event) => {
        const row = event.points[0].customdata;
        if (row !== undefined && flights.has(row)) location.hash = `flight-${row}`;
      });
    });
  }

  // The flights are deflated, some together: packed.py says how. Blocks are unpacked when one of them is opened.
  const order = content.flights.rows, together = content.flights.together, unpacked = new Map();
  const flights = new Map(order.map((row, place) => [row, place]));
  let current = -1;

  async function inflate(text) {
    const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }

  function unpack(bytes) {
    const length = new DataView(bytes.buffer).getUint32(0, true);
    let next = 4 + length;
    const column = ([, size, low, step, logarithmic]) => {
      const values = new Array(size);
      for (let i = 0, level = 0; i < size; i++) {
        level = (level + bytes[next + i] + 256 * bytes[next + size + i]) & 65535;
        const value = low + step * level;
        values[i] = level === 65535 ? null : Number((logarithmic ? 10 ** value : value).toPrecision(6));
      }
      next += 2 * size;
      return values;
    };
    return JSON.parse(new TextDecoder().decode(bytes.subarray(4, next))).map((flight) => ({
      ...flight,
      columns: Object.fromEntries(flight.columns.map((one) => [one[0], one.length === 2 ? one[1] : column(one)])),
    }));
  }

  async function load(row) {
    const place = flights.get(row), block = Math.floor(place / together);
    if (!unpacked.has(block)) unpacked.set(block, inflate(content.flights.blocks[block]).then(unpack));
    return (await unpacked.get(block))[place % together];
  }

  function element(name, text) {
    const made = document.createElement(name);
    if (text !== undefined) made.textContent = text;
    return made;
  }

  async function open(row) {
    const section = document.getElementById("flight");
    current = flights.get(row);
    section.hidden = false;
    if (!("DecompressionStream" in window)) {
      document.getElementById("flight-title").textContent = "This browser is too old to unpack flights: one of 2023 or later does.";
      return;
    }
    const flight = await load(row);
    if (current !== flights.get(row)) return;  // another was opened meanwhile
    const columns = { ...content.common, ...flight.columns };
    document.getElementById("flight-title").textContent = flight.title;
    document.getElementById("flight-facts").replaceChildren(...Object.entries(flight.facts).map(([name, value]) => {
      const fact = element("div");
      fact.append(element("dt", name), element("dd", value));
      return fact;
    }));
    const charts = document.getElementById("flight-charts");
    charts.querySelectorAll(".chart").forEach((place) => Plotly.purge(place));
    charts.replaceChildren();
    const drawn = [];  // once all figures are in their places
    for (const chart of content.templates) {
      const shown = chart.curves.filter((curve) => drawable(curve, columns));
      if (!shown.some((curve) => curve.label !== "")) continue;
      const figure = element("figure"), place = element("div");
      place.className = "chart";
      figure.append(element("h3", chart.title), place, element("figcaption", chart.caption));
      charts.append(figure);
      drawn.push([place, { ...chart, name: `flight-${row}-${chart.name}` }]);
    }
    drawn.forEach(([place, chart]) => draw(place, chart, columns));
    document.querySelectorAll(".flights a").forEach((link) => {
      if (link.hash !== `#flight-${row}`) link.removeAttribute("aria-current");
      else {
        link.setAttribute("aria-current", "true");
        link.closest("details").open = true;
      }
    });
    section.scrollIntoView();
  }

  function follow() {
    const found = /^#flight-(\d+)$/.exec(location.hash);
    if (found && flights.has(Number(found[1]))) open(Number(found[1]));
  }

  function step(by) {
    location.hash = `flight-${order[(current + by + order.length) % order.length]}`;
  }

  const charts = new Map(content.charts.map((chart) => [chart.name, chart]));

  // What is folded has no size to draw in: its charts wait until it is opened.
  function show(whole) {
    const places = [...whole.querySelectorAll("[data-chart]:not([data-begun])")];
    return Promise.all(places.filter((place) => !place.closest("details:not([open])")).map((place) => {
      const chart = charts.get(place.dataset.chart);
      place.dataset.begun = "yes";
      return draw(place, chart, chart.columns);
    }));
  }

  function unfold() {
    const target = document.getElementById(location.hash.slice(1));
    if (!(target instanceof HTMLDetailsElement)) return;
    target.open = true;
    target.scrollIntoView();
  }

  dark.addEventListener("change", () => document.querySelectorAll("[data-drawn]").forEach((place) => Plotly.relayout(place, inColours(place))));
  document.querySelectorAll("details").forEach((part) => part.addEventListener("toggle", () => show(part)));
  window.addEventListener("hashchange", unfold);
  unfold();
  show(document).then(() => {
    if (!document.getElementById("flight")) return;
    document.getElementById("previous").addEventListener("click", () => step(-1));
    document.getElementById("next").addEventListener("click", () => step(1));
    window.addEventListener("hashchange", follow);
    follow();
  });
})();
