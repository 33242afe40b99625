// Draws the charts of a page, and opens flights one by one; everything it shows is in the element "content".
"use strict";
(() => {
  const content = JSON.parse(document.getElementById("content").textContent);

  function trace(curve, columns) {
    const made = {
      type: "scatter",
      x: columns[curve.x],
      y: columns[curve.y],
      name: curve.label,
      showlegend: curve.label !== "",
      hoverinfo: curve.label === "" ? "skip" : "all",
      mode: curve.kind === "points" ? "markers" : "lines",
    };
    if (curve.kind === "points") {
      made.marker = { color: curve.colour, size: curve.width };
    } else {
      made.line = { color: curve.colour, width: curve.width, dash: curve.dash ? "dash" : "solid",
                    shape: curve.kind === "steps" ? "hv" : "linear" };
    }
    if (curve.low) {
      const low = columns[curve.low], high = columns[curve.high];
      made.error_y = { type: "data", symmetric: false, color: curve.colour, thickness: 1.2, width: 4,
                       array: made.y.map((y, i) => high[i] - y), arrayminus: made.y.map((y, i) => y - low[i]) };
    }
    if (curve.link) made.customdata = columns[curve.link];
    return made;
  }

  function axis(title, logarithmic) {
    const made = { title: { text: title, standoff: 8 }, automargin: true, gridcolor: "#e6e6e6", zeroline: false,
                   linecolor: "#8c8c8c", ticks: "outside", tickcolor: "#8c8c8c" };
    if (logarithmic) Object.assign(made, { type: "log", exponentformat: "power" });
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

  function draw(place, chart, columns) {
    const curves = chart.curves.filter((curve) => columns[curve.x] && columns[curve.y]);
    const layout = {
      margin: { l: 56, r: 12, t: 30, b: 44 }, autosize: true, hovermode: "closest", dragmode: "zoom",
      font: { family: 'system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif', size: 12, color: "#1d2730" },
      xaxis: axis(chart.x, chart.logarithmic.includes("x")), yaxis: axis(chart.y, chart.logarithmic.includes("y")),
      legend: { orientation: "h", x: 0, yref: "container", y: 0, yanchor: "bottom", font: { size: 11 } },
      paper_bgcolor: "#fff", plot_bgcolor: "#fff",
    };
    // Many names need room of their own, or they would take it from the curves.
    const names = curves.filter((curve) => curve.label !== "").length;
    if (names > 4) place.style.height = `${24 + 1.15 * (names - 4)}rem`;
    if (chart.equal) layout.yaxis.scaleanchor = "x";
    if (chart.x_range) layout.xaxis.range = chart.x_range;
    const config = {
      responsive: true, displaylogo: false,
      modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"],
      toImageButtonOptions: { filename: chart.name, scale: 3 },
      modeBarButtonsToAdd: [{ name: "csv", title: "Save as CSV", icon: sheet, click: () => save(chart, columns) }],
    };
    return Plotly.newPlot(place, curves.map((curve) => trace(curve, columns)), layout, config).then(() => {
      place.dataset.drawn = "yes";
      place.on("plotly_click", (event) => {
        const row = event.points[0].customdata;
        if (row !== undefined && flights.has(row)) location.hash = `flight-${row}`;
      });
    });
  }

  const flights = new Map(content.flights.map((flight) => [flight.row, flight]));
  const order = content.flights.map((flight) => flight.row);
  let current = -1;

  function element(name, text) {
    const made = document.createElement(name);
    if (text !== undefined) made.textContent = text;
    return made;
  }

  function open(row) {
    const flight = flights.get(row), section = document.getElementById("flight");
    const columns = { ...content.common, ...flight.columns };
    current = order.indexOf(row);
    section.hidden = false;
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
      const shown = chart.curves.filter((curve) => columns[curve.x] && columns[curve.y]);
      if (!shown.some((curve) => curve.label !== "")) continue;
      const figure = element("figure"), place = element("div");
      place.className = "chart";
      figure.append(element("h3", chart.title), place, element("figcaption", chart.caption));
      charts.append(figure);
      drawn.push([place, { ...chart, name: `flight-${row}-${chart.name}` }]);
    }
    drawn.forEach(([place, chart]) => draw(place, chart, columns));
    document.querySelectorAll(".flights a").forEach((link) => {
      if (link.hash === `#flight-${row}`) link.setAttribute("aria-current", "true");
      else link.removeAttribute("aria-current");
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
  const places = [...document.querySelectorAll("[data-chart]")];
  Promise.all(places.map((place) => {
    const chart = charts.get(place.dataset.chart);
    return draw(place, chart, chart.columns);
  })).then(() => {
    if (!document.getElementById("flight")) return;
    document.getElementById("previous").addEventListener("click", () => step(-1));
    document.getElementById("next").addEventListener("click", () => step(1));
    window.addEventListener("hashchange", follow);
    follow();
  });
})();
