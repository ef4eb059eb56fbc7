// The beam at one place of its path, or the seta, over the ground, in SVG.

const MARGIN = 0.06;
/** The thinnest branch of a seta, over the extent of the picture. */
const THINNEST = 1 / 600;
const svg = document.getElementById('beam');

function element(name, attributes) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

const ground = element('polygon', { class: 'ground' });
const outline = element('polygon', { class: 'outline' });
const seta = element('g', { class: 'seta' });
svg.append(ground, seta, outline);
let thinnest = 1;

/** x and y in turn, as SVG has them: its y axis points down. */
function corners(places) {
  const texts = [];
  for (let k = 0; k < places.length; k += 2) texts.push(`${places[k]},${-places[k + 1]}`);
  return texts;
}

/** Makes room for all places of a path. Nothing is drawn of a run whose shapes are not known. */
export function prepare(poses) {
  let [left, right, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const { outline, branches = [] } of poses.along) {
    for (const places of [outline, ...branches.map(({ line }) => line)]) {
      for (let k = 0; k < places.length; k += 2) {
        left = Math.min(left, places[k]);
        right = Math.max(right, places[k]);
        bottom = Math.min(bottom, places[k + 1]);
        top = Math.max(top, places[k + 1]);
      }
    }
  }
  const isShown = left <= right;
  document.getElementById('shape').hidden = !isShown;
  if (!isShown) return;
  const extent = Math.max(right - left, top - bottom);
  const margin = MARGIN * extent;
  const below = bottom - 2 * margin;
  thinnest = THINNEST * extent;
  svg.setAttribute('viewBox', `${left - margin} ${-top - margin} ${right - left + 2 * margin} ${top - below + margin}`);
  const surface = poses.ground;
  const around = [...corners(surface), `${surface.at(-2)},${-below + extent}`, `${surface[0]},${-below + extent}`];
  ground.setAttribute('points', around.join(' '));
}

/** Draws the beam, or the seta, at one place. */
export function draw(pose) {
  outline.setAttribute('points', corners(pose.outline).join(' '));
  outline.setAttribute('class', pose.unstable ? 'outline unstable' : 'outline');
  seta.replaceChildren(...(pose.branches ?? []).map(({ line, diameter, attached }) => element('polyline', {
    class: attached ? 'branch' : 'branch detached',
    points: corners(line).join(' '),
    'stroke-width': Math.max(diameter, thinnest),
  })));
}
