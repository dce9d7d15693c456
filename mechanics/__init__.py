"""Reference solvers and oracles. SI in, SI out, no state.

A folder is a chapter of the subject; what several chapters work with stands beside them: equations, vectors, roots,
refusals. `wire/` reads and answers the requests of programs.
"""
