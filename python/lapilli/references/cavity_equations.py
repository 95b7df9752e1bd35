"""The discrete equations of cavity.py on one grid, and the iteration that solves them.

Central differences on nodes. Walls: psi = 0, Thom's vorticity -2 psi_1/h^2, T held or mirrored.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from scipy.sparse import block_array, csr_array, diags_array, eye_array, kron
from scipy.sparse.linalg import splu

from lapilli.references.arrays import Array
from lapilli.references.cavity_flow import Box, Flow, interpolate

MAX_STEPS = 80


class Equations:
    """Residual and Jacobian of the free nodal values: inner psi, inner omega, free T."""

    def __init__(self, box: Box, nx: int, ny: int) -> None:
        self.box = box
        self.x = np.linspace(0, box.size[0], nx + 1)
        self.y = np.linspace(0, box.size[1], ny + 1)
        self.h = box.size[0] / nx
        self.shape = (nx + 1, ny + 1)
        node = np.arange((nx + 1) * (ny + 1)).reshape(self.shape)
        inner = node[1:-1, 1:-1].ravel()
        held = np.zeros(self.shape, dtype=bool)
        axis = 0 if box.heated == "left" else 1
        np.moveaxis(held, axis, 0)[[0, -1]] = True
        wall_value = np.zeros(self.shape)
        np.moveaxis(wall_value, axis, 0)[0] = 1.0
        free = node[~held]

        identity = csr_array(eye_array(node.size))
        self.insert = csr_array(identity[:, inner])  # inner values -> nodes
        self.insert_heat = csr_array(identity[:, free])
        self.wall_temperature = wall_value.ravel()
        self.wall_vorticity = self._thom(node) @ self.insert
        gradient_x, gradient_y, laplace = self._differences()
        self.inner_x, self.inner_y, self.inner_laplace = (
            csr_array(operator[inner]) for operator in (gradient_x, gradient_y, laplace)
        )
        # velocity is zero on the walls: rows of wall nodes are blanked
        moving = diags_array(np.isin(free, inner).astype(float))
        self.heat_u = csr_array(moving @ gradient_y[free])
        self.heat_v = csr_array(-(moving @ gradient_x[free]))
        self.heat_x, self.heat_y = csr_array(gradient_x[free]), csr_array(gradient_y[free])
        self.heat_laplace = csr_array(laplace[free])
        self.size = (len(inner), len(free))

    def _differences(self) -> tuple[csr_array, csr_array, csr_array]:
        """Nodal d/dx, d/dy and Laplacian; beyond a wall the field is mirrored."""
        firsts, seconds = [], []
        for count in self.shape:
            off = np.ones(count - 1)
            second = diags_array([off, np.full(count, -2.0), off], offsets=[-1, 0, 1]).tolil()
            second[0, 1] = second[-1, -2] = 2.0
            first = diags_array([-off, off], offsets=[-1, 1]).tolil()
            first[0, 1] = first[-1, -2] = 0.0
            firsts.append(csr_array(first) / (2 * self.h))
            seconds.append(csr_array(second) / self.h**2)
        ones = [eye_array(count) for count in self.shape]
        return (
            csr_array(kron(firsts[0], ones[1])),
            csr_array(kron(ones[0], firsts[1])),
            csr_array(kron(seconds[0], ones[1]) + kron(ones[0], seconds[1])),
        )

    def _thom(self, node: npt.NDArray[np.int_]) -> csr_array:
        """Nodal stream function to wall vorticity -2 psi_1/h^2 (no slip), zero elsewhere."""
        wall = np.concatenate([node[0], node[-1], node[1:-1, 0], node[1:-1, -1]])
        near = np.concatenate([node[1], node[-2], node[1:-1, 1], node[1:-1, -2]])
        values = np.full(len(wall), -2 / self.h**2)
        return csr_array((values, (wall, near)), shape=(node.size, node.size))

    def guess(self) -> Array:
        """Conduction with a weak circulation: one cell, or `rolls` rolls for heating from below."""
        x, y = np.meshgrid(self.x, self.y, indexing="ij")
        width, height = self.box.size
        if self.box.heated == "left":
            stream = -(np.sin(np.pi * x / width) ** 2) * np.sin(np.pi * y / height) ** 2
            heat = 1 - x
        else:
            turn = np.pi * self.box.rolls * x / width
            stream = 3 * np.sin(turn) * np.sin(np.pi * y) ** 2
            heat = 1 - y - 0.2 * np.cos(turn) * np.sin(np.pi * y)
        return self._gather(stream, heat)

    def taken_from(self, flow: Flow) -> Array:
        """The fields of another solution, interpolated."""
        grid = np.stack(np.meshgrid(self.x, self.y, indexing="ij"), axis=-1).reshape(-1, 2)
        return self._gather(
            interpolate(flow, flow.stream, grid), interpolate(flow, flow.temperature, grid)
        )

    def _gather(self, stream: Array, heat: Array) -> Array:
        psi = self.insert.T @ stream.ravel()
        omega = -(self.inner_laplace @ (self.insert @ psi))
        return np.concatenate([psi, omega, self.insert_heat.T @ heat.ravel()])

    def nodal(self, unknowns: Array) -> tuple[Array, Array, Array]:
        """Stream function, vorticity and temperature on all nodes (flat)."""
        n = self.size[0]
        psi, omega = unknowns[:n], unknowns[n : 2 * n]
        return (
            self.insert @ psi,
            self.insert @ omega + self.wall_vorticity @ psi,
            self.insert_heat @ unknowns[2 * n :] + self.wall_temperature,
        )

    def residual(self, unknowns: Array) -> tuple[Array, csr_array]:
        """The three steady equations (the second over Pr) and their Jacobian."""
        psi, omega, heat = self.nodal(unknowns)
        ra, pr = self.box.rayleigh, self.box.prandtl
        u, v = self.inner_y @ psi, -(self.inner_x @ psi)
        omega_x, omega_y = self.inner_x @ omega, self.inner_y @ omega
        heat_u, heat_v = self.heat_u @ psi, self.heat_v @ psi
        heat_x, heat_y = self.heat_x @ heat, self.heat_y @ heat
        value = np.concatenate(
            [
                self.inner_laplace @ psi + self.insert.T @ omega,
                (u * omega_x + v * omega_y) / pr
                - self.inner_laplace @ omega
                - ra * (self.inner_x @ heat),
                heat_u * heat_x + heat_v * heat_y - self.heat_laplace @ heat,
            ]
        )
        transport = (
            diags_array(u) @ self.inner_x + diags_array(v) @ self.inner_y
        ) / pr - self.inner_laplace
        turned = (
            diags_array(omega_x) @ self.inner_y - diags_array(omega_y) @ self.inner_x
        ) @ self.insert / pr + transport @ self.wall_vorticity
        carried = diags_array(heat_x) @ self.heat_u + diags_array(heat_y) @ self.heat_v
        spread = (
            diags_array(heat_u) @ self.heat_x + diags_array(heat_v) @ self.heat_y
        ) - self.heat_laplace
        jacobian = block_array(
            [
                [self.inner_laplace @ self.insert, eye_array(self.size[0]), None],
                [turned, transport @ self.insert, -ra * (self.inner_x @ self.insert_heat)],
                [carried @ self.insert, None, spread @ self.insert_heat],
            ],
            format="csr",
        )
        return value, csr_array(jacobian)

    def solve(self, unknowns: Array) -> Flow:
        """Implicit pseudo-time steps that turn into Newton's method as the residual falls."""
        n = self.size[0]
        inertia = np.ones(len(unknowns))
        inertia[:n] = 0.0
        inertia[n : 2 * n] = 1 / self.box.prandtl
        value, jacobian = self.residual(unknowns)
        first = last = self._size_of(value)
        step = 0.05
        for _ in range(MAX_STEPS):
            if last < 1e-9:
                return self._flow(unknowns, last)
            matrix = (jacobian + diags_array(inertia / step)).tocsc()
            trial = unknowns - splu(matrix, permc_spec="COLAMD").solve(value)
            trial_value, trial_jacobian = self.residual(trial)
            now = self._size_of(trial_value)
            if now > 20 * last:
                step /= 10
                continue
            unknowns, value, jacobian = trial, trial_value, trial_jacobian
            step = min(1e12, step * min(10.0, max(0.5, last / now)) * (10 if now < 1e-3 else 1))
            last = now
        raise RuntimeError(
            f"no steady flow found for {self.box}: residual {last:.1e} of {first:.1e}"
        )

    def _size_of(self, value: Array) -> float:
        """Largest residual, each equation over the size of its terms."""
        n = self.size[0]
        scales = (1.0 + self.box.rayleigh, 1.0 + self.box.rayleigh, 1.0 / self.h)
        parts = (value[:n], value[n : 2 * n], value[2 * n :])
        return max(float(np.max(np.abs(p))) / s for p, s in zip(parts, scales, strict=True))

    def _flow(self, unknowns: Array, residual: float) -> Flow:
        psi, omega, heat = self.nodal(unknowns)
        return Flow(
            box=self.box,
            x=self.x,
            y=self.y,
            stream=psi.reshape(self.shape),
            vorticity=omega.reshape(self.shape),
            temperature=heat.reshape(self.shape),
            horizontal=(self.insert @ (self.inner_y @ psi)).reshape(self.shape),
            vertical=(self.insert @ -(self.inner_x @ psi)).reshape(self.shape),
            residual=residual,
        )
