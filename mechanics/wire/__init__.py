"""The solvers on the wire: a JSON object in, a JSON object out, every refusal with a code and the value that is wrong.

`solvers` knows them by name, `reading` reads the text, `fields` the values; each solver's module has its table of
fields, what it answers, an example and `solve`.
"""
