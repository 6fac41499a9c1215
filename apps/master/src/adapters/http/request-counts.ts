import type { MasterMetrics } from '../../core/master/master.ts';

/** Counts responses by route and class of status: names of our own, never what a client sent. */
export class RequestCounts {
  readonly #counts = new Map<string, { route: string; status: string; count: number }>();

  /** @param route path of the route that answered; undefined when none did */
  count(route: string | undefined, statusCode: number): void {
    const status = `${Math.floor(statusCode / 100)}xx`;
    const key = `${route} ${status}`;
    const entry = this.#counts.get(key);
    if (entry) entry.count += 1;
    else this.#counts.set(key, { route: route ?? 'none', status, count: 1 });
  }

  metrics(): MasterMetrics {
    return [
      {
        name: 'ubii_http_responses_total',
        help: 'HTTP responses by route and class of status.',
        kind: 'counter',
        values: [...this.#counts.values()].map(({ route, status, count }) => ({
          labels: { route, status },
          value: count,
        })),
      },
    ];
  }
}
