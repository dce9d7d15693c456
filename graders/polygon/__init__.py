"""Vector polygons without a key: reading, walks in the mechanism's graph, projections and their derivatives.

The true motion of the mechanism is the judge. It comes in plain numbers with the reference; no mechanics is done here.
Angles are counter-clockwise from +X, radians; lengths in metres.
"""
