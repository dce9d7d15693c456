"""HTTP API, pages and storage. The only room that knows FastAPI, Pydantic and SQLAlchemy.

`people/`, `courses/`, `answering/`, `sets/`, `marks/`, `regrading/` and `jobs/` hold the resources, one file each;
`web/` what is alike in every request; `storage/` what every store promises, `database/` and `tables/` the one there is.
Here stand the application itself, who asks (`reader`), who may (`policy`), and what concerns the server as a whole.
"""
