"""Controls and switching functions as series: from coefficients to controls at the points of a flight."""

from dataclasses import dataclass

import numpy as np

from sailnet.errors import SailnetError
from sailnet.ocp.definition.canonical import canonical
from sailnet.ocp.definition.problem import Bounded, Direction, Problem
from sailnet.ocp.definition.smoothing import Exact
from sailnet.ocp.solvers.delta.series import Basis
from sailnet.physics.arrays import Array

REACH = np.pi
"""Coefficients lie between -REACH and REACH, as in the paper."""


@dataclass(frozen=True)
class Switched:
    """A bang-bang control by the sign of its series f_s, Eqs. (7)-(8).

    Attributes:
        column: of the control among all controls.
        channel: of its series.
        index: among the bounded controls.
        lower, upper: its bounds.
        scale: of its switching function.
    """

    column: int
    channel: int
    index: int
    lower: float
    upper: float
    scale: float


@dataclass(frozen=True)
class Clipped:
    """A control in which the Hamiltonian is not affine: a series of its range, clipped.

    Attributes:
        column, channel: as above.
        lower, upper: its bounds.
    """

    column: int
    channel: int
    lower: float
    upper: float


@dataclass(frozen=True)
class Pointed:
    """A direction by one angle, or by the two of Eqs. (42)-(44).

    Attributes:
        columns: of its components.
        channels: of its angles.
    """

    columns: tuple[int, ...]
    channels: tuple[int, ...]


