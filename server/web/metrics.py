"""Figures for Prometheus: requests by route and status, how long they took, writes that the store refused."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from fastapi import APIRouter, Depends, Request
from prometheus_client import CollectorRegistry, Counter, Histogram, Metric
from prometheus_client.core import CounterMetricFamily
from prometheus_client.exposition import CONTENT_TYPE_LATEST, generate_latest
from prometheus_client.registry import Collector
from starlette.responses import Response

from server.reader import admit
from server.web.errors import Failure

BUCKETS = (0.002, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0)  # s

router = APIRouter(dependencies=[Depends(admit)], tags=["operations"])


@dataclass(frozen=True, slots=True)
class FailedWrites(Collector):
    """What the store could not write, as the store counts it."""

    count: Callable[[], int]

    def collect(self) -> Iterator[Metric]:
        """Give the figure as it is now."""
        yield CounterMetricFamily("grubler_failed_writes", "What the store could not write.", value=self.count())


class Metrics:
    """The figures of one server; routes are named by their pattern, so that no number of a variant becomes a label."""

    def __init__(self) -> None:
        self.registry = CollectorRegistry()
        names = ("method", "route", "status")
        self._requests = Counter("grubler_requests", "Requests answered.", names, registry=self.registry)
        self._seconds = Histogram(
            "grubler_request_seconds", "Time to answer.", ("route",), buckets=BUCKETS, registry=self.registry
        )

    def answered(self, method: str, route: str, status: int, seconds: float) -> None:
        """Note a request that was answered."""
        self._requests.labels(method, route, str(status)).inc()
        self._seconds.labels(route).observe(seconds)

    def text(self) -> bytes:
        """Write all figures as Prometheus reads them."""
        return generate_latest(self.registry)


@router.get(
    "/metrics",
    response_class=Response,
    responses={200: {"content": {"text/plain": {}}}, 401: {"model": Failure}, 403: {"model": Failure}},
)
async def show_metrics(request: Request) -> Response:
    """Give the figures of this server since its start."""
    metrics: Metrics = request.app.state.metrics
    return Response(metrics.text(), media_type=CONTENT_TYPE_LATEST)
