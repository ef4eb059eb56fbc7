"""First peaks of a strip as a plane solid, by a p-version finite element program of its own: against the library's.

    .venv/bin/python verification/solid.py            # writes solid.csv, every row by its second mesh, which is the finer one, and prints both
    .venv/bin/python verification/solid.py --check    # the same against the committed table; exit 1 on a mismatch
    .venv/bin/python verification/solid.py --check --quick    # one row on its first mesh

Shared with the crate are the equations alone. Displacements are nodal polynomials on Gauss-Lobatto points; the tangent is that of the energy,
assembled as a sparse matrix and factorised by SuperLU. The displacement of the grip is prescribed, the force is its multiplier, and the peak is the
root of dP/du, of the same factors. A Neo-Hookean strip of 40 nm x 10 nm, E = 2 GPa, nu = 0.2, in plane stress or plane strain; the half space has
A_H = 1e-19 J, r0 = 0.4 nm, and its traction acts on the reference length of the lower face. Units nm and nN.
"""
import argparse
import csv
import pathlib
import sys

import numpy as np
from numpy.polynomial import legendre
from scipy.sparse import csc_matrix, diags
from scipy.sparse.linalg import splu

TABLE = pathlib.Path(__file__).with_suffix(".csv")
E, NU, A_H, R0, HEIGHT, LENGTH = 2.0, 0.2, 0.1, 0.4, 10.0, 40.0
MU, LAM = E / 2 / (1 + NU), E * NU / (1 + NU) / (1 - 2 * NU)
CASES = [("rigid", "stress"), ("parabolic", "stress"), ("parabolic", "strain")]
MESHES = [(6, 3.3, 0.25, 3), (6, 2.5, 0.30, 3)]                # order, size, ratio of the cuts to the grip, how many
TOLERANCE = 1e-5                                              # of the force between two meshes, and of a check


def lobatto(order):
    """Points and derivative-ready basis: coefficients of the Lagrange polynomials in Legendre's."""
    inner = legendre.legroots(legendre.legder([0] * order + [1])) if order > 1 else []
    points = np.concatenate([[-1.0], np.sort(inner), [1.0]])
    return points, np.linalg.inv(legendre.legvander(points, order))


def at(coefficients, t):
    order = len(coefficients) - 1
    slope = np.array([legendre.legval(t, legendre.legder(np.eye(order + 1)[k])) for k in range(order + 1)]).T
    return legendre.legvander(t, order) @ coefficients, slope @ coefficients


