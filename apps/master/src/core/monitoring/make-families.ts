import type { MetricFamily } from './metric-family.ts';

export function counter(name: string, help: string, value: number): MetricFamily {
  return { name, help, kind: 'counter', values: [{ labels: {}, value }] };
}

export function gauge(name: string, help: string, value: number): MetricFamily {
  return { name, help, kind: 'gauge', values: [{ labels: {}, value }] };
}

export function family(
  name: string,
  help: string,
  kind: MetricFamily['kind'],
  label: string,
  values: readonly (readonly [string, number])[],
): MetricFamily {
  return {
    name,
    help,
    kind,
    values: values.map(([key, value]) => ({ labels: { [label]: key }, value })),
  };
}
