"""The force of sunlight on a flat sail that is not ideal."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields

from sailnet.errors import SailnetError

Triple = tuple[float, float, float]


def is_number(value: object) -> bool:
    """Whether this is an integer or a float; True is neither."""
    return isinstance(value, (int, float)) and not isinstance(value, bool)


@dataclass(frozen=True)
class Optics:
    """Optical coefficients of a flat sail, and the force that follows.

    Light that comes in at the cone angle alpha pushes a real sail along its normal by

        P A [(1 + rho s) cos^2 alpha + B_f (1 - s) rho cos alpha
             + (1 - rho) (eps_f B_f - eps_b B_b) / (eps_f + eps_b) cos alpha]

    and along its surface, away from the Sun, by P A (1 - rho s) cos alpha sin alpha (C. R. McInnes, "Solar
    Sailing", Springer-Praxis, 1999, Section 2.6). In the radial and transverse directions of Eq. (1) the
    normal is (cos alpha, sin alpha) and the tangent (sin alpha, -cos alpha). The ideal sail, rho = s = 1,
    has 2 P A cos^2 alpha and nothing across: Eq. (1), with 2 P A = beta / r^2.

    beta stays what it is by definition, the characteristic acceleration of *this* sail: the force is scaled
    so that a sail that faces the Sun has beta / r^2 whatever its optics, and only its law of the cone angle
    differs. A sail whose area was chosen as if it were ideal is weaker by :attr:`facing_share`; add
    ``beta_bias = facing_share - 1`` for that.

    Attributes:
        reflectivity: rho, share of the light that is reflected.
        specularity: s, share of that which is reflected as by a mirror.
        front_emissivity: eps_f.
        back_emissivity: eps_b.
        front_lambertian: B_f, non-Lambertian coefficient of the front; 2/3 is Lambertian.
        back_lambertian: B_b, of the back.
    """

    reflectivity: float = 1.0
    specularity: float = 1.0
    front_emissivity: float = 0.05
    back_emissivity: float = 0.55
    front_lambertian: float = 2.0 / 3.0
    back_lambertian: float = 2.0 / 3.0

    def __post_init__(self) -> None:
        for name, value in asdict(self).items():
            if not is_number(value) or not 0.0 <= value <= 1.0:
                raise SailnetError(f"optics: {name} must be from 0 to 1, not {value!r}")
        if self.front_emissivity + self.back_emissivity == 0.0:
            raise SailnetError("optics: one of the emissivities must be above 0, or no heat leaves the sail")
        if self._along[1] + self._along[0] <= 0.0:
            raise SailnetError("optics: such a sail is not pushed away from the Sun")

    @property
    def _along(self) -> tuple[float, float]:
        mirrored = self.reflectivity * self.specularity
        diffuse = self.front_lambertian * (self.reflectivity - mirrored)
        emitted = self.front_emissivity * self.front_lambertian - self.back_emissivity * self.back_lambertian
        heat = (1.0 - self.reflectivity) * emitted / (self.front_emissivity + self.back_emissivity)
        return 1.0 + mirrored, diffuse + heat

    @property
    def ideal(self) -> bool:
        """Whether the force is along the normal alone, and by cos^2: that of Eq. (1)."""
        return self.force == OPTICS["ideal"].force

    @property
    def name(self) -> str | None:
        """In ``OPTICS``; None for coefficients that are not known by a name."""
        return next((name for name, known in OPTICS.items() if known == self), None)

    @property
    def description(self) -> str:
        """Its name, or else its coefficients."""
        return self.name or ", ".join(f"{key} {value!r}" for key, value in asdict(self).items())

    @property
    def facing_share(self) -> float:
        """Force on the sail when it faces the Sun, of that on an ideal one of the same area."""
        return sum(self._along) / 2.0

    @property
    def force(self) -> Triple:
        """Coefficients of cos^2 and cos along the normal and of cos sin along the tangent, per beta / r^2."""
        square, linear = self._along
        across = 1.0 - self.reflectivity * self.specularity
        facing = 2.0 * self.facing_share
        return square / facing, linear / facing, across / facing


OPTICS: Mapping[str, Optics] = {
    "ideal": Optics(),
    "jpl": Optics(0.88, 0.94, 0.05, 0.55, 0.79, 0.55),
    "nasa": Optics(0.91, 0.89, 0.025, 0.27, 0.79, 0.67),
}
"""Known sails. ``jpl`` is the square sail of JPL's study of a rendezvous with comet Halley, aluminium in
front and chromium behind: McInnes, Table 2.1, after J. L. Wright, "Space Sailing", Gordon and Breach, 1992,
Appendices A and B. Facing the Sun it has 1.816 P A, where the ideal sail has 2. ``nasa`` has the coefficients
of A. Heaton and A. Artusio-Glimpse, "An Update to the NASA Reference Solar Sail Thrust Model", 2015, NTRS
20150021404."""


def optics_from(given: object) -> Optics:
    """Read a name of ``OPTICS`` or a table of coefficients.

    Raises:
        SailnetError: an unknown name, or a coefficient that cannot be.
    """
    if isinstance(given, Optics):
        return given
    if isinstance(given, str) and given in OPTICS:
        return OPTICS[given]
    if isinstance(given, Mapping):
        known = [item.name for item in fields(Optics)]
        if unknown := sorted(set(given) - set(known)):
            raise SailnetError(f"optics has no {', '.join(unknown)}; known are {', '.join(known)}")
        return Optics(**given)
    raise SailnetError(f"optics must be one of {', '.join(OPTICS)} or a table, not {given!r}")