class Strip:
    def __init__(self, grip, plane, order, size, ratio, cuts):
        self.grip, self.plane = grip, plane
        n, rows = round(LENGTH / size), max(2, round(HEIGHT / size))
        graded = [size * ratio**k for k in range(1, cuts + 1)]
        x = np.sort([LENGTH * k / n for k in range(n + 1)] + [LENGTH - c for c in graded])
        y = np.sort([HEIGHT * k / rows for k in range(rows + 1)] + graded + [HEIGHT - c for c in graded])
        points, basis = lobatto(order)
        place = lambda cuts: np.concatenate([cuts[:1], *(a + (b - a) * (points[1:] + 1) / 2 for a, b in zip(cuts, cuts[1:]))])
        self.x, self.y = place(x), place(y)
        self.ny = len(self.y)
        self.nodes = len(self.x) * self.ny
        local = np.arange(order + 1)
        t, w = legendre.leggauss(order + 2)
        value, slope = at(basis, t)
        grids, dx, dy, weight = [], [], [], []
        for i, (a, b) in enumerate(zip(x, x[1:])):
            for j, (c, d) in enumerate(zip(y, y[1:])):
                grids.append(((i * order + local)[:, None] * self.ny + j * order + local).ravel())
                dx.append(np.einsum("pi,qj->pqij", slope * 2 / (b - a), value).reshape(len(t) ** 2, -1))
                dy.append(np.einsum("pi,qj->pqij", value, slope * 2 / (d - c)).reshape(len(t) ** 2, -1))
                weight.append(np.outer(w, w).ravel() * (b - a) * (d - c) / 4)
        self.element = np.array(grids)
        self.gradient, self.weight = np.array([dx, dy]), np.array(weight)
        t, w = legendre.leggauss(order + 10)
        self.face_value = at(basis, t)[0]
        self.face = np.array([(i * order + local) * self.ny for i in range(len(x) - 1)])
        self.face_weight = np.array([w * (b - a) / 2 for a, b in zip(x, x[1:])])
        # mean of u_y over the end face with the weight of a parabolic traction
        self.mean = np.zeros(self.ny)
        for j, (c, d) in enumerate(zip(y, y[1:])):
            height = c + (d - c) * (t + 1) / 2 - HEIGHT / 2
            parabola = 1.5 / HEIGHT * (1 - 4 * height**2 / HEIGHT**2) * w * (d - c) / 2
            self.mean[j * order : (j + 1) * order + 1] += parabola @ self.face_value

    def material(self, f):
        """P and dP/dF of F = (11, 12, 21, 22), at many points."""
        j = f[0] * f[3] - f[1] * f[2]
        cof = np.array([f[3], -f[2], -f[1], f[0]])
        log, across = np.log(j), np.zeros_like(j)
        if self.plane == "stress":
            for _ in range(30):
                across -= (MU * np.expm1(2 * across) + LAM * (log + across)) / (2 * MU * np.exp(2 * across) + LAM)
        c = LAM * (log + across) - MU
        square = 2 * MU * np.exp(2 * across)
        slope = LAM / j * (square / (square + LAM) if self.plane == "stress" else 1.0)
        tangent = (slope / j - c / j**2) * cof[:, None] * cof[None, :]
        for a in range(4):
            tangent[a, a] += MU
            tangent[a, 3 - a] += c / j * (1 if a in (0, 3) else -1)
        return MU * f + c / j * cof, tangent

    def assembled(self, u):
        """Residual and tangent of all nodes; u is (nodes, 2)."""
        own = u[self.element]
        f = np.einsum("leqn,eni->ileq", self.gradient, own).reshape(4, *self.weight.shape)
        f[0] += 1
        f[3] += 1
        stress, tangent = self.material(f)
        stress = (stress * self.weight).reshape(2, 2, *self.weight.shape)
        tangent = (tangent * self.weight).reshape(2, 2, 2, 2, *self.weight.shape)
        r = np.zeros((self.nodes, 2))
        np.add.at(r, self.element, np.einsum("ijeq,jeqn->eni", stress, self.gradient))
        carried = np.einsum("ijkleq,leqm->ijkeqm", tangent, self.gradient)
        k = np.einsum("jeqn,ijkeqm->enimk", self.gradient, carried, optimize=True)
        dofs = (2 * self.element[:, :, None] + np.arange(2)).reshape(len(self.element), -1)
        size = dofs.shape[1]
        rows, columns = np.repeat(dofs, size, axis=1).ravel(), np.tile(dofs, (1, size)).ravel()
        # the ground
        gap = R0 * 15 ** (-1 / 6) + u[self.face][:, :, 1] @ self.face_value.T
        q = R0 / gap
        traction = A_H / (2 * np.pi * R0**3) * (q**9 / 45 - q**3 / 3)
        density = A_H / (2 * np.pi * R0**4) * (q**10 / 5 - q**4)
        np.add.at(r[:, 1], self.face, -(traction * self.face_weight) @ self.face_value)
        stiff = np.einsum("eq,qn,qm->enm", density * self.face_weight, self.face_value, self.face_value)
        faces = 2 * self.face + 1
        m = faces.shape[1]
        rows = np.concatenate([rows, np.repeat(faces, m, axis=1).ravel()])
        columns = np.concatenate([columns, np.tile(faces, (1, m)).ravel()])
        values = np.concatenate([k.reshape(-1), stiff.ravel()])
        return r.ravel(), csc_matrix((values, (rows, columns)), shape=(2 * self.nodes,) * 2)

    def map(self, z):
        """Displacements of all nodes by the unknowns, their derivative, and the direction of u in the unknowns."""
        inside = 2 * (self.nodes - self.ny)
        if self.grip == "parabolic":
            weight = np.zeros(2 * self.nodes)
            weight[inside + 1 :: 2] = self.mean
            return z, diags([np.ones(len(z))], [0], format="csc"), weight, None
        h = self.y - HEIGHT / 2
        (xc, yc, theta), s, c = z[inside:], np.sin(z[-1]), np.cos(z[-1])
        full = np.concatenate([z[:inside], np.stack([xc - h * s, yc + h * (c - 1)], axis=1).ravel()])
        a, b, ones = inside + 2 * np.arange(self.ny), inside + 2 * np.arange(self.ny) + 1, np.ones(self.ny)
        rows = np.concatenate([np.arange(inside), a, a, b, b])
        columns = np.concatenate([np.arange(inside), np.repeat([inside, inside + 2, inside + 1, inside + 2], self.ny)])
        values = np.concatenate([np.ones(inside), ones, -h * c, ones, -h * s])
        weight = np.zeros(inside + 3)
        weight[inside + 1] = 1
        return full, csc_matrix((values, (rows, columns)), shape=(2 * self.nodes, inside + 3)), weight, (a, b, h, s, c)

    def solved(self, z, force, u):
        """The equilibrium at u, and dP/du there."""
        for _ in range(25):
            full, jacobian, weight, turned = self.map(z)
            r, k = self.assembled(full.reshape(-1, 2))
            if turned:
                a, b, h, s, c = turned
                curvature = h @ (r[a] * s - r[b] * c)
            r, k = jacobian.T @ r, (jacobian.T @ k @ jacobian).tolil()
            if turned:
                k[-1, -1] += curvature
            k[0, :] = 0
            k[0, 0] = 1
            r[0] = z[0]                                       # x of the lower left corner stays
            lu = splu(k.tocsc())
            by_force, by_residual = lu.solve(weight), lu.solve(r - force * weight)
            change = (u - weight @ z + weight @ by_residual) / (weight @ by_force)
            step = change * by_force - by_residual
            z, force = z + step, force + change
            if np.abs(step).max() < 1e-11:
                return z, force, 1 / (weight @ by_force)
        raise RuntimeError("Newton's method did not converge")

    def peak(self):
        size = 2 * self.nodes if self.grip == "parabolic" else 2 * (self.nodes - self.ny) + 3
        z, force, ends = np.zeros(size), 0.0, []
        for u in [0.03, 0.08, 0.15, 0.22, 0.28, 0.32, 0.35, 0.38]:
            z, force, slope = self.solved(z, force, u)
            ends = (ends + [(u, slope, z, force)])[-2:]
            if slope < 0:
                break
        for _ in range(12):
            (u0, s0, *_), (u1, s1, z1, force1) = ends
            u = u1 - s1 * (u1 - u0) / (s1 - s0)
            z, force, slope = self.solved(z1, force1, u)
            ends = [ends[1], (u, slope, z, force)]
            if abs(u - u1) < 1e-6:
                return force, u
        raise RuntimeError("the peak was not located")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    rows, wrong = [], 0
    known = {}
    if options.check:
        known = {(row["grip"], row["plane"]): float(row["peak_force_nN"]) for row in csv.DictReader(TABLE.open())}
    for grip, plane in CASES[1:2] if options.quick else CASES:
        found = [Strip(grip, plane, *mesh).peak() for mesh in (MESHES[:1] if options.quick else MESHES)]
        apart = abs(found[-1][0] / found[0][0] - 1)
        print(grip, plane, *(f"{force:.8f} nN at {u:.5f} nm" for force, u in found), f"apart {apart:.1e}", flush=True)
        wrong += apart > TOLERANCE
        if options.check:
            wrong += abs(found[0][0] / known[grip, plane] - 1) > TOLERANCE
        rows.append([grip, plane, f"{found[-1][0]:.6f}", f"{found[-1][1]:.4f}"])
    if not options.check:
        with TABLE.open("w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["grip", "plane", "peak_force_nN", "peak_displacement_nm"])
            writer.writerows(rows)
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
