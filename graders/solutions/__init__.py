"""Sets of solutions: whether two equations, systems or inequalities are true at the same points of a domain.

Doubles choose where to look; balls decide. The set of solutions knows no sign, side, non-zero factor or multiplicity.
"""
