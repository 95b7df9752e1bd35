"""Yang, Zhao, Zhu & Feng: multi-horizon peridynamics of buoyant flow with heat."""
