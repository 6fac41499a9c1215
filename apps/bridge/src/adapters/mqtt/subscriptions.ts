import { toFilter } from '../../core/mapping/address-path.ts';
import { takesIn } from '../../core/mapping/mapping.ts';
import type { Mapping, Qos } from '../../core/mapping/mapping.ts';

/** How one filter is subscribed to. */
export interface FilterOptions {
  readonly qos: Qos;
  /** No local: the broker does not send back what this connection published. [BR-21] */
  readonly nl: true;
  /** Not retain as published: the flag says that the broker kept the message. [BR-14] */
  readonly rap: false;
  /** Retain handling: 0 sends retained messages with the subscription, 2 does not. */
  readonly rh: 0 | 2;
}

/** Returns the filters of all mappings that take messages; mappings with the same filter share one. */
export function filtersOf(mappings: readonly Mapping[]): ReadonlyMap<string, FilterOptions> {
  const filters = new Map<string, FilterOptions>();
  for (const mapping of mappings.filter(takesIn)) {
    const filter = toFilter(mapping.foreign);
    const before = filters.get(filter);
    filters.set(filter, {
      qos: Math.max(before?.qos ?? 0, mapping.qos) as Qos,
      nl: true,
      rap: false,
      rh: mapping.retained || before?.rh === 0 ? 0 : 2,
    });
  }
  return filters;
}
