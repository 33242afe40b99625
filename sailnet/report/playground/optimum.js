// The expert's stored answers: the shortest time from a start, and the optimal trajectory of the sail as assumed.
"use strict";

async function inflate(text) {
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// All first bytes of the numbers come first, then all second ones.
function fromPlanes(planes, size) {
  const count = planes.length / size, bytes = new Uint8Array(planes.length);
  for (let i = 0; i < count; i++) for (let k = 0; k < size; k++) bytes[i * size + k] = planes[k * count + i];
  return bytes.buffer;
}

async function openOptima(stored, motion) {
  const missing = 65535, axes = ["r", "u", "v"].map((name) => stored.axes[name]);
  const levels = new Uint16Array(fromPlanes(await inflate(stored.times), 2));
  const costates = new Float32Array(fromPlanes(await inflate(stored.costates), 4));
  const count = costates.length / 3, logarithms = stored.shares.map(Math.log);

  // Row of a start; it is one of the grid.
  function rowOf(start) {
    return axes.reduce((row, [first, last], i) => row * (last - first + 1) + Math.round(100 * start[i]) - first, 0);
  }

  // The shortest time [TU] of an ideal sail with this share of the assumed beta, or null where the expert has none:
  // Lagrange's polynomial through the logarithms of the stored times over that of beta.
  function time(start, share) {
    const at = Math.log(share), row = rowOf(start);
    let sum = 0;
    for (let i = 0; i < logarithms.length; i++) {
      const level = levels[i * count + row];
      if (level === missing) return null;
      let weight = 1;
      logarithms.forEach((other, k) => { if (k !== i) weight *= (at - other) / (logarithms[i] - other); });
      sum += weight * stored.step * level;
    }
    return stored.shortest * Math.exp(sum);
  }

  // The optimal trajectory, or null; the last is kept, for all but the start may change.
  let last = { row: -1 };
  function trajectory(start) {
    const row = rowOf(start);
    if (last.row !== row) last = { row, columns: propagated(start, row, time(start, 1)) };
    return last.columns;
  }

  // By Runge and Kutta's formula of order 4, in steps that only a drawing may take.
  function propagated(start, row, duration, steps = 1600) {
    if (duration === null) return null;
    const [l0, l1, l2] = costates.slice(3 * row, 3 * row + 3), h = duration / steps;
    const columns = { time: [], r: [], theta: [], cone_angle: [] };
    let y = [...start, l0, l1, l2, 0];
    for (let i = 0; i <= steps; i++) {
      if (i % 4 === 0) {
        columns.time.push(i * h);
        columns.r.push(y[0]);
        columns.theta.push(y[6]);
        columns.cone_angle.push(motion.angle(y));
      }
      const to = (by, k) => y.map((value, j) => value + by * k[j]);
      const k1 = motion.slopes(y), k2 = motion.slopes(to(h / 2, k1)), k3 = motion.slopes(to(h / 2, k2)), k4 = motion.slopes(to(h, k3));
      y = y.map((value, j) => value + (h / 6) * (k1[j] + 2 * k2[j] + 2 * k3[j] + k4[j]));
    }
    return columns;
  }

  return { time, trajectory };
}
