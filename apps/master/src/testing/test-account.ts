import { Account } from '../core/shares/account.ts';
import { RESOURCES, type Resource } from '../core/shares/resources.ts';

/** An account of one client on its own, unlimited but for what `max` says. */
export function testAccount(max: { readonly [R in Resource]?: number } = {}): Account {
  return new Account({
    kind: 'client',
    id: 'test',
    max: Float64Array.from(RESOURCES, (resource) => max[resource] ?? Number.POSITIVE_INFINITY),
  });
}
