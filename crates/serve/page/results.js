// The numbers of a run, as a table and as a sentence.

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
  detached: 'the beam is off',
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
  const row = (name, at) => at && { name, u: at.displacement_nm, p: at.force_nN, du: at.error_nm, dp: at.error_nN };
  return [
    row('Initiation peak', summary.initiation_peak),
    // the same point under its other name would be read twice
    summary.peak?.displacement_nm !== summary.initiation_peak?.displacement_nm && row('Peak', summary.peak),
    row('Largest computed force', summary.largest_computed_force),
    row('Plateau', summary.plateau),
    row('First jump', summary.first_jump),
    summary.pad_detachment?.displacement_nm !== summary.first_jump?.displacement_nm && row('Pad detachment', summary.pad_detachment),
    summary.detachment?.displacement_nm !== summary.first_jump?.displacement_nm && row('Detachment', summary.detachment),
  ].filter(Boolean);
}

/** Puts the numbers of a run on the page. */
export function show(summary) {
  const cell = (number, error) => {
    const cell = document.createElement('td');
    const small = document.createElement('small');
    small.textContent = bound(error);
    cell.append(shown(number), ' ', small);
    return cell;
  };
  const table = rows(summary).map(({ name, u, p, du, dp }) => {
    const row = document.createElement('tr');
    const head = document.createElement('th');
    head.scope = 'row';
    head.textContent = name;
    row.append(head, cell(u, du), cell(p, dp));
    return row;
  });
  const kendall = summary.derived.kendall_force_nN;
  if (kendall !== null) {
    const row = document.createElement('tr');
    row.innerHTML = '<th scope="row">Kendall’s force</th><td>–</td><td></td>';
    row.lastChild.textContent = shown(kendall);
    table.push(row);
  }
  document.getElementById('numbers').replaceChildren(...table);
  const warnings = summary.warnings.map((warning) => {
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
export function sentence(summary) {
  const at = ({ displacement_nm, force_nN }) => `${shown(force_nN, 4)} nN at u = ${shown(displacement_nm, 4)} nm`;
  const parts = [];
  if (summary.peak) parts.push(`Peak ${at(summary.peak)}.`);
  else if (summary.largest_computed_force) parts.push(`Largest computed force ${at(summary.largest_computed_force)}.`);
  if (summary.first_jump) parts.push(`First jump from ${at(summary.first_jump)}.`);
  parts.push(`End of the path: ${ending(summary)}.`);
  return parts.join(' ');
}
