// The page: what is set flies at once, and is drawn, told and put into the command that repeats it.
"use strict";
(async () => {
  const content = JSON.parse(document.getElementById("content").textContent);
  const byId = (id) => document.getElementById(id);
  if (!("DecompressionStream" in window)) {
    byId("verdict").textContent = "This browser is too old for this page: one of 2023 or later flies.";
    return;
  }
  const module = Uint8Array.from(atob(byId("module").textContent), (letter) => letter.charCodeAt(0));
  const [machine, optima] = await Promise.all([startMachine(module), openOptima(content.optima, extremal)]);
  const orbit = orbitView(byId("orbit")), { units, rules } = content;
  const numbers = ["r", "u", "v", "bias", "noise", "delay", "period", "seed"], periods = content.periods;
  const first = { ...content.first };
  let now = { ...first }, waiting = false;

  // What a link to this page may say after its #.
  for (const [name, value] of new URLSearchParams(location.hash.slice(1))) {
    if (name === "optics" ? value in content.optics : numbers.includes(name) && value !== "" && Number.isFinite(Number(value))) {
      now[name] = name === "optics" ? value : Number(value);
    }
  }

  const fixed = (number, digits) => number.toFixed(digits).replace(/^-(?=[0.]*$)/, "").replace("-", "−");
  const days = (time) => `${fixed(time * units.days, time * units.days < 100 ? 1 : 0)} days`;
  const lasting = (time) => (time * units.days < 2 ? `${fixed(time * units.days * 24, 1)} h` : days(time));
  const figures = (number) => number.toLocaleString("en", { maximumSignificantDigits: 3 });
  const percent = (share) => `${share > 0 ? "+" : ""}${fixed(100 * share, 0)} %`;
  const told = {
    r: (value) => `${fixed(value, 2)} AU`, u: (value) => `${fixed(value * units.kilometres_per_second, 1)} km/s`,
    v: (value) => `${fixed(value * units.kilometres_per_second, 1)} km/s`,
    bias: percent, noise: (value) => `±${fixed(100 * value, 0)} %`, delay: lasting, period: lasting,
  };

  // A setting from a slider: the period's counts through those that there are.
  const fromSlider = (name, value) => (name === "period" ? periods[value] : Number(value));
  const toSlider = (name, value) => (name === "period" ? periods.indexOf(periods.reduce((a, b) => (Math.abs(b - value) < Math.abs(a - value) ? b : a))) : value);

  function keepWithin() {
    for (const name of numbers) {
      const input = byId(`set-${name}`);
      input.value = toSlider(name, now[name]);
      now[name] = fromSlider(name, input.value);
      const output = document.querySelector(`output[for="set-${name}"]`);
      if (output) output.textContent = told[name](now[name]);
      if (output) input.setAttribute("aria-valuetext", output.textContent);
    }
    byId("set-optics").value = now.optics;
    byId("position").setAttribute("aria-valuenow", now.r);
    byId("position").setAttribute("aria-valuetext", `r ${told.r(now.r)}`);
    byId("velocity").setAttribute("aria-valuenow", now.v);
    byId("velocity").setAttribute("aria-valuetext", `u ${told.u(now.u)}, v ${told.v(now.v)}`);
  }

  function fly() {
    waiting = false;
    keepWithin();
    const start = [now.r, now.u, now.v], before = performance.now();
    const flight = machine.fly({ ...rules, period: now.period, beta_bias: now.bias, beta_noise: now.noise, delay: now.delay,
                                 seed: now.seed, optics: content.optics[now.optics] }, start);
    const flown = performance.now() - before;
    const nominal = optima.trajectory(start), own = optima.time(start, 1 + now.bias);
    orbit.draw(flight, nominal, start, content.orbits);
    drawCharts(flight, nominal);
    tell(flight, own, flown);
    const shown = performance.now() - before;
    byId("flight").dataset.shown = shown;
    byId("milliseconds").textContent = `Flown in ${fixed(flown, 0)} ms, drawn in ${fixed(shown - flown, 0)} ms.`;
  }

  function drawCharts({ columns, sail }, nominal) {
    const time = columns.time, end = [...time, sail.time], bound = content.bound, degrees = (angle) => (angle * 180) / Math.PI;
    const held = (values) => [...values, values.at(-1)], flat = (value) => ({ x: [0, sail.time], y: [value, value], kind: "bound" });
    drawCurves(byId("cone"), [flat(bound), flat(-bound),
      ...(nominal ? [{ x: nominal.time, y: nominal.cone_angle.map(degrees), kind: "optimum" }] : []),
      { x: end, y: held(columns.attitude).map(degrees), kind: "flown", steps: true },
    ], { low: -1.1 * bound, high: 1.1 * bound, at: [-60, -30, 0, 30, 60], unit: "time [TU]" });
    const share = (beta) => 100 * (beta / rules.beta - 1);
    drawCurves(byId("beta"), [{ x: end, y: held(columns.beta).map(share), kind: "real", steps: true },
      { x: time, y: columns.beta_estimate.map(share), kind: "flown" }], { low: -5, high: 5, unit: "time [TU]" });
    drawCurves(byId("left"), [...(nominal ? [{ x: [0, nominal.time.at(-1)], y: [nominal.time.at(-1), 0], kind: "optimum" }] : []),
      { x: time, y: columns.time_of_flight, kind: "flown" }], { low: 0, high: 1, unit: "time [TU]" });
  }

  function tell({ sail, ending, columns, statuses }, own, flown) {
    const errors = ["r", "u", "v"].map((name) => Math.abs(sail.state[name] - content.target[name]));
    const arrived = ending === "STOPPED" && errors.every((error) => error <= content.tolerance) && sail.max_cone_angle <= rules.bound;
    const words = { STOPPED: "Stopped off the target", LOST: "Lost", TOO_LONG: "Not there in time" };
    const outside = columns.status.filter((status) => statuses[status] === "OUTSIDE_DOMAIN").length;
    byId("verdict").textContent = arrived ? "Arrived" : words[ending];
    byId("verdict").className = arrived ? "good" : "bad";
    const per = units.kilometres_per_second * 1000;
    const more = own === null ? "no stored answer" : `${sail.time > own ? "+" : ""}${fixed(100 * (sail.time / own - 1), 2)} %`;
    const facts = {
      "flown-time": `${fixed(sail.time, 3)} TU, ${days(sail.time)}`,
      "best-time": own === null ? "no stored answer" : `${fixed(own, 3)} TU, ${days(own)}`,
      "above": arrived ? more : "did not arrive",
      "error-r": `${figures(errors[0] * units.kilometres)} km`,
      "error-uv": `${figures(errors[1] * per)} and ${figures(errors[2] * per)} m/s`,
      "reversals": `${sail.reversals}`,
      "estimate": `${fixed(100 * (sail.beta_estimate / rules.beta - 1), 1)} %, really ${percent(sail.beta_error)}`,
      "outside": `${outside} of ${sail.periods} periods`,
    };
    for (const [id, text] of Object.entries(facts)) byId(id).textContent = text;
    byId("whose-best").textContent = now.optics === "ideal" ? "shortest, of the sail that flew" : "shortest, of an ideal sail of this β";
    byId("command").textContent = command();
    Object.assign(byId("flight").dataset, {
      arrived: arrived ? "yes" : "no", time: sail.time, best: own ?? "", errors: errors.join(" "), reversals: sail.reversals,
      periods: sail.periods, estimate: sail.beta_estimate, milliseconds: flown,
    });
  }

  // What repeats the flight, with nothing that says what is so anyway.
  function command() {
    const options = [["beta-bias", now.bias, 0], ["beta-noise", now.noise, 0], ["optics", now.optics, "ideal"], ["delay", now.delay, 0],
                     ["period", now.period, first.period], ["seed", now.seed, 0]];
    const given = options.filter(([, value, off]) => value !== off).map(([name, value]) => ` --${name} ${value}`);
    return `sailnet fly ${now.r} ${now.u} ${now.v}${given.join("")}`;
  }

  let remembered;
  function change(changes) {
    Object.assign(now, changes);
    if (!waiting) requestAnimationFrame(fly);
    waiting = true;
    clearTimeout(remembered);
    remembered = setTimeout(() => history.replaceState(null, "", `#${new URLSearchParams(now)}`), 400);
  }

  for (const name of numbers) {
    byId(`set-${name}`).addEventListener("input", (event) => change({ [name]: fromSlider(name, event.target.value) }));
  }
  byId("set-optics").addEventListener("change", (event) => change({ optics: event.target.value }));
  byId("another").addEventListener("click", () => change({ seed: now.seed + 1 }));
  byId("reset").addEventListener("click", () => change(first));
  document.querySelectorAll("[data-start]").forEach((button) => button.addEventListener("click", () => {
    const [r, u, v] = JSON.parse(button.dataset.start);
    change({ r, u, v });
  }));
  byId("copy").addEventListener("click", async () => {
    await navigator.clipboard.writeText(byId("command").textContent);
    byId("copy").textContent = "Copied";
  });

  // The handles: a start is one of the grid, which is as fine as this picture.
  const rounded = (value) => Math.round(100 * value) / 100;
  const moves = {
    position: ([x]) => ({ r: rounded(x) }),
    velocity: ([x, y]) => ({ u: rounded((x - now.r) / SPEED), v: rounded(y / SPEED) }),
  };
  const keys = {
    position: { ArrowRight: ["r", 1], ArrowUp: ["r", 1], ArrowLeft: ["r", -1], ArrowDown: ["r", -1] },
    velocity: { ArrowRight: ["u", 1], ArrowUp: ["v", 1], ArrowLeft: ["u", -1], ArrowDown: ["v", -1] },
  };
  for (const [name, move] of Object.entries(moves)) {
    const handle = byId(name);
    handle.addEventListener("pointerdown", (event) => {
      handle.setPointerCapture(event.pointerId);
      handle.focus();
      event.preventDefault();
    });
    handle.addEventListener("pointermove", (event) => {
      if (handle.hasPointerCapture(event.pointerId)) change(move(orbit.where(event)));
    });
    handle.addEventListener("keydown", (event) => {
      const [what, by] = keys[name][event.key] ?? [];
      if (!what) return;
      event.preventDefault();
      change({ [what]: rounded(now[what] + by * (event.shiftKey ? 0.05 : 0.01)) });
    });
  }
  new ResizeObserver(() => change({})).observe(byId("orbit"));
  fly();
  byId("flight").dataset.ready = "yes";
})();
