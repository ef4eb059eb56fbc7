"""Numbers computed on two levels of discretisation, and printed to the digits on which both agree."""
import math

LEVELS = (dict(N=32, n=10, goal=2e-2, fine=(24, 16, 1e-11)), dict(N=40, n=12, goal=1.2e-2, fine=(31, 20, 1e-12)))
THIRD = dict(N=48, n=14, goal=3e-3, fine=(36, 18, 1e-11), most=1500)
AGREED = 1e-5                                                         # what differs more than this is not printed


def same(p, q):
    """Whether two results are those of one path."""
    return all((p[k] is None) == (q[k] is None) and (p[k] is None or abs(p[k] - q[k]) <= 1e-6 * abs(q[k]) + 1e-14) for k in p)


def twice(compute):
    """compute(level) -> {name: number or None} on both levels: {name: (number, relative difference)} and remarks.

    Where the two disagree a third path with short steps decides.
    """
    a, b = compute(LEVELS[0]), compute(LEVELS[1])
    remarks = []
    if not same(a, b):
        third = compute(THIRD)
        remarks.append("third path")
        a, b = third, b if same(third, b) or not same(third, a) else a
    out = {}
    for k, q in b.items():
        p = a[k]
        if p is None and q is None:
            continue
        if p is None or q is None:
            remarks.append(f"{k}: not confirmed, {p} {q}")
            continue
        difference = abs(p - q) / max(abs(q), 1e-300) if p != q else 0.0
        if difference < AGREED:
            out[k] = (q, difference)
        else:
            remarks.append(f"{k}: the levels differ, {p!r} {q!r}")
    return out, remarks


def good(difference):
    """Significant digits that are good: three times the difference, never more than 12."""
    return 12 if difference < 3e-13 else max(1, min(12, int(math.floor(-math.log10(3.0 * difference)))))


def printed(value, difference):
    """A number to its good digits."""
    if value == 0.0:
        return "0"
    digits = good(difference)
    e = math.floor(math.log10(abs(value)))
    if e < -4:
        return f"{value:.{digits - 1}e}"
    return f"{value:.{max(0, digits - 1 - e)}f}"


def unit(text):
    """One unit of the last digit printed."""
    m, _, e = text.lower().partition("e")
    return 10.0 ** (int(e or 0) - (len(m.partition(".")[2])))


def off(text, value, relative=1e-9):
    """The relative difference of a value from a printed number where it is more than `relative` and than one unit of the last
    digit; else None."""
    reference = float(text)
    difference = abs(value - reference)
    if difference <= max(relative * abs(reference), 1.000001 * unit(text)):
        return None
    return difference / max(abs(reference), 1e-300)
