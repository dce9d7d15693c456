# Grübler: serves by default; `grade FILE…` and the other commands are alternatives.
# Pin the base fully with --build-arg DIGEST=@sha256:…
ARG BASE=python:3.11.13-slim-bookworm
ARG DIGEST=""

# hadolint ignore=DL3006
FROM ${BASE}${DIGEST} AS build
ARG UV_VERSION=0.13.9
ENV UV_COMPILE_BYTECODE=1 \
    UV_LINK_MODE=copy \
    UV_NO_CACHE=1 \
    UV_PROJECT_ENVIRONMENT=/opt/grubler
RUN python3 -m venv /opt/uv && /opt/uv/bin/pip install --no-cache-dir "uv==${UV_VERSION}"
WORKDIR /src
COPY pyproject.toml uv.lock ./
RUN /opt/uv/bin/uv sync --locked --no-dev --no-install-project
COPY . .
# uv leaves a lock that everybody may write; in the image nobody may write but to /data.
RUN /opt/uv/bin/uv sync --locked --no-dev --no-editable && rm -f /opt/grubler/.lock

# hadolint ignore=DL3006
FROM ${BASE}${DIGEST}
COPY --from=build /opt/grubler /opt/grubler
RUN install -d -m 0700 -o 10001 -g 10001 /data
ENV PATH=/opt/grubler/bin:$PATH \
    PYTHONDONTWRITEBYTECODE=1 \
    PYTHONUNBUFFERED=1 \
    GRUBLER_DATA_DIR=/data \
    GRUBLER_HOST=0.0.0.0 \
    GRUBLER_PORT=8000
USER 10001:10001
VOLUME /data
EXPOSE 8000
HEALTHCHECK --interval=30s --timeout=5s --start-period=20s CMD ["python", "-c", \
    "import os, urllib.request as u; u.urlopen(f'http://127.0.0.1:{os.environ[\"GRUBLER_PORT\"]}/health', timeout=4)"]
ENTRYPOINT ["grubler"]
# Plain http inside the container: publish the port to a proxy that speaks https, and tell its address in
# GRUBLER_PUBLIC_URL.
CMD ["serve", "--insecure-http"]
