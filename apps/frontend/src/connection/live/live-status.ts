/**
 * Status of a subscription: `off` without a topic or in a hidden page, `asking` until the master accepts it, `live`
 * afterwards, `refused` when the master does not allow it.
 */
export type LiveStatus = 'off' | 'asking' | 'live' | 'refused';
export type LiveEvent = 'subscribe' | 'accept' | 'refuse' | 'unsubscribe';

const MOVES: Readonly<Record<LiveStatus, Readonly<Partial<Record<LiveEvent, LiveStatus>>>>> = {
  off: { subscribe: 'asking' },
  asking: { accept: 'live', refuse: 'refused', unsubscribe: 'off' },
  live: { unsubscribe: 'off' },
  refused: { unsubscribe: 'off' },
};

/** Returns the status after an event; unchanged for irrelevant events, such as a late reply. */
export function nextStatus(status: LiveStatus, event: LiveEvent): LiveStatus {
  return MOVES[status][event] ?? status;
}

/** Combined status of several subscriptions. */
export function joinStatus(all: readonly LiveStatus[]): LiveStatus {
  return (['refused', 'asking', 'live'] as const).find((one) => all.includes(one)) ?? 'off';
}
