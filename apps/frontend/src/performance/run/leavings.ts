import { SERVICES, toJson } from '@ubii/proto';

/** What a test puts on the master for a while. */
export interface Leaving {
  readonly kind: 'client' | 'session';
  readonly id: string;
}

/** Keeps book of what a running test must take away again, however it ends. */
export interface Leavings {
  add(leaving: Leaving): void;
  /** It is gone. */
  drop(leaving: Leaving): void;
  /** In the order in which they go: a session publishes on topics of its client. */
  readonly all: readonly Leaving[];
}

const KEY = 'ubii.performance.leavings';

/**
 * @param storage outlives a reload and a crash of the tab, so that the next visit can tidy up
 */
export function createLeavings(storage: Pick<Storage, 'getItem' | 'setItem'>): Leavings {
  const known = new Map<string, Leaving>();
  for (const leaving of read(storage.getItem(KEY))) known.set(leaving.id, leaving);
  const save = (): void => storage.setItem(KEY, JSON.stringify([...known.values()]));
  return {
    add(leaving) {
      known.set(leaving.id, leaving);
      save();
    },
    drop({ id }) {
      if (known.delete(id)) save();
    },
    get all() {
      const leavings = [...known.values()];
      const of = (kind: Leaving['kind']) => leavings.filter((one) => one.kind === kind);
      return [...of('session'), ...of('client')];
    },
  };
}

function read(text: string | null): Leaving[] {
  try {
    const list: unknown = JSON.parse(text ?? '[]');
    return Array.isArray(list) ? list.filter(isLeaving) : [];
  } catch {
    return [];
  }
}

function isLeaving(value: unknown): value is Leaving {
  const { kind, id } = (value ?? {}) as Record<string, unknown>;
  return (kind === 'client' || kind === 'session') && typeof id === 'string';
}

/** The service that takes it away, as text for a page that has no time for an answer. */
export function removalRequest({ kind, id }: Leaving): string {
  const request =
    kind === 'client'
      ? { topic: SERVICES.clientDeregistration.topic, client: { id } }
      : { topic: SERVICES.sessionRuntimeRemove.topic, session: { id } };
  return JSON.stringify(toJson('ubii.services.ServiceRequest', request));
}
