import { Counter, Gauge, Registry } from 'prom-client';

import type { MasterMetrics } from '../../core/master/master.ts';

/** Prometheus' text format, with the content type to send it with. */
export async function formatMetrics(
  metrics: MasterMetrics,
): Promise<{ readonly contentType: string; readonly text: string }> {
  const registry = new Registry();
  for (const { name, help, kind, values } of metrics) {
    const labelNames = Object.keys(values[0]?.labels ?? {});
    const options = { name, help, labelNames, registers: [registry] };
    if (kind === 'counter') {
      const counter = new Counter(options);
      for (const { labels, value } of values) counter.inc({ ...labels }, value);
    } else {
      const gauge = new Gauge(options);
      for (const { labels, value } of values) gauge.set({ ...labels }, value);
    }
  }
  return { contentType: registry.contentType, text: await registry.metrics() };
}