class Controls:
    """All controls of a problem as series of one length.

    A point z holds, series by series, ``terms`` coefficients, then the final time's coefficient if that
    time is free.

    Args:
        problem: the problem.
        basis: of the series.
        terms: of each series.

    Raises:
        SailnetError: for a control without bounds in which the Hamiltonian is not affine, or a direction
            of neither two nor three components.
    """

    def __init__(self, problem: Problem, basis: Basis, terms: int) -> None:
        self.problem, self.basis, self.terms = problem, basis, terms
        equations = canonical(problem, Exact())
        self.switched: list[Switched] = []
        self.clipped: list[Clipped] = []
        self.pointed: list[Pointed] = []
        column = channel = index = 0
        for control in problem.controls:
            if isinstance(control, Direction):
                size = len(control.variables)
                if size not in (2, 3):
                    raise SailnetError(f"{problem.name}: a direction of {size} components has no angles here")
                channels = tuple(range(channel, channel + size - 1))
                self.pointed.append(Pointed(tuple(range(column, column + size)), channels))
                column, channel = column + size, channel + size - 1
                continue
            if equations.corners[index] == equations.switching[index][1]:
                self.switched.append(
                    Switched(column, channel, index, control.lower, control.upper, control.scale)
                )
            else:
                self.clipped.append(self._clip(control, column, channel))
            column, channel, index = column + 1, channel + 1, index + 1
        self.channels, self.columns = channel, column

    def _clip(self, control: Bounded, column: int, channel: int) -> Clipped:
        if not np.isfinite(control.upper - control.lower):
            raise SailnetError(
                f"{self.problem.name}: the delta method needs bounds of {control.variable}; give some"
            )
        return Clipped(column, channel, control.lower, control.upper)

    @property
    def size(self) -> int:
        """Length of a point z."""
        return self.channels * self.terms + int(self.problem.time_is_free)

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Least and greatest z; a free time lies between half its guess and one and a half of it."""
        upper = np.full(self.size, REACH)
        lower = -upper
        if self.problem.time_is_free:
            lower[-1], upper[-1] = 0.5, 1.5
        return lower, upper

    def final_times(self, z: Array) -> Array:
        """(m,) final times of (m, d) points: t_f = c t_d with the problem's guess for t_d."""
        guess = self.problem.time_guess
        return guess * z[:, -1] if self.problem.time_is_free else np.full(len(z), guess)

    def coefficients(self, z: Array) -> Array:
        """(m, channels, terms) coefficients of the series."""
        return z[:, : self.channels * self.terms].reshape(len(z), self.channels, self.terms)

    def series(self, z: Array, s: Array) -> Array:
        """(m, k, channels) the series at k normalised times."""
        values = self.basis.values(s, self.terms)
        return np.asarray(np.einsum("mct,kt->mkc", self.coefficients(z), values))

    def shares(self, series: Array, softness: float = 0.0) -> Array:
        """Where switched controls stand between their bounds, 0 at the lower and 1 at the upper.

        Within an interval a series is taken for straight, so that a switch moves a flight continuously:
        the share's straight line there has the switch's mean and first moment.

        Args:
            series: (m, 3, k, channels) at begin, middle and end of every interval.
            softness: of the switches; with some, a control passes smoothly from one bound to the other
                while its series passes zero by about as much.

        Returns:
            (m, 3, k, switched).
        """
        chosen = series[..., [switched.channel for switched in self.switched]]
        if softness:
            return np.asarray(0.5 * (1.0 - np.tanh(chosen / softness)))
        first, last = chosen[:, 0], chosen[:, 2]
        down = np.maximum(-first, 0.0) + np.maximum(-last, 0.0)
        sides = np.abs(first) + np.abs(last)
        # Of two points on one side, the other side's sum is zero: the share is 1 or 0.
        share = down / np.where(sides == 0.0, 1.0, sides)
        lean = 3.0 * share * (1.0 - share) * np.sign(first - last)
        return np.stack([share - lean, share, share + lean], axis=1)

    def controls(self, series: Array, shares: Array) -> Array:
        """(..., controls) at points whose series and shares are given."""
        u = np.empty((*series.shape[:-1], self.columns))
        for j, switched in enumerate(self.switched):
            u[..., switched.column] = switched.lower + (switched.upper - switched.lower) * shares[..., j]
        for clipped in self.clipped:
            middle, half = 0.5 * (clipped.lower + clipped.upper), 0.5 * (clipped.upper - clipped.lower)
            value = middle + half * series[..., clipped.channel]
            u[..., clipped.column] = np.clip(value, clipped.lower, clipped.upper)
        for pointed in self.pointed:
            u[..., pointed.columns] = self._direction(series[..., pointed.channels])[0]
        return u

    def turned(self, series: Array, slopes: Array) -> Array:
        """(m, k, ..., angles and clipped) derivatives by what the series give freely.

        Args:
            series: (m, k, channels).
            slopes: (m, k, ..., controls) derivatives by the controls.
        """
        found = []
        for pointed in self.pointed:
            for tangent in self._direction(series[:, :, pointed.channels])[1]:
                shape = (*tangent.shape[:2], *[1] * (slopes.ndim - 3), tangent.shape[-1])
                found.append((slopes[..., pointed.columns] * tangent.reshape(shape)).sum(axis=-1))
        for clipped in self.clipped:
            # On a bound dH/du need not vanish.
            free = np.abs(series[:, :, clipped.channel]) < 1.0
            found.append(slopes[..., clipped.column] * free.reshape(*free.shape, *[1] * (slopes.ndim - 3)))
        return np.stack(found, axis=-1) if found else np.zeros((*slopes.shape[:-1], 0))

    def wanted(self, switching: Array, u: Array) -> list[tuple[int, Array]]:
        """What each series would have to be, by channel, along one flight.

        Args:
            switching: (k, bounded) switching functions in order of time.
            u: (k, controls) controls.
        """
        found = []
        for switched in self.switched:
            series = switching[:, switched.index]
            # Its sign alone steers.
            found.append((switched.channel, series / max(float(np.abs(series).max()), 1e-300)))
        for clipped in self.clipped:
            middle, half = 0.5 * (clipped.lower + clipped.upper), 0.5 * (clipped.upper - clipped.lower)
            found.append((clipped.channel, (u[:, clipped.column] - middle) / half))
        for pointed in self.pointed:
            a = u[:, pointed.columns]
            plane = (0, 1) if a.shape[1] == 2 else (2, 1)
            turned = np.unwrap(np.arctan2(a[:, plane[0]], a[:, plane[1]]))
            turned -= 2.0 * np.pi * np.round(turned.mean() / (2.0 * np.pi))
            angles = [turned] if a.shape[1] == 2 else [np.arcsin(np.clip(a[:, 0], -1.0, 1.0)), turned]
            found += list(zip(pointed.channels, angles, strict=True))
        return found

    @staticmethod
    def _direction(angles: Array) -> tuple[Array, list[Array]]:
        """Unit vectors, and their derivatives by each angle."""
        first = angles[..., 0]
        sin, cos = np.sin(first), np.cos(first)
        if angles.shape[-1] == 1:
            return np.stack([sin, cos], axis=-1), [np.stack([cos, -sin], axis=-1)]
        sin_psi, cos_psi = np.sin(angles[..., 1]), np.cos(angles[..., 1])
        unit = np.stack([sin, cos * cos_psi, cos * sin_psi], axis=-1)
        by_phi = np.stack([cos, -sin * cos_psi, -sin * sin_psi], axis=-1)
        by_psi = np.stack([np.zeros_like(sin), -cos * sin_psi, cos * cos_psi], axis=-1)
        return unit, [by_phi, by_psi]
