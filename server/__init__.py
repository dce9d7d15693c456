"""HTTP API, pages and storage. The only room that knows FastAPI, Pydantic and SQLAlchemy.

`people/`, `courses/`, `catalogue/`, `answering/`, `sets/`, `marks/`, `regrading/`, `solvers/`, `audit/` and `jobs/`
hold the resources, one file each; `web/` what is alike in every request; `storage/` what every store promises,
`database/`, `tables/` and `migrations/` the one there is, `upkeep/` its copies. Here stand the application itself, who
asks (`reader`), who may (`policy`), what they work with (`workbench`), and what concerns the server as a whole.
"""
