//! What plays the pages: the controls below the picture, and the script that moves a place along the curve.

/// The button, the slider and the text of a page; `place` is what the slider is, to those who cannot see it.
pub(crate) fn controls(place: &str) -> String {
    format!(
        "<div class=\"controls\"><button id=\"play\">Pause</button>\
         <input id=\"time\" type=\"range\" min=\"0\" max=\"1\" step=\"0.001\" value=\"0\" aria-label=\"{place}\"/>\
         <output id=\"says\"></output></div>\n"
    )
}

/// The script that plays. The script of the page stands behind it: it says what `show` draws at the place `at`, from 0 to 1, in how many `seconds` that
/// goes from end to end, and calls `start`. `around` gives the frames before and behind the place, and how far it is from one to the other.
///
/// No sign of it is one that XML reads: neither a left angle bracket nor an ampersand.
pub(crate) const PLAYER: &str = r#"
const slider = document.getElementById('time'), play = document.getElementById('play'), says = document.getElementById('says');
const dot = document.getElementById('dot');
let playing = true, before = null, at = 0;
function around(frames) {
  let to = frames.findIndex(frame => frame.t >= at);
  if (0 > to) to = frames.length - 1;
  if (1 > to) to = 1;
  const a = frames[to - 1], b = frames[to];
  return [a, b, b.t > a.t ? Math.min(1, Math.max(0, (at - a.t) / (b.t - a.t))) : 1];
}
function step(now) {
  if (playing) {
    if (before !== null) at += (now - before) / 1000 / seconds;
    if (at > 1.06) at = 0;
    show();
    slider.value = at;
  }
  before = now;
  requestAnimationFrame(step);
}
play.onclick = () => { playing = !playing; play.textContent = playing ? 'Pause' : 'Play'; };
slider.oninput = () => { playing = false; play.textContent = 'Play'; at = Number(slider.value); show(); };
function start() {
  show();
  requestAnimationFrame(step);
}
"#;
