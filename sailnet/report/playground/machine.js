// The flight file and the plant, as they were compiled to WebAssembly: structures by their members' names, one flight.
"use strict";

// What browser_layout tells: of each structure its size, and of each member its type, offset and size; of each
// enumeration its numbers by name.
class Structures {
  static READERS = {
    double: (view, at) => view.getFloat64(at, true), int32_t: (view, at) => view.getInt32(at, true),
    uint32_t: (view, at) => view.getUint32(at, true), uint64_t: (view, at) => view.getBigUint64(at, true),
  };
  static WRITERS = {
    double: (view, at, value) => view.setFloat64(at, value, true), int32_t: (view, at, value) => view.setInt32(at, value, true),
    uint32_t: (view, at, value) => view.setUint32(at, value, true),
    uint64_t: (view, at, value) => view.setBigUint64(at, BigInt(value), true),
  };
  static SIZES = { double: 8, int32_t: 4, uint32_t: 4, uint64_t: 8 };

  constructor(text) {
    this.sizes = {};
    this.members = {};
    for (const line of text.trim().split("\n")) {
      const [owner, name, type, offset, size] = line.split(",");
      if (name === "") {
        this.sizes[owner] = Number(size);
        this.members[owner] = {};
      } else this.members[owner][name] = { type, offset: Number(offset), size: Number(size) };
    }
  }

  // Names of an enumeration by their numbers.
  names(owner) {
    return Object.fromEntries(Object.entries(this.members[owner]).map(([name, { offset }]) => [offset, name]));
  }

  write(view, owner, at, values) {
    for (const [name, { type, offset, size }] of Object.entries(this.members[owner])) {
      const value = values[name];
      if (value === undefined) throw new Error(`the page says nothing of ${owner}.${name}`);
      if (this.members[type]) this.write(view, type, at + offset, value);
      else [value].flat().forEach((one, i) => Structures.WRITERS[type](view, at + offset + i * Structures.SIZES[type], one));
    }
  }

  // The members that are single numbers; those of a structure within it by its name.
  read(view, owner, at) {
    const values = {};
    for (const [name, { type, offset, size }] of Object.entries(this.members[owner])) {
      if (this.members[type]) values[name] = this.read(view, type, at + offset);
      else if (size === Structures.SIZES[type]) values[name] = Structures.READERS[type](view, at + offset);
    }
    return values;
  }

  // Append a member of structures side by side to a column. Most are doubles, of which there are thousands.
  append(view, owner, at, count, name, column) {
    const { type, offset } = this.members[owner][name], size = this.sizes[owner];
    if (type === "double" && (at + offset) % 8 === 0 && size % 8 === 0) {
      const numbers = new Float64Array(view.buffer, at + offset, ((count - 1) * size) / 8 + 1);
      for (let i = 0; i < numbers.length; i += size / 8) column.push(numbers[i]);
    } else {
      const read = Structures.READERS[type];
      for (let i = 0; i < count; i++) column.push(read(view, at + offset + i * size));
    }
  }
}

const COLUMNS = ["time", "r", "theta", "u", "v", "cone_angle", "attitude", "beta", "beta_estimate", "time_of_flight", "status"];

async function startMachine(bytes) {
  const { instance } = await WebAssembly.instantiate(bytes, {});
  const c = instance.exports, view = () => new DataView(c.memory.buffer);
  c._initialize();
  const text = new Uint8Array(c.memory.buffer, c.browser_layout());
  const structures = new Structures(new TextDecoder().decode(text.slice(0, text.indexOf(0))));
  const endings = structures.names("plant_ending"), statuses = structures.names("plant_status");

  // One flight: the sail at its end, and columns of a number a guidance period.
  function fly(rules, [r, u, v]) {
    structures.write(view(), "plant_rules", c.browser_rules(), rules);
    if (!c.browser_depart(r, u, v)) throw new Error("the delay is too many guidance periods");
    const columns = Object.fromEntries(COLUMNS.map((name) => [name, []]));
    for (let periods; (periods = c.browser_fly()) > 0;) {
      for (const name of COLUMNS) structures.append(view(), "plant_record", c.browser_records(), periods, name, columns[name]);
    }
    const sail = structures.read(view(), "plant_sail", c.browser_sail());
    return { sail, ending: endings[sail.ending], columns, statuses };
  }

  // One command of the law alone: its status, and the command's members.
  function guidance(r, u, v, beta) {
    const status = c.browser_guidance(r, u, v, beta);
    return { status: statuses[status], ...structures.read(view(), "plant_command_f64", c.browser_command()) };
  }

  return { fly, guidance };
}
