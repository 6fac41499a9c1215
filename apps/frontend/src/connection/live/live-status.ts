/**
 * How a subscription stands: `off` without a topic or in a hidden page, `asking` until the master accepts it,
 * `live` from then on, `refused` when the master does not allow it.
 */
export type LiveStatus = 'off' | 'asking' | 'live' | 'refused';
export type LiveEvent = 'subscribe' | 'accept' | 'refuse' | 'unsubscribe';

const MOVES: Readonly<Record<LiveStatus, Readonly<Partial<Record<LiveEvent, LiveStatus>>>>> = {
  off: { subscribe: 'asking' },
  asking: { accept: 'live', refuse: 'refused', unsubscribe: 'off' },
  live: { unsubscribe: 'off' },
  refused: { unsubscribe: 'off' },
};

/** The status after an event; the same for one that has no meaning in it, such as a reply that comes too late. */
export function nextStatus(status: LiveStatus, event: LiveEvent): LiveStatus {
  return MOVES[status][event] ?? status;
}

/** The status of several subscriptions together: the one that tells most. */
export function joinStatus(all: readonly LiveStatus[]): LiveStatus {
  return (['refused', 'asking', 'live'] as const).find((one) => all.includes(one)) ?? 'off';
}
