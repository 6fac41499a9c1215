/** One measured quantity with its values, fit for Prometheus. Labels come from closed lists. */
export interface MetricFamily {
  /** snake_case with unit, such as `ubii_records_received_total`. */
  readonly name: string;
  readonly help: string;
  readonly kind: 'counter' | 'gauge';
  /** Every value has the same label names. A family without labels has one value. */
  readonly values: readonly {
    readonly labels: Readonly<Record<string, string>>;
    readonly value: number;
  }[];
}

/** Every metric of the master at one moment. */
export type MasterMetrics = readonly MetricFamily[];

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
