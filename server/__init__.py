"""HTTP API, pages and storage. The only room that knows FastAPI, Pydantic and SQLAlchemy."""
