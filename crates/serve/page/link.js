// A link holds the whole scene behind its #, which a browser sends to nobody.

const SIGN = '#scene=';

/** The part of a link that holds a scene. */
export function written(scene) {
  const bytes = new TextEncoder().encode(JSON.stringify([scene.name, scene.title, scene.text]));
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
  return SIGN + btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** The scene of a link; null where it holds none, and an error where what it holds cannot be read. */
export function read(hash) {
  if (!hash.startsWith(SIGN)) return null;
  const letters = atob(hash.slice(SIGN.length).replaceAll('-', '+').replaceAll('_', '/'));
  const bytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
  const parts = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
  if (!Array.isArray(parts) || parts.length !== 3 || parts.some((part) => typeof part !== 'string')) {
    throw new Error('it has other parts');
  }
  const [name, title, text] = parts;
  return { name, title, text };
}
