// The beam at one place of its path, over the ground, in SVG.

const MARGIN = 0.06;
const svg = document.getElementById('beam');

function element(name, attributes) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

const ground = element('polygon', { class: 'ground' });
const outline = element('polygon', { class: 'outline' });
svg.append(ground, outline);

/** Makes room for all places of a path; the y axis of SVG points down. */
export function prepare(poses) {
  if (poses.along.length === 0) {
    svg.hidden = true;
    return;
  }
  svg.hidden = false;
  let [left, right, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const { outline } of poses.along) {
    for (let k = 0; k < outline.length; k += 2) {
      left = Math.min(left, outline[k]);
      right = Math.max(right, outline[k]);
      bottom = Math.min(bottom, outline[k + 1]);
      top = Math.max(top, outline[k + 1]);
    }
  }
  const extent = Math.max(right - left, top - bottom);
  const margin = MARGIN * extent;
  const below = bottom - 2 * margin;
  svg.setAttribute('viewBox', `${left - margin} ${-top - margin} ${right - left + 2 * margin} ${top - below + margin}`);
  const surface = poses.ground;
  const corners = [];
  for (let k = 0; k < surface.length; k += 2) corners.push(`${surface[k]},${-surface[k + 1]}`);
  corners.push(`${surface.at(-2)},${-below + extent}`, `${surface[0]},${-below + extent}`);
  ground.setAttribute('points', corners.join(' '));
}

/** Draws the beam at one place. */
export function draw(pose) {
  const corners = [];
  for (let k = 0; k < pose.outline.length; k += 2) corners.push(`${pose.outline[k]},${-pose.outline[k + 1]}`);
  outline.setAttribute('points', corners.join(' '));
  outline.setAttribute('class', pose.unstable ? 'outline unstable' : 'outline');
}
