import { SERVICES, type Init, type ServiceRequest } from '@ubii/proto';
import * as v from 'valibot';
import { readStored } from '../../json/read-stored.ts';
import { validElements } from '../../json/schemas.ts';

const LEAVING = v.object({ kind: v.picklist(['client', 'session']), id: v.string() });
const LEAVINGS = validElements(LEAVING);

/** Temporary object of a test on the master. */
export type Leaving = Readonly<v.InferOutput<typeof LEAVING>>;

/** Tracks what a running test must remove again, however it ends. */
export interface Leavings {
  add(leaving: Leaving): void;
  /** The object was removed. */
  drop(leaving: Leaving): void;
  /** In the order of removal: a session publishes on topics of its client. */
  readonly all: readonly Leaving[];
}

const KEY = 'ubii.performance.leavings';

/** @param storage survives a reload and a crash of the tab, so that the next visit can clean up */
export function createLeavings(storage: Pick<Storage, 'getItem' | 'setItem'>): Leavings {
  const known = new Map<string, Leaving>();
  for (const leaving of readStored(LEAVINGS, storage.getItem(KEY)) ?? []) {
    known.set(leaving.id, leaving);
  }
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

/** Body of the service request that removes it, for pages that cannot wait for a reply. */
export function removalRequest({ kind, id }: Leaving): Init<ServiceRequest> {
  return kind === 'client'
    ? { topic: SERVICES.clientDeregistration.topic, client: { id } }
    : { topic: SERVICES.sessionRuntimeRemove.topic, session: { id } };
}
