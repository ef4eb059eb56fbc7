// The numbers of a run, of a peel, a seta or a pull at a rate, as a table and as a sentence.

/** A number with so many digits as a reader wants. */
export function shown(number, digits = 6) {
  const text = Number(number).toPrecision(digits);
  return text.includes('e') ? text : String(Number(text));
}

/** An error bound. */
function bound(error) {
  return error === null || error === undefined ? 'no error bound' : `± ${Number(error).toExponential(0)}`;
}

const ENDS = {
  detached: 'nothing adheres any more',
  'still-attached': 'what comes to rest still adheres',
  pivoting: 'still in edge contact',
  pushing: 'the grip pushes behind a snap-off',
  'turned-back': 're-adhered: u has returned to 0',
  sliding: 'the whole contact slides',
  snapped: 'it snaps off, with friction',
  'bonded-part-unstable': 'what is still bonded is unstable',
  'upright-section': 'a section stands upright',
  bound: 'stopped by a limit',
  refused: 'there is no stable state to start from',
  failed: 'the computation stopped short',
};

/** The rows of the table: name, place, errors. */
export function rows(summary) {
  const row = (name, at, error = at) => at && { name, u: at.displacement_nm, p: at.force_nN, du: error?.error_nm ?? error?.location_error_nm, dp: error?.error_nN ?? error?.location_error_nN };
  const mesh = summary.mesh_error && { error_nm: summary.mesh_error.displacement_nm, error_nN: summary.mesh_error.force_nN };
  return [
    row('Initiation peak', summary.initiation_peak),
    // the same point under its other name would be read twice
    summary.peak?.displacement_nm !== summary.initiation_peak?.displacement_nm && row('Peak', summary.peak, summary.tips ? mesh : summary.peak),
    row('Largest force', summary.largest_force),
    row('Peak of the equilibria', summary.equilibria_peak),
    row('First detachment', summary.first_detachment),
    row('Last detachment', summary.last_detachment),
    row('Largest computed force', summary.largest_computed_force),
    row('Plateau', summary.plateau),
    row('First jump', summary.first_jump),
    summary.pad_detachment?.displacement_nm !== summary.first_jump?.displacement_nm && row('Pad detachment', summary.pad_detachment),
    summary.detachment?.displacement_nm !== summary.first_jump?.displacement_nm && row('Detachment', summary.detachment),
  ].filter(Boolean);
}

/** Where the force is largest: the peak of a path, or the largest force of a pull at a rate. */
export function highest(summary) {
  return summary.peak ?? summary.largest_force ?? summary.largest_computed_force ?? null;
}

/** What is marked on the curve, with words. */
export function marks(summary, units) {
  const at = ({ u, p, du, dp }) => `u = ${inUnit(u, units.u)} ${bound(du && du / units.u.factor)} ${units.u.name}, P = ${inUnit(p, units.p)} ${bound(dp && dp / units.p.factor)} ${units.p.name}`;
  if (!summary.limit_points) return rows(summary).map((row) => ({ x: row.u, y: row.p, text: `${row.name}: ${at(row)}` }));
  return summary.limit_points.map(({ kind, displacement_nm: u, force_nN: p, error_nm: du, error_nN: dp }) => ({ x: u, y: p, text: `${kind} limit point: ${at({ u, p, du, dp })}` }));
}

/** A number of nm or nN in the unit that is shown. */
export function inUnit(number, { factor }, digits) {
  return shown(number / factor, digits);
}

/** Puts the numbers of a run on the page. */
export function show(summary, units) {
  const inScale = (error, { factor }) => (error === null || error === undefined ? error : error / factor);
  const cell = (number, error, unit) => {
    const cell = document.createElement('td');
    const small = document.createElement('small');
    small.textContent = bound(inScale(error, unit));
    cell.append(inUnit(number, unit), ' ', small);
    return cell;
  };
  document.getElementById('unit-u').textContent = units.u.name;
  document.getElementById('unit-p').textContent = units.p.name;
  const table = rows(summary).map(({ name, u, p, du, dp }) => {
    const row = document.createElement('tr');
    const head = document.createElement('th');
    head.scope = 'row';
    head.textContent = name;
    row.append(head, cell(u, du, units.u), cell(p, dp, units.p));
    return row;
  });
  const kendall = summary.derived?.kendall_force_nN ?? null;
  if (kendall !== null) {
    const row = document.createElement('tr');
    row.innerHTML = '<th scope="row">Kendall’s force</th><td>–</td><td></td>';
    row.lastChild.textContent = inUnit(kendall, units.p);
    table.push(row);
  }
  document.getElementById('numbers').replaceChildren(...table);
  const warnings = (summary.warnings ?? []).map((warning) => {
    const item = document.createElement('li');
    item.textContent = `Warning: ${warning.meaning}.`;
    return item;
  });
  document.getElementById('warnings').replaceChildren(...warnings);
}

/** How the run ended, for whom it ended short. */
export function ending(summary) {
  const end = ENDS[summary.end] ?? summary.end;
  return summary.reason ? `${end}: ${summary.reason}` : end;
}

/** The run in a sentence or two. */
export function sentence(summary, units) {
  const at = ({ displacement_nm, force_nN }) => `${inUnit(force_nN, units.p, 4)} ${units.p.name} at u = ${inUnit(displacement_nm, units.u, 4)} ${units.u.name}`;
  const parts = [];
  if (summary.tips && summary.peak) parts.push(`Peak ${at(summary.peak)}, where ${summary.peak.tips_attached} of ${summary.tips} tips adhere.`);
  else if (summary.peak) parts.push(`Peak ${at(summary.peak)}.`);
  else if (summary.largest_force) parts.push(`Largest force ${at(summary.largest_force)}.`);
  else if (summary.largest_computed_force) parts.push(`Largest computed force ${at(summary.largest_computed_force)}.`);
  if (summary.force_over_equilibria) parts.push(`That is ${shown(summary.force_over_equilibria, 3)} times the peak of the equilibria.`);
  if (summary.first_jump) parts.push(`First jump from ${at(summary.first_jump)}.`);
  parts.push(`End of the ${summary.limit_points ? 'path' : 'pull'}: ${ending(summary)}.`);
  return parts.join(' ');
}
