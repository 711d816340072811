"""The first standing wave in a tank with slip walls, exact and as computed."""

import numpy as np

GRAVITY = 9.81
LENGTH = 1.0  # of the tank [m]
DEPTH = 0.3
IMPULSE = 0.05  # initial velocity, as in constant/ulphProperties [m/s]

K = np.pi / LENGTH
OMEGA = np.sqrt(GRAVITY * K * np.tanh(K * DEPTH))
PERIOD = 2 * np.pi / OMEGA


def viscousRoot(nu):
    """Decay rate of the energy [1/s] and omega [1/s] at a finite viscosity.

    (s + 2 nu k^2)^2 + omega0^2 = 4 nu^2 k^3 sqrt(k^2 + s/nu), s = -rate/2 + i omega:
    Lamb's equation, which holds for deep water and, here, for a slip floor up to
    terms as small as what it adds to Lighthill's decay.
    """
    s = -2 * nu * K**2 + 1j * OMEGA
    for _ in range(100):
        layer = 4 * nu**2 * K**3 * np.sqrt(K**2 + s / nu)
        s = -2 * nu * K**2 + 1j * np.sqrt(OMEGA**2 - layer)
    return -2 * s.real, s.imag


def mode(x):
    """Velocity of the wave (n, 2) at the points x, unit amplitude at the surface."""
    kx, ky = K * x[:, 0], K * x[:, 1]
    return (
        np.stack([np.sin(kx) * np.cosh(ky), -np.cos(kx) * np.sinh(ky)], axis=1)
        / np.cosh(K * DEPTH)
    )


class Wave:
    """A run: times [s], amplitude of the wave's velocity [m/s], and its fit."""

    def __init__(self, case):
        self.case = case
        self.nu = case.entry("viscosity/nu")
        self.times = np.array(case.times)
        self.amplitude = np.array([self.project(case.cloud(t)) for t in case.times])
        self.rate, self.omega, self.start, self.phase, self.misfit = self.fit()

    @staticmethod
    def project(fields):
        """Share of the wave in the velocity: sound is orthogonal to it."""
        basis = mode(fields["x"])
        m = fields["mass"][:, None]
        return (m * basis * fields["U"][:, :2]).sum() / (m * basis**2).sum()

    def fit(self):
        """Energy decay rate, omega, amplitude, phase of A e^(-rate t/2) cos.

        Gauss-Newton from the exact values; last the rms misfit over A.
        """
        t, a = self.times, self.amplitude
        p = np.array([4 * self.nu * K**2, OMEGA, a[0], 0.0])

        def model(p):
            return p[2] * np.exp(-p[0] * t / 2) * np.cos(p[1] * t + p[3])

        for _ in range(30):
            base = model(p)
            step = 1e-6 * np.maximum(np.abs(p), 1e-3)
            J = np.stack(
                [(model(p + s * e) - base) / s for s, e in zip(step, np.eye(4))], axis=1
            )
            p = p + np.linalg.lstsq(J, a - base, rcond=None)[0]
        return (*p, np.sqrt(((a - model(p)) ** 2).mean()) / abs(p[2]))

    def fitted(self, t):
        """Amplitude [m/s] of the fit at the times t."""
        return self.start * np.exp(-self.rate * t / 2) * np.cos(
            self.omega * t + self.phase
        )
