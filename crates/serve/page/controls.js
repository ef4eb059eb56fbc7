// The keys of a scene as sliders, numbers and lists of words. Ranges come from the server, which has them from its list of keys.

/** The keys that stand first, where the scene has them. */
const FIRST = [
  'strip.length', 'strip.height', 'strip.youngs_modulus', 'strip.bending_stiffness_factor',
  'spatula.pad_length', 'spatula.pad_thickness', 'spatula.shaft_angle', 'spatula.youngs_modulus', 'spatula.bending_stiffness_factor',
  'seta.shaft_length', 'seta.shaft_angle', 'seta.brush_height', 'seta.diameter_ratio', 'time.rate',
  'adhesion.hamaker_constant', 'adhesion.equilibrium_distance', 'adhesion.work', 'adhesion.strength', 'adhesion.law', 'adhesion.line_load',
  'drive.angle', 'grip.rotation',
  'substrate.shape', 'substrate.height', 'substrate.wavelength', 'substrate.radius', 'substrate.offset',
];
/** Positions of a slider. */
const STEPS = 1000;
const DIGITS = 4;

function short(number) {
  return String(Number(number.toPrecision(DIGITS)));
}

function toPosition({ low, high, logarithmic }, value) {
  const share = logarithmic ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
  return Math.round(STEPS * Math.min(1, Math.max(0, share)));
}

function toValue({ low, high, logarithmic }, position) {
  const share = position / STEPS;
  return logarithmic ? low * (high / low) ** share : low + share * (high - low);
}

/** The controls of the page. `changed(key, text, isWord)` is called with the text of a value as a scene has it; null: as the scene gave it. */
export class Controls {
  constructor(first, others, changed) {
    Object.assign(this, { first, others, changed });
    this.ranges = new Map();
    this.set = new Map();
  }

  /** Marks the controls of the key whose value was refused, and no other. */
  markWrong(key) {
    for (const one of document.querySelectorAll('.control [aria-invalid]')) {
      one.removeAttribute('aria-invalid');
      one.removeAttribute('aria-errormessage');
    }
    if (key === null || key === undefined) return;
    for (const one of document.querySelectorAll(`.control[data-key="${CSS.escape(key)}"] :is(input, select)`)) {
      one.setAttribute('aria-invalid', 'true');
      one.setAttribute('aria-errormessage', 'problem');
    }
  }

  /** What takes a value back to that of the scene; it is there while another one is set. */
  reset({ key, about }, box) {
    const button = document.createElement('button');
    Object.assign(button, { type: 'button', textContent: '↺', title: 'As the scene has it', disabled: !this.set.has(key) });
    button.setAttribute('aria-label', `Reset ${about}`);
    button.addEventListener('click', () => {
      box.querySelector('input, select').focus();
      this.changed(key, null, false);
    });
    return button;
  }

  /** Forgets the ranges: another scene has others. */
  forget() {
    this.ranges.clear();
  }

  /** Shows these controls, of which these keys are set; what has the focus keeps it. */
  show(list, set) {
    this.set = set;
    const focused = document.activeElement?.id;
    const isFirst = ({ key, value }) => FIRST.includes(key) && value !== null;
    const order = ({ key }) => FIRST.indexOf(key);
    const first = list.filter(isFirst).sort((a, b) => order(a) - order(b));
    this.first.replaceChildren(...first.map((control) => this.one(control)));
    const others = [];
    let table = '';
    for (const control of list.filter((control) => !isFirst(control))) {
      const of = control.key.split('.')[0];
      if (of !== table) {
        table = of;
        const heading = document.createElement('h3');
        heading.textContent = of;
        others.push(heading);
      }
      others.push(this.one(control));
    }
    this.others.replaceChildren(...others);
    if (focused) document.getElementById(focused)?.focus();
  }

  one(control) {
    const box = document.createElement('div');
    box.className = 'control';
    box.dataset.key = control.key;
    const label = document.createElement('label');
    const small = document.createElement('small');
    small.textContent = control.key;
    label.append(control.about, small);
    label.htmlFor = `key-${control.key}`;
    const reset = this.reset(control, box);
    const change = (text, isWord) => {
      reset.disabled = false;
      this.changed(control.key, text, isWord);
    };
    box.append(label, ...(control.kind === 'choice' ? this.words(control, change) : this.number(control, box, change)), reset);
    return box;
  }

  words({ key, value, words }, change) {
    const select = document.createElement('select');
    select.id = `key-${key}`;
    for (const word of words) select.add(new Option(word, word, false, word === value));
    select.addEventListener('change', () => change(select.value, true));
    return [select];
  }

  number({ key, about, unit, value, slider, default: byDefault, range }, box, change) {
    const withUnit = (text) => (unit ? `${text} ${unit}` : text);
    const field = document.createElement('input');
    Object.assign(field, { type: 'text', inputMode: 'decimal', autocomplete: 'off' });
    field.value = value === null ? '' : short(value);
    field.placeholder = value === null ? byDefault : '';
    field.title = `${range}; default: ${byDefault}`;
    const sign = document.createElement('span');
    sign.textContent = unit;
    const range_ = this.range(key, value, slider);
    field.addEventListener('change', () => {
      const text = field.value.trim();
      // an emptied field is that of the scene again, and what was said of it is said no more
      if (text === '') return this.changed(key, null, false);
      const number = Number(text);
      if (range_ && Number.isFinite(number)) ruler.value = toPosition(range_, number);
      // one with a unit of its own is sent as it stands
      change(/[a-zµ]/i.test(text.replace(/e[+-]?\d/i, '')) ? text : withUnit(text), value === null);
    });
    if (!range_) {
      field.id = `key-${key}`;
      box.classList.add('plain');
      return [field, sign];
    }
    field.setAttribute('aria-label', `${about}, as a number${unit ? ` in ${unit}` : ''}`);
    const ruler = document.createElement('input');
    Object.assign(ruler, { type: 'range', min: 0, max: STEPS, step: 1, id: `key-${key}` });
    ruler.value = toPosition(range_, value);
    ruler.setAttribute('aria-valuetext', withUnit(field.value));
    ruler.addEventListener('input', () => {
      field.value = short(toValue(range_, Number(ruler.value)));
      ruler.setAttribute('aria-valuetext', withUnit(field.value));
      change(withUnit(field.value), false);
    });
    return [ruler, field, sign];
  }

  /** The range of a slider, which stays where it was as long as the value is in it. */
  range(key, value, slider) {
    const known = this.ranges.get(key);
    if (!slider || (known && value >= known.low && value <= known.high)) return slider && known;
    this.ranges.set(key, slider);
    return slider;
  }
}
