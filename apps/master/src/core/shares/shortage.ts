import type { LimitName, Limits } from '../limits/index.ts';
import { quote } from '../texts/quote.ts';
import type { Account } from './account.ts';
import { RESOURCE_INFO, type Resource } from './resources.ts';

/** There is no room for what an account is to pay for. */
export interface Shortage {
  readonly account: Account;
  readonly resource: Resource;
  /** Account that is exhausted: the client's, its invitation's, its class' or the whole. */
  readonly level: Account;
  /** Its usage, if it differs from that of the account. */
  readonly used?: number;
}

/** The limit that there is no room by. */
export function limitOf({ account, resource, level }: Shortage, limits: Limits): LimitName {
  const { all, each } = RESOURCE_INFO[resource]!;
  if (level.kind !== 'client' || each === undefined) return all;
  const max = account.max(resource);
  const names = [each.client, each.participant, each.player];
  return names.find((name) => name !== undefined && limits[name] === max) ?? each.client;
}

/**
 * Describes the exhausted resource, its share, its usage and the remedy: the rest of a sentence that starts with "This
 * would be". [AC-83]
 */
export function describeShortage(shortage: Shortage, limits: Limits): string {
  const { account, resource, level } = shortage;
  const { what } = RESOURCE_INFO[resource]!;
  const limit = limitOf(shortage, limits);
  const raise = `or raise the limit with --limits ${limit}=<number>`;
  const max = level.max(resource);
  const used = `used: ${shortage.used ?? level.used(resource)}`;
  switch (level.kind) {
    case 'client':
      return `more than ${max} ${what} of one client (limit ${limit}, ${used}); remove what is not needed, ${raise}.`;
    case 'session':
      return `more than ${max} ${what} of one session (${used}); remove what is not needed.`;
    case 'invitation':
      return `more than ${max} ${what} of all clients that joined with the invitation ${quote(level.label)}, its share of ${limits[limit]} (limit ${limit}, ${used}); end what these clients do not need, ${raise}.`;
    case 'class':
      return `more than ${max} ${what} of all ${level.label}s together, their share of ${limits[limit]} (limit ${limit}, ${used}); end what is not needed, ${raise}.`;
    case 'all':
    case 'master':
      return `more than ${fillMaxOf(account, resource)} ${what}${reserveOf(shortage, limits[limit])} (limit ${limit}, ${used}); end what is not needed, ${raise}.`;
  }
}

/** Describes a reserve that an account may not use. */
function reserveOf({ account, resource }: Shortage, limit: number): string {
  if (fillMaxOf(account, resource) >= limit) return '';
  return `: the rest of ${limit} is kept for running sessions and admins`;
}

/** Returns the total usage up to which this account may use more, as a share. */
export function fillMaxOf(account: Account, resource: Resource): number {
  let fillMax = Number.POSITIVE_INFINITY;
  for (let level: Account | undefined = account; level !== undefined; level = level.parent) {
    const { kind } = level;
    const max = kind === 'all' ? level.max(resource) : level.untilFilled(resource);
    fillMax = Math.min(fillMax, max ?? fillMax);
  }
  return fillMax;
}
