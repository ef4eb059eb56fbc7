// Units of lengths and forces: the one that fits the largest value that is shown.

/** Each a thousand times the one before it. */
const UNITS = { nm: ['pm', 'nm', 'µm', 'mm', 'm', 'km'], nN: ['pN', 'nN', 'µN', 'mN', 'N', 'kN'] };

/** The unit that fits a value: its own from 0.1 to 1000. `factor` is how much of its own one of it is. */
export function unitOf(base, largest) {
  const units = UNITS[base];
  const own = units.indexOf(base);
  const fits = !(largest > 0) || (largest >= 0.1 && largest < 1000);
  const index = fits ? own : Math.min(units.length - 1, Math.max(0, own + Math.floor(Math.log10(largest) / 3 + 1e-9)));
  return { name: units[index], factor: 1000 ** (index - own) };
}

/** The units of a curve: of its displacements and of its forces. */
export function unitsOf({ displacement_nm: u, force_nN: p }) {
  const largest = (values) => values.reduce((a, b) => Math.max(a, Math.abs(b)), 0);
  return { u: unitOf('nm', largest(u)), p: unitOf('nN', largest(p)) };
}

/** Names an axis with its unit, and writes the ticks in it. */
export function nameAxis(axis, words, { name, factor }) {
  axis.title.text = `${words} (${name})`;
  axis.ticks.callback = (value) => String(Number((value / factor).toPrecision(6)));
}
