// Small drawings in SVG: curves over time, and what the orbit's picture is made of.
"use strict";

function svg(name, attributes = {}, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

const short = (number) => Number(number.toFixed(2));

// Points of a line, "steps": held until the next. More of them than there are pixels cost time alone.
function line(xs, ys, steps = false, most = 1500) {
  const parts = [], every = Math.max(1, Math.floor(xs.length / most));
  for (let i = 0; i < xs.length; i += i < xs.length - every ? every : Math.max(1, xs.length - 1 - i)) {
    if (!Number.isFinite(ys[i])) continue;
    if (steps && parts.length) parts.push(`H${short(xs[i])}`);
    parts.push(`${parts.length ? "L" : "M"}${short(xs[i])} ${short(ys[i])}`);
  }
  return parts.join("");
}

// Round numbers between two, about as many as are asked for.
function ticks(low, high, about) {
  const raw = (high - low) / about, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((factor) => factor * power).find((one) => one >= raw - 1e-12 * power);
  const made = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) made.push(Number((i * step).toPrecision(12)));
  return made;
}

// Curves over time in an <svg>: {x, y, kind, steps} with kind the class that colours it; y may be a range or what is to
// be seen of it at least.
function drawCurves(place, curves, { low, high, at, unit }) {
  const width = Math.max(240, place.clientWidth), height = place.clientHeight || 200;
  const left = 44, right = width - 10, top = 10, bottom = height - 34;
  place.setAttribute("viewBox", `0 0 ${width} ${height}`);
  const last = Math.max(...curves.map((curve) => curve.x.at(-1)), 1e-9);
  for (const curve of curves) for (const value of curve.y) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  const x = (value) => left + ((right - left) * value) / last, y = (value) => bottom - ((bottom - top) * (value - low)) / (high - low);
  const parts = [];
  for (const value of at ?? ticks(low, high, 4)) {
    parts.push(svg("line", { class: "grid", x1: left, x2: right, y1: short(y(value)), y2: short(y(value)) }));
    parts.push(svg("text", { class: "tick", x: left - 6, y: short(y(value)) + 4, "text-anchor": "end" }, `${value}`));
  }
  for (const value of ticks(0, last, width < 340 ? 4 : 6)) {
    parts.push(svg("line", { class: "grid", x1: short(x(value)), x2: short(x(value)), y1: top, y2: bottom }));
    parts.push(svg("text", { class: "tick", x: short(x(value)), y: bottom + 15, "text-anchor": "middle" }, `${value}`));
  }
  parts.push(svg("text", { class: "tick", x: (left + right) / 2, y: height - 4, "text-anchor": "middle" }, unit));
  for (const curve of curves) {
    parts.push(svg("path", { class: `curve ${curve.kind}`, d: line(curve.x.map(x), curve.y.map(y), curve.steps) }));
  }
  place.replaceChildren(...parts);
}

// The picture of the orbit, X to the right and Y up, in AU, the Sun in the middle. The start is on the right.
const SPEED = 0.55;  // AU on the picture that stand for 1 AU/TU
const NORMALS = 26;

function orbitView(place) {
  let pixels = 1, reach = 1.8;
  const at = (x, y) => [x * pixels, -y * pixels];
  const around = (r, theta) => at(r * Math.cos(theta), r * Math.sin(theta));

  function path(columns, kind) {
    const points = columns.r.map((r, i) => around(r, columns.theta[i]));
    return svg("path", { class: `curve ${kind}`, d: line(points.map(([x]) => x), points.map(([, y]) => y)) });
  }

  // The sail's normal, along which an ideal sail is pushed; evenly in time.
  function normals({ r, theta, attitude }) {
    return Array.from({ length: NORMALS }, (_, k) => {
      const i = Math.floor(((k + 0.5) * r.length) / NORMALS), angle = theta[i] + attitude[i];
      const [x, y] = around(r[i], theta[i]), [dx, dy] = [12 * Math.cos(angle), -12 * Math.sin(angle)];
      const sail = `M${short(x - 0.42 * dy)} ${short(y + 0.42 * dx)}L${short(x + 0.42 * dy)} ${short(y - 0.42 * dx)}`;
      return svg("path", { class: "normal", d: `${sail}M${short(x)} ${short(y)}l${short(dx)} ${short(dy)}` });
    });
  }

  function draw(flight, optimum, start, orbits) {
    const farthest = Math.max(1.62, ...flight.columns.r.slice(0, 20000), ...(optimum?.r ?? []));
    reach = Math.min(6, 1.1 * farthest);
    const side = Math.max(240, place.clientWidth);
    pixels = side / (2 * reach);
    place.setAttribute("viewBox", `${-side / 2} ${-side / 2} ${side} ${side}`);
    const circle = (radius, kind) => svg("circle", { class: `orbit ${kind}`, r: short(radius * pixels) });
    const [x, y] = at(start[0], 0), [tx, ty] = at(start[0] + SPEED * start[1], SPEED * start[2]);
    const { sail } = flight, [ex, ey] = around(sail.state.r, sail.state.theta);
    const drawn = [circle(orbits.departure, "departure"), circle(orbits.target, "target"), svg("circle", { class: "sun", r: 9 })];
    if (optimum) drawn.push(path(optimum, "optimum"));
    drawn.push(path(flight.columns, "flown"), ...normals(flight.columns));
    drawn.push(svg("circle", { class: "end", cx: short(ex), cy: short(ey), r: 5 }));
    drawn.push(svg("line", { class: "velocity", x1: short(x), y1: short(y), x2: short(tx), y2: short(ty) }));
    place.querySelector(".drawn").replaceChildren(...drawn);
    for (const [name, hx, hy] of [["position", x, y], ["velocity", tx, ty]]) {
      place.querySelector(`#${name}`).setAttribute("transform", `translate(${short(hx)} ${short(hy)})`);
    }
  }

  // Where a pointer is, in AU.
  function where(event) {
    const box = place.getBoundingClientRect(), scale = (2 * reach) / box.width;
    return [(event.clientX - box.left - box.width / 2) * scale, (box.top + box.height / 2 - event.clientY) * scale];
  }

  return { draw, where };
}
